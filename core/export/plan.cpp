#include "core/export/plan.h"

#include <set>

#include "core/export/text.h"
#include "core/sensing/compiled_sensor.h"

namespace braitenlab::robots {

namespace {

// A plan in the making: taps name their sources as Brain does.
struct Draft {
    const Brain& brain;
    std::vector<std::vector<Brain::Tap>> taps;  // of each unit
    std::vector<float> bias;
    std::size_t sensors() const { return brain.sensors.size(); }
    std::size_t hidden() const { return brain.units.size() - 2; }
};

bool is_covered(const Brain& brain, const Brain::Tap& tap) {
    const auto source = static_cast<std::size_t>(tap.source);
    return source < brain.sensors.size() && brain.sensors[source] < 0;
}

// The taps that can change a sum. A covered sensor reads 0, so that its wires add constants.
Draft without_constants(const Brain& brain) {
    Draft draft{brain, {}, {}};
    for (const Brain::Unit& unit : brain.units) {
        float bias = unit.bias;
        std::vector<Brain::Tap> taps;
        for (std::int32_t i = unit.first_tap; i < unit.end_tap; ++i) {
            const Brain::Tap& tap = brain.taps[static_cast<std::size_t>(i)];
            if (is_covered(brain, tap))
                bias += tap.weight * respond(tap.curve, 0);
            else if (tap.weight != 0 || tap.learned >= 0)
                taps.push_back(tap);
        }
        draft.taps.push_back(std::move(taps));
        draft.bias.push_back(bias);
    }
    return draft;
}

// The sources (sensors, then units) that reach a motor, and the motors.
std::set<std::size_t> effective_sources(const Draft& draft) {
    std::set<std::size_t> found;
    std::vector<std::size_t> open{draft.hidden(), draft.hidden() + 1};
    for (const std::size_t motor : open) found.insert(draft.sensors() + motor);
    while (!open.empty()) {
        const std::size_t unit = open.back();
        open.pop_back();
        for (const Brain::Tap& tap : draft.taps[unit]) {
            const auto source = static_cast<std::size_t>(tap.source);
            if (found.insert(source).second && source >= draft.sensors()) open.push_back(source - draft.sensors());
        }
    }
    return found;
}

std::vector<const Node*> sensors_by_id(const BrainGraph& graph) {
    std::vector<const Node*> sensors;
    for (const Node& node : graph.nodes)
        if (node.kind == NodeKind::sensor) sensors.push_back(&node);
    std::sort(sensors.begin(), sensors.end(), [](const Node* a, const Node* b) { return a->id < b->id; });
    return sensors;
}

float lab_range_of(const Sensor& sensor) {
    const bool is_table = sensor.response == SensorResponse::table && !sensor.points.empty();
    return is_table ? std::min(sensor.range, sensor.points.back().distance) : sensor.range;
}

float in_room(const Sensor& sensor, const BrainToExport& given) {
    const sensing::CompiledSensor compiled(sensor);
    if (!compiled.sees_ambient_light) return 0;
    return std::clamp(sensing::total_reading(compiled, 0, given.ambient, given.lux), 0.0f, 1.0f);
}

// With what the vehicle's sensor of this name says of it.
Input input_of(const BrainToExport& given, const std::string& name) {
    const bool is_share = given.length > 0 && given.width > 0;
    const float length = is_share ? given.length : 1, width = is_share ? given.width : 1;
    for (const Sensor& sensor : given.sensors)
        if (sensor.name == name)
            return {name,
                    "",
                    sensor.channel,
                    Place{sensor.x / length, sensor.y / width, sensor.angle, is_share},
                    sensor.response == SensorResponse::photocell ? sensor.half_lux : Sensor{}.half_lux,
                    lab_range_of(sensor),
                    in_room(sensor, given)};
    return {name, ""};
}

// New indices of the sources that stay; −1 for the others.
struct Renumbered {
    std::vector<int> inputs, units;
};

Renumbered renumber(const Draft& draft, const std::set<std::size_t>& kept) {
    Renumbered to{std::vector<int>(draft.sensors(), -1), std::vector<int>(draft.brain.units.size(), -1)};
    int next = 0;
    for (std::size_t s = 0; s < draft.sensors(); ++s)
        if (kept.count(s) > 0) to.inputs[s] = next++;
    next = 0;
    for (std::size_t u = 0; u < draft.brain.units.size(); ++u)
        if (kept.count(draft.sensors() + u) > 0) to.units[u] = next++;
    return to;
}

PlanTap plan_tap(const Draft& draft, const Renumbered& to, const Brain::Tap& tap, bool into_motor) {
    const auto source = static_cast<std::size_t>(tap.source);
    PlanTap made{Reads::sensor, 0, tap.weight, tap.threshold, tap.curve, 0, 0};
    if (tap.learned >= 0) made.learning_rate = tap.learning_rate, made.decay = tap.decay;
    if (source < draft.sensors()) {
        made.source = to.inputs[source];
        return made;
    }
    const std::size_t unit = source - draft.sensors();
    made.source = to.units[unit];
    made.reads = into_motor && unit < draft.hidden() ? Reads::now : Reads::before;
    return made;
}

void mark_kept(Plan& plan) {
    for (PlanUnit& unit : plan.units) unit.is_kept = unit.follow < 1;
    for (const PlanUnit& unit : plan.units)
        for (const PlanTap& tap : unit.taps)
            if (tap.reads == Reads::before) plan.units[static_cast<std::size_t>(tap.source)].is_kept = true;
}

void name_parts(Plan& plan, const BrainGraph& graph, const std::vector<NodeId>& ids) {
    Identifiers identifiers;
    for (Input& input : plan.inputs) input.id = identifiers.make("sensor_", input.name);
    for (std::size_t u = 0; u < plan.units.size(); ++u) {
        PlanUnit& unit = plan.units[u];
        const bool motor = u >= plan.hidden();
        const Node* node = find_node(graph, ids[u]);
        unit.name = motor ? (u == plan.hidden() ? "ML" : "MR") : node->name;
        unit.time_constant = node ? node->time_constant : 0;
        unit.id = identifiers.make(motor ? "motor_" : "neuron_", unit.name);
    }
    for (PlanUnit& unit : plan.units)
        for (PlanTap& tap : unit.taps) {
            if (tap.learning_rate <= 0) continue;
            const auto source = static_cast<std::size_t>(tap.source);
            const std::string& from = tap.reads == Reads::sensor ? plan.inputs[source].name : plan.units[source].name;
            tap.learned_id = identifiers.make("learned_", from + "_" + unit.name);
        }
}

Range hull(Range a, Range b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }

Range source_range(const Plan& plan, const PlanTap& tap) {
    return tap.reads == Reads::sensor ? Range{0, 1} : plan.units[static_cast<std::size_t>(tap.source)].value;
}

Range contribution(const Plan& plan, const PlanTap& tap) {
    // Every range contains 0, so a threshold, which makes an input 0, does not widen it.
    const Range in = range_of(tap.curve, source_range(plan, tap));
    // A learned part keeps the weight within its limits.
    const Range weight = tap.learning_rate > 0 ? Range{-limits::weight, limits::weight} : Range{tap.weight, tap.weight};
    const float products[] = {weight.low * in.low, weight.low * in.high, weight.high * in.low, weight.high * in.high};
    return {*std::min_element(std::begin(products), std::end(products)),
            *std::max_element(std::begin(products), std::end(products))};
}

// The range of a unit's sum, partial sums included, and of its value. Values start at 0.
void set_range(const Plan& plan, PlanUnit& unit) {
    Range sum{unit.bias, unit.bias}, whole = hull({0, 0}, sum);
    for (const PlanTap& tap : unit.taps) {
        const Range part = contribution(plan, tap);
        sum = {sum.low + part.low, sum.high + part.high};
        whole = hull(whole, sum);
    }
    unit.sum = whole;
    const Range value = hull({0, 0}, range_of(unit.curve, sum));
    unit.value = {std::max(value.low, -largest_value), std::min(value.high, largest_value)};
}

void find_ranges(Plan& plan) {
    // Ranges only grow. A loop that has not settled after this many rounds is taken to grow without limit.
    const std::size_t rounds = 2 * plan.units.size() + 32;
    for (std::size_t round = 0; round < 2 * rounds; ++round) {
        bool changed = false;
        for (PlanUnit& unit : plan.units) {
            const Range before = unit.value;
            set_range(plan, unit);
            if (unit.value == before) continue;
            changed = true;
            if (round < rounds) continue;
            if (unit.value.low < before.low) unit.value.low = -largest_value;
            if (unit.value.high > before.high) unit.value.high = largest_value;
        }
        if (!changed) return;
    }
}

}  // namespace

Range range_of(const Curve& curve, Range inputs) {
    const Range ends = {respond(curve, inputs.low), respond(curve, inputs.high)};
    Range values = {std::min(ends.low, ends.high), std::max(ends.low, ends.high)};
    // The other responses are monotonous.
    if (curve.response == Response::hump && inputs.low <= curve.peak && curve.peak <= inputs.high) values.high = 1;
    return values;
}

bool has_response(const Plan& plan, Response response) {
    const auto is_it = [response](const auto& part) { return part.curve.response == response; };
    return std::any_of(plan.units.begin(), plan.units.end(), is_it) || has_wire(plan, is_it);
}

Result<Plan> make_plan(const BrainToExport& given, float rate_hz) {
    const std::vector<const Node*> sensors = sensors_by_id(given.brain);
    std::vector<std::string> names;
    for (const Node* sensor : sensors) names.push_back(sensor->name);
    const auto compiled = compile(given.brain, names, 1 / rate_hz);
    if (!compiled) return compiled.error();
    const Draft draft = without_constants(*compiled);
    const std::set<std::size_t> kept = effective_sources(draft);
    const Renumbered to = renumber(draft, kept);

    Plan plan{given.title, rate_hz, {}, {}, given.lux};
    for (std::size_t s = 0; s < draft.sensors(); ++s)
        if (to.inputs[s] >= 0) plan.inputs.push_back(input_of(given, sensors[s]->name));
    std::vector<NodeId> ids;
    for (std::size_t u = 0; u < compiled->units.size(); ++u) {
        if (to.units[u] < 0) continue;
        PlanUnit unit;
        unit.bias = draft.bias[u];
        unit.follow = compiled->units[u].follow;
        unit.curve = compiled->units[u].curve;
        for (const Brain::Tap& tap : draft.taps[u]) unit.taps.push_back(plan_tap(draft, to, tap, u >= draft.hidden()));
        plan.units.push_back(std::move(unit));
        ids.push_back(compiled->unit_ids[u]);
    }
    name_parts(plan, given.brain, ids);
    mark_kept(plan);
    find_ranges(plan);
    return plan;
}

}  // namespace braitenlab::robots

#include "core/export/vectors.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/io/csv.h"
#include "core/maths/random.h"

namespace braitenlab::robots {

namespace {

constexpr float step_of_input = 1000;  // inputs are whole thousandths

float thousandth(maths::Random& random) { return static_cast<float>(random.next() % 1001U) / step_of_input; }

// The inputs of the next tick from those of this one.
class Inputs {
public:
    Inputs(std::size_t count, std::uint64_t seed) : values_(count, 0.0f), random_(seed, 77) {}

    // `again`: further proposals for the same tick.
    std::vector<float> propose(int tick, bool again) {
        const std::size_t corners = std::size_t{1} << std::min<std::size_t>(values_.size(), 6);
        const auto at = static_cast<std::size_t>(tick);
        std::vector<float> next = values_;
        if (at < 2 * corners && !again) {
            for (std::size_t i = 0; i < next.size(); ++i) next[i] = (at / 2 >> i & 1U) != 0 ? 1.0f : 0.0f;
            return next;
        }
        const std::uint32_t kind = again ? 2 : random_.next() % 4;  // twice the same, then a step, then new values
        for (float& value : next) {
            if (kind == 2) value = thousandth(random_);
            if (kind == 3) value = std::clamp(value + (thousandth(random_) - 0.5f) / 5, 0.0f, 1.0f);
        }
        for (float& value : next) value = std::round(value * step_of_input) / step_of_input;
        return next;
    }
    void accept(std::vector<float> values) { values_ = std::move(values); }

private:
    std::vector<float> values_;
    maths::Random random_;
};

bool is_close(float value, float to) { return std::fabs(value - to) < close_call_margin; }

// Evaluates one tick of a plan to find close calls. `held`, `settled`: units before and after the tick.
struct CloseCalls {
    const Plan& plan;
    const std::vector<float>&sensed, &held, &settled;

    float read(const PlanTap& tap) const {
        const auto source = static_cast<std::size_t>(tap.source);
        if (tap.reads == Reads::sensor) return sensed[source];
        return tap.reads == Reads::now ? settled[source] : held[source];
    }
    bool in_tap(const PlanTap& tap) const {
        const float input = read(tap);
        if (tap.threshold > 0 && is_close(std::fabs(input), tap.threshold)) return true;
        return tap.curve.response == Response::step && is_close(masked(input, tap.threshold), tap.curve.peak);
    }
    bool in_unit(const PlanUnit& unit) const {
        float sum = unit.bias;
        for (const PlanTap& tap : unit.taps) {
            if (in_tap(tap)) return true;
            sum += tap.weight * respond(tap.curve, masked(read(tap), tap.threshold));
        }
        return unit.curve.response == Response::step && is_close(sum, unit.curve.peak);
    }
    bool any() const {
        return std::any_of(plan.units.begin(), plan.units.end(), [&](const PlanUnit& unit) { return in_unit(unit); });
    }
};

// The compiled brain beside the plan, so that the vectors come from the code that drives the vehicles of the lab.
struct Reference {
    Plan plan;
    Brain brain;
    std::vector<int> sensor_of_input, unit_of_plan;

    std::vector<float> sensed(const std::vector<float>& inputs) const {
        std::vector<float> all(brain.sensors.size(), 0.0f);
        for (std::size_t i = 0; i < inputs.size(); ++i) all[static_cast<std::size_t>(sensor_of_input[i])] = inputs[i];
        return all;
    }
    std::vector<float> units(const std::vector<float>& state) const {
        std::vector<float> values;
        for (const int unit : unit_of_plan) values.push_back(state[static_cast<std::size_t>(unit)]);
        return values;
    }
};

Result<Reference> make_reference(const BrainToExport& given, float rate_hz) {
    auto plan = make_plan(given, rate_hz);
    if (!plan) return plan.error();
    std::vector<std::string> names;
    for (const Node& node : given.brain.nodes)
        if (node.kind == NodeKind::sensor) names.push_back(node.name);
    auto brain = compile(given.brain, names, 1 / rate_hz);
    if (!brain) return brain.error();
    Reference made{std::move(*plan), std::move(*brain), {}, {}};
    for (const Input& input : made.plan.inputs)
        made.sensor_of_input.push_back(
            static_cast<int>(std::find(names.begin(), names.end(), input.name) - names.begin()));
    const auto units = static_cast<int>(made.brain.units.size());
    for (std::size_t u = 0; u < made.plan.hidden(); ++u)
        for (int all = 0; all < units - 2; ++all) {
            const Node* node = find_node(given.brain, made.brain.unit_ids[static_cast<std::size_t>(all)]);
            if (node && node->name == made.plan.units[u].name) made.unit_of_plan.push_back(all);
        }
    for (const int motor : {units - 2, units - 1}) made.unit_of_plan.push_back(motor);
    return made;
}

}  // namespace

Result<GoldenVectors> golden_vectors(const BrainToExport& given, float rate_hz, int ticks, std::uint64_t seed) {
    const auto reference = make_reference(given, rate_hz);
    if (!reference) return reference.error();
    GoldenVectors made{{}, rate_hz, {}};
    for (const Input& input : reference->plan.inputs) made.sensors.push_back(input.name);
    std::vector<float> state(static_cast<std::size_t>(reference->brain.state_size()), 0.0f);
    Inputs inputs(made.sensors.size(), seed);
    for (int tick = 0; tick < ticks; ++tick) {
        const std::vector<float> before = state;
        GoldenVector row;
        float motors[2];
        for (int attempt = 0; attempt < 100; ++attempt) {
            state = before;
            row.sensed = inputs.propose(tick, attempt > 0);
            think(reference->brain, reference->sensed(row.sensed), state, motors);
            row.is_close_call =
                CloseCalls{reference->plan, row.sensed, reference->units(before), reference->units(state)}.any();
            if (!row.is_close_call) break;
        }
        inputs.accept(row.sensed);
        row.left = motors[0], row.right = motors[1];
        made.ticks.push_back(std::move(row));
    }
    return made;
}

std::string write_csv(const GoldenVectors& vectors) {
    std::string text = "tick";
    for (const std::string& name : vectors.sensors) {
        text += ',';
        io::add_csv_cell(text, std::string_view("sensor_" + name));
    }
    text += ",left,right,close_call\n";
    for (std::size_t tick = 0; tick < vectors.ticks.size(); ++tick) {
        const GoldenVector& row = vectors.ticks[tick];
        text += fmt::format("{}", tick);
        for (const float value : row.sensed) text += fmt::format(",{:.3f}", value);
        text += fmt::format(",{:.9g},{:.9g},{:d}\n", row.left, row.right, row.is_close_call ? 1 : 0);
    }
    return text;
}

}  // namespace braitenlab::robots

#include "ui/panels/brain/brain_analysis.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/brain/four_neurons.h"
#include "core/insight/why.h"
#include "ui/wiring/node_text.h"

namespace braitenlab::ui {

namespace {

constexpr float rounding_error = 1e-4f;

Product product_of(const Snapshot& now, const VehicleView& vehicle, const SensorPair& pair, Dial dial) {
    const BrainGraph& brain = *brain_of(now, vehicle);
    const bool is_left = dial == Dial::LL || dial == Dial::RL;
    const std::string& sensor = is_left ? pair.left : pair.right;
    const std::string short_name = wiring::short_name(kind_of(now, vehicle).sensors, sensor);
    const std::string wire_name = "·" + std::string(name(dial));
    Product p{sensor, sensor + wire_name, short_name + wire_name};
    const auto ends = direct_ends(brain, dial, pair);
    if (!ends) return p;
    const float reading = node_value(now, vehicle, ends->from);
    p.reading = p.input = reading;
    p.weight = at(read_dials(brain, pair), dial);
    if (const Wire* wire = find_wire(brain, ends->from, ends->to)) {
        p.input = let_through(*wire, reading);
        p.weight += learned(now, vehicle, ends->from, ends->to);
        p.cut = wire->cut;
        p.masked = std::fabs(reading) < wire->threshold;
        if (wire->curve != Curve{}) {
            p.letters = "f(" + sensor + ")" + wire_name;
            p.label = "f(" + short_name + ")" + wire_name;
        }
        p.value = p.cut ? 0.0f : p.input * p.weight;
    }
    return p;
}

// The wires to the motor from other nodes than the pair. The largest contributions first, in steps of a tenth so that
// the order seldom changes; then the largest weights.
std::vector<Term> terms_of(const Snapshot& now, const VehicleView& vehicle, const SensorPair& pair, NodeId motor) {
    struct Candidate {
        Term term;
        float tenths, weight;  // size of the contribution, rounded; size of the weight
    };
    const BrainGraph& brain = *brain_of(now, vehicle);
    const std::vector<Sensor>& sensors = kind_of(now, vehicle).sensors;
    std::vector<Candidate> candidates;
    for (const Wire& wire : brain.wires) {
        const Node* from = find_node(brain, wire.from);
        if (wire.to != motor || !from || from->name == pair.left || from->name == pair.right) continue;
        if (wire.weight == 0 && wire.learning_rate == 0) continue;
        const float value =
            signal(wire, node_value(now, vehicle, wire.from), learned(now, vehicle, wire.from, wire.to));
        candidates.push_back({{from->name, wiring::short_name(sensors, from->name), value},
                              std::round(std::fabs(value) * 10),
                              std::fabs(wire.weight)});
    }
    std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
        return std::tie(a.tenths, a.weight) > std::tie(b.tenths, b.weight);
    });
    std::vector<Term> terms;
    for (std::size_t i = 0; i < std::min(most_terms, candidates.size()); ++i) terms.push_back(candidates[i].term);
    return terms;
}

// True when the two products and the bias are the whole sum: two sensors, two motors and wires between them, with any
// curves and lesions.
bool is_plain(const BrainGraph& brain, const SensorPair& pair) {
    const auto plain_node = [&](const Node& n) {
        const bool known =
            n.kind == NodeKind::sensor ? n.name == pair.left || n.name == pair.right : n.kind == NodeKind::motor;
        return known && n.curve == Curve{} && n.time_constant == 0;
    };
    const auto plain_wire = [&](const Wire& w) {
        const Node* from = find_node(brain, w.from);
        return from && from->kind == NodeKind::sensor;
    };
    return std::all_of(brain.nodes.begin(), brain.nodes.end(), plain_node) &&
           std::all_of(brain.wires.begin(), brain.wires.end(), plain_wire);
}

// A contribution of a sensor or neuron to the sum of a motor.
struct Contribution {
    std::string_view source;  // the node's name
    Cause::By by;
    const Product* product;  // null for a term
    std::string name;
    float value = 0;
    float push = 0;  // towards the turn
};

std::vector<Contribution> contributions(const std::array<MotorSum, 2>& both, float towards) {
    std::vector<Contribution> all;
    for (const float side : {-1.0f, 1.0f}) {
        const MotorSum& sum = both[side > 0 ? 1 : 0];
        const float sign = side * towards;
        for (const Product& p : sum.products)
            all.push_back({p.sensor, Cause::By::product, &p, p.letters, p.value, sign * p.value});
        for (const Term& term : sum.terms)
            all.push_back({term.name, Cause::By::term, nullptr, term.name, term.value, sign * term.value});
    }
    return all;
}

constexpr double recognition_period = 0.25;  // wall seconds

// One eye, or two for the same channel: eyes for different colours tell nothing about one stimulus.
bool has_eyes_of_one_channel(const std::vector<Sensor>& sensors) {
    std::optional<Channel> channel;
    for (const Sensor& sensor : sensors) {
        if (sensor.name != "SL" && sensor.name != "SR") continue;
        if (channel.value_or(sensor.channel) != sensor.channel) return false;
        channel = sensor.channel;
    }
    return channel.has_value();
}

bool reads_a_sensor(const BrainGraph& brain) {
    return std::any_of(brain.wires.begin(), brain.wires.end(), [&](const Wire& wire) {
        const Node* from = find_node(brain, wire.from);
        return wire.weight != 0 && from && from->kind == NodeKind::sensor;
    });
}

bool has_neurons(const BrainGraph& brain) {
    return std::any_of(brain.nodes.begin(), brain.nodes.end(),
                       [](const Node& node) { return node.kind == NodeKind::neuron; });
}

std::vector<Reading> rounded_readings(std::vector<Reading> readings) {
    for (Reading& reading : readings) reading.value = std::round(reading.value * 20) / 20;
    return readings;
}

}  // namespace

std::array<MotorSum, 2> motor_sums(const Snapshot& now, const VehicleView& vehicle, const SensorPair& pair) {
    const BrainGraph& brain = *brain_of(now, vehicle);
    const FourNeurons dials = read_dials(brain, pair);
    const auto product = [&](Dial dial) { return product_of(now, vehicle, pair, dial); };
    std::array<MotorSum, 2> both{MotorSum{"ML", "LM", {product(Dial::LL), product(Dial::LR)}, {}, dials.LM},
                                 MotorSum{"MR", "RM", {product(Dial::RR), product(Dial::RL)}, {}, dials.RM}};
    const bool plain = is_plain(brain, pair);
    const bool is_wired = std::any_of(weight_dials.begin(), weight_dials.end(), [&](Dial dial) {
        const auto ends = direct_ends(brain, dial, pair);
        return ends && find_wire(brain, ends->from, ends->to);
    });
    for (std::size_t side = 0; side < both.size(); ++side) {
        MotorSum& sum = both[side];
        sum.total = vehicle.motor[side];
        sum.more_wires = !plain, sum.shows_products = plain || is_wired;
        const Node* motor = find_node(brain, std::string(sum.motor));
        sum.stopped = motor && motor->silenced;
        if (!motor) continue;
        if (!plain) sum.terms = terms_of(now, vehicle, pair, motor->id);
        if (sum.stopped) continue;
        float shown = sum.products[0].value + sum.products[1].value + sum.bias;
        for (const Term& term : sum.terms) shown += term.value;
        // The motor's state is not limited to −1..1.
        if (!plain) sum.rest = node_value(now, vehicle, motor->id) - shown;
        sum.limited = std::fabs(shown + sum.rest) > 1.0f + rounding_error;
    }
    return both;
}

Cause cause(const std::array<MotorSum, 2>& both) {
    Cause c;
    c.difference = both[1].total - both[0].total;
    const float towards = c.difference > 0 ? 1.0f : -1.0f;
    const std::vector<Contribution> all = contributions(both, towards);
    std::vector<const Contribution*> sources;  // the largest contribution of each sensor or neuron
    std::vector<float> parts;                  // of the sources with all of their wires
    for (const Contribution& one : all) {
        const auto known = std::find_if(sources.begin(), sources.end(),
                                        [&](const Contribution* source) { return source->source == one.source; });
        if (known == sources.end()) {
            sources.push_back(&one), parts.push_back(one.push);
            continue;
        }
        parts[static_cast<std::size_t>(known - sources.begin())] += one.push;
        if (one.push > (*known)->push) *known = &one;
    }
    parts.push_back((both[1].bias - both[0].bias) * towards);
    parts.push_back((both[1].rest - both[0].rest) * towards);
    const auto main = insight::main_part(parts);
    if (!main) return c;
    if (*main >= sources.size()) {
        c.by = *main == sources.size() ? Cause::By::biases : Cause::By::rest;
        return c;
    }
    const Contribution& one = *sources[*main];
    c.by = one.by, c.product = one.product, c.name = one.name, c.value = one.value, c.holds_back = one.value < 0;
    return c;
}

const Recognised& recognised(Recognised& known, const Snapshot& now, const VehicleView& vehicle, double wall_seconds) {
    const auto& brain = brain_of(now, vehicle);
    const bool same = known.brain == brain && known.vehicle == vehicle.id && known.scene == now.scene;
    if (same && std::fabs(wall_seconds - known.at) < recognition_period) return known;
    auto readings = rounded_readings(readings_beside_pairs(now, vehicle));
    known.at = wall_seconds;
    if (same && readings == known.readings) return known;
    known.pairs = characters_of(*brain, kind_of(now, vehicle), readings);
    known.single.reset();
    const auto& sensors = kind_of(now, vehicle).sensors;
    if ((known.pairs.empty() && has_eyes_of_one_channel(sensors)) || !reads_a_sensor(*brain))
        known.single = recognise(*brain, {}, readings);
    known.brain = brain;
    known.vehicle = vehicle.id;
    known.scene = now.scene;
    known.readings = std::move(readings);
    return known;
}

std::optional<Character> shown_character(const Recognised& known, const Snapshot& now, const VehicleView& vehicle,
                                         const SensorPair& pair) {
    std::optional<Character> character = known.single;
    for (const PairCharacter& each : known.pairs)
        if (each.pair.sensors == pair && each.is_wired) character = each.character;
    const bool says_little =
        character == Character::still || character == Character::indifferent || character == Character::mixed;
    if (says_little && has_neurons(*brain_of(now, vehicle))) return std::nullopt;
    return character;
}

std::string_view character_key(const Recognised& known, const Snapshot& now, const VehicleView& vehicle,
                               const SensorPair& pair) {
    if (const auto shown = shown_character(known, now, vehicle, pair)) return name(*shown);
    return has_neurons(*brain_of(now, vehicle)) ? "parts" : "single_sensors";
}

}  // namespace braitenlab::ui

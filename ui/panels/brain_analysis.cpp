#include "ui/panels/brain_analysis.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/brain/four_neurons.h"
#include "ui/panels/brain_analysis.h"

namespace braitenlab::ui {

namespace {

constexpr float rounding_error = 1e-4f;
constexpr float least_push = 0.005f;  // smaller contributions are 0.00 on the screen

Product product_of(const Snapshot& now, const VehicleView& vehicle, const char* sensor, const char* motor, Dial dial,
                   std::string_view letters) {
    const BrainGraph& brain = *brain_of(now, vehicle);
    Product p{letters};
    const Node* from = find_node(brain, std::string(sensor));
    const Node* to = find_node(brain, std::string(motor));
    if (!from || !to) return p;
    const float reading = node_value(now, vehicle, from->id);
    p.input = reading;
    p.weight = at(read_dials(brain), dial);
    if (const Wire* wire = find_wire(brain, from->id, to->id)) {
        p.input = let_through(*wire, reading);
        p.weight += learned(now, vehicle, from->id, to->id);
        p.cut = wire->cut;
        p.masked = std::fabs(reading) < wire->threshold;
        p.value = p.cut ? 0.0f : p.input * p.weight;
    }
    return p;
}

// True when the two products and the bias are the whole sum: two sensors, two motors and wires between them, with any
// curves and lesions.
bool is_plain(const BrainGraph& brain) {
    const auto plain_node = [](const Node& n) {
        const bool known = n.kind == NodeKind::sensor ? n.name == "SL" || n.name == "SR" : n.kind == NodeKind::motor;
        return known && n.curve == Curve{} && n.time_constant == 0;
    };
    const auto plain_wire = [&](const Wire& w) {
        const Node* from = find_node(brain, w.from);
        return from && from->kind == NodeKind::sensor;
    };
    return std::all_of(brain.nodes.begin(), brain.nodes.end(), plain_node) &&
           std::all_of(brain.wires.begin(), brain.wires.end(), plain_wire);
}

}  // namespace

std::array<MotorSum, 2> motor_sums(const Snapshot& now, const VehicleView& vehicle) {
    const BrainGraph& brain = *brain_of(now, vehicle);
    const FourNeurons dials = read_dials(brain);
    const auto make = [&](const char* sensor, const char* motor, Dial dial, std::string_view letters) {
        return product_of(now, vehicle, sensor, motor, dial, letters);
    };
    MotorSum left{"ML", "LM", {make("SL", "ML", Dial::LL, "SL·LL"), make("SR", "ML", Dial::LR, "SR·LR")}, dials.LM};
    MotorSum right{"MR", "RM", {make("SR", "MR", Dial::RR, "SR·RR"), make("SL", "MR", Dial::RL, "SL·RL")}, dials.RM};
    left.total = vehicle.motor[0];
    right.total = vehicle.motor[1];
    std::array<MotorSum, 2> both{left, right};
    const bool plain = is_plain(brain);
    for (MotorSum& sum : both) {
        const Node* motor = find_node(brain, std::string(sum.motor));
        sum.stopped = motor && motor->silenced;
        if (!motor || sum.stopped) continue;
        const float shown = sum.products[0].value + sum.products[1].value + sum.bias;
        // The motor's state is not limited to −1..1.
        if (!plain) sum.others = node_value(now, vehicle, motor->id) - shown;
        sum.limited = std::fabs(shown + sum.others) > 1.0f + rounding_error;
    }
    both[0].more_wires = both[1].more_wires = !plain;
    return both;
}

Cause cause(const std::array<MotorSum, 2>& both) {
    Cause c;
    c.difference = both[1].total - both[0].total;
    const float towards = c.difference > 0 ? 1.0f : -1.0f;
    float largest = least_push;
    const auto claim = [&](Cause::By by, float push) {
        if (push <= largest) return false;
        largest = push;
        c.by = by;
        return true;
    };
    claim(Cause::By::biases, (both[1].bias - both[0].bias) * towards);
    claim(Cause::By::others, (both[1].others - both[0].others) * towards);
    for (const float side : {-1.0f, 1.0f})
        for (const Product& p : both[side > 0 ? 1 : 0].products)
            if (claim(Cause::By::product, p.value * side * towards)) {
                c.product = &p;
                c.holds_back = p.value < 0;
            }
    return c;
}

namespace {

constexpr double recognition_period = 0.25;  // wall seconds

std::vector<Reading> rounded_readings(std::vector<Reading> readings) {
    for (Reading& reading : readings) reading.value = std::round(reading.value * 20) / 20;
    return readings;
}

}  // namespace

Character recognised(Recognised& known, const Snapshot& now, const VehicleView& vehicle, double wall_seconds) {
    const auto& brain = brain_of(now, vehicle);
    const bool same = known.brain == brain && known.vehicle == vehicle.id;
    if (same && std::fabs(wall_seconds - known.at) < recognition_period) return known.character;
    auto readings = rounded_readings(readings_beside_pairs(now, vehicle));
    known.at = wall_seconds;
    if (same && readings == known.readings) return known.character;
    known.character = recognise(*brain, {}, readings);
    known.brain = brain;
    known.vehicle = vehicle.id;
    known.readings = std::move(readings);
    return known.character;
}

}  // namespace braitenlab::ui

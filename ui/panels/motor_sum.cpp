#include "ui/panels/motor_sum.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/brain/four_neurons.h"

namespace braitenlab {

namespace {

constexpr float just_over = 1e-4f;    // rounding alone
constexpr float least_push = 0.005f;  // below it, the two decimals on the screen show nothing

Product product(const Snapshot& now, const VehicleView& vehicle, const char* eye, const char* motor, Dial dial,
                std::string_view letters) {
    const BrainGraph& brain = *now.brains[static_cast<std::size_t>(vehicle.brain)];
    Product p{letters};
    const Node* from = find_node(brain, std::string(eye));
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

// Whether the two products and the bias are all there is: two eyes, two motors and wires from those to these, with
// whatever curves; lesions or not.
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
    const BrainGraph& brain = *now.brains[static_cast<std::size_t>(vehicle.brain)];
    const FourNeurons dials = read_dials(brain);
    const auto make = [&](const char* eye, const char* motor, Dial dial, std::string_view letters) {
        return product(now, vehicle, eye, motor, dial, letters);
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
        // From the motor's own state, which is not yet bounded to what a wheel can do.
        if (!plain) sum.others = node_value(now, vehicle, motor->id) - shown;
        sum.limited = std::fabs(shown + sum.others) > 1.0f + just_over;
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

}  // namespace braitenlab

#include "ui/wiring/inspected.h"

#include <utility>

#include "core/brain/edit.h"
#include "ui/strings.h"
#include "ui/wiring/number_sheet.h"
#include "ui/wiring/sum.h"

namespace braitenlab {

std::string_view Inspected::words(std::string_view key) const { return ui.strings(key); }

const Node* Inspected::node() const {
    const Caught& chosen = state.selection;
    const bool one = chosen.nodes.size() == 1 && chosen.wires.empty();
    return one ? find_node(graph(), *chosen.nodes.begin()) : nullptr;
}

std::optional<WireEnds> Inspected::wire() const {
    const Caught& chosen = state.selection;
    const bool one = chosen.wires.size() == 1 && chosen.nodes.empty();
    return one ? std::optional(*chosen.wires.begin()) : std::nullopt;
}

float Inspected::value(NodeId id) const { return node_value(*view.now, vehicle, id); }

float Inspected::learned_by(const Wire& wire) const {
    return learns(wire) ? learned(*view.now, vehicle, wire.from, wire.to) : 0;
}

void Inspected::ask(Command command, std::uint64_t gesture) {
    ui.outbox.push_back(EditRequest{std::move(command), gesture});
}

void Inspected::ask(const Edit& edit, std::uint64_t gesture) {
    if (edit) ask(SetBrain{target, in_place(*edit.graph, state.layout.of(brain, state.held))}, gesture);
}

void inspect_node(Inspected& in, const Node& node) {
    const float sum = sum_of(
        in.graph(), node.id, [&](NodeId id) { return in.value(id); },
        [&](const Wire& wire) { return in.learned_by(wire); });
    Node wanted = node;
    NumberSheet sheet(in, wanted.curve, {sum, node.silenced, "wiring.do.silence"});
    sheet.number({"inspector.bias", "inspector.bias", "inspector.bias_how", -1, 1, 1, true}, wanted.bias);
    sheet.number({"inspector.memory", "inspector.memory", "inspector.memory_how", 0, 5, 600}, wanted.time_constant);
    sheet.curve_numbers(wanted.curve, false);
    const bool is_motor = node.kind == NodeKind::motor;
    if (is_motor && wanted.bias != node.bias)
        in.ask(TurnDial{in.target, node.name == "ML" ? Dial::LM : Dial::RM, wanted.bias}, sheet.gesture());
    else if (wanted != node)
        in.ask(set_parameters(in.graph(), wanted), sheet.gesture());
}

namespace {

// The wire with these numbers; a free place becomes a wire first.
Edit replaced(const BrainGraph& graph, const Wire& wanted) {
    const WireEnds ends{wanted.from, wanted.to};
    const bool there = find_wire(graph, ends.from, ends.to) != nullptr;
    const Edit made = there ? Edit(graph) : set_weight(graph, ends, 0);
    return made ? set_parameters(*made.graph, wanted) : made;
}

}  // namespace

void inspect_wire(Inspected& in, WireEnds ends) {
    const Wire* found = find_wire(in.graph(), ends.from, ends.to);
    const Wire wire = found != nullptr ? *found : Wire{.from = ends.from, .to = ends.to, .weight = 0};
    Wire wanted = wire;
    NumberSheet sheet(in, wanted.curve, {masked(in.value(ends.from), wire.threshold), wire.cut, "wiring.do.sever"});
    sheet.number({"inspector.weight", "inspector.weight", "inspector.weight_how", -2, 2, 2, true}, wanted.weight);
    sheet.number({"inspector.threshold", "inspector.threshold", "inspector.threshold_how", 0, 1, 1}, wanted.threshold);
    sheet.number({"inspector.learning", "inspector.learning", "inspector.learning_how", 0, 2, 10},
                 wanted.learning_rate);
    sheet.number({"inspector.decay", "inspector.decay", "inspector.decay_how", 0, 2, 10}, wanted.decay);
    sheet.curve_numbers(wanted.curve, true);
    const auto dial = direct_dial(in.graph(), ends);
    if (dial && wanted.weight != wire.weight)
        in.ask(TurnDial{in.target, *dial, wanted.weight}, sheet.gesture());
    else if (dial && wanted.threshold != wire.threshold)
        in.ask(TurnDial{in.target, threshold_of(*dial), wanted.threshold}, sheet.gesture());
    else if (wanted != wire)
        in.ask(replaced(in.graph(), wanted), sheet.gesture());
}

}  // namespace braitenlab

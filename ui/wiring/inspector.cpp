#include "ui/wiring/inspector.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/brain/four_neurons.h"
#include "ui/widgets/button.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/wiring/menu.h"
#include "ui/wiring/node_text.h"
#include "ui/words/strings.h"

namespace braitenlab::wiring {

using namespace ui;

namespace {

// The parameters of a neuron or motor.
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
        in.send(TurnDial{in.target, node.name == "ML" ? Dial::LM : Dial::RM, wanted.bias}, sheet.gesture());
    else if (wanted != node)
        in.send(set_parameters(in.graph(), wanted), sheet.gesture());
}

// The brain with these parameters of the wire, which is added where there is none.
Edit with_wire(const BrainGraph& graph, const Wire& wanted) {
    const WireEnds ends{wanted.from, wanted.to};
    const bool there = find_wire(graph, ends.from, ends.to) != nullptr;
    const Edit made = there ? Edit(graph) : set_weight(graph, ends, 0);
    return made ? set_parameters(*made.graph, wanted) : made;
}

// The parameters of a wire or of a direct place without a wire.
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
        in.send(TurnDial{in.target, *dial, wanted.weight}, sheet.gesture());
    else if (dial && wanted.threshold != wire.threshold)
        in.send(TurnDial{in.target, threshold_of(*dial), wanted.threshold}, sheet.gesture());
    else if (wanted != wire)
        in.send(with_wire(in.graph(), wanted), sheet.gesture());
}

std::string node_heading(const Inspected& in, const Node& node) {
    const float value = shown_value(node, in.value(node.id));
    const std::string now = node.kind == NodeKind::sensor ? fixed(in.ui, value, 2) : with_sign(in.ui, value, 2);
    const bool outer = node.kind != NodeKind::neuron;  // the description on the card is small
    return short_name(kind_of(*in.view.now, in.vehicle).sensors, node.name) + "  ·  " +
           (outer ? std::string(in.words(description_key(*in.view.now, in.vehicle, node))) + "  ·  " : "") +
           fill(in.words(node.silenced ? "inspector.silenced" : "inspector.stands_at"), {now});
}

std::string wire_heading(const Inspected& in, WireEnds ends) {
    const std::string name = short_wire_name(kind_of(*in.view.now, in.vehicle).sensors, in.graph(), ends) + "  ·  ";
    const Wire* wire = find_wire(in.graph(), ends.from, ends.to);
    if (wire != nullptr && wire->cut) return name + std::string(in.words("inspector.severed"));
    const float learnt = wire == nullptr ? 0 : in.learned_by(*wire);
    const float carried = wire == nullptr ? 0 : signal(*wire, in.value(ends.from), learnt);
    std::string text = name + fill(in.words("inspector.carries"), {with_sign(in.ui, carried, 2)});
    if (wire != nullptr && learns(*wire))
        text += "  ·  " + fill(in.words("inspector.learned"), {with_sign(in.ui, learnt, 2)});
    return text;
}

std::string heading(const Inspected& in) {
    if (const Node* node = in.node()) return node_heading(in, *node);
    if (const auto ends = in.wire()) return wire_heading(in, *ends);
    return std::string(in.words("inspector.heading"));
}

// Moves the keyboard focus to the first number after the menu row or Enter that edits the numbers.
void take_keyboard(Inspected& in) {
    if (!std::exchange(in.state.edit_numbers, false) || in.ui.keyboard == nullptr) return;
    in.ui.keyboard->focus = in.wire() ? "inspector.weight" : "inspector.bias";
    in.ui.keyboard->revealed = true;
}

void show_sensor(Inspected& in, const Node& node) {
    lesion_button(in, node.silenced, "wiring.do.silence");
    paragraph(in.ui, in.words("inspector.sensor"), in.ui.palette.second_text, Face::small);
}

// "4 neurons", "1 neuron". String keys.
std::string counted(const Inspected& in, std::ptrdiff_t number, std::string_view one, std::string_view many) {
    return fill(in.words(number == 1 ? one : many), {std::to_string(number)});
}

void show_many(Inspected& in) {
    Ui& ui = in.ui;
    const CanvasSelection& chosen = in.state.selection;
    const auto nodes = std::ssize(chosen.nodes), wires = std::ssize(chosen.wires);
    paragraph(ui,
              fill(in.words("inspector.many"), {counted(in, nodes, "inspector.one_node", "inspector.nodes"),
                                                counted(in, wires, "inspector.one_wire", "inspector.wires")}),
              ui.palette.second_text, Face::small);
    const float left = ImGui::GetCursorScreenPos().x, right = left + ImGui::GetContentRegionAvail().x;
    float x = left;
    for (const MenuRow& row : menu_rows(in.graph(), chosen, false)) {
        const ButtonLook look{{}, in.words(row.words)};
        const float width = button_width(ui, look);
        if (x + width >= right)
            x = left;
        else if (x > left)
            ImGui::SameLine();
        const std::string name(row.words.substr(row.words.rfind('.') + 1));
        if (button(ui, "inspector." + name, look).pressed) in.state.hovered = {}, in.state.chosen_row = row;
        x += width + ui.px(spacing::small);
    }
}

void show_nothing(Inspected& in) {
    const auto of_kind = [&](NodeKind kind) {
        return std::count_if(in.graph().nodes.begin(), in.graph().nodes.end(),
                             [kind](const Node& node) { return node.kind == kind; });
    };
    const auto wires = std::count_if(in.graph().wires.begin(), in.graph().wires.end(),
                                     [](const Wire& w) { return w.weight != 0 || learns(w); });
    const std::string counts =
        counted(in, of_kind(NodeKind::sensor), "inspector.one_sensor", "inspector.sensors") + "  ·  " +
        counted(in, of_kind(NodeKind::neuron), "inspector.one_neuron", "inspector.neurons") + "  ·  " +
        counted(in, of_kind(NodeKind::motor), "inspector.one_motor", "inspector.motors") + "  ·  " +
        counted(in, wires, "inspector.one_wire", "inspector.wires");
    paragraph(in.ui, in.words("inspector.nothing"), in.ui.palette.text, Face::text);
    paragraph(in.ui, counts, in.ui.palette.second_text, Face::small);
    const std::string_view keys = in.words("inspector.keys");
    const auto lines = static_cast<float>(lines_of_words(in.ui, keys, Face::small, card_width(in.ui)).size());
    const bool has_room = ImGui::GetContentRegionAvail().y >= lines * line_height(in.ui, Face::small);
    if (has_room && !in.view.program.touch) paragraph(in.ui, keys, in.ui.palette.second_text, Face::small);
}

void show(Inspected& in) {
    take_keyboard(in);
    if (const Node* node = in.node())
        node->kind == NodeKind::sensor ? show_sensor(in, *node) : inspect_node(in, *node);
    else if (const auto ends = in.wire())
        inspect_wire(in, *ends);
    else if (in.state.selection.nodes.size() + in.state.selection.wires.size() > 1)
        show_many(in);
    else
        show_nothing(in);
}

}  // namespace

Rect inspector_rect(const Ui& ui, const CanvasState& state, Rect canvas) {
    const float most = ui.finger > 0 ? 0.45f : 0.4f;  // of the height
    const float open = std::min(sheet_height(ui, canvas.w - ui.px(2 * spacing::large)), canvas.h * most);
    const float height = state.inspector.folded ? folded_height(ui) : open;
    return {canvas.x, canvas.y + canvas.h - height, canvas.w, height};
}

void draw_inspector(const LabView& view, CanvasState& state, SliderState& sliders, Ui& ui, Rect rect) {
    const VehicleView* vehicle = selected_vehicle(view);
    if (vehicle == nullptr || vehicle->brain < 0 || hides_brain(view, vehicle->kind)) return;
    Inspected in{view, *vehicle, brain_of(*view.now, *vehicle), state, sliders, ui, target_of(view, *vehicle)};
    if (begin_card(ui, state.inspector, "card.inspector", heading(in), rect)) {
        if (view.lecture) gap(ui, spacing::tight);  // below the heading, whose type is large
        show(in);
    }
    end_card(ui, state.inspector);
}

}  // namespace braitenlab::wiring

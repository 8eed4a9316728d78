#include "ui/wiring/inspector.h"

#include <algorithm>
#include <array>
#include <string>

#include <imgui.h>

#include "ui/strings.h"
#include "ui/theme.h"
#include "ui/widgets/button.h"
#include "ui/widgets/item.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/wiring/actions.h"
#include "ui/wiring/curve_plot.h"
#include "ui/wiring/sum.h"

namespace braitenlab {
namespace {

using maths::vec2;

constexpr float card_height = 160, plot_side = 104, kind_width = 44, kind_height = 30, space = 16;  // layout pixels
constexpr float room_for_plot = 560;

// In the order of Response: the words of neuron_kinds().
constexpr int responses = 6;

bool has_peak(const Curve& c) {
    return c.response == Response::step || c.response == Response::sigmoid || c.response == Response::hump;
}
bool has_width(const Curve& c) { return c.response == Response::sigmoid || c.response == Response::hump; }

// One number of the node or wire, and how its slider looks.
struct Number {
    std::string_view words, tooltip;     // string keys; the first is its anchor too
    float value, low, high, typed_high;  // the slider's range, and how far a typed number may go
    bool is_signed = false;
};

class Inspector {
public:
    Inspector(const LabView& view, const VehicleView& vehicle, CanvasState& state, SliderState& sliders, Ui& ui)
        : view_(view),
          vehicle_(vehicle),
          brain_(view.now->brains[static_cast<std::size_t>(vehicle.brain)]),
          graph_(*brain_),
          state_(state),
          sliders_(sliders),
          ui_(ui) {
        if (view.whole_kind)
            target_.kind = vehicle.kind;
        else
            target_.vehicle = vehicle.id;
    }

    const Node* node() const {
        const bool one = state_.selection.nodes.size() == 1 && state_.selection.wires.empty();
        return one ? find_node(graph_, *state_.selection.nodes.begin()) : nullptr;
    }
    std::optional<WireEnds> wire() const {
        const bool one = state_.selection.wires.size() == 1 && state_.selection.nodes.empty();
        return one ? std::optional(*state_.selection.wires.begin()) : std::nullopt;
    }

    std::string heading() const {
        if (const Node* one = node()) return one->name + "  ·  " + node_words(*one);
        if (const auto ends = wire()) return wire_name(graph_, *ends) + "  ·  " + wire_words(*ends);
        return std::string(ui_.strings("inspector.heading"));
    }

    void draw() {
        take_keyboard();
        if (const Node* one = node())
            one->kind == NodeKind::sensor ? draw_sensor(*one) : draw_node(*one);
        else if (const auto ends = wire())
            draw_wire(*ends);
        else if (state_.selection.nodes.size() + state_.selection.wires.size() > 1)
            draw_many();
        else
            draw_nothing();
    }

private:
    float value(NodeId id) const { return node_value(*view_.now, vehicle_, id); }
    float learned_by(const Wire& wire) const {
        return learns(wire) ? learned(*view_.now, vehicle_, wire.from, wire.to) : 0;
    }
    std::string_view words(std::string_view key) const { return ui_.strings(key); }

    std::string node_words(const Node& node) const {
        const std::string now = node.kind == NodeKind::sensor ? fixed(value(node.id), 2) : with_sign(value(node.id), 2);
        return fill(words(node.silenced ? "inspector.silenced" : "inspector.stands_at"), {now});
    }
    std::string wire_words(WireEnds ends) const {
        const Wire* wire = find_wire(graph_, ends.from, ends.to);
        if (wire != nullptr && wire->cut) return std::string(words("inspector.severed"));
        const float learnt = wire == nullptr ? 0 : learned_by(*wire);
        const float carried = wire == nullptr ? 0 : signal(*wire, value(ends.from), learnt);
        std::string text = fill(words("inspector.carries"), {with_sign(carried, 2)});
        if (wire != nullptr && learns(*wire))
            text += "  ·  " + fill(words("inspector.learned"), {with_sign(learnt, 2)});
        return text;
    }

    // The menu, or Enter, has asked for the numbers.
    void take_keyboard() {
        if (!std::exchange(state_.edit_numbers, false) || ui_.keyboard == nullptr) return;
        ui_.keyboard->focus = wire() ? "inspector.weight" : "inspector.bias";
        ui_.keyboard->revealed = true;
    }

    void ask(Command command, std::uint64_t gesture) { ui_.outbox.push_back(EditRequest{std::move(command), gesture}); }
    void ask(const Edit& edit, std::uint64_t gesture) {
        if (edit) ask(SetBrain{target_, in_place(*edit.graph, state_.layout.of(brain_, {}))}, gesture);
    }

    std::optional<SliderEdit> number(const Number& n, float width) {
        const std::string id(n.words);
        SliderLook look;
        look.words = words(n.words);
        look.tooltip = words(n.tooltip);
        look.low = n.low;
        look.high = sliders_.typed == id ? n.typed_high : n.high;
        look.signed_number = look.meaning = n.is_signed;
        look.words_width = words_width_;
        return slider(ui_, sliders_, id, n.value, width, view_.wall_seconds, look);
    }

    void plot(const Curve& curve, vec2 now) {
        if (!plots_) return;
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const Item area = item(ui_, "inspector.plot", {ui_.px(plot_side), ui_.px(plot_side)}, false);
        draw_plot(*ImGui::GetWindowDrawList(), ui_, plot_of(curve, {at.x, at.y, area.rect.w, area.rect.h}), curve, now);
        tooltip(ui_, area, words("inspector.plot_how"));
        ImGui::SameLine(0, ui_.px(space));
    }

    // The six curves to choose from and the lesion below them; the response that was chosen.
    std::optional<Response> curves(const Curve& curve, bool hurt, std::string_view hurt_words) {
        std::optional<Response> chosen;
        ImGui::BeginGroup();
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui_.px(4), ui_.px(4)});
        for (int i = 0; i < responses; ++i) {
            if (i % 3 != 0) ImGui::SameLine();
            if (kind_button(i, curve)) chosen = static_cast<Response>(i);
        }
        lesion_button(hurt, hurt_words);
        ImGui::PopStyleVar();
        ImGui::EndGroup();
        ImGui::SameLine(0, ui_.px(space));
        return chosen;
    }

    bool kind_button(int index, const Curve& curve) {
        const Item at =
            item(ui_, "inspector.kind." + std::to_string(index + 1), {ui_.px(kind_width), ui_.px(kind_height)});
        const Palette& p = ui_.palette;
        const bool on = static_cast<int>(curve.response) == index;
        fill_box(ui_, at.rect, on ? mix(p.panel, p.accent, 0.20f) : mix(p.raised, p.line, at.warmth * 0.6f));
        line_box(ui_, at.rect, on ? p.accent : p.line);
        const float inset = ui_.px(6);
        draw_curve_sign(*ImGui::GetWindowDrawList(), ui_,
                        {at.rect.x + inset, at.rect.y + inset, at.rect.w - 2 * inset, at.rect.h - 2 * inset},
                        neuron_kinds()[static_cast<std::size_t>(index)].made.curve, on ? p.text : p.second_text);
        tooltip(ui_, at, ui_.strings(neuron_kinds()[static_cast<std::size_t>(index)].words));
        return at.pressed && !on;
    }

    void lesion_button(bool hurt, std::string_view key) {
        ButtonLook look{{}, ui_.strings(hurt ? "wiring.do.heal" : key)};
        look.on = hurt;
        look.min_width = 3 * kind_width + 8;
        const Item at = button(ui_, "inspector.lesion", look);
        tooltip(ui_, at, words("inspector.lesion_how"));
        if (at.pressed) for_selection(), state_.keys.push_back(Action::lesion);
    }

    // What the card's buttons do is for what is selected, wherever the pointer rests meanwhile.
    void for_selection() { state_.hovered = {}; }

    // Two sliders side by side, row by row.
    class Rows {
    public:
        Rows(const Ui& ui, float width) : ui_(ui), each_((width - ui.px(space)) / 2) { ImGui::BeginGroup(); }
        ~Rows() {
            if (count_ == 0) ImGui::Dummy({1, 1});
            ImGui::EndGroup();
        }
        Rows(const Rows&) = delete;
        Rows& operator=(const Rows&) = delete;
        float next() {
            if (count_++ % 2 == 1) ImGui::SameLine(0, ui_.px(space));
            return each_;
        }

    private:
        const Ui& ui_;
        float each_;
        int count_ = 0;
    };

    float left_over() const {
        const float taken = (plots_ ? plot_side + space : 0) + 3 * kind_width + 8 + space;
        return ImGui::GetContentRegionAvail().x + ImGui::GetCursorPosX() - start_ - ui_.px(taken + 12);
    }

    void begin_columns() {
        start_ = ImGui::GetCursorPosX();
        plots_ = ImGui::GetContentRegionAvail().x > ui_.px(room_for_plot);
        width_ = left_over();
        words_width_ = 0;
        for (const char* key : {"inspector.weight", "inspector.threshold", "inspector.bias", "inspector.memory",
                                "inspector.peak", "inspector.width", "inspector.learning", "inspector.decay"})
            words_width_ = std::max(words_width_, text_width(ui_, Face::text, words(key)) / ui_.scale + 8);
    }

    void shape_numbers(Rows& rows, Curve& curve, std::uint64_t& gesture) {
        if (has_peak(curve))
            if (const auto e =
                    number({"inspector.peak", "inspector.peak_how", curve.peak, -2, 2, 2, true}, rows.next()))
                curve.peak = e->value, gesture = e->gesture;
        if (has_width(curve))
            if (const auto e =
                    number({"inspector.width", "inspector.width_how", curve.width, 0.01f, 2, 10}, rows.next()))
                curve.width = e->value, gesture = e->gesture;
    }

    void draw_node(const Node& node) {
        begin_columns();
        const auto read_value = [this](NodeId id) { return value(id); };
        const float sum = sum_of(graph_, node.id, read_value, [this](const Wire& wire) { return learned_by(wire); });
        plot(node.curve, {sum, respond(node.curve, sum)});
        Node wanted = node;
        std::uint64_t gesture = 0;
        if (const auto kind = curves(node.curve, node.silenced, "wiring.do.silence"))
            wanted.curve.response = *kind, gesture = state_.next_gesture++;
        Rows rows(ui_, width_);
        const bool is_motor = node.kind == NodeKind::motor;
        if (const auto e = number({"inspector.bias", "inspector.bias_how", node.bias, -1, 1, 1, true}, rows.next())) {
            if (is_motor) return ask(TurnDial{target_, node.name == "ML" ? Dial::LM : Dial::RM, e->value}, e->gesture);
            wanted.bias = e->value, gesture = e->gesture;
        }
        if (const auto e =
                number({"inspector.memory", "inspector.memory_how", node.time_constant, 0, 5, 600}, rows.next()))
            wanted.time_constant = e->value, gesture = e->gesture;
        shape_numbers(rows, wanted.curve, gesture);
        if (wanted != node) ask(replace(graph_, wanted), gesture);
    }

    void draw_wire(WireEnds ends) {
        begin_columns();
        const Wire* found = find_wire(graph_, ends.from, ends.to);
        Wire wire;
        wire.from = ends.from, wire.to = ends.to, wire.weight = 0;
        if (found != nullptr) wire = *found;
        const float input = std::abs(value(ends.from)) < wire.threshold ? 0.0f : value(ends.from);
        plot(wire.curve, {input, respond(wire.curve, input)});
        Wire wanted = wire;
        std::uint64_t gesture = 0;
        if (const auto kind = curves(wire.curve, wire.cut, "wiring.do.sever"))
            wanted.curve.response = *kind, gesture = state_.next_gesture++;
        Rows rows(ui_, width_);
        const auto dial = direct_dial(graph_, ends);
        if (const auto e =
                number({"inspector.weight", "inspector.weight_how", wire.weight, -2, 2, 2, true}, rows.next())) {
            if (dial) return ask(TurnDial{target_, *dial, e->value}, e->gesture);
            wanted.weight = e->value, gesture = e->gesture;
        }
        if (const auto e =
                number({"inspector.threshold", "inspector.threshold_how", wire.threshold, 0, 1, 1}, rows.next())) {
            if (dial) return ask(TurnDial{target_, threshold_of(*dial), e->value}, e->gesture);
            wanted.threshold = e->value, gesture = e->gesture;
        }
        if (const auto e =
                number({"inspector.learning", "inspector.learning_how", wire.learning_rate, 0, 2, 10}, rows.next()))
            wanted.learning_rate = e->value, gesture = e->gesture;
        if (const auto e = number({"inspector.decay", "inspector.decay_how", wire.decay, 0, 2, 10}, rows.next()))
            wanted.decay = e->value, gesture = e->gesture;
        shape_numbers(rows, wanted.curve, gesture);
        if (wanted != wire) ask_wire(wanted, gesture);
    }

    // A free place becomes a wire when it gets numbers.
    void ask_wire(const Wire& wanted, std::uint64_t gesture) {
        const WireEnds ends{wanted.from, wanted.to};
        const bool there = find_wire(graph_, ends.from, ends.to) != nullptr;
        const Edit made = there ? Edit{graph_, {}} : set_weight(graph_, ends, 0);
        if (made) ask(replace(*made.graph, wanted), gesture);
    }

    void draw_sensor(const Node& node) {
        lesion_button(node.silenced, "wiring.do.silence");
        paragraph(ui_, words("inspector.sensor"), ui_.palette.second_text, Face::small);
    }

    void draw_many() {
        const Caught& chosen = state_.selection;
        paragraph(
            ui_,
            fill(words("inspector.many"), {std::to_string(chosen.nodes.size()), std::to_string(chosen.wires.size())}),
            ui_.palette.second_text, Face::small);
        const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
        float x = ImGui::GetCursorScreenPos().x;
        for (const MenuRow& row : menu_rows(graph_, chosen, false)) {
            const ButtonLook look{{}, ui_.strings(row.words)};
            const float width = button_width(ui_, look);
            if (x + width < right && x > right - ImGui::GetContentRegionAvail().x) ImGui::SameLine();
            if (x + width >= right) x = right - ImGui::GetContentRegionAvail().x;
            const std::string name(row.words.substr(row.words.rfind('.') + 1));
            if (button(ui_, "inspector." + name, look).pressed) for_selection(), state_.wanted = row;
            x += width + ui_.px(8);
        }
    }

    void draw_nothing() {
        int counts[3] = {0, 0, 0};
        for (const Node& node : graph_.nodes) ++counts[static_cast<int>(node.kind)];
        const auto wires = std::count_if(graph_.wires.begin(), graph_.wires.end(),
                                         [](const Wire& w) { return w.weight != 0 || learns(w); });
        paragraph(ui_, words("inspector.nothing"), ui_.palette.text, Face::text);
        paragraph(ui_,
                  fill(words("inspector.counts"), {std::to_string(counts[0]), std::to_string(counts[1]),
                                                   std::to_string(counts[2]), std::to_string(wires)}),
                  ui_.palette.second_text, Face::small);
        paragraph(ui_, words("inspector.keys"), ui_.palette.second_text, Face::small);
    }

    const LabView& view_;
    const VehicleView& vehicle_;
    std::shared_ptr<const BrainGraph> brain_;
    const BrainGraph& graph_;
    CanvasState& state_;
    SliderState& sliders_;
    Ui& ui_;
    Target target_;
    bool plots_ = true;
    float start_ = 0, width_ = 0, words_width_ = 64;
};

}  // namespace

Rect inspector_place(const Ui& ui, const CanvasState& state, Rect canvas) {
    const float open = std::min(ui.px(card_height), canvas.h * 0.4f);
    const float height = state.inspector.folded ? folded_height(ui) : open;
    return {canvas.x, canvas.y + canvas.h - height, canvas.w, height};
}

void wiring_inspector(const LabView& view, CanvasState& state, SliderState& sliders, Ui& ui, Rect place) {
    const VehicleView* vehicle = find_vehicle(*view.now, view.selected);
    if (vehicle == nullptr || vehicle->brain < 0) return;
    Inspector inspector(view, *vehicle, state, sliders, ui);
    const std::string heading = inspector.heading();
    if (begin_card(ui, state.inspector, "card.inspector", heading, place)) inspector.draw();
    end_card(state.inspector);
}

}  // namespace braitenlab

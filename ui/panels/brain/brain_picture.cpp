// The picture of a brain, seen from above, with the current signals on its wires: the four wires of the chosen pair, or
// the whole graph if there are more. A click on a sensor, neuron, wire or wheel silences, cuts or stops it; a second
// click heals it.
#include <algorithm>
#include <map>
#include <string>

#include <imgui.h>

#include "core/brain/four_neurons.h"
#include "core/scene/sensor_edits.h"
#include "ui/panels/brain/brain_layout.h"
#include "ui/panels/panels.h"
#include "ui/panels/signal_drag.h"
#include "ui/shortcuts.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/wiring/node_text.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

using sketch::NodeMark;
using sketch::WireMark;

// Layout pixels.
constexpr float reach_of_wire = 7;
constexpr float reach_of_pair = 86;         // from the middle to the numbers of the motors
constexpr float from_eye_to_its_name = 44;  // with a pair

class BrainPicture {
public:
    BrainPicture(const LabView& view, PanelState& state, Ui& ui, const VehicleView& vehicle, float layout_height)
        : view_(view),
          state_(state),
          ui_(ui),
          vehicle_(vehicle),
          brain_(*brain_of(*view.now, vehicle)),
          pair_(shown_pair(view, vehicle)),
          is_graph_(!sketch::is_four_wires(brain_, pair_)),
          unit_(ui.px(1)) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        all_ = {at.x, at.y, card_width(ui), ui.px(brain_picture_height(view, vehicle, layout_height))};
        if (!is_graph_)
            unit_ = std::min(
                ui.px(1), (all_.w / 2 - text_width(ui, Face::small, with_sign(ui, 1, 2)) - ui.px(2)) / reach_of_pair);
        parts_ = is_graph_ ? sketch::lay_out_graph(brain_, kind_of(*view.now, vehicle), pair_, all_, ui.px(1))
                           : sketch::lay_out_pair(brain_, pair_, all_, unit_);
        for (const NodeMark& sensor : parts_.sensors)
            is_crowded_ |= text_width(ui, is_graph_ ? Face::label : Face::small, full_name(sensor)) > room_of_name();
    }

    void draw() {
        fill_box(ui_, all_, ui_.palette.ground.with_alpha(0.45f));
        fill_box(ui_, parts_.chassis, mix(ui_.palette.panel, ui_.palette.chassis, 0.22f));
        line_box(ui_, parts_.chassis, colour_of(ui_.palette, vehicle_.role), Corner::box, 1.5f);
        for (const NodeMark& sensor : parts_.sensors)
            node(sensor, {ui_.px(24), ui_.px(24)}, "lesion.eye", "lesion.eye_hurt");
        for (const NodeMark& motor : parts_.motors)
            node(motor, {ui_.px(24), ui_.px(46)}, "lesion.motor", "lesion.motor_hurt");
        for (const NodeMark& neuron : parts_.neurons)
            node(neuron, {ui_.px(24), ui_.px(24)}, "lesion.neuron", "lesion.neuron_hurt");
        wires();
        strokes();
        const bool is_on_button = watch_button();
        ImGui::SetCursorScreenPos({all_.x, all_.y});
        const Item area = item(ui_, "brain.picture", {all_.w, all_.h}, false);
        if (state_.brain.lesion_under_pointer.empty() && !is_on_button)
            tooltip(ui_, area, ui_.strings("brain.picture"));
        heal();
    }

private:
    // The value of a node; 0 for a silenced one and for a node that the brain does not have.
    float reading(const Node* node) const {
        return node && !node->silenced ? node_value(*view_.now, vehicle_, node->id) : 0;
    }

    // True when a lesion of this part is requested: by a click, Enter, or L over it.
    bool lesion_requested(const Item& at, bool over, const std::string& anchor) {
        if (over) state_.brain.lesion_under_pointer = anchor;
        const bool by_key = state_.brain.lesion_requested == anchor;
        if (by_key) state_.brain.lesion_requested.clear();
        return at.pressed || by_key;
    }

    // A node as a widget over what strokes() draws. `words`, `words_hurt`: string keys of its tooltip.
    void node(const NodeMark& which, ImVec2 size, std::string_view words, std::string_view words_hurt) {
        if (!which.node) return;
        ImGui::SetCursorScreenPos({which.at.x - size.x / 2, which.at.y - size.y / 2});
        const Item at = item(ui_, which.anchor, size);
        drag_signal(state_, ui_, at.held, which.name);
        if (at.warmth > 0) warmth_[which.node->id] = at.warmth;
        if (at.hovered) {
            const std::string value = which.node->silenced ? "" : "  " + fixed(ui_, reading(which.node), 2);
            const Sensor* sensor = find_sensor(sensors(), which.name);
            const std::string name = sensor ? sensor_label(ui_, sensors(), *sensor) : which.name;
            tooltip(ui_, at, fill(ui_.strings(which.node->silenced ? words_hurt : words), {name + value}),
                    ui_.strings("lesion.key"));
        }
        BrainGraph edited = brain_;
        find_node(edited, which.name)->silenced = !which.node->silenced;
        if (at.hovered) try_out(edited);
        if (lesion_requested(at, at.hovered, which.anchor)) set(std::move(edited));
    }

    // The wire in the brain; null for a place without one, or with weight 0.
    const Wire* wire_of(const WireMark& mark) const {
        if (mark.wire < 0) return nullptr;
        const Wire& wire = brain_.wires[static_cast<std::size_t>(mark.wire)];
        return wire.weight != 0 || wire.cut || learns(wire) ? &wire : nullptr;
    }

    // Wires. The widget is the sign at the end, for the keyboard and for tests; the mouse takes a wire anywhere.
    void wires() {
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        const bool free = state_.brain.lesion_under_pointer.empty() && all_.contains(mouse.x, mouse.y) &&
                          ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
        float nearest = ui_.px(reach_of_wire);
        for (const WireMark& mark : parts_.wires) {
            if (!free || !wire_of(mark)) continue;
            if (const float d = sketch::distance(mark.path, mouse); d < nearest) nearest = d, warm_ = &mark;
        }
        for (const WireMark& mark : parts_.wires) {
            const Wire* wire = wire_of(mark);
            if (!wire) continue;
            const float size = ui_.px(24);
            ImGui::SetCursorScreenPos({mark.path[3].x - size / 2, mark.path[3].y - size / 2});
            Item at = item(ui_, mark.anchor, {size, size});
            if (warm_ == &mark) {
                at.hovered = true;
                at.pressed |= ImGui::IsMouseClicked(0) && !at.held;
                const std::string name =
                    wiring::short_wire_name(sensors(), brain_, {wire->from, wire->to}, shown_pair(view_, vehicle_));
                tooltip(ui_, at, fill(ui_.strings(wire->cut ? "lesion.wire_hurt" : "lesion.wire"), {name}),
                        ui_.strings("lesion.key"));
            } else if (at.pressed && !at.entered) {
                at.pressed = false;  // another wire is nearer to the pointer
            }
            if (warm_ == &mark) try_out(cut_or_healed(*wire));
            if (lesion_requested(at, warm_ == &mark, mark.anchor)) set(cut_or_healed(*wire));
        }
    }

    BrainGraph cut_or_healed(const Wire& wire) const {
        BrainGraph edited = brain_;
        find_wire(edited, wire.from, wire.to)->cut = !wire.cut;
        return edited;
    }

    // The path with this brain is shown while the pointer is here.
    void try_out(const BrainGraph& edited) { state_.brain.what_if = {SetBrain{target_of(view_, vehicle_), edited}}; }

    void strokes() {
        for (const WireMark& mark : parts_.wires) {
            sketch::WireLook look;
            look.warm = warm_ == &mark;
            look.thin = is_graph_;
            if (const Wire* wire = wire_of(mark)) {
                const float plus = learns(*wire) ? learned(*view_.now, vehicle_, wire->from, wire->to) : 0;
                look.weight = wire->weight + plus;
                look.cut = wire->cut;
                look.carried = signal(*wire, reading(find_node(brain_, wire->from)), plus);
            }
            sketch::wire(ui_, mark.path, look);
        }
        for (const NodeMark& neuron : parts_.neurons)
            sketch::neuron(ui_, neuron.at, parts_.neuron_radius, reading(neuron.node), neuron.node->silenced,
                           warmth(neuron));
        for (std::size_t i = 0; i < parts_.sensors.size(); ++i) sensor(parts_.sensors[i], i == 0);
        for (std::size_t side = 0; side < 2; ++side) motor(side);
    }

    void sensor(const NodeMark& which, bool is_first) {
        const bool covered = which.node && which.node->silenced;
        sketch::eye(ui_, which.at, parts_.sensor_radius, reading(which.node), covered, warmth(which));
        if (!is_graph_) {
            const float out = is_first ? -1.0f : 1.0f;
            sketch::number(ui_, {which.at.x + out * unit_ * from_eye_to_its_name, which.at.y + ui_.px(6)}, is_first,
                           name_in_pair(which), covered ? "—" : fixed(ui_, reading(which.node), 2));
            return;
        }
        // Names of a crowded row may overlap. There the place of the sensor shows its side.
        std::string name = full_name(which);
        const Sensor* sensor = find_sensor(sensors(), which.name);
        // A symbol has space of its own on both sides.
        const float room = room_of_name() + (is_crowded_ ? ui_.px(7) : 0);
        const bool fits = text_width(ui_, Face::label, name) <= room;
        if (!fits && is_crowded_ && sensor && name != which.name) name = wiring::channel_symbol(sensor->channel);
        const float width = text_width(ui_, Face::label, name);
        if (width <= room)
            put(ui_, {which.at.x - width / 2, all_.y + ui_.px(1)}, name, ui_.palette.second_text, Face::label);
    }

    void motor(std::size_t side) {
        const NodeMark& which = parts_.motors[side];
        const bool stopped = which.node && which.node->silenced;
        const float out = side == 0 ? -1.0f : 1.0f;
        sketch::wheel(ui_, which.at, out, vehicle_.motor[side], vehicle_.wheel_angle[side], stopped, warmth(which));
        sketch::number(ui_, {which.at.x + out * unit_ * 32, which.at.y + ui_.px(4)}, side == 0, which.name,
                       with_sign(ui_, vehicle_.motor[side], 2));
    }

    float warmth(const NodeMark& which) const {
        const auto found = which.node ? warmth_.find(which.node->id) : warmth_.end();
        return found == warmth_.end() ? 0 : found->second;
    }

    const std::vector<Sensor>& sensors() const { return kind_of(*view_.now, vehicle_).sensors; }
    std::string full_name(const NodeMark& sensor) const { return wiring::short_name(sensors(), sensor.name); }
    // The symbol of the channel and the side, where there is no room for a longer name.
    std::string name_in_pair(const NodeMark& which) const {
        const Sensor* sensor = is_crowded_ ? find_sensor(sensors(), which.name) : nullptr;
        return sensor ? wiring::symbol_name(*sensor) : full_name(which);
    }
    // In the row of a graph, or of a pair beside its right eye.
    float room_of_name() const {
        const auto& sensors = parts_.sensors;
        const float least = ui_.px(parts_.sensor_radius / 0.36f - 4);
        if (is_graph_ && sensors.size() > 1) return std::max(least, sensors[1].at.x - sensors[0].at.x - ui_.px(4));
        if (is_graph_) return least;
        const float from = parts_.sensors.back().at.x + unit_ * from_eye_to_its_name;
        return all_.x + all_.w - ui_.px(spacing::hair) - from;
    }

    SmallButton look_of_button() const {
        return {"button.watch", icon::wiring, ui_.strings("button.watch"),
                view_.settings.watching && !state_.map.replaces_diagram};
    }

    // Shows the whole brain beside the scene, or hides it: between the wheels, where no name and no number is. In large
    // type it would cover a wire. True while the pointer is on it.
    bool watch_button() {
        if (view_.lecture) return false;
        const float width = small_button_width(ui_, look_of_button(), false);
        ImGui::SetCursorScreenPos(
            {all_.x + (all_.w - width) / 2, all_.y + all_.h - ui_.px(ui_.tall(small_button_height) + spacing::hair)});
        const Item at = small_button(ui_, look_of_button(), false);
        tooltip(ui_, at, ui_.strings("tooltip.watch"), key_name(Action::watch, ui_.strings));
        if (at.pressed) state_.chosen.push_back(Action::watch);
        return at.hovered;
    }

    // The number of lesions in the brain, and a button that heals them all.
    void heal() {
        const auto nodes =
            std::count_if(brain_.nodes.begin(), brain_.nodes.end(), [](const Node& n) { return n.silenced; });
        const auto wires = std::count_if(brain_.wires.begin(), brain_.wires.end(), [](const Wire& w) { return w.cut; });
        if (nodes + wires == 0) return;
        const SmallButton look{"lesion.heal", icon::heal, ui_.strings("lesion.heal")};
        const Item at = small_button(ui_, look);
        tooltip(ui_, at, ui_.strings("tooltip.heal"));
        put_right(ui_, {all_.x + all_.w, at.middle_y() - line_height(ui_, Face::small) / 2},
                  fill(ui_.strings("lesion.count"), {std::to_string(nodes + wires)}), ui_.palette.second_text,
                  Face::small);
        if (!at.pressed) return;
        BrainGraph healed = brain_;
        for (Node& node : healed.nodes) node.silenced = false;
        for (Wire& wire : healed.wires) wire.cut = false;
        set(std::move(healed));
    }

    void set(BrainGraph brain) {
        ui_.outbox.push_back(EditRequest{SetBrain{target_of(view_, vehicle_), std::move(brain)},
                                         gestures::panels + ++state_.sliders.gesture});
    }

    const LabView& view_;
    PanelState& state_;
    Ui& ui_;
    const VehicleView& vehicle_;
    const BrainGraph& brain_;
    SensorPair pair_;
    bool is_graph_;  // the whole brain is shown, not only the wires of the pair
    float unit_;     // window pixels per layout pixel of the pair's picture; less than ui_.px(1) in a narrow card
    bool is_crowded_ = false;  // names of sensors are symbols
    Rect all_;
    sketch::BrainLayout parts_;
    const WireMark* warm_ = nullptr;  // under the pointer
    std::map<NodeId, float> warmth_;  // of the widgets of nodes
};

}  // namespace

float brain_picture_height(const LabView& view, const VehicleView& vehicle, float of_pair) {
    constexpr float low = 100;
    const BrainGraph& brain = *brain_of(*view.now, vehicle);
    if (sketch::is_four_wires(brain, shown_pair(view, vehicle))) return of_pair;
    const bool has_neurons = std::any_of(brain.nodes.begin(), brain.nodes.end(),
                                         [](const Node& node) { return node.kind == NodeKind::neuron; });
    return of_pair + (has_neurons || of_pair > low ? sketch::graph_height : sketch::low_graph_height);
}

void brain_picture(const LabView& view, PanelState& state, Ui& ui, const VehicleView& vehicle, float layout_height) {
    BrainPicture(view, state, ui, vehicle, layout_height).draw();
}

}  // namespace braitenlab::ui

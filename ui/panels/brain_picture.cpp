// The picture of a brain with two sensors, seen from above, with the current signals on its wires. A click on a sensor,
// wire or wheel silences, cuts or stops it; a second click heals it.
#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include <imgui.h>

#include "core/brain/four_neurons.h"
#include "ui/panels/brain_sketch.h"
#include "ui/panels/panels.h"
#include "ui/shortcuts.h"
#include "ui/strings.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"

namespace braitenlab::ui {

namespace {

constexpr float reach_of_wire = 7;  // layout pixels

struct PictureLayout {
    ImVec2 eye[2], wheel[2];  // left, right
    Rect chassis;
};

PictureLayout picture_layout(const Ui& ui, ImVec2 at, float width, float picture_height) {
    PictureLayout p;
    const float middle = at.x + width / 2, half = ui.px(50);
    p.chassis = {middle - half, at.y + ui.px(12), 2 * half, ui.px(picture_height - 24)};
    for (int side = 0; side < 2; ++side) {
        const float s = side == 0 ? -1.0f : 1.0f;
        p.eye[side] = {middle + s * ui.px(30), at.y + ui.px(16)};
        p.wheel[side] = {middle + s * ui.px(54), at.y + ui.px(picture_height - 32)};
    }
    return p;
}

// A sensor or motor; null where the brain has no such node.
struct PictureEnd {
    std::string name;
    std::string anchor = "lesion." + name;
    const Node* node = nullptr;
    bool lesioned() const { return node && node->silenced; }
};

struct PictureWire {
    std::string_view letters, anchor;
    int eye = 0, motor = 0;  // 0 left, 1 right
    const Wire* wire = nullptr;
    sketch::WirePath path{};
    bool exists() const { return wire && (wire->weight != 0 || wire->cut); }
};

class BrainPicture {
public:
    BrainPicture(const LabView& view, PanelState& state, Ui& ui, const VehicleView& vehicle, float layout_height)
        : view_(view),
          state_(state),
          ui_(ui),
          vehicle_(vehicle),
          brain_(*brain_of(*view.now, vehicle)),
          height_(layout_height),
          eyes_{{shown_pair(view, vehicle).left}, {shown_pair(view, vehicle).right}},
          at_(ImGui::GetCursorScreenPos()),
          layout_(picture_layout(ui, at_, card_width(ui), layout_height)) {
        for (PictureEnd* end : {&eyes_[0], &eyes_[1], &motors_[0], &motors_[1]})
            end->node = find_node(brain_, end->name);
        for (PictureWire& c : wires_) {
            const Node *from = eyes_[c.eye].node, *to = motors_[c.motor].node;
            c.wire = from && to ? find_wire(brain_, from->id, to->id) : nullptr;
            // Wires end above the wheels, the uncrossed one further out, so that the end signs are side by side.
            const float inward = c.motor == 0 ? 1.0f : -1.0f;
            const ImVec2 wheel = layout_.wheel[c.motor], eye = layout_.eye[c.eye];
            c.path = sketch::path({eye.x, eye.y + ui.px(9)},
                                  {wheel.x + inward * ui.px(c.eye == c.motor ? 17 : 31), wheel.y - ui.px(2)});
        }
    }

    void draw() {
        const Rect all{at_.x, at_.y, card_width(ui_), ui_.px(height_)};
        fill_box(ui_, all, ui_.palette.ground.with_alpha(0.45f));
        fill_box(ui_, layout_.chassis, mix(ui_.palette.panel, ui_.palette.chassis, 0.22f), 12);
        line_box(ui_, layout_.chassis, colour_of(ui_.palette, vehicle_.role), 12, 1.5f);
        ends();
        connections(all);
        strokes();
        watch_button(all);
        ImGui::SetCursorScreenPos(at_);
        const Item area = item(ui_, "brain.picture", {all.w, all.h}, false);
        if (state_.lesion_under_pointer.empty()) tooltip(ui_, area, ui_.strings("brain.picture"));
        heal();
    }

private:
    float reading(int side) const {
        const Node* node = eyes_[side].node;
        return node && !node->silenced ? node_value(*view_.now, vehicle_, node->id) : 0;
    }

    // True when a lesion of this part is requested: by a click, Enter, or L over it.
    bool lesion_requested(const Item& at, bool over) {
        if (over) state_.lesion_under_pointer = at_anchor_;
        const bool by_key = state_.lesion_requested == at_anchor_;
        if (by_key) state_.lesion_requested.clear();
        return at.pressed || by_key;
    }

    // Sensors and motors, as widgets over what strokes() draws.
    void ends() {
        for (int side = 0; side < 2; ++side) {
            end(eyes_[side], layout_.eye[side], {ui_.px(24), ui_.px(24)},
                eyes_[side].lesioned() ? "lesion.eye_hurt" : "lesion.eye", warmth_eye_[side]);
            end(motors_[side], layout_.wheel[side], {ui_.px(20), ui_.px(46)},
                motors_[side].lesioned() ? "lesion.motor_hurt" : "lesion.motor", warmth_motor_[side]);
        }
    }

    void end(const PictureEnd& which, ImVec2 middle, ImVec2 size, std::string_view words, float& warmth) {
        if (!which.node) return;
        ImGui::SetCursorScreenPos({middle.x - size.x / 2, middle.y - size.y / 2});
        const Item at = item(ui_, which.anchor, size);
        warmth = at.warmth;
        at_anchor_ = which.anchor;
        if (at.hovered) tooltip(ui_, at, fill(ui_.strings(words), {which.name}), ui_.strings("lesion.key"));
        if (!lesion_requested(at, at.hovered)) return;
        BrainGraph edited = brain_;
        find_node(edited, which.name)->silenced = !which.lesioned();
        set(std::move(edited));
    }

    // Wires. The widget is the sign at the end, for the keyboard and for tests; the mouse takes a wire anywhere.
    void connections(const Rect& all) {
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        const bool free = state_.lesion_under_pointer.empty() && all.contains(mouse.x, mouse.y) &&
                          ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
        float nearest = ui_.px(reach_of_wire);
        for (const PictureWire& c : wires_) {
            if (!free || !c.exists()) continue;
            if (const float d = sketch::distance(c.path, mouse); d < nearest) nearest = d, warm_ = &c;
        }
        for (const PictureWire& c : wires_) {
            if (!c.exists()) continue;
            const float size = ui_.px(16);
            ImGui::SetCursorScreenPos({c.path[3].x - size / 2, c.path[3].y - size / 2});
            Item at = item(ui_, c.anchor, {size, size});
            at_anchor_ = c.anchor;
            if (warm_ == &c) {
                at.hovered = true;
                at.pressed |= ImGui::IsMouseClicked(0) && !at.held;
                show_tooltip(at, c);
            } else if (at.pressed && !at.entered) {
                at.pressed = false;  // another wire is nearer to the pointer
            }
            if (lesion_requested(at, warm_ == &c)) cut_or_heal(*c.wire);
        }
    }

    void show_tooltip(const Item& at, const PictureWire& c) {
        tooltip(ui_, at, fill(ui_.strings(c.wire->cut ? "lesion.wire_hurt" : "lesion.wire"), {c.letters}),
                ui_.strings("lesion.key"));
    }

    void cut_or_heal(const Wire& wire) {
        BrainGraph edited = brain_;
        find_wire(edited, wire.from, wire.to)->cut = !wire.cut;
        set(std::move(edited));
    }

    void strokes() {
        for (const PictureWire& c : wires_) {
            sketch::WireLook look;
            look.warm = warm_ == &c;
            if (c.wire) {
                look.weight = c.wire->weight;
                look.cut = c.wire->cut;
                look.carried = signal(*c.wire, reading(c.eye), learned(*view_.now, vehicle_, c.wire->from, c.wire->to));
            }
            sketch::wire(ui_, c.path, look);
        }
        for (int side = 0; side < 2; ++side) {
            const auto s = static_cast<std::size_t>(side);
            const float out = side == 0 ? -1.0f : 1.0f;
            sketch::eye(ui_, layout_.eye[side], reading(side), eyes_[side].lesioned(), warmth_eye_[side]);
            sketch::wheel(ui_, layout_.wheel[side], out, vehicle_.motor[s], vehicle_.wheel_angle[s],
                          motors_[side].lesioned(), warmth_motor_[side]);
            sketch::number(ui_, {layout_.eye[side].x + out * ui_.px(44), layout_.eye[side].y + ui_.px(6)}, side == 0,
                           eyes_[side].name, eyes_[side].lesioned() ? "—" : fixed(reading(side), 2));
            sketch::number(ui_, {layout_.wheel[side].x + out * ui_.px(32), layout_.wheel[side].y + ui_.px(4)},
                           side == 0, motors_[side].name, with_sign(vehicle_.motor[s], 2));
        }
    }

    // Shows the whole brain beside the scene, or hides it.
    void watch_button(const Rect& all) {
        const SmallButton look{"button.watch", icon::wiring, ui_.strings("button.watch"), view_.settings.watching};
        const float width = small_button_width(ui_, look, false);
        ImGui::SetCursorScreenPos({all.x + all.w - width - ui_.px(4), all.y + ui_.px(4)});
        const Item at = small_button(ui_, look, false);
        tooltip(ui_, at, ui_.strings("tooltip.watch"), key_name(Action::watch, ui_.strings));
        if (at.pressed) ui_.outbox.push_back(Action::watch);
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
        put_right(ui_, {at_.x + card_width(ui_), at.middle_y() - line_height(ui_, Face::small) / 2},
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
    float height_;        // layout pixels
    PictureEnd eyes_[2];  // of the chosen pair
    ImVec2 at_;
    PictureLayout layout_;
    PictureEnd motors_[2]{{"ML"}, {"MR"}};
    std::array<PictureWire, 4> wires_{
        {{"LR", "lesion.LR", 1, 0}, {"RL", "lesion.RL", 0, 1}, {"LL", "lesion.LL", 0, 0}, {"RR", "lesion.RR", 1, 1}}};
    const PictureWire* warm_ = nullptr;  // under the pointer
    std::string_view at_anchor_;
    float warmth_eye_[2]{}, warmth_motor_[2]{};
};

}  // namespace

void brain_picture(const LabView& view, PanelState& state, Ui& ui, const VehicleView& vehicle, float layout_height) {
    BrainPicture(view, state, ui, vehicle, layout_height).draw();
}

}  // namespace braitenlab::ui

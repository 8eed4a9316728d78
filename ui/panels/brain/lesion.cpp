// Lesions by the key L and by clicks outside the brain picture.
#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include <imgui.h>

#include "core/brain/four_neurons.h"
#include "core/maths/portable.h"
#include "ui/panels/panels.h"
#include "ui/request.h"

namespace braitenlab::ui {

using maths::vec2;

namespace {

struct SliderOfWire {
    Dial weight;
    std::string_view slider, threshold, lesion;
};
constexpr std::array<SliderOfWire, 4> sliders_of_wires{{{Dial::LL, "slider.LL", "threshold.LL", "lesion.LL"},
                                                        {Dial::LR, "slider.LR", "threshold.LR", "lesion.LR"},
                                                        {Dial::RL, "slider.RL", "threshold.RL", "lesion.RL"},
                                                        {Dial::RR, "slider.RR", "threshold.RR", "lesion.RR"}}};

bool contains(const Anchors& anchors, std::string_view name, vec2 at) {
    const Rect* rect = anchors.find(name);
    return rect && rect->contains(at.x, at.y);
}

// The sensor or driven wheel of the selected vehicle that is nearest to the pointer, within `pixels` or `metres` of it,
// whichever is more on the screen.
std::string part_in_scene(const LabView& view, vec2 pointer) {
    constexpr float pixels = 14, metres = 0.14f, eye_height = 0.3f, wheel_height = 0.1f;
    const VehicleView* vehicle = selected_vehicle(view);
    if (!vehicle || !view.camera_view) return {};
    const vec2 ahead{maths::cosine(vehicle->heading), maths::sine(vehicle->heading)};
    const vec2 place{vehicle->x, vehicle->y};
    std::string nearest;
    float least = 1e9f;
    const auto offer = [&](float x, float y, float height, const std::string& name) {
        const vec2 at = place + ahead * x + vec2{-ahead.y, ahead.x} * y;
        const auto middle = project(*view.camera_view, at, height);
        const auto beside = project(*view.camera_view, at + ahead * metres, height);
        if (!middle || !beside) return;
        const float far = maths::distance(*middle, pointer);
        if (far > std::max(pixels, maths::distance(*middle, *beside)) || far >= least) return;
        least = far;
        nearest = name;
    };
    const Kind& kind = kind_of(*view.now, *vehicle);
    for (const Sensor& sensor : kind.sensors) offer(sensor.x, sensor.y, eye_height, sensor.name);
    for (const Wheel& wheel : kind.body.wheels)
        if (wheel.motor != Motor::none) offer(wheel.x, wheel.y, wheel_height, wheel.motor == Motor::left ? "ML" : "MR");
    return nearest.empty() ? nearest : "lesion." + nearest;
}

// The brain with this part lesioned, or healed if it was lesioned; nullopt when the brain has no such part. The sliders
// set the wires of `pair`.
std::optional<BrainGraph> toggled(BrainGraph brain, std::string_view lesion, const SensorPair& pair) {
    for (const SliderOfWire& each : sliders_of_wires) {
        if (each.lesion != lesion) continue;
        const auto ends = direct_ends(brain, each.weight, pair);
        Wire* wire = ends ? find_wire(brain, ends->from, ends->to) : nullptr;
        if (!wire || (wire->weight == 0 && !learns(*wire) && !wire->cut)) return std::nullopt;
        wire->cut = !wire->cut;
        return brain;
    }
    Node* node = find_node(brain, std::string(lesion.substr(lesion.find('.') + 1)));
    if (!node) return std::nullopt;
    node->silenced = !node->silenced;
    return brain;
}

// Anchor of the part under the pointer, outside the brain picture: over a card the wire of a slider, else a part of the
// selected vehicle in the scene. Empty: none.
std::string lesion_under_pointer(const LabView& view, const Anchors& anchors, bool over_card) {
    const vec2 pointer{ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y};
    if (over_card) {
        for (const SliderOfWire& wire : sliders_of_wires)
            if (contains(anchors, wire.slider, pointer) || contains(anchors, wire.threshold, pointer))
                return std::string(wire.lesion);
        return {};
    }
    return view.mode == Mode::wiring ? std::string{} : part_in_scene(view, pointer);
}

}  // namespace

void lesions(const LabView& view, PanelState& state, Ui& ui) {
    const VehicleView* vehicle = selected_vehicle(view);
    if (state.brain.lesion_under_pointer.empty() && vehicle && !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup))
        state.brain.lesion_under_pointer = lesion_under_pointer(view, ui.anchors, ImGui::GetIO().WantCaptureMouse);
    const std::string wanted = std::exchange(state.brain.lesion_requested, {});
    if (wanted.empty() || !vehicle) return;
    if (auto brain = toggled(*brain_of(*view.now, *vehicle), wanted, shown_pair(view, *vehicle)))
        ui.outbox.push_back(EditRequest{SetBrain{target_of(view, *vehicle), std::move(*brain)},
                                        gestures::panels + ++state.sliders.gesture});
}

}  // namespace braitenlab::ui

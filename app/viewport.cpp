#include "app/viewport.h"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "ui/request.h"

namespace braitenlab {

using maths::vec2;

namespace {

constexpr float drag_threshold = 4;                   // px
constexpr float source_reach = 18;                    // px
constexpr float turn_rate = 1.2f, raise_rate = 0.8f;  // rad/s by the arrow keys

vec2 mouse() { return {ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y}; }

void turn(Camera& camera, float azimuth, float elevation) {
    camera.azimuth += azimuth;
    camera.elevation = std::clamp(camera.elevation + elevation, 0.15f, 1.5f);
}

Grip under(const Snapshot& now, const Sight& sight, vec2 pixel) {
    if (const VehicleId vehicle = pick(now, sight, pixel); vehicle != no_vehicle) return {.vehicle = vehicle};
    Grip nearest;
    float best = source_reach;
    for (const SourceView& s : now.sources) {
        for (const float height : {0.0f, 0.4f}) {  // its foot and its bulb
            const auto at = project(sight, {s.x, s.y}, height);
            if (at && maths::distance(*at, pixel) < best) best = maths::distance(*at, pixel), nearest.source = s.source;
        }
    }
    return nearest;
}

std::optional<vec2> place_of(const Snapshot& now, const Grip& grip) {
    if (const VehicleView* v = find_vehicle(now, grip.vehicle)) return vec2{v->x, v->y};
    for (const SourceView& s : now.sources)
        if (s.source == grip.source) return vec2{s.x, s.y};
    return std::nullopt;
}

vec2 inside(const Arena& arena, vec2 place) {
    const float x = arena.width / 2, y = arena.height / 2;
    return {std::clamp(place.x, -x, x), std::clamp(place.y, -y, y)};
}

void press(const Lab& lab, ViewportState& state, const Sight& sight) {
    state.pressed_at = mouse();
    state.held = state.hovered;
    state.dragging = false;
    ++state.gesture;
    const auto floor = unproject(sight, mouse());
    const auto place = place_of(lab.session.snapshot(), state.held);
    state.offset = floor && place ? *place - *floor : vec2{};
}

void drag(Lab& lab, ViewportState& state, const Sight& sight) {
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    if (!state.held.any()) {
        turn(lab.camera, -moved.x * 0.006f, moved.y * 0.005f);
        return;
    }
    const auto floor = unproject(sight, mouse());
    if (!floor || (moved.x == 0 && moved.y == 0)) return;
    const vec2 to = inside(lab.session.scene().arena, *floor + state.offset);
    const std::uint64_t gesture = gestures::viewport + state.gesture;
    if (const VehicleView* v = find_vehicle(lab.session.snapshot(), state.held.vehicle))
        handle(lab, EditRequest{MoveVehicle{v->id, to.x, to.y, v->heading}, gesture});
    else if (state.held.source >= 0)
        handle(lab, EditRequest{MoveSource{state.held.source, to.x, to.y}, gesture});
}

}  // namespace

void drive_viewport(Lab& lab, ViewportState& state, const Sight& sight, Arrows arrows, float seconds) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool over_view = !io.WantCaptureMouse || state.pressed_at || state.orbiting;
    turn(lab.camera, arrows.turn * turn_rate * seconds, arrows.raise * raise_rate * seconds);

    state.hovered = over_view && lab.mode != Mode::wiring ? under(lab.session.snapshot(), sight, mouse()) : Grip{};
    if (over_view && io.MouseWheel != 0)
        lab.camera.zoom = std::clamp(lab.camera.zoom * std::exp2(io.MouseWheel * 0.2f), 0.25f, 8.0f);

    if (!io.WantCaptureMouse && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) press(lab, state, sight);
    if (state.pressed_at) {
        if (state.held.vehicle != no_vehicle) lab.selected = state.held.vehicle;
        if (maths::distance(*state.pressed_at, mouse()) > drag_threshold) state.dragging = true;
        if (state.dragging) drag(lab, state, sight);
        if (!io.MouseDown[ImGuiMouseButton_Left]) state.pressed_at.reset(), state.held = {};
    }

    if (!io.WantCaptureMouse && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) state.orbiting = true;
    if (state.orbiting) turn(lab.camera, -io.MouseDelta.x * 0.006f, io.MouseDelta.y * 0.005f);
    if (!io.MouseDown[ImGuiMouseButton_Right]) state.orbiting = false;

    if (state.hovered.any() || state.held.any()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
}

}  // namespace braitenlab

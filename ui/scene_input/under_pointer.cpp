#include "ui/scene_input/under_pointer.h"

#include <cmath>

#include "core/maths/angle.h"
#include "core/scene/arena.h"

namespace braitenlab::ui {

using maths::vec2;

namespace {

// Layout pixels; `handle_near`: beyond the ring.
constexpr float ring_gap = 16, ring_grip = 6, knob_grip = 12, handle_near = 36;

}  // namespace

SceneObject chosen(const LabView& view) { return chosen_object(view.settings.selection); }

SceneObject object_at_pointer(const SceneInputFrame& frame) {
    return pick_object(*frame.view.now, frame.camera_view, frame.pointer.at, frame.view.settings.overlays.surfaces);
}

std::optional<vec2> floor_at(const SceneInputFrame& frame) { return unproject(frame.camera_view, frame.pointer.at); }

float pixels_from(const SceneInputFrame& frame, vec2 place) {
    const auto at = project(frame.camera_view, place);
    return at ? maths::distance(*at, frame.pointer.at) : 1e9f;
}

vec2 to_millimetres(vec2 place) {
    constexpr float per_metre = 1000;
    return {std::round(place.x * per_metre) / per_metre, std::round(place.y * per_metre) / per_metre};
}

vec2 in_arena(const LabView& view, vec2 place) {
    const vec2 shown = to_millimetres(place);
    return view.now->scene ? moved_inside(view.now->scene->arena, shown) : shown;
}

std::optional<Handle> handle_of(const SceneInputState& state, const SceneInputFrame& frame) {
    const SceneObject object = state.drag.phase == SceneInputPhase::turn ? state.drag.on.object : chosen(frame.view);
    const auto place = place_of(*frame.view.now, object);
    const bool turns = object && object.kind != SceneObjectKind::source;
    if (!frame.view.settings.selection.more.empty()) return std::nullopt;  // it turns one object
    const bool free = state.drag.phase == SceneInputPhase::idle || state.drag.phase == SceneInputPhase::turn;
    if (rides(frame.view.settings.camera.mode) && object == vehicle_object(frame.view.settings.selection.vehicle))
        return std::nullopt;
    if (!turns || !place || !free || state.tool != SceneInputTool::hand || frame.view.mode == Mode::wiring)
        return std::nullopt;
    Handle handle;
    handle.middle = {place->x, place->y};
    const float scale = pixels_per_metre(frame.camera_view, handle.middle);
    if (scale <= 0) return std::nullopt;
    handle.radius = reach_of(*frame.view.now, object) + ring_gap * frame.scale / scale;
    handle.knob = handle.middle + maths::from_polar(handle.radius, place->heading);
    const float near = handle.radius * scale + handle_near * frame.scale;
    const bool shown = state.drag.phase == SceneInputPhase::turn || pixels_from(frame, handle.middle) <= near;
    return shown ? std::optional(handle) : std::nullopt;
}

SceneInputHit under_pointer(const SceneInputState& state, const SceneInputFrame& frame) {
    if (!frame.pointer.over || frame.view.mode == Mode::wiring || state.tool != SceneInputTool::hand) return {};
    const auto handle = handle_of(state, frame);
    const auto floor = floor_at(frame);
    const SceneObject object = object_at_pointer(frame);
    const float to_knob = handle ? pixels_from(frame, handle->knob) : 1e9f;
    if (to_knob <= knob_grip * frame.scale * finger_reach(frame.view)) {
        // Another object may be below the knob: take the nearer one.
        const auto place = object == chosen(frame.view) ? std::nullopt : place_of(*frame.view.now, object);
        const bool neighbour = place && pixels_from(frame, {place->x, place->y}) < to_knob;
        return neighbour ? SceneInputHit{object, false} : SceneInputHit{chosen(frame.view), true};
    }
    const bool lies_below = object.kind == SceneObjectKind::zone;  // the ring is drawn over zones
    if (object && !lies_below) return {object, false};
    if (handle && floor) {
        const float off = std::fabs(maths::distance(*floor, handle->middle) - handle->radius);
        if (off * pixels_per_metre(frame.camera_view, *floor) <= ring_grip * frame.scale * finger_reach(frame.view))
            return {chosen(frame.view), true};
    }
    return {object, false};
}

}  // namespace braitenlab::ui

#include "ui/scene_input/interaction.h"

#include <algorithm>
#include <cmath>

#include "core/maths/angle.h"
#include "core/maths/degrees.h"
#include "ui/scene_input/edits.h"
#include "ui/scene_input/path_drawing.h"
#include "ui/scene_input/point_handles.h"
#include "ui/scene_input/polygon_tool.h"
#include "ui/scene_input/sensor_handles.h"
#include "ui/scene_input/tools.h"
#include "ui/scene_input/trail_moments.h"
#include "ui/scene_input/under_pointer.h"

namespace braitenlab::ui {

using maths::vec2;

namespace {

constexpr float drag_threshold = 4;  // layout pixels
constexpr double turn_step = 15;     // degrees, with Shift

void request(Outbox& outbox, Command command, std::uint64_t gesture = 0) {
    outbox.push_back(EditRequest{std::move(command), gesture});
}

// Trails are drawn over zones.
bool is_free_floor(const SceneInputHit& hit) {
    return !hit.handle && (!hit.object || hit.object.kind == SceneObjectKind::zone);
}

bool is_selected(const LabView& view, const SceneObject& object) {
    const std::vector<SceneObject> all = selected_objects(view.settings.selection);
    return std::find(all.begin(), all.end(), object) != all.end();
}

float bearing_from(Pose place, vec2 point) { return maths::arctangent2(point.y - place.y, point.x - place.x); }

void begin_drag(SceneInputState& state, const SceneInputFrame& frame) {
    const SceneInputPointer& pointer = frame.pointer;
    SceneInputDrag& drag = state.drag;
    drag = {};
    drag.phase = SceneInputPhase::pending;
    drag.left = pointer.left_pressed;
    drag.right = !drag.left && pointer.right_pressed;
    drag.press = drag.last = pointer.at;
    drag.gesture = gestures::viewport + ++state.gesture;
    if (!drag.left) return;
    drag.moment = state.trail_moment;
    drag.selects = pointer.shift && !state.hovered.handle && frame.view.mode != Mode::wiring;
    if (drag.selects) {
        drag.click = state.hovered.object;
        return;
    }
    drag.on = state.hovered;
    // A zone may cover most of the floor: the first click selects it, and a drag of an unselected one turns the view.
    const bool zone = drag.on.object.kind == SceneObjectKind::zone && !drag.on.handle;
    if (zone && !is_selected(frame.view, drag.on.object)) {
        drag.click = drag.on.object;
        drag.on = {};
    }
    const auto place = place_of(*frame.view.now, drag.on.object);
    if (!place) return;
    drag.began = *place;
    const vec2 floor = floor_at(frame).value_or(vec2{place->x, place->y});
    drag.offset = vec2{place->x, place->y} - floor;
    drag.bearing = bearing_from(*place, floor);
    if (frame.view.settings.selection.more.empty() || drag.on.handle || !is_selected(frame.view, drag.on.object))
        return;
    drag.click = drag.on.object;
    for (const SceneObject& other : selected_objects(frame.view.settings.selection))
        if (const auto at = place_of(*frame.view.now, other); at && other != drag.on.object)
            drag.others.emplace_back(other, *at);
}

void choose(const SceneObject& object, const LabView& view, Outbox& outbox) {
    if (object == chosen(view) && view.settings.selection.more.empty()) return;
    if (object.kind == SceneObjectKind::vehicle)
        outbox.push_back(SelectRequest{object.index});
    else
        outbox.push_back(TakeRequest{object});
}

// Adds the object to the selection, or removes it.
void toggle(const SceneObject& object, const LabView& view, Outbox& outbox) {
    std::vector<SceneObject> all = selected_objects(view.settings.selection);
    if (std::erase(all, object) == 0) all.push_back(object);
    outbox.push_back(SelectObjectsRequest{std::move(all)});
}

// All objects whose position is within a rectangle on the screen; zones only while they are shown.
std::vector<SceneObject> objects_between(const SceneInputFrame& frame, vec2 a, vec2 b) {
    const Snapshot& now = *frame.view.now;
    std::vector<SceneObject> all;
    for (const VehicleView& v : now.vehicles) all.push_back(vehicle_object(v.id));
    for (const SceneObject& object : objects_beside_vehicles(*now.scene))
        if (object.kind != SceneObjectKind::zone || frame.view.settings.overlays.surfaces) all.push_back(object);
    const auto within = [](float value, float one, float other) {
        return value >= std::min(one, other) && value <= std::max(one, other);
    };
    std::erase_if(all, [&](const SceneObject& object) {
        const auto place = place_of(now, object);
        const auto at = place ? project(frame.camera_view, {place->x, place->y}) : std::nullopt;
        return !at || !within(at->x, a.x, b.x) || !within(at->y, a.y, b.y);
    });
    return all;
}

void press_with_tool(SceneInputState& state, const SceneInputFrame& frame, Outbox& outbox) {
    const auto at = aim(state, frame.view, frame.pointer.at);
    if (!at) return;
    if (state.tool == SceneInputTool::polygon) return click_corner(state, frame, *at, outbox);
    if (state.tool == SceneInputTool::tape && frame.pointer.left_double)
        return end_line(state, frame.view, frame.pointer.shift, outbox);
    if (state.tool == SceneInputTool::ruler && state.corners.size() > 1) state.corners.clear();
    const bool begins = spans(state.tool) && state.corners.empty();
    set_corner(state, frame.view, *at, frame.pointer.shift, outbox);
    if (!begins) return;
    begin_drag(state, frame);
    state.drag.phase = SceneInputPhase::span;
}

// The second end of a span. A press without a drag measures nothing yet: the next click is the second end.
void release_span(SceneInputState& state, const SceneInputDrag& drag, const SceneInputFrame& frame, Outbox& outbox) {
    const bool click = maths::distance(drag.press, frame.pointer.at) <= drag_threshold * frame.scale;
    if (click && state.tool == SceneInputTool::ruler) return;
    if (state.corners.size() != 1) return;
    const vec2 from = state.corners[0];
    const vec2 to = click ? from : aim(state, frame.view, frame.pointer.at).value_or(from);
    complete_span(state, frame.view, to, frame.pointer.shift, outbox);
}

void press(SceneInputState& state, const SceneInputFrame& frame, Outbox& outbox) {
    const SceneInputPointer& pointer = frame.pointer;
    if (!pointer.over || !(pointer.left_pressed || pointer.right_pressed || pointer.middle_pressed)) return;
    if (state.drag.phase != SceneInputPhase::idle) return;  // a second button changes nothing
    state.refusal = {};
    const bool draws = pointer.left_pressed && state.tool != SceneInputTool::hand && frame.view.mode != Mode::wiring;
    if (!draws) {
        begin_drag(state, frame);
        const SceneInputHit& on = state.drag.on;
        if (on.object && !on.handle && !is_selected(frame.view, on.object)) choose(on.object, frame.view, outbox);
        return;
    }
    press_with_tool(state, frame, outbox);
}

bool moved_enough(const SceneInputState& state, const SceneInputFrame& frame) {
    return maths::distance(state.drag.press, frame.pointer.at) > drag_threshold * frame.scale;
}

SceneInputPhase phase_for(const SceneInputState& state, const SceneInputFrame& frame) {
    const SceneInputDrag& drag = state.drag;
    if (drag.selects) return SceneInputPhase::select;
    const bool flat = frame.view.settings.camera.mode == CameraMode::birds_eye;  // north is always up
    if (!drag.left || (!drag.on && flat)) return SceneInputPhase::pan;
    // The vehicle that the camera follows moves away from the pointer: orbit instead.
    const bool ridden = rides(frame.view.settings.camera.mode) &&
                        drag.on.object == vehicle_object(frame.view.settings.selection.vehicle);
    if (!drag.on || ridden) return SceneInputPhase::orbit;
    return drag.on.handle ? SceneInputPhase::turn : SceneInputPhase::move;
}

bool is_there(const SceneObject& object, const LabView& view, Pose to) {
    const auto is = place_of(*view.now, object);
    const bool source = object.kind == SceneObjectKind::source;
    return !is || (std::hypot(is->x - to.x, is->y - to.y) < 1e-4f &&
                   (source || std::fabs(maths::wrap_angle(is->heading - to.heading)) < 1e-4f));
}

// The pose of an object that is moved together with the dragged one.
Pose moved_along(const SceneInputDrag& drag, Pose began) {
    const vec2 at = to_millimetres({began.x + drag.put.x - drag.began.x, began.y + drag.put.y - drag.began.y});
    return {at.x, at.y, began.heading};
}

// Requests the poses, unless all objects have them. A moving vehicle leaves the pose, so it is requested every frame.
// All objects are requested together, so that a later frame of the drag replaces the earlier one in the step of undo.
void put(SceneInputDrag& drag, const LabView& view, Pose to, Outbox& outbox) {
    drag.put = to;
    bool there = is_there(drag.on.object, view, to);
    for (const auto& [other, began] : drag.others) there = there && is_there(other, view, moved_along(drag, began));
    if (there) return;
    const auto put_object = [&](const SceneObject& object, Pose pose) {
        if (const auto command = move_of(*view.now, object, pose)) request(outbox, *command, drag.gesture);
    };
    put_object(drag.on.object, to);
    for (const auto& [other, began] : drag.others) put_object(other, moved_along(drag, began));
}

void continue_drag(SceneInputState& state, const SceneInputFrame& frame, Outbox& outbox) {
    SceneInputDrag& drag = state.drag;
    const auto floor = floor_at(frame);
    if (drag.phase == SceneInputPhase::pending && moved_enough(state, frame)) drag.phase = phase_for(state, frame);
    if (drag.phase == SceneInputPhase::pending) return;
    drag.moved = frame.pointer.at - drag.last;  // from the press on, so that the floor stays under the pointer
    drag.last = frame.pointer.at;
    if (drag.phase == SceneInputPhase::move && floor) {
        const vec2 at = to_millimetres(*floor + drag.offset);
        put(drag, frame.view, {at.x, at.y, drag.began.heading}, outbox);
    }
    if (drag.phase == SceneInputPhase::turn && floor) {
        Pose to = drag.began;
        const float turned = maths::wrap_angle(to.heading + bearing_from(to, *floor) - drag.bearing);
        to.heading = maths::wrap_angle(maths::to_degree_steps(turned, frame.pointer.shift ? turn_step : 1));
        put(drag, frame.view, to, outbox);
    }
}

// The objects are released: before the first tick the pose of a vehicle becomes its start.
void finish_move(const SceneInputDrag& drag, const LabView& view, Outbox& outbox) {
    const auto finish = [&](const SceneObject& object, Pose at) {
        const auto move = move_of(*view.now, object, at);
        if (auto start = move ? start_of(*view.now, *move) : std::nullopt) request(outbox, *start, drag.gesture);
    };
    finish(drag.on.object, drag.put);
    for (const auto& [other, began] : drag.others) finish(other, moved_along(drag, began));
}

void open_menu(SceneInputState& state, const SceneInputFrame& frame) {
    state.menu = {};
    state.menu.open = true;
    state.menu.object = object_at_pointer(frame);
    state.menu.at = frame.pointer.at;
    state.menu.place = in_arena(frame.view, floor_at(frame).value_or(vec2{}));
}

void release(SceneInputState& state, const SceneInputFrame& frame, Outbox& outbox) {
    const SceneInputDrag drag = state.drag;
    const SceneInputPointer& pointer = frame.pointer;
    if (drag.left ? pointer.left_down : drag.right ? pointer.right_down : pointer.middle_down) return;
    state.drag = {};
    if (drag.phase == SceneInputPhase::move || drag.phase == SceneInputPhase::turn)
        finish_move(drag, frame.view, outbox);
    if (drag.phase == SceneInputPhase::span) release_span(state, drag, frame, outbox);
    if (drag.phase == SceneInputPhase::select)
        outbox.push_back(SelectObjectsRequest{objects_between(frame, drag.press, pointer.at)});
    if (drag.phase != SceneInputPhase::pending || frame.view.mode == Mode::wiring) return;
    if (drag.selects && drag.click) toggle(drag.click, frame.view, outbox);
    if (drag.moment && !drag.selects && !drag.on)
        outbox.push_back(WhyRequest{*drag.moment});
    else if (drag.left && !drag.selects && (!drag.on || drag.click))
        choose(drag.click, frame.view, outbox);
    if (drag.right && state.tool != SceneInputTool::hand)
        take_back_corner(state);
    else if (drag.right)
        open_menu(state, frame);
}

}  // namespace

void interact(SceneInputState& state, const SceneInputFrame& frame, Outbox& outbox) {
    if (!place_of(*frame.view.now, state.drag.on.object) && state.drag.on)
        state.drag = {};                                                                // the object no longer exists
    if (maths::distance(state.pointer, frame.pointer.at) > 1) state.crosshair.reset();  // the mouse points again
    state.pointer = frame.pointer.at;
    state.over = frame.pointer.over;
    state.middle = frame.area.middle();
    if (use_path_drawing(state, frame, outbox)) return;
    if (use_sensor_handles(state, frame, outbox) || use_point_handles(state, frame, outbox)) return;
    state.hovered = under_pointer(state, frame);
    if (state.drag.phase == SceneInputPhase::idle)
        state.trail_moment = is_free_floor(state.hovered) ? trail_moment_at_pointer(state, frame) : std::nullopt;
    press(state, frame, outbox);
    if (state.drag.phase == SceneInputPhase::idle) return;
    continue_drag(state, frame, outbox);
    release(state, frame, outbox);
}

void open_menu_of(SceneInputState& state, const LabView& view, const SceneObject& object) {
    const auto place = place_of(*view.now, object);
    if (!place) return;
    const auto at = project(*view.camera_view, {place->x, place->y});
    if (!at) return;
    state.menu = {};
    state.menu.open = state.menu.by_key = true;
    state.menu.object = object;
    state.menu.place = {place->x, place->y};
    state.menu.at = *at;
}

void open_menu_of_floor(SceneInputState& state, const LabView& view) {
    const auto middle = state.crosshair ? state.crosshair : unproject(*view.camera_view, state.middle);
    state.menu = {};
    state.menu.open = state.menu.by_key = true;
    state.menu.place = in_arena(view, middle.value_or(vec2{}));
    state.menu.at = project(*view.camera_view, state.menu.place).value_or(state.middle);
}

bool cancel(SceneInputState& state, const LabView& view, Outbox& outbox) {
    if (cancel_path_drawing(state)) return true;
    if (cancel_sensor_drag(state, *view.now, outbox) || cancel_point_drag(state, outbox)) return true;
    SceneInputDrag drag = state.drag;
    state.refusal = {};
    if (drag.phase == SceneInputPhase::move || drag.phase == SceneInputPhase::turn) put(drag, view, drag.began, outbox);
    if (drag.phase != SceneInputPhase::idle) {
        state.drag = {};
        if (drag.phase == SceneInputPhase::span) state.corners.clear();
    } else if (state.tool == SceneInputTool::tape && state.corners.size() > 1) {
        end_line(state, view, false, outbox);
    } else if (!state.corners.empty()) {
        state.corners.clear();
    } else if (state.tool != SceneInputTool::hand) {
        choose_tool(state, SceneInputTool::hand);
    } else if (view.settings.selection.object || !view.settings.selection.more.empty()) {
        outbox.push_back(TakeRequest{});
    } else {
        return false;
    }
    return true;
}

}  // namespace braitenlab::ui

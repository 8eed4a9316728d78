#include "ui/stage/interaction.h"

#include <algorithm>
#include <cmath>

#include "core/maths/angle.h"
#include "ui/stage/edits.h"

namespace braitenlab {

using maths::vec2;

namespace {

constexpr float drag_begins = 4;                               // layout pixels
constexpr float ring_gap = 16, ring_grip = 6, knob_grip = 11;  // layout pixels
constexpr float handle_near = 36;                              // layout pixels beyond the ring
constexpr float corner_grip = 11;                              // layout pixels round the first corner, which closes
constexpr float turn_step = maths::pi / 12;                    // with Shift
constexpr double refusal_seconds = 3;

void ask(Outbox& outbox, Command command, std::uint64_t gesture = 0) {
    outbox.push_back(EditRequest{std::move(command), gesture});
}

void refuse(StageState& state, double wall_seconds, std::string_view key) {
    state.refusal = {std::string(key), wall_seconds + refusal_seconds};
}

std::optional<vec2> floor_at(const StageFrame& frame) { return unproject(frame.sight, frame.pointer.at); }

float bearing_from(Pose place, vec2 point) { return maths::arctangent2(point.y - place.y, point.x - place.x); }

// How many pixels the pointer is away from a place on the floor.
float pixels_from(const StageFrame& frame, vec2 place) {
    const auto at = project(frame.sight, place);
    return at ? maths::distance(*at, frame.pointer.at) : 1e9f;
}

StageHit under_pointer(const StageState& state, const StageFrame& frame) {
    if (!frame.pointer.over || frame.view.mode == Mode::wiring || state.tool != StageTool::hand) return {};
    const auto handle = handle_of(state, frame);
    const auto floor = floor_at(frame);
    const Thing thing = pick_thing(*frame.view.now, frame.sight, frame.pointer.at);
    const float to_knob = handle ? pixels_from(frame, handle->knob) : 1e9f;
    if (to_knob <= knob_grip * frame.scale) {
        // A neighbour may stand right below the knob: whoever is nearer to the pointer.
        const auto place = thing == chosen(frame.view) ? std::nullopt : place_of(*frame.view.now, thing);
        const bool neighbour = place && pixels_from(frame, {place->x, place->y}) < to_knob;
        return neighbour ? StageHit{thing, false} : StageHit{chosen(frame.view), true};
    }
    if (thing) return {thing, false};
    if (handle && floor) {
        const float off = std::fabs(maths::distance(*floor, handle->middle) - handle->radius);
        if (off * pixels_per_metre(frame.sight, *floor) <= ring_grip * frame.scale) return {chosen(frame.view), true};
    }
    return {};
}

void begin_drag(StageState& state, const StageFrame& frame) {
    const StagePointer& pointer = frame.pointer;
    StageDrag& drag = state.drag;
    drag = {};
    drag.phase = StagePhase::pending;
    drag.left = pointer.left_pressed;
    drag.right = !drag.left && pointer.right_pressed;
    drag.press = drag.last = pointer.at;
    drag.gesture = gestures::viewport + ++state.gesture;
    if (!drag.left) return;
    drag.on = state.hovered;
    const auto place = place_of(*frame.view.now, drag.on.thing);
    if (!place) return;
    drag.began = *place;
    const vec2 floor = floor_at(frame).value_or(vec2{place->x, place->y});
    drag.offset = vec2{place->x, place->y} - floor;
    drag.bearing = bearing_from(*place, floor);
}

void choose(const Thing& thing, const LabView& view, Outbox& outbox) {
    if (thing == chosen(view)) return;
    if (thing.kind == ThingKind::vehicle)
        outbox.push_back(SelectRequest{thing.index});
    else
        outbox.push_back(TakeRequest{thing});
}

void click_corner(StageState& state, const StageFrame& frame, vec2 at, Outbox& outbox) {
    const StagePointer& pointer = frame.pointer;
    const bool on_first =
        state.corners.size() >= 3 && pixels_from(frame, state.corners[0]) <= corner_grip * frame.scale;
    if (on_first || (pointer.left_double && state.corners.size() >= 3))
        return close_outline(state, frame.view.wall_seconds, pointer.shift, outbox);
    if (pointer.left_double) return;  // the first of the two clicks has set the corner
    if (const OutlineFault fault = fault_of_next(state.corners, at); fault != OutlineFault::none)
        return refuse(state, frame.view.wall_seconds, reason(fault));
    state.corners.push_back(at);
}

vec2 in_arena(const LabView& view, vec2 place) {
    if (!view.now->scene) return place;
    const float x = view.now->scene->arena.width / 2, y = view.now->scene->arena.height / 2;
    return {std::clamp(place.x, -x, x), std::clamp(place.y, -y, y)};
}

void press(StageState& state, const StageFrame& frame, Outbox& outbox) {
    const StagePointer& pointer = frame.pointer;
    if (!pointer.over || !(pointer.left_pressed || pointer.right_pressed || pointer.middle_pressed)) return;
    if (state.drag.phase != StagePhase::idle) return;  // a second button changes nothing
    state.refusal = {};
    const bool draws = pointer.left_pressed && state.tool != StageTool::hand && frame.view.mode != Mode::wiring;
    const auto floor = floor_at(frame);
    if (!draws) {
        begin_drag(state, frame);
        if (state.drag.on.thing && !state.drag.on.handle) choose(state.drag.on.thing, frame.view, outbox);
        return;
    }
    if (!floor) return;
    const vec2 at = in_arena(frame.view, *floor);
    if (state.tool == StageTool::polygon) return click_corner(state, frame, at, outbox);
    if (state.tool == StageTool::box) {
        begin_drag(state, frame);
        state.drag.phase = StagePhase::box;
        state.drag.corner = at;
        return;
    }
    Source lamp;
    lamp.x = at.x, lamp.y = at.y;
    ask(outbox, AddSource{lamp});
    if (!pointer.shift) state.tool = StageTool::hand;
}

bool moved_enough(const StageState& state, const StageFrame& frame) {
    return maths::distance(state.drag.press, frame.pointer.at) > drag_begins * frame.scale;
}

StagePhase phase_for(const StageState& state, const StageFrame& frame) {
    const StageDrag& drag = state.drag;
    const bool flat = frame.view.camera == CameraMode::birds_eye;  // turned by hand it would lose its north
    if (!drag.left || (!drag.on && flat)) return StagePhase::pan;
    // Whoever the camera rides with would flee from the pointer that drags it: both move.
    const bool ridden = rides(frame.view.camera) && drag.on.thing == vehicle_thing(frame.view.selected);
    if (!drag.on || ridden) return StagePhase::orbit;
    return drag.on.handle ? StagePhase::turn : StagePhase::move;
}

// Asks for the thing to be there, unless it is already. A vehicle that drives would drive out of the hand: it is put
// back every frame.
void put(StageDrag& drag, const LabView& view, Pose to, Outbox& outbox) {
    drag.put = to;
    const auto is = place_of(*view.now, drag.on.thing);
    const auto command = move_of(*view.now, drag.on.thing, to);
    if (!is || !command) return;
    const bool source = drag.on.thing.kind == ThingKind::source;
    const bool there = std::hypot(is->x - to.x, is->y - to.y) < 1e-4f &&
                       (source || std::fabs(maths::wrap_angle(is->heading - to.heading)) < 1e-4f);
    if (!there) ask(outbox, *command, drag.gesture);
}

void go_on(StageState& state, const StageFrame& frame, Outbox& outbox) {
    StageDrag& drag = state.drag;
    const auto floor = floor_at(frame);
    if (drag.phase == StagePhase::pending && moved_enough(state, frame)) drag.phase = phase_for(state, frame);
    if (drag.phase == StagePhase::pending) return;
    drag.moved = frame.pointer.at - drag.last;  // from the press on: the floor stays under the pointer
    drag.last = frame.pointer.at;
    if (drag.phase == StagePhase::move && floor)
        put(drag, frame.view, {floor->x + drag.offset.x, floor->y + drag.offset.y, drag.began.heading}, outbox);
    if (drag.phase == StagePhase::turn && floor) {
        Pose to = drag.began;
        to.heading = maths::wrap_angle(to.heading + bearing_from(to, *floor) - drag.bearing);
        if (frame.pointer.shift) to.heading = maths::wrap_angle(std::round(to.heading / turn_step) * turn_step);
        put(drag, frame.view, to, outbox);
    }
}

// The hand lets go of what it has moved.
void leave(const StageDrag& drag, const LabView& view, Outbox& outbox) {
    const auto move = move_of(*view.now, drag.on.thing, drag.put);
    if (auto start = move ? start_of(*view.now, *move) : std::nullopt) ask(outbox, *start, drag.gesture);
}

void open_menu(StageState& state, const StageFrame& frame) {
    state.menu = {};
    state.menu.open = true;
    state.menu.thing = pick_thing(*frame.view.now, frame.sight, frame.pointer.at);
    state.menu.at = frame.pointer.at;
    state.menu.place = in_arena(frame.view, floor_at(frame).value_or(vec2{}));
}

void release(StageState& state, const StageFrame& frame, Outbox& outbox) {
    const StageDrag drag = state.drag;
    const StagePointer& pointer = frame.pointer;
    if (drag.left ? pointer.left_down : drag.right ? pointer.right_down : pointer.middle_down) return;
    state.drag = {};
    if (drag.phase == StagePhase::move || drag.phase == StagePhase::turn) leave(drag, frame.view, outbox);
    if (drag.phase == StagePhase::box) {
        vec2 far = in_arena(frame.view, floor_at(frame).value_or(drag.corner));
        // A mere click sets up a box of one metre.
        const bool click = maths::distance(drag.press, pointer.at) <= drag_begins * frame.scale;
        ask(outbox, AddObstacle{click ? box_between(drag.corner - vec2{0.5f, 0.5f}, drag.corner + vec2{0.5f, 0.5f})
                                      : box_between(drag.corner, far)});
        if (!pointer.shift) state.tool = StageTool::hand;
    }
    if (drag.phase != StagePhase::pending || frame.view.mode == Mode::wiring) return;
    if (drag.left && !drag.on) choose({}, frame.view, outbox);
    if (drag.right && state.tool != StageTool::hand)
        take_back_corner(state);
    else if (drag.right)
        open_menu(state, frame);
}

}  // namespace

Thing chosen(const LabView& view) { return view.thing ? view.thing : vehicle_thing(view.selected); }

std::string_view reason(OutlineFault fault) {
    switch (fault) {
        case OutlineFault::none:
            break;
        case OutlineFault::too_near:
            return "stage.refused.too_near";
        case OutlineFault::crosses:
            return "stage.refused.crosses";
        case OutlineFault::dents:
            return "stage.refused.dents";
        case OutlineFault::too_many:
            return "stage.refused.too_many";
        case OutlineFault::too_few:
            return "stage.refused.too_few";
        case OutlineFault::too_narrow:
            return "stage.refused.too_narrow";
    }
    return {};
}

std::optional<Handle> handle_of(const StageState& state, const StageFrame& frame) {
    const Thing thing = state.drag.phase == StagePhase::turn ? state.drag.on.thing : chosen(frame.view);
    const auto place = place_of(*frame.view.now, thing);
    const bool turns = thing.kind == ThingKind::vehicle || thing.kind == ThingKind::obstacle;
    const bool free = state.drag.phase == StagePhase::idle || state.drag.phase == StagePhase::turn;
    if (rides(frame.view.camera) && thing == vehicle_thing(frame.view.selected)) return std::nullopt;
    if (!turns || !place || !free || state.tool != StageTool::hand || frame.view.mode == Mode::wiring)
        return std::nullopt;
    Handle handle;
    handle.middle = {place->x, place->y};
    const float scale = pixels_per_metre(frame.sight, handle.middle);
    if (scale <= 0) return std::nullopt;
    handle.radius = reach_of(*frame.view.now, thing) + ring_gap * frame.scale / scale;
    handle.knob = handle.middle + maths::from_polar(handle.radius, place->heading);
    const float near = handle.radius * scale + handle_near * frame.scale;
    const bool shown = state.drag.phase == StagePhase::turn || pixels_from(frame, handle.middle) <= near;
    return shown ? std::optional(handle) : std::nullopt;
}

void interact(StageState& state, const StageFrame& frame, Outbox& outbox) {
    if (!place_of(*frame.view.now, state.drag.on.thing) && state.drag.on) state.drag = {};  // it has left the world
    state.hovered = under_pointer(state, frame);
    press(state, frame, outbox);
    if (state.drag.phase == StagePhase::idle) return;
    go_on(state, frame, outbox);
    release(state, frame, outbox);
}

void open_menu_of(StageState& state, const LabView& view, const Thing& thing) {
    const auto place = place_of(*view.now, thing);
    if (!place) return;
    const auto at = project(*view.sight, {place->x, place->y});
    if (!at) return;
    state.menu = {};
    state.menu.open = state.menu.by_key = true;
    state.menu.thing = thing;
    state.menu.place = {place->x, place->y};
    state.menu.at = *at;
}

bool cancel(StageState& state, const LabView& view, Outbox& outbox) {
    StageDrag drag = state.drag;
    state.refusal = {};
    if (drag.phase == StagePhase::move || drag.phase == StagePhase::turn) put(drag, view, drag.began, outbox);
    if (drag.phase != StagePhase::idle) {
        state.drag = {};
    } else if (!state.corners.empty()) {
        state.corners.clear();
    } else if (state.tool != StageTool::hand) {
        state.tool = StageTool::hand;
    } else if (view.thing) {
        outbox.push_back(TakeRequest{});
    } else {
        return false;
    }
    return true;
}

void take_back_corner(StageState& state) {
    state.refusal = {};
    if (state.corners.empty())
        state.tool = StageTool::hand;
    else
        state.corners.pop_back();
}

void close_outline(StageState& state, double wall_seconds, bool keep_tool, Outbox& outbox) {
    if (const OutlineFault fault = fault_of(state.corners); fault != OutlineFault::none)
        return refuse(state, wall_seconds, reason(fault));
    ask(outbox, AddObstacle{obstacle_from(state.corners)});
    state.corners.clear();
    state.refusal = {};
    if (!keep_tool) state.tool = StageTool::hand;
}

}  // namespace braitenlab

#include "ui/scene_input/path_drawing.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/lesson/path_distance.h"
#include "ui/scene_input/under_pointer.h"

namespace braitenlab::ui {

using maths::vec2;

namespace {

constexpr float point_distance = 0.04f, longest_gap = 1, shortest_path = 0.3f;  // m
constexpr std::size_t most_points = 4000;

void extend(PathDrawing& drawing, const SceneInputFrame& frame) {
    const auto floor = floor_at(frame);
    if (!floor || drawing.points.size() >= most_points) return;
    const vec2 from = drawing.points.back(), way = in_arena(frame.view, *floor) - from;
    const float length = maths::length(way);
    if (length < point_distance) return;
    // A fast pointer skips metres between two frames; the path has no gap there.
    const int pieces = static_cast<int>(std::ceil(length / longest_gap));
    for (int i = 1; i <= pieces; ++i)
        drawing.points.push_back(from + way * (static_cast<float>(i) / static_cast<float>(pieces)));
}

void finish(PathDrawing& drawing, Outbox& outbox) {
    if (path_length(drawing.points) >= shortest_path) {
        outbox.push_back(PredictPathRequest{std::move(drawing.points)});
        drawing.on = false;
    }
    drawing.held = false;
    drawing.points.clear();
}

}  // namespace

const VehicleView* vehicle_to_draw_for(const LabView& view) {
    if (!view.lesson || view.mode == Mode::wiring || !view.may.open_prediction) return nullptr;
    const Exercise& exercise = *view.lesson->exercise;
    const auto& starts = exercise.scene.starts;
    const auto start = std::find_if(starts.begin(), starts.end(), [&](const Start& each) {
        return !each.name.empty() && each.name == exercise.prediction.path_of;
    });
    const auto& all = view.now->vehicles;
    const auto vehicle =
        std::find_if(all.begin(), all.end(), [&](const VehicleView& v) { return v.start == start - starts.begin(); });
    return start == starts.end() || vehicle == all.end() ? nullptr : &*vehicle;
}

bool use_path_drawing(SceneInputState& state, const SceneInputFrame& frame, Outbox& outbox) {
    PathDrawing& drawing = state.path;
    const VehicleView* vehicle = drawing.on ? vehicle_to_draw_for(frame.view) : nullptr;
    if (!vehicle) return drawing = {}, false;
    const SceneInputPointer& pointer = frame.pointer;
    if (state.drag.phase != SceneInputPhase::idle || pointer.right_pressed || pointer.middle_pressed)
        return drawing.held;
    const SceneObject pressed = pointer.over && pointer.left_pressed ? object_at_pointer(frame) : SceneObject{};
    if (pressed.kind == SceneObjectKind::vehicle && pressed && pressed != vehicle_object(vehicle->id)) {
        outbox.push_back(NoticeRequest{"notice.draw_from_vehicle", std::to_string(vehicle->id + 1), {}});
    } else if (pointer.over && pointer.left_pressed) {
        drawing.held = true;
        drawing.points = {{vehicle->x, vehicle->y}};
    }
    state.hovered = {};
    if (drawing.held) extend(drawing, frame);
    if (drawing.held && !pointer.left_down) finish(drawing, outbox);
    return true;
}

bool draw_path_step(SceneInputState& state, const LabView& view, vec2 way) {
    PathDrawing& drawing = state.path;
    const VehicleView* vehicle = drawing.on && !drawing.held ? vehicle_to_draw_for(view) : nullptr;
    if (!vehicle) return false;
    if (drawing.points.empty()) drawing.points = {{vehicle->x, vehicle->y}};
    if (drawing.points.size() < most_points) drawing.points.push_back(in_arena(view, drawing.points.back() + way));
    return true;
}

bool take_back_path_step(SceneInputState& state) {
    PathDrawing& drawing = state.path;
    if (!drawing.on || drawing.held) return false;
    if (!drawing.points.empty()) drawing.points.pop_back();
    return true;
}

bool finish_path_drawing(SceneInputState& state, Outbox& outbox) {
    if (!state.path.on || state.path.held) return false;
    finish(state.path, outbox);
    return true;
}

bool cancel_path_drawing(SceneInputState& state) { return std::exchange(state.path, {}).on; }

}  // namespace braitenlab::ui

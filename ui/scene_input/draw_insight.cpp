#include "ui/scene_input/draw_insight.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <imgui.h>

#include "render/view/drawing.h"
#include "ui/map_look.h"
#include "ui/scene_input/draw.h"
#include "ui/scene_input/floor_lines.h"
#include "ui/widgets/paint.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

using maths::vec2;

namespace {

constexpr std::size_t ticks_per_point = 6;
constexpr float least_named = 0.3f;  // m, in an arena of full scale: a shorter path has no words at its end

// The part of a path that is still to come, `first` being the tick of its first pose.
std::vector<vec2> coming(const std::vector<Pose>& path, std::uint64_t first, std::uint64_t now) {
    std::vector<vec2> points;
    for (std::size_t i = now > first ? static_cast<std::size_t>(now - first) : 0; i < path.size(); ++i)
        if (i % ticks_per_point == 0 || i + 1 == path.size()) points.push_back({path[i].x, path[i].y});
    return points;
}

// Words at the end of a path; beside the vehicle, and without a dot, where one stands there.
void name_end(const SceneInputFrame& frame, const Ui& ui, const std::vector<vec2>& points, std::string_view words,
              Colour colour, NoteSide side = NoteSide::any) {
    const auto at = project(frame.camera_view, points.back());
    if (!at) return;
    constexpr float radius = 4, around = 6;
    const std::optional<Rect> body = body_at(frame, *at);
    if (!body) draw_dot(ui, {at->x, at->y}, radius, colour);
    draw_label(frame, ui, words, colour, body.value_or(square_around(*at, ui.px(2 * around))), side);
}

// True if the first point is higher on the screen.
bool is_higher(const SceneInputFrame& frame, vec2 a, vec2 b) {
    const auto first = project(frame.camera_view, a), second = project(frame.camera_view, b);
    return first && second && first->y < second->y;
}

// The whole path of the last run, while the new one waits at its start.
void draw_last_path(const SceneInputFrame& frame, const Ui& ui, GhostView run) {
    run.count = run.path->size();
    draw_path_dots(frame, ui, run, ui.palette.second_text);
    const Pose end = run.path->back();
    name_end(frame, ui, {{end.x, end.y}}, ui.strings("scene_input.last_run_end"), ui.palette.second_text);
    if (const auto at = project(frame.camera_view, {end.x, end.y}))
        ui.anchors.record("stage.last_run", square_around(*at, ui.px(24)));
}

void draw_prediction(const SceneInputFrame& frame, const Ui& ui, const PredictionView& shown) {
    const std::uint64_t now = frame.view.now->tick;
    const Palette& p = ui.palette;
    const Colour colour = p.text.with_alpha(shown.is_outdated ? 0.4f : 1.0f);
    for (const std::vector<Pose>& other : *shown.fan)
        draw_floor_line(frame, ui, coming(other, shown.tick, now), p.accent.with_alpha(0.35f), 1.25f);
    std::vector<vec2> points = coming(*shown.path, shown.tick, now);
    if (points.empty()) return;
    NoteSide side = NoteSide::any;  // the words of both ends do not overlap: one is above its end, the other one below
    if (shown.before) {
        const std::vector<vec2> before = coming(*shown.before, shown.before_tick, now);
        draw_floor_line(frame, ui, before, p.second_text.with_alpha(0.6f), 1.5f);
        constexpr float apart = 0.6f;  // m
        if (!before.empty() && maths::distance(before.back(), points.back()) > apart) {
            const bool above = is_higher(frame, points.back(), before.back());
            side = above ? NoteSide::above : NoteSide::below;
            name_end(frame, ui, before, ui.strings("scene_input.before"), p.second_text,
                     above ? NoteSide::below : NoteSide::above);
        }
    }
    draw_coming_dots(frame, ui, {shown.path, shown.tick, now}, colour);
    const std::uint64_t end = shown.tick + shown.path->size() - 1;
    const auto seconds = static_cast<int>(std::lround(static_cast<double>(end - now) / 60));
    const bool moves =
        maths::distance(points.front(), points.back()) > least_named * scale_of(frame.view.now->scene->arena);
    if (seconds > 0 && moves)
        name_end(frame, ui, points, fill(ui.strings("scene_input.in_seconds"), {std::to_string(seconds)}), colour,
                 side);
    if (const auto at = project(frame.camera_view, points.back()))
        ui.anchors.record("stage.prediction", square_around(*at, ui.px(16)));
}

// The path of the cell of the map under the pointer, and its kind.
void draw_map_path(const SceneInputFrame& frame, const Ui& ui, const MapView& map) {
    const std::vector<vec2> points = coming(*map.path, 0, 0);
    const insight::MapCell* cell = map.cells->shown(*map.hovered);
    if (points.empty() || !cell) return;
    keep_line_free(frame, ui, points);
    const MapColour colour = look_of(cell->outcome.behaviour).colour;
    draw_dashes(frame, ui, points, {colour.r, colour.g, colour.b, 1});
    name_end(frame, ui, points, ui.strings("map.kind." + std::string(row_of(cell->outcome.behaviour).word)),
             {colour.r, colour.g, colour.b, 1});
}

std::vector<vec2> points_of(const std::vector<Pose>& path) {
    std::vector<vec2> points;
    for (const Pose& pose : path) points.push_back({pose.x, pose.y});
    return points;
}

// The paths of all robots; thicker those of the weakest one and of the one under the pointer, which has its name.
void draw_robots(const SceneInputFrame& frame, const Ui& ui, const RobotsView& shown) {
    const insight::RobotsReport& report = *shown.report;
    const Palette& p = ui.palette;
    const auto tone = [&](const insight::RobotResult& robot) { return robot.works ? p.accent : p.warning; };
    const auto is_shown = [&](int index) {
        return !shown.replayed || *shown.replayed == every_robot || *shown.replayed == index;
    };
    for (int i = 0; i < static_cast<int>(report.robots.size()); ++i) {
        const insight::RobotResult& robot = report.robots[static_cast<std::size_t>(i)];
        if (!is_shown(i)) continue;
        const bool chosen = shown.replayed && *shown.replayed == i;
        draw_floor_line(frame, ui, points_of(robot.path), tone(robot).with_alpha(chosen ? 0.9f : 0.35f),
                        chosen ? 2.0f : 1.25f);
    }
    const int named = shown.hovered.value_or(shown.replayed ? every_robot : report.weakest);
    if (named < 0 || named >= static_cast<int>(report.robots.size())) return;
    const insight::RobotResult& robot = report.robots[static_cast<std::size_t>(named)];
    const std::vector<vec2> points = points_of(robot.path);
    if (points.empty()) return;
    keep_line_free(frame, ui, points);
    draw_floor_line(frame, ui, points, tone(robot), 2.5f);
    const std::string_view words = ui.strings(named == report.weakest ? "reality.weakest_robot" : "reality.robot");
    name_end(frame, ui, points, fill(words, {std::to_string(named + 1)}), tone(robot));
}

// The ghost covers the vehicle that it is compared with; it is drawn once the two runs differ.
bool is_beside(const LabView& view, const Pose& ghost) {
    constexpr float least = 0.15f;  // m
    const VehicleView* vehicle = selected_vehicle(view);
    return !vehicle || maths::distance(vec2{vehicle->x, vehicle->y}, vec2{ghost.x, ghost.y}) >= least;
}

// The driven part of a run.
std::vector<vec2> driven(const GhostView& run) {
    std::vector<vec2> points;
    for (std::size_t i = 0; i < run.count; ++i)
        if (i % ticks_per_point == 0 || i + 1 == run.count) points.push_back({(*run.path)[i].x, (*run.path)[i].y});
    return points;
}

std::optional<Rect> picture_of_ghost(const SceneInputFrame& frame, const std::optional<GhostView>& ghost) {
    if (!ghost) return std::nullopt;
    return picture_of_body(frame, {ghost->pose.x, ghost->pose.y}, ghost->length);
}

void draw_slots(const SceneInputFrame& frame, const Ui& ui, const SlotsView& slots) {
    constexpr float line_width = 2.5f;  // layout pixels
    const Palette& p = ui.palette;
    const std::optional<Rect> a = picture_of_ghost(frame, slots.a), b = picture_of_ghost(frame, slots.b);
    if (slots.a) {
        const std::vector<vec2> points = driven(*slots.a);
        draw_floor_line(frame, ui, points, p.slot_a, line_width);
        draw_label(frame, ui, "A", p.slot_a, *a, NoteSide::any, b);
        if (const auto at = project(frame.camera_view, points.back()))
            ui.anchors.record("stage.slot_a", square_around(*at, ui.px(24)));
    }
    if (!slots.b) return;
    draw_dashes(frame, ui, driven(*slots.b), p.slot_b);
    if (is_beside(frame.view, slots.b->pose))
        draw_ghost(frame, ui, *slots.b, {p.slot_b, p.slot_b, "B", "stage.slot_b", a});
}

// Names are placed beside all paths that are drawn.
void keep_paths_free(const SceneInputFrame& frame, const Ui& ui) {
    const LabView& view = frame.view;
    if (view.features.prediction) {
        keep_line_free(frame, ui,
                       coming(*view.features.prediction->path, view.features.prediction->tick, view.now->tick));
        if (view.features.prediction->before)
            keep_line_free(
                frame, ui,
                coming(*view.features.prediction->before, view.features.prediction->before_tick, view.now->tick));
    }
    if (view.mode == Mode::wiring) return;
    for (const auto& slot : {view.features.slots.a, view.features.slots.b})
        if (slot) keep_line_free(frame, ui, driven(*slot));
    if (const auto ghost = picture_of_ghost(frame, view.features.slots.b);
        ghost && is_beside(view, view.features.slots.b->pose))
        frame.labels->keep_free(*ghost);
}

}  // namespace

void draw_insight(const SceneInputFrame& frame, const Ui& ui) {
    const LabView& view = frame.view;
    keep_paths_free(frame, ui);
    if (view.mode == Mode::wiring) {
        if (view.features.prediction) draw_prediction(frame, ui, *view.features.prediction);
        return;
    }
    const bool waits = view.now->tick == 0 && view.mode == Mode::paused;
    if (view.features.last_run && !view.features.ghost && waits) draw_last_path(frame, ui, *view.features.last_run);
    if (view.features.last_run && !view.features.ghost && !waits && is_beside(view, view.features.last_run->pose))
        draw_ghost(frame, ui, *view.features.last_run,
                   {ui.palette.second_text, ui.palette.line, ui.strings("scene_input.last_run"), "stage.last_run"});
    draw_slots(frame, ui, view.features.slots);
    if (view.features.robots && view.features.robots->report) return draw_robots(frame, ui, *view.features.robots);
    if (view.features.map && view.features.map->hovered && view.features.map->path)
        return draw_map_path(frame, ui, *view.features.map);
    if (view.features.prediction && view.features.prediction->tick <= view.now->tick)
        draw_prediction(frame, ui, *view.features.prediction);
}

}  // namespace braitenlab::ui

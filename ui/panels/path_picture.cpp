#include "ui/panels/path_picture.h"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "core/lesson/selection.h"
#include "core/maths/angle.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"

namespace braitenlab::ui {

namespace {

// Maps the arena into a rectangle of the window.
struct ArenaMap {
    Rect place;
    float scale = 1;  // window pixels per metre

    ArenaMap(const Arena& arena, Rect to) : place(to), scale(std::min(to.w / arena.width, to.h / arena.height)) {}
    ImVec2 operator()(maths::vec2 at) const {
        return {place.x + place.w / 2 + at.x * scale, place.y + place.h / 2 - at.y * scale};
    }
};

constexpr int sides_of_round = 48;

// The outline of a rectangle or an ellipse with these half axes, m, as the current path of the draw list; `closed`:
// with its first corner again.
void path_of_outline(const ArenaMap& map, maths::vec2 middle, float half_x, float half_y, bool round,
                     bool closed = false) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const int corners = round ? sides_of_round : 4;
    for (int i = 0; i < corners + closed; ++i) {
        const float turn = 2 * maths::pi * (static_cast<float>(i) + (round ? 0 : 0.5f)) / static_cast<float>(corners);
        const float reach = round ? 1 : std::sqrt(2.0f);
        draw.PathLineTo(map({middle.x + half_x * reach * std::cos(turn), middle.y + half_y * reach * std::sin(turn)}));
    }
}

// The edge of an open arena is a table's: the floor beyond it is not drawn.
void draw_table(const Ui& ui, const Scene& scene, const ArenaMap& map) {
    if (scene.arena.edge != Boundary::open) return;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const Arena& arena = scene.arena;
    path_of_outline(map, {}, arena.width / 2, arena.height / 2, arena.round);
    draw.PathFillConvex(paint(mix(ui.palette.raised, ui.palette.text, 0.22f)));
    for (const Zone& zone : scene.zones) {
        if (zone.surface != Surface::tape || !zone.corners.empty() || zone.heading != 0) continue;
        path_of_outline(map, {zone.x, zone.y}, zone.length / 2, zone.width / 2, zone.round);
        draw.PathFillConvex(paint(ui.palette.panel));
    }
    path_of_outline(map, {}, arena.width / 2, arena.height / 2, arena.round, true);
    draw.PathStroke(paint(ui.palette.second_text), 0, ui.px(1.5f));
}

void draw_objects(const Ui& ui, const Scene& scene, const ArenaMap& map) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    for (const Obstacle& obstacle : scene.obstacles) {
        const ImVec2 at = map({obstacle.x, obstacle.y});
        const float half = std::max(ui.px(1), std::min(obstacle.length, obstacle.width) / 2 * map.scale);
        draw.AddRectFilled({at.x - half, at.y - half}, {at.x + half, at.y + half}, paint(ui.palette.line));
    }
    for (const Source& source : scene.sources)
        draw.AddCircleFilled(map({source.x, source.y}), ui.px(2), paint(ui.palette.second_text));
}

// Interrupted where the vehicle went over an edge of a torus.
void draw_path(const Ui& ui, const std::vector<maths::vec2>& path, const Arena& arena, const ArenaMap& map,
               ImU32 colour) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    maths::vec2 last = path.front();
    for (const maths::vec2 at : path) {
        const bool crosses_edge =
            std::fabs(at.x - last.x) > arena.width / 2 || std::fabs(at.y - last.y) > arena.height / 2;
        if (crosses_edge) draw.PathStroke(colour, 0, ui.px(1.5f));
        draw.PathLineTo(map(at));
        last = at;
    }
    draw.PathStroke(colour, 0, ui.px(1.5f));
    draw.AddCircleFilled(map(path.front()), ui.px(2), colour);
}

void draw_fall(const Ui& ui, ImVec2 at, ImU32 colour) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float r = ui.px(4), width = ui.px(2);
    draw.AddLine({at.x - r, at.y - r}, {at.x + r, at.y + r}, colour, width);
    draw.AddLine({at.x - r, at.y + r}, {at.x + r, at.y - r}, colour, width);
}

}  // namespace

void draw_run(const Ui& ui, const Exercise& exercise, const StartResult& run, Rect place, Colour of_path) {
    const Scene& scene = exercise.scene;
    const ArenaMap map(scene.arena, place);
    ImGui::PushClipRect({place.x, place.y}, {place.x + place.w, place.y + place.h}, true);
    draw_table(ui, scene, map);
    draw_objects(ui, scene, map);
    if (!run.path.empty()) {
        draw_path(ui, run.path, scene.arena, map, paint(of_path));
        if (scene.arena.edge == Boundary::open && has_fallen(exercise, run))
            draw_fall(ui, map(run.path.back()), paint(of_path));
    }
    ImGui::PopClipRect();
}

}  // namespace braitenlab::ui

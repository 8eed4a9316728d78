#include "ui/panels/path_picture.h"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "core/lesson/selection.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"

namespace braitenlab::ui {

namespace {

// Interrupted where the vehicle went over an edge of a torus.
void draw_path(const Ui& ui, const std::vector<maths::vec2>& path, const Arena& arena, const FloorMap& map,
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
    constexpr float share = 0.045f, least = 2.5f, most = 4;  // radius: of the picture's width; layout pixels
    draw.AddCircleFilled(map(path.front()), std::clamp(share * map.place.w, ui.px(least), ui.px(most)), colour);
}

void draw_fall(const Ui& ui, ImVec2 at, ImU32 colour) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float r = ui.px(5), width = ui.px(2.5f);
    draw.AddLine({at.x - r, at.y - r}, {at.x + r, at.y + r}, colour, width);
    draw.AddLine({at.x - r, at.y + r}, {at.x + r, at.y - r}, colour, width);
}

}  // namespace

void draw_run(const Ui& ui, const Exercise& exercise, const StartResult& run, const FloorMap& map, Colour of_path) {
    const Rect& place = map.place;
    ImGui::PushClipRect({place.x, place.y}, {place.x + place.w, place.y + place.h}, true);
    draw_floor(ui, exercise.scene, map);
    if (!run.path.empty()) {
        const Arena& arena = exercise.scene.arena;
        draw_path(ui, run.path, arena, map, paint(of_path));
        if (arena.edge == Boundary::open && has_fallen(exercise, run))
            draw_fall(ui, map(run.path.back()), paint(ui.palette.warning));
    }
    ImGui::PopClipRect();
}

}  // namespace braitenlab::ui

#include "ui/scene_input/draw_outside.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <imgui.h>

#include "render/view/pick.h"
#include "ui/widgets/paint.h"

namespace braitenlab::ui {

using maths::vec2;

namespace {

constexpr float arrow_inset = 20, disc = 7, rim = 2, tip = 15, tip_half = 5;  // layout pixels
constexpr std::size_t most_marked = 24;                                       // sources; of more the marks are a crowd

// Where the line from the middle of the area to a point outside leaves the area.
vec2 at_edge(const Rect& area, vec2 outside) {
    const vec2 middle = area.middle(), way = outside - middle;
    const float x = way.x != 0 ? 0.5f * area.w / std::fabs(way.x) : 1e9f;
    const float y = way.y != 0 ? 0.5f * area.h / std::fabs(way.y) : 1e9f;
    return middle + way * std::min(x, y);
}

}  // namespace

void draw_sources_outside(const SceneInputFrame& frame, const Ui& ui) {
    const Snapshot& now = *frame.view.now;
    if (frame.view.mode == Mode::wiring || rides(frame.view.settings.camera.mode) || now.sources.size() > most_marked)
        return;
    const float inset = ui.px(arrow_inset);
    const Rect area{frame.area.x + inset, frame.area.y + inset, frame.area.w - 2 * inset, frame.area.h - 2 * inset};
    if (area.w <= 0 || area.h <= 0) return;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    for (const SourceView& source : now.sources) {
        const auto bulb = project(frame.camera_view, {source.x, source.y}, bulb_height * scale_of(now.scene->arena));
        if (!bulb || source.strength == 0 || frame.area.contains(bulb->x, bulb->y)) continue;
        const vec2 at = at_edge(area, *bulb), way = maths::normalise(*bulb - at), side{-way.y, way.x};
        const auto point = [&](vec2 offset) { return ImVec2{at.x + ui.px(offset.x), at.y + ui.px(offset.y)}; };
        const auto arrow = [&](float grown, Colour colour) {
            const ImVec2 middle{at.x, at.y};
            list.AddCircleFilled(middle, ui.px(disc + grown), paint(colour), 24);
            list.AddTriangleFilled(point(way * (tip + 1.5f * grown)), point(side * (tip_half + grown) + way * 4.0f),
                                   point(side * -(tip_half + grown) + way * 4.0f), paint(colour));
        };
        arrow(rim, ui.palette.ground.with_alpha(0.85f));
        arrow(0, colour_of(ui.palette, source.channel));
        const Rect place = square_around(at, ui.px(2 * tip));
        if (frame.labels) frame.labels->take(place);
        ui.anchors.record("stage.outside." + std::to_string(source.source), place);
    }
}

}  // namespace braitenlab::ui

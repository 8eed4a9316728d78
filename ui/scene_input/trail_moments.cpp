#include "ui/scene_input/trail_moments.h"

#include <algorithm>
#include <string>

#include "core/brain/brain.h"
#include "ui/scene_input/draw.h"
#include "ui/scene_input/under_pointer.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

using maths::vec2;

namespace {

constexpr std::size_t ticks_between_points = 6;
constexpr float trail_reach = 8, from_the_vehicle = 26;  // layout pixels

vec2 position(const Pose& pose) { return {pose.x, pose.y}; }

// The poses up to the displayed tick; 0 where no trail is shown.
std::size_t shown_poses(const LabView& view) {
    if (!view.features.path || !view.settings.overlays.trails || view.mode == Mode::wiring || !can_tell_why(view))
        return 0;
    return std::min(view.features.path->size(), static_cast<std::size_t>(view.now->tick) + 1);
}

}  // namespace

std::optional<std::uint64_t> trail_moment_at_pointer(const SceneInputState& state, const SceneInputFrame& frame) {
    if (!frame.pointer.over || state.tool != SceneInputTool::hand) return std::nullopt;
    const std::size_t count = shown_poses(frame.view);
    if (count == 0) return std::nullopt;
    const std::vector<Pose>& path = *frame.view.features.path;
    if (pixels_from(frame, position(path[count - 1])) < from_the_vehicle * frame.scale) return std::nullopt;
    std::optional<std::uint64_t> nearest;
    float least = trail_reach * frame.scale * finger_reach(frame.view);
    for (std::size_t i = 0; i < count; i += ticks_between_points)
        if (const float away = pixels_from(frame, position(path[i])); away <= least) least = away, nearest = i;
    return nearest;
}

void draw_trail_moment(const SceneInputFrame& frame, const Ui& ui, std::uint64_t tick) {
    if (tick >= shown_poses(frame.view) || frame.view.lecture) return;  // a lecture has no tooltips
    const auto at = project(frame.camera_view, position((*frame.view.features.path)[static_cast<std::size_t>(tick)]));
    if (!at) return;
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    draw.AddCircle({at->x, at->y}, ui.px(7), paint(ui.palette.panel), 0, ui.px(5));
    draw.AddCircle({at->x, at->y}, ui.px(7), paint(ui.palette.accent), 0, ui.px(2.5f));
    const std::string seconds = fixed(ui, static_cast<float>(tick) * tick_seconds, 1);
    draw_note(frame, ui, fill(ui.strings("scene_input.why_at"), {seconds}), ui.palette.accent, *at, NoteSide::above);
}

}  // namespace braitenlab::ui

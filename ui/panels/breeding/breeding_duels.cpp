#include <algorithm>
#include <cmath>
#include <string>

#include <imgui.h>

#include "ui/panels/breeding/breeding_parts.h"
#include "ui/panels/scene_picture.h"
#include "ui/widgets/item.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

using evolve::Duel;
using evolve::Side;

constexpr float least_body = 9;  // layout pixels

// A body with a point at its front for a predator, and a round one for prey.
void draw_body(const Ui& ui, const FloorMap& map, const Pose& pose, Role role, float length) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const Colour colour = colour_of(ui.palette, role);
    const ImVec2 at = map({pose.x, pose.y});
    const float size = std::max(ui.px(least_body), length * map.scale) / 2;
    const ImVec2 ahead{std::cos(pose.heading) * size, -std::sin(pose.heading) * size};
    const ImVec2 left{ahead.y * 0.62f, -ahead.x * 0.62f};
    if (role == Role::predator) {
        draw.AddTriangleFilled({at.x + 1.2f * ahead.x, at.y + 1.2f * ahead.y},
                               {at.x - ahead.x + left.x, at.y - ahead.y + left.y},
                               {at.x - ahead.x - left.x, at.y - ahead.y - left.y}, paint(colour));
    } else {
        draw.AddCircleFilled(at, 0.75f * size, paint(colour), 16);
        draw.AddLine(at, {at.x + 1.2f * ahead.x, at.y + 1.2f * ahead.y}, paint(colour), ui.px(2));
    }
}

void draw_trail(const Ui& ui, const FloorMap& map, const std::vector<Pose>& path, std::size_t end, Colour colour) {
    constexpr std::size_t step = 6;  // ticks
    constexpr float jump = 2;        // m: across the seam of a torus
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    for (std::size_t i = step; i <= end; i += step) {
        const maths::vec2 from{path[i - step].x, path[i - step].y}, to{path[i].x, path[i].y};
        if (maths::distance(from, to) < jump) draw.AddLine(map(from), map(to), paint(colour), ui.px(1.5f));
    }
}

// The match at this time; at its end if the time is later.
void picture_of_duel(const BreedingView& view, const Duel& duel, double seconds, Ui& ui, Rect r) {
    const Scene& scene = view.base->scene();
    fill_box(ui, r, ui.palette.raised, Corner::box);
    const float inset = ui.px(spacing::tight);
    const Rect inner{r.x + inset, r.y + inset, r.w - 2 * inset, r.h - 2 * inset};
    const maths::vec2 half{scene.arena.width / 2, scene.arena.height / 2};
    const FloorMap map({-half, half}, inner);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.PushClipRect({inner.x, inner.y}, {inner.x + inner.w, inner.y + inner.h}, true);
    draw_floor(ui, scene, map);
    const std::size_t last = duel.paths.front().size() - 1;
    const std::size_t tick = std::min(last, static_cast<std::size_t>(seconds * 60));
    for (const Side side : {Side::prey, Side::predator}) {
        const Role role = role_of(side);
        const std::vector<Pose>& path = at(duel.paths, side);
        draw_trail(ui, map, path, tick, colour_of(ui.palette, role).with_alpha(0.7f));
        draw_body(ui, map, path[tick], role, view.base->kind(side).body.length);
    }
    draw.PopClipRect();
    line_box(ui, r, ui.palette.line, Corner::box);
}

// The moment of the matches now. Without motion they are shown at their ends.
double moment_of(const LabView& lab, double began) {
    const double longest =
        static_cast<double>(std::max_element(lab.features.breeding.duels->begin(), lab.features.breeding.duels->end(),
                                             [](const Duel& a, const Duel& b) { return a.seconds() < b.seconds(); })
                                ->seconds());
    return lab.program.reduce_motion ? longest
                                     : std::fmod(std::max(0.0, lab.wall_seconds - began), longest + rest_after_match);
}

std::string name_of_match(const BreedingView& view, const Ui& ui, const BreedingCell& cell) {
    if (view.watches_panel) return fill(ui.strings("breeding.panel_duel"), {std::to_string(cell.prey)});
    return fill(ui.strings("breeding.duel"), {std::to_string(cell.predator), std::to_string(cell.prey)});
}

// "Run 3 of 4: eaten after 1.4 s" of the match whose start is shown, "Same start: …" of the other.
std::string end_of_match(const BreedingView& view, const Ui& ui, std::size_t match, bool is_eaten, float seconds) {
    std::string end = fill(ui.strings(is_eaten ? "breeding.eaten" : "breeding.lives"), {fixed(ui, seconds, 1)});
    if (view.watches_panel) return end;
    if (match != view.start.match) return fill(ui.strings("breeding.same_start"), {end});
    return fill(ui.strings("breeding.run_of_match"),
                {std::to_string(view.start.run + 1), std::to_string(evolve::tournament_trials), end});
}

// The lines that the names of the watched matches need.
std::size_t lines_of_names(const BreedingView& view, const Ui& ui, float width) {
    std::size_t most = 1;
    for (const BreedingCell& cell : view.watched)
        most = std::max(most, lines_of_words(ui, name_of_match(view, ui, cell), Face::small, width).size());
    return most;
}

// The same of their ends, whatever these will be: the pictures stay in their places.
std::size_t lines_of_ends(const BreedingView& view, const Ui& ui, float width) {
    std::size_t most = 1;
    for (const std::size_t match : {view.start.match, view.start.match + 1})
        for (const bool is_eaten : {true, false}) {
            const std::string end = end_of_match(view, ui, match, is_eaten, view.base->breeding().seconds);
            most = std::max(most, lines_of_words(ui, end, Face::small, width).size());
        }
    return most;
}

}  // namespace

void breeding_duels(const LabView& lab, BreedingSheetState& state, Ui& ui, Rect r) {
    const BreedingView& view = lab.features.breeding;
    if (state.watched != view.watched || !view.duels) state.watched = view.watched, state.began = lab.wall_seconds;
    if (view.watched.empty()) {
        if (view.matrix->size() == 0) return;  // there is no cell to click
        put_lines(ui, {r.x, r.y}, ui.strings("breeding.watch_how"), ui.palette.second_text, Face::small, r.w, 6);
        return;
    }
    const float line = line_height(ui, Face::small), space = ui.px(spacing::medium), tight = ui.px(spacing::tight);
    const float width = (r.w - space) / 2;
    const std::size_t in_names = lines_of_names(view, ui, width), in_ends = lines_of_ends(view, ui, width);
    const float words = static_cast<float>(in_names + in_ends) * line + tight;
    const float below = 2 * line + tight;  // of the words about both
    const float side = std::min(width, r.h - words - below);
    for (std::size_t i = 0; i < view.watched.size(); ++i) {
        const BreedingCell& cell = view.watched[i];
        const Rect picture{r.x + static_cast<float>(i) * (width + space), r.y + words, side, side};
        mark(ui, "breeding.duel." + std::to_string(i + 1), picture);
        put_lines(ui, {picture.x, r.y}, name_of_match(view, ui, cell), ui.palette.text, Face::small, width, in_names);
        if (!view.duels) continue;
        const Duel& duel = (*view.duels)[i];
        put_lines(ui, {picture.x, r.y + static_cast<float>(in_names) * line},
                  end_of_match(view, ui, i, duel.is_eaten, duel.seconds()), ui.palette.second_text, Face::small, width,
                  in_ends);
        picture_of_duel(view, duel, moment_of(lab, state.began), ui, picture);
    }
    if (!view.watches_panel)
        put_lines(ui, {r.x, r.y + words + side + tight}, ui.strings("breeding.nearest_start"), ui.palette.second_text,
                  Face::small, r.w, 2);
}

}  // namespace braitenlab::ui

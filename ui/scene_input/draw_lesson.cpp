#include "ui/scene_input/draw_lesson.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <imgui.h>

#include "core/maths/angle.h"
#include "render/view/drawing.h"
#include "ui/scene_input/draw.h"
#include "ui/strings.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"

namespace braitenlab::ui {

using maths::vec2;

namespace {

class LessonDrawing {
public:
    LessonDrawing(const SceneInputState& state, const SceneInputFrame& frame, const Ui& ui)
        : state_(state), frame_(frame), ui_(ui) {}

    void draw() const {
        const LabView& view = frame_.view;
        if (!view.lesson || view.mode == Mode::wiring) return;
        if (state_.path.on) draw_start();
        if (state_.path.held)
            dashes(state_.path.points, ui_.palette.accent, path_width);
        else if (!view.ghost && !(view.lesson->grade && view.lesson->grade->good))
            draw_paths(*view.lesson);
        if (view.ghost) draw_ghost(*view.ghost);
    }

private:
    static constexpr float path_width = 2.5f, ghost_width = 1.75f;  // layout pixels
    static constexpr float path_dash = 0.22f, path_gap = 0.14f;     // m
    static constexpr float ghost_dash = 0.11f, ghost_gap = 0.08f;
    static constexpr float jump = 2;  // m: points farther apart are not joined; the seam of a torus lies between them

    void segment(vec2 from, vec2 to, float from_height, float to_height, Colour colour, float width) const {
        const auto a = project(frame_.camera_view, from, from_height), b = project(frame_.camera_view, to, to_height);
        if (a && b) draw_line(ui_, {{a->x, a->y}, {b->x, b->y}}, colour, width, false);
    }

    // Dashes of one length on the floor, so that they stay where they are when the camera moves.
    void dashes(const std::vector<vec2>& points, Colour colour, float width, float height = 0, float dash = path_dash,
                float gap = path_gap) const {
        float along = 0;  // m since the begin of the last dash
        for (std::size_t i = 1; i < points.size(); ++i) {
            const vec2 from = points[i - 1], way = points[i] - from;
            const float length = maths::length(way);
            if (length <= 0 || length > jump) continue;
            for (float done = 0; done < length;) {
                const bool drawn = along < dash;
                const float step = std::min(length - done, (drawn ? dash : dash + gap) - along);
                if (drawn)
                    segment(from + way * (done / length), from + way * ((done + step) / length), height, height, colour,
                            width);
                done += std::max(step, 1e-4f);
                along += std::max(step, 1e-4f);
                if (along >= dash + gap) along = 0;
            }
        }
    }

    void line(const std::vector<vec2>& points, Colour colour, float width) const {
        std::vector<ImVec2> piece;
        const auto end_piece = [&] { draw_line(ui_, piece, colour, width, false), piece.clear(); };
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto at = project(frame_.camera_view, points[i]);
            if (!at || (i > 0 && maths::distance(points[i - 1], points[i]) > jump)) end_piece();
            if (at) piece.push_back({at->x, at->y});
        }
        end_piece();
    }

    void name(vec2 place, float height, std::string_view key, Colour edge) const {
        if (const auto at = project(frame_.camera_view, place, height))
            draw_note(frame_, ui_, ui_.strings(key), edge, *at);
    }

    // A ring around the vehicle at which the path begins.
    void draw_start() const {
        const VehicleView* vehicle = vehicle_to_draw_for(frame_.view);
        if (!vehicle) return;
        constexpr int segments = 48;
        std::vector<vec2> ring;
        for (int i = 0; i <= segments; ++i)
            ring.push_back(vec2{vehicle->x, vehicle->y} +
                           maths::from_polar(0.95f, 2 * maths::pi * static_cast<float>(i) / segments));
        line(ring, ui_.palette.accent.with_alpha(0.5f + 0.5f * ui_.pulse), 2.5f);
        const auto at = project(frame_.camera_view, {vehicle->x, vehicle->y});
        const float size = ui_.px(24);
        if (at) ui_.anchors.record("stage.path", {at->x - size / 2, at->y - size / 2, size, size});
    }

    void draw_paths(const LessonView& lesson) const {
        if (lesson.drawn_path.empty()) return;
        line(lesson.real_path, ui_.palette.text, path_width);
        dashes(lesson.drawn_path, ui_.palette.accent, path_width);
        const vec2 end = lesson.drawn_path.back();
        name(end, 0, "scene_input.predicted_path", ui_.palette.accent);
        if (lesson.real_path.empty()) return;
        // Far from the other name.
        const auto place = std::max_element(lesson.real_path.begin(), lesson.real_path.end(), [&](vec2 a, vec2 b) {
            return maths::distance(a, end) < maths::distance(b, end);
        });
        name(*place, 0, "scene_input.real_path", ui_.palette.text);
    }

    void draw_ghost(const GhostView& ghost) const {
        draw_dots(ghost);
        const auto corner = [&](float ahead, float left) {
            const float c = std::cos(ghost.pose.heading), s = std::sin(ghost.pose.heading);
            return vec2{ghost.pose.x + c * ahead - s * left, ghost.pose.y + s * ahead + c * left};
        };
        const float x = ghost.length / 2, y = ghost.width / 2;
        const std::vector<vec2> outline{corner(x, y), corner(-x, y), corner(-x, -y), corner(x, -y), corner(x, y)};
        fill(outline);
        for (const float height : {0.02f, render::deck_height})
            dashes(outline, ui_.palette.text, ghost_width, height, ghost_dash, ghost_gap);
        for (std::size_t i = 0; i < 4; ++i)
            segment(outline[i], outline[i], 0.02f, render::deck_height, ui_.palette.text, ghost_width);
        const std::vector<vec2> arrow{corner(0, 0.4f * y), corner(0.7f * x, 0), corner(0, -0.4f * y)};
        for (std::size_t i = 1; i < arrow.size(); ++i)
            segment(arrow[i - 1], arrow[i], render::deck_height, render::deck_height, ui_.palette.text, ghost_width);
        name({ghost.pose.x, ghost.pose.y}, render::deck_height, "scene_input.solution", ui_.palette.second_text);
        const auto at = project(frame_.camera_view, {ghost.pose.x, ghost.pose.y});
        const float size = ui_.px(24);
        if (at) ui_.anchors.record("stage.ghost", {at->x - size / 2, at->y - size / 2, size, size});
    }

    void fill(const std::vector<vec2>& outline) const {
        std::vector<ImVec2> points;
        for (std::size_t i = 0; i + 1 < outline.size(); ++i)
            if (const auto at = project(frame_.camera_view, outline[i], render::deck_height))
                points.push_back({at->x, at->y});
        if (points.size() == 4)
            ImGui::GetBackgroundDrawList()->AddConvexPolyFilled(points.data(), 4,
                                                                paint(ui_.palette.text.with_alpha(0.14f)));
    }

    // At fixed times, so that their distances show the speed; they fade within a minute.
    void draw_dots(const GhostView& ghost) const {
        constexpr std::size_t ticks_per_dot = 15, most_ticks = 3600;
        const std::size_t last = ghost.count - 1;
        for (std::size_t tick = last / ticks_per_dot * ticks_per_dot; tick + most_ticks > last; tick -= ticks_per_dot) {
            const Pose& pose = (*ghost.path)[tick];
            const float age = static_cast<float>(last - tick) / static_cast<float>(most_ticks);
            if (const auto at = project(frame_.camera_view, {pose.x, pose.y}))
                draw_dot(ui_, {at->x, at->y}, 2, ui_.palette.text.with_alpha(0.8f - 0.6f * age));
            if (tick == 0) break;
        }
    }

    const SceneInputState& state_;
    const SceneInputFrame& frame_;
    const Ui& ui_;
};

}  // namespace

void draw_lesson(const SceneInputState& state, const SceneInputFrame& frame, const Ui& ui) {
    LessonDrawing(state, frame, ui).draw();
}

}  // namespace braitenlab::ui

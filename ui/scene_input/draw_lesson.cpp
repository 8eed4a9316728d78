#include "ui/scene_input/draw_lesson.h"

#include <algorithm>
#include <vector>

#include <imgui.h>

#include "core/maths/angle.h"
#include "ui/scene_input/draw.h"
#include "ui/scene_input/floor_lines.h"
#include "ui/scene_input/path_drawing.h"
#include "ui/widgets/paint.h"
#include "ui/words/strings.h"

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
        if (state_.path.points.size() > 1)
            dashes(state_.path.points, ui_.palette.accent);
        else if (!view.features.ghost && !(view.lesson->grade && view.lesson->grade->good))
            draw_paths(*view.lesson);
        if (view.features.ghost)
            draw_ghost(frame_, ui_, *view.features.ghost,
                       {ui_.palette.text, ui_.palette.second_text, ui_.strings("scene_input.solution"), "stage.ghost"});
    }

private:
    static constexpr float path_width = 2.5f;  // layout pixels

    void dashes(const std::vector<vec2>& points, Colour colour) const { draw_dashes(frame_, ui_, points, colour); }
    void line(const std::vector<vec2>& points, Colour colour, float width) const {
        draw_floor_line(frame_, ui_, points, colour, width);
    }
    void name(vec2 place, std::string_view key, Colour edge) const {
        const auto at = project(frame_.camera_view, place);
        if (at) draw_label(frame_, ui_, ui_.strings(key), edge, square_around(*at, ui_.px(6)));
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
        if (at) ui_.anchors.record("stage.path", square_around(*at, ui_.px(24)));
    }

    void draw_paths(const LessonView& lesson) const {
        const std::vector<vec2>& drawn = lesson.attempt.answers.drawn_path;
        const std::vector<vec2>& real = lesson.attempt.work.real_path;
        if (drawn.empty()) return;
        keep_line_free(frame_, ui_, real);
        keep_line_free(frame_, ui_, drawn);
        line(real, ui_.palette.text, path_width);
        dashes(drawn, ui_.palette.accent);
        const vec2 end = drawn.back();
        name(end, "scene_input.predicted_path", ui_.palette.accent);
        if (real.empty()) return;
        // Far from the other name.
        const auto place = std::max_element(real.begin(), real.end(), [&](vec2 a, vec2 b) {
            return maths::distance(a, end) < maths::distance(b, end);
        });
        name(*place, "scene_input.real_path", ui_.palette.text);
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

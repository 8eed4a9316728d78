#include "ui/panels/course/marks.h"

#include <algorithm>
#include <optional>
#include <string>

#include <imgui.h>

#include "ui/shortcuts.h"
#include "ui/strings.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"

namespace braitenlab::ui {

namespace {

constexpr float pen_width = 4, pen_border = 2;  // layout pixels
constexpr float least_step = 3;                 // layout pixels between two points
constexpr std::size_t most_points = 20'000;     // of all lines

std::size_t point_count(const Marks& marks) {
    std::size_t count = 0;
    for (const MarkLine& line : marks.lines) count += line.points.size();
    return count;
}

// Where the lines are.
struct Paper {
    const CameraView* camera;  // null: there is no floor
    Rect scene, window;

    // Null outside the scene and above the horizon.
    std::optional<maths::vec2> floor_at(ImVec2 pixel) const {
        if (!camera || !scene.contains(pixel.x, pixel.y)) return std::nullopt;
        return unproject(*camera, {pixel.x, pixel.y});
    }
    std::optional<maths::vec2> pixel_of(const MarkLine& line, maths::vec2 point) const {
        if (!line.on_floor) return maths::vec2{window.x + point.x * window.w, window.y + point.y * window.h};
        return camera ? project(*camera, point) : std::nullopt;
    }
    maths::vec2 share_of(ImVec2 pixel) const {
        return {(pixel.x - window.x) / std::max(1.0f, window.w), (pixel.y - window.y) / std::max(1.0f, window.h)};
    }
};

void add_point(const Paper& paper, Marks& marks, const Ui& ui, ImVec2 pointer) {
    if (point_count(marks) >= most_points) return;
    const auto floor = paper.floor_at(pointer);
    if (marks.lines.back().points.empty()) marks.lines.back().on_floor = floor.has_value();
    // The line leaves or enters the scene: another one goes on from here.
    if (marks.lines.back().on_floor != floor.has_value()) marks.lines.push_back({floor.has_value()});
    MarkLine& line = marks.lines.back();
    if (!line.points.empty()) {
        const auto last = paper.pixel_of(line, line.points.back());
        if (last && maths::length(maths::vec2{pointer.x, pointer.y} - *last) < ui.px(least_step)) return;
    }
    line.points.push_back(floor ? *floor : paper.share_of(pointer));
}

// A window without a picture below the bar takes the mouse from the cards.
void follow_pen(const Paper& paper, Marks& marks, const Ui& ui, Rect bar) {
    const ImGuiIO& io = ImGui::GetIO();
    const float top = bar.y + bar.h;
    ImGui::SetNextWindowPos({paper.window.x, top});
    ImGui::SetNextWindowSize({paper.window.w, std::max(1.0f, paper.window.y + paper.window.h - top)});
    ImGui::Begin("marks", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollWithMouse);
    const bool over = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    ImGui::End();
    if (over && ImGui::IsMouseClicked(0)) marks.pressed = true, marks.lines.emplace_back();
    marks.pressed &= io.MouseDown[0];
    if (marks.pressed) add_point(paper, marks, ui, io.MousePos);
}

// The pixels of the line; a part behind the camera is left out.
void draw_line(const Paper& paper, const MarkLine& line, ImU32 colour, float width) {
    ImDrawList& draw = *ImGui::GetForegroundDrawList();
    std::vector<ImVec2> pixels;
    const auto finish = [&] {
        if (pixels.size() > 1) draw.AddPolyline(pixels.data(), static_cast<int>(pixels.size()), colour, 0, width);
        for (const ImVec2& end : pixels) draw.AddCircleFilled(end, width / 2, colour);  // round ends and joints
        pixels.clear();
    };
    const Rect& within = line.on_floor ? paper.scene : paper.window;
    draw.PushClipRect({within.x, within.y}, {within.x + within.w, within.y + within.h});
    for (const maths::vec2 place : line.points) {
        const auto pixel = paper.pixel_of(line, place);
        if (pixel)
            pixels.push_back({pixel->x, pixel->y});
        else
            finish();
    }
    finish();
    draw.PopClipRect();
}

void sign_of_pen(Ui& ui, Rect scene, Rect window) {
    const std::string words = fill(ui.strings("lecture.drawing"), {key_name(Action::draw_marks, ui.strings),
                                                                   key_name(Action::clear_marks, ui.strings)});
    ImDrawList& draw = *ImGui::GetForegroundDrawList();
    const float w = text_width(ui, Face::strong, words) + ui.px(24), h = line_height(ui, Face::strong) + ui.px(12);
    const float x = std::clamp(scene.x + (scene.w - w) / 2, window.x, std::max(window.x, window.x + window.w - w));
    const Rect sign{x, scene.y + scene.h - h - ui.px(8), w, h};
    draw.AddRectFilled({sign.x, sign.y}, {sign.x + w, sign.y + h}, paint(ui.palette.warning), ui.px(radius::box));
    put_on(draw, ui, {sign.x + ui.px(12), sign.y + ui.px(6)}, words, ui.palette.ground, Face::strong);
    ui.anchors.record("marks.sign", sign);
}

}  // namespace

void draw_marks(const LabView& view, Marks& marks, Ui& ui, Rect scene, Rect bar, Rect window) {
    if (!view.lecture || marks.run_id != view.run_id) marks.lines.clear(), marks.pressed = false;
    marks.run_id = view.run_id;
    marks.drawing &= view.lecture;
    // In Mode::wiring the scene is a small inset.
    const Paper paper{view.mode == Mode::wiring ? nullptr : view.camera_view, scene, window};
    if (marks.drawing) follow_pen(paper, marks, ui, bar);
    for (const MarkLine& line : marks.lines)
        draw_line(paper, line, paint(ui.palette.ground), ui.px(pen_width + 2 * pen_border));
    for (const MarkLine& line : marks.lines) draw_line(paper, line, paint(ui.palette.warning), ui.px(pen_width));
    if (marks.drawing) sign_of_pen(ui, scene, window);
}

}  // namespace braitenlab::ui

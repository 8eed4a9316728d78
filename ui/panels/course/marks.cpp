#include "ui/panels/course/marks.h"

#include <algorithm>
#include <optional>
#include <string>

#include <imgui.h>

#include "ui/imgui_compat.h"
#include "ui/shortcuts.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

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
    const MarkedParts& parts;

    MarkedPart part_at(ImVec2 pixel) const {
        const auto has = [pixel](const Rect& r) { return r.w > 0 && r.contains(pixel.x, pixel.y); };
        if (has(parts.diagram)) return MarkedPart::diagram;
        if (has(parts.strip)) return MarkedPart::strip;
        if (has(parts.question)) return MarkedPart::question;
        const bool on_floor = camera && has(parts.scene) && unproject(*camera, {pixel.x, pixel.y});
        return on_floor ? MarkedPart::floor : MarkedPart::window;  // not above the horizon
    }
    const Rect& rect_of(MarkedPart part) const {
        return part == MarkedPart::floor      ? parts.scene
               : part == MarkedPart::diagram  ? parts.diagram
               : part == MarkedPart::strip    ? parts.strip
               : part == MarkedPart::question ? parts.question
                                              : parts.window;
    }
    // nullopt for a point behind the camera, and while the part is not shown.
    std::optional<maths::vec2> pixel_of(MarkedPart part, maths::vec2 point) const {
        const Rect& r = rect_of(part);
        if (r.w <= 0) return std::nullopt;
        if (part == MarkedPart::floor) return camera ? project(*camera, point) : std::nullopt;
        if (part == MarkedPart::diagram) return parts.of_diagram.to_window(point);
        return maths::vec2{r.x + point.x * r.w, r.y + point.y * r.h};
    }
    // Precondition: part_at(pixel) is this part.
    maths::vec2 point_at(MarkedPart part, maths::vec2 pixel) const {
        if (part == MarkedPart::floor) return *unproject(*camera, pixel);
        if (part == MarkedPart::diagram) return parts.of_diagram.to_canvas(pixel);
        const Rect& r = rect_of(part);
        return {(pixel.x - r.x) / std::max(1.0f, r.w), (pixel.y - r.y) / std::max(1.0f, r.h)};
    }
};

void add_point(const Paper& paper, Marks& marks, const Ui& ui, ImVec2 pointer) {
    if (point_count(marks) >= most_points) return;
    const MarkedPart part = paper.part_at(pointer);
    if (marks.lines.back().points.empty()) marks.lines.back().on = part, marks.lines.back().asked = paper.parts.asked;
    // The line leaves its part: another one goes on from here.
    if (marks.lines.back().on != part) marks.lines.push_back({.on = part, .asked = paper.parts.asked});
    MarkLine& line = marks.lines.back();
    const maths::vec2 pixel{pointer.x, pointer.y};
    if (!line.points.empty()) {
        const auto last = paper.pixel_of(part, line.points.back());
        if (last && maths::length(pixel - *last) < ui.px(least_step)) return;
    }
    line.points.push_back(paper.point_at(part, pixel));
}

// A window without a picture below the bar takes the mouse from the cards.
void follow_pen(const Paper& paper, Marks& marks, const Ui& ui) {
    const ImGuiIO& io = ImGui::GetIO();
    const Rect &window = paper.parts.window, &bar = paper.parts.bar;
    const float top = bar.y + bar.h;
    ImGui::SetNextWindowPos({window.x, top});
    ImGui::SetNextWindowSize({window.w, std::max(1.0f, window.y + window.h - top)});
    ImGui::Begin("marks", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollWithMouse);
    const bool over = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    compat::end_window();
    if (over && ImGui::IsMouseClicked(0)) marks.pressed = true, marks.lines.emplace_back();
    marks.pressed &= io.MouseDown[0];
    if (marks.pressed) add_point(paper, marks, ui, io.MousePos);
}

// The pixels of the line; a part behind the camera is left out.
void draw_line(const Paper& paper, const MarkLine& line, ImU32 colour, float width) {
    if (line.on == MarkedPart::question && line.asked != paper.parts.asked) return;
    ImDrawList& draw = *ImGui::GetForegroundDrawList();
    std::vector<ImVec2> pixels;
    const auto finish = [&] {
        if (pixels.size() > 1) draw.AddPolyline(pixels.data(), static_cast<int>(pixels.size()), colour, 0, width);
        for (const ImVec2& end : pixels) draw.AddCircleFilled(end, width / 2, colour);  // round ends and joints
        pixels.clear();
    };
    const Rect& within = paper.rect_of(line.on);
    draw.PushClipRect({within.x, within.y}, {within.x + within.w, within.y + within.h});
    for (const maths::vec2 place : line.points) {
        const auto pixel = paper.pixel_of(line.on, place);
        if (pixel)
            pixels.push_back({pixel->x, pixel->y});
        else
            finish();
    }
    finish();
    draw.PopClipRect();
}

}  // namespace

void sign_of_pen(Ui& ui, Rect place) {
    const std::string words = fill(ui.strings("lecture.drawing"), {key_name(Action::draw_marks, ui.strings),
                                                                   key_name(Action::clear_marks, ui.strings)});
    const float side = ui.px(spacing::small), most = std::max(1.0f, place.w - 2 * side);
    const bool is_wide = text_width(ui, Face::strong, words) <= most;
    const Face face = is_wide ? Face::strong : Face::small;
    const float w = is_wide ? text_width(ui, face, words) : most;
    const auto lines = static_cast<float>(std::min<std::size_t>(2, lines_of_words(ui, words, face, most).size()));
    const float h = lines * line_height(ui, face) + ui.px(8);
    const Rect sign{place.x, place.y + (place.h - h) / 2, w + 2 * side, h};
    fill_box(ui, sign, ui.palette.warning);
    put_lines(ui, {sign.x + side, sign.y + ui.px(4)}, words, ui.palette.ground, face, most, 2);
    mark(ui, "marks.sign", sign);
}

void draw_marks(const LabView& view, Marks& marks, Ui& ui, const MarkedParts& parts) {
    if (!view.lecture || marks.run_id != view.run_id) marks.lines.clear(), marks.pressed = false;
    marks.run_id = view.run_id;
    marks.drawing &= view.lecture;
    // In Mode::wiring the scene is a small inset.
    const Paper paper{view.mode == Mode::wiring ? nullptr : view.camera_view, parts};
    if (marks.drawing) follow_pen(paper, marks, ui);
    for (const MarkLine& line : marks.lines)
        draw_line(paper, line, paint(ui.palette.ground), ui.px(pen_width + 2 * pen_border));
    for (const MarkLine& line : marks.lines) draw_line(paper, line, paint(ui.palette.warning), ui.px(pen_width));
}

}  // namespace braitenlab::ui

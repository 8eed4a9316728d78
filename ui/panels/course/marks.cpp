#include "ui/panels/course/marks.h"

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
    for (const auto& line : marks.lines) count += line.size();
    return count;
}

void add_point(const CameraView& camera, Marks& marks, const Ui& ui, ImVec2 pointer) {
    const auto place = unproject(camera, {pointer.x, pointer.y});
    if (!place || point_count(marks) >= most_points) return;
    auto& line = marks.lines.back();
    if (!line.empty()) {
        const auto last = project(camera, line.back());
        if (last && maths::length(maths::vec2{pointer.x, pointer.y} - *last) < ui.px(least_step)) return;
    }
    line.push_back(*place);
}

void follow_pen(const LabView& view, Marks& marks, const Ui& ui, Rect scene) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool starts =
        ImGui::IsMouseClicked(0) && !io.WantCaptureMouse && scene.contains(io.MousePos.x, io.MousePos.y);
    if (starts) marks.pressed = true, marks.lines.emplace_back();
    marks.pressed &= io.MouseDown[0];
    if (marks.pressed) add_point(*view.camera_view, marks, ui, io.MousePos);
}

// The pixels of the line; a part behind the camera is left out.
void draw_line(const CameraView& camera, const std::vector<maths::vec2>& line, ImU32 colour, float width) {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    std::vector<ImVec2> pixels;
    const auto finish = [&] {
        if (pixels.size() > 1) draw.AddPolyline(pixels.data(), static_cast<int>(pixels.size()), colour, 0, width);
        for (const ImVec2& end : pixels) draw.AddCircleFilled(end, width / 2, colour);  // round ends and joints
        pixels.clear();
    };
    for (const maths::vec2 place : line) {
        const auto pixel = project(camera, place);
        if (pixel)
            pixels.push_back({pixel->x, pixel->y});
        else
            finish();
    }
    finish();
}

void sign_of_pen(Ui& ui, Rect scene) {
    const std::string words = fill(ui.strings("lecture.drawing"), {key_name(Action::draw_marks, ui.strings),
                                                                   key_name(Action::clear_marks, ui.strings)});
    ImDrawList& draw = *ImGui::GetForegroundDrawList();
    ImFont* face = font(ui, Face::strong);
    const float w = text_width(ui, Face::strong, words) + ui.px(24), h = line_height(ui, Face::strong) + ui.px(12);
    const Rect sign{scene.x + (scene.w - w) / 2, scene.y + scene.h - h - ui.px(8), w, h};
    draw.AddRectFilled({sign.x, sign.y}, {sign.x + w, sign.y + h}, paint(ui.palette.warning), ui.px(8));
    draw.AddText(face, line_height(ui, Face::strong), {sign.x + ui.px(12), sign.y + ui.px(6)}, paint(ui.palette.ground),
                 words.c_str());
    ui.anchors.record("marks.sign", sign);
}

}  // namespace

void draw_marks(const LabView& view, Marks& marks, Ui& ui, Rect scene) {
    if (!view.lecture || marks.run_id != view.run_id) marks.lines.clear(), marks.pressed = false;
    marks.run_id = view.run_id;
    marks.drawing &= view.lecture;
    if (!view.camera_view || view.mode == Mode::wiring) return;
    if (marks.drawing) follow_pen(view, marks, ui, scene);
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    draw.PushClipRect({scene.x, scene.y}, {scene.x + scene.w, scene.y + scene.h});
    for (const auto& line : marks.lines)
        draw_line(*view.camera_view, line, paint(ui.palette.ground), ui.px(pen_width + 2 * pen_border));
    for (const auto& line : marks.lines)
        draw_line(*view.camera_view, line, paint(ui.palette.warning), ui.px(pen_width));
    draw.PopClipRect();
    if (marks.drawing) sign_of_pen(ui, scene);
}

}  // namespace braitenlab::ui

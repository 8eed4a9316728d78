// The title page of the first start: the name of the program, a sentence and one button, over a scene that moves.
#include <algorithm>

#include <imgui.h>

#include "ui/imgui_compat.h"
#include "ui/panels/panels.h"
#include "ui/widgets/button.h"
#include "ui/widgets/item.h"
#include "ui/widgets/menu_bar.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr float title_inset = 72, narrow_title_inset = 40, narrow_title_window = 1200;  // layout pixels
constexpr float title_words_width = 400, below_name = 6, above_button = 28, begin_width = 150, least_begin_height = 44;

// The colour of the table around the arena (faded_floor() in shaders/common.glsl), nearly opaque up to `words_end`, so
// that no line of the scene crosses the words; it ends at `until`. Both: x, window pixels.
void shade_words(const Ui& ui, Rect window, float words_end, float until) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const Colour table = mix(ui.palette.floor, ui.palette.sky, 0.72f);
    const ImU32 full = paint(table.with_alpha(0.96f)), most = paint(table.with_alpha(0.92f));
    const float bottom = window.y + window.h;
    draw.AddRectFilledMultiColor({window.x, window.y}, {words_end, bottom}, full, most, most, full);
    // In steps of a smooth curve: a straight one shows an edge at both ends.
    constexpr int steps = 12;
    const auto share = [](int i) {
        const float t = static_cast<float>(i) / steps;
        return 1 - t * t * (3 - 2 * t);
    };
    for (int i = 0; i < steps; ++i) {
        const float step = (until - words_end) / steps, from = words_end + step * static_cast<float>(i);
        const ImU32 left = paint(table.with_alpha(0.92f * share(i))),
                    right = paint(table.with_alpha(0.92f * share(i + 1)));
        draw.AddRectFilledMultiColor({from, window.y}, {from + step, bottom}, left, right, right, left);
    }
}

}  // namespace

void title_page(const LabView& view, Ui& ui, Rect window) {
    ImGui::SetNextWindowPos({window.x, window.y});
    ImGui::SetNextWindowSize({window.w, window.h});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::Begin("title page", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav);
    ImGui::PopStyleVar();
    const float inset = ui.px(window.w < ui.px(narrow_title_window) ? narrow_title_inset : title_inset);
    const float width = std::min(ui.px(title_words_width), window.w - 2 * inset), x = window.x + inset;
    const auto lines = lines_of_words(ui, ui.strings("title.sentence"), Face::title, width);
    float widest = 0;
    for (const std::string& each : lines) widest = std::max(widest, text_width(ui, Face::title, each));
    shade_words(ui, window, x + widest, std::min(window.x + window.w, x + widest + 2.0f * inset));
    const float name = line_height(ui, Face::display), line = line_height(ui, Face::title);
    // For a finger, before one has touched the window: a telephone shows it reduced.
    const float button = std::max(least_begin_height, view.program.finger / ui.px(1));
    const float height =
        name + ui.px(below_name) + static_cast<float>(lines.size()) * line + ui.px(above_button + button);
    float y = window.y + (window.h - height) / 2;
    put(ui, {x, y}, "Braitenlab", ui.palette.text, Face::display);
    mark(ui, "title.name", {x, y, text_width(ui, Face::display, "Braitenlab"), name});
    y += name + ui.px(below_name);
    for (const std::string& each : lines) {
        put(ui, {x, y}, each, ui.palette.second_text, Face::title);
        y += line;
    }
    ImGui::SetCursorScreenPos({x, y + ui.px(above_button)});
    ButtonLook look{{}, ui.strings("title.begin"), Emphasis::primary};
    look.min_width = std::max(begin_width, 2 * button), look.min_height = button;
    if (push_button(ui, "title.begin", look, ui.strings("title.begin_how"), key_name({key::enter}, ui.strings)))
        ui.outbox.push_back(BeginRequest{});
    put(ui, {x, window.y + window.h - ui.px(32)}, view.program.version, ui.palette.second_text, Face::small);
    compat::end_window();
}

}  // namespace braitenlab::ui

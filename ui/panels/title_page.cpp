// The title page of the first start: the name of the program, a sentence and one button, over a scene that moves.
#include "ui/panels/title_page.h"

#include <algorithm>
#include <cmath>

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
// that no line of the scene crosses the words; it ends at `until`. Both in window pixels, along x or, `down`, along y.
void shade_words(const Ui& ui, Rect window, float words_end, float until, bool down) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const Colour table = mix(ui.palette.floor, ui.palette.sky, 0.72f);
    const auto band = [&](float from, float to, float at_from, float at_to) {
        const ImU32 first = paint(table.with_alpha(at_from)), last = paint(table.with_alpha(at_to));
        if (down)
            draw.AddRectFilledMultiColor({window.x, from}, {window.x + window.w, to}, first, first, last, last);
        else
            draw.AddRectFilledMultiColor({from, window.y}, {to, window.y + window.h}, first, last, last, first);
    };
    constexpr float most = 0.92f;
    band(down ? window.y : window.x, words_end, 0.96f, most);
    // In steps of a smooth curve: a straight one shows an edge at both ends.
    constexpr int steps = 12;
    const auto share = [](int i) {
        const float t = static_cast<float>(i) / steps;
        return most * (1 - t * t * (3 - 2 * t));
    };
    for (int i = 0; i < steps; ++i) {
        const float step = (until - words_end) / steps, from = words_end + step * static_cast<float>(i);
        band(from, from + step, share(i), share(i + 1));
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
    const float name = line_height(ui, Face::display), line = line_height(ui, Face::title);
    // For a finger, before one has touched the window: a telephone shows it reduced.
    const float button = std::max(least_begin_height, std::ceil(view.program.finger) / ui.px(1));
    const float height =
        name + ui.px(below_name) + static_cast<float>(lines.size()) * line + ui.px(above_button + button);
    const bool upright = window.h > window.w;
    const float room = upright ? title_words_share * window.h : window.h;
    float y = window.y + std::max(0.0f, std::floor((room - height) / 2));
    const float words_end = upright ? y + height : x + widest;
    const float window_end = upright ? window.y + window.h : window.x + window.w;
    shade_words(ui, window, words_end, std::min(window_end, words_end + 2.0f * inset), upright);
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

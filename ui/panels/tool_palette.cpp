// The bar of tools over the scene: hand, lamp, box, polygon, zone, tape, ruler.
#include <algorithm>
#include <array>
#include <cstddef>

#include <imgui.h>

#include "core/maths/angle.h"
#include "ui/imgui_compat.h"
#include "ui/panels/panels.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

struct ToolLook {
    SceneInputTool tool;
    std::string_view anchor, words, how;
};

constexpr std::array<ToolLook, tool_words.size()> tool_looks{
    {{SceneInputTool::hand, "tool.hand", "tools.hand", "tools.hand_how"},
     {SceneInputTool::lamp, "tool.lamp", "tools.lamp", "tools.lamp_how"},
     {SceneInputTool::box, "tool.box", "tools.box", "tools.box_how"},
     {SceneInputTool::polygon, "tool.polygon", "tools.polygon", "tools.polygon_how"},
     {SceneInputTool::zone, "tool.zone", "tools.zone", "tools.zone_how"},
     {SceneInputTool::tape, "tool.tape", "tools.tape", "tools.tape_how"},
     {SceneInputTool::ruler, "tool.ruler", "tools.ruler", "tools.ruler_how"}}};

// The sign of a tool, drawn without a font.
void tool_sign(const Ui& ui, SceneInputTool tool, ImVec2 c, Colour colour) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 ink = paint(colour);
    const float u = ui.px(1), thick = ui.px(1.6f);
    const auto at = [&](float x, float y) { return ImVec2{c.x + x * u, c.y + y * u}; };
    if (tool == SceneInputTool::hand) {
        const ImVec2 arrow[]{at(-4, -8),  at(6, 2),        at(1, 2.6f), at(3.6f, 8),
                             at(1.2f, 9), at(-1.2f, 3.6f), at(-4, 6.4f)};
        compat::polyline(list, arrow, 7, ink, true, thick);
    } else if (tool == SceneInputTool::lamp) {
        list.AddCircle(c, 3.6f * u, ink, 24, thick);
        for (int i = 0; i < 8; ++i) {
            const maths::vec2 way = maths::direction(maths::pi / 4 * static_cast<float>(i));
            list.AddLine(at(way.x * 6, way.y * 6), at(way.x * 8.6f, way.y * 8.6f), ink, thick);
        }
    } else if (tool == SceneInputTool::box) {
        compat::outline(list, at(-7, -5.5f), at(7, 5.5f), ink, u, thick);
    } else if (tool == SceneInputTool::zone) {
        compat::outline(list, at(-7.5f, -6), at(7.5f, 6), ink, u, thick);
        for (const float x : {-4.0f, 1.0f, 6.0f})  // hatched: a piece of the floor
            list.AddLine(at(std::max(-7.5f, x - 6), std::min(6.0f, x + 7.5f)), at(std::min(7.5f, x + 5), -3.5f), ink,
                         u);
    } else if (tool == SceneInputTool::tape) {
        const ImVec2 line[]{at(-8, 6), at(-2, -4), at(3, 2), at(8, -6)};
        compat::polyline(list, line, 4, ink, false, 2.2f * thick);
    } else if (tool == SceneInputTool::ruler) {
        compat::outline(list, at(-8.5f, -4), at(8.5f, 4), ink, u, thick);
        for (int i = 0; i < 4; ++i)
            list.AddLine(at(-5.1f + 3.4f * static_cast<float>(i), -4),
                         at(-5.1f + 3.4f * static_cast<float>(i), i % 2 == 0 ? 1.2f : -0.8f), ink, u);
    } else {
        const ImVec2 corners[]{at(-7.5f, 3), at(-3, -7), at(6, -5), at(7.5f, 4), at(0, 8)};
        compat::polyline(list, corners, 5, ink, true, thick);
        for (const ImVec2 corner : corners) list.AddCircleFilled(corner, 2.2f * u, ink, 12);
    }
}

// Tools in a row: all, or those that a narrow area has room for. `width`: layout pixels.
std::size_t tools_in_a_row(float width, float size) {
    const float fitting = (width - 2 * tool_pad) / size;
    return static_cast<std::size_t>(std::clamp(fitting, 1.0f, static_cast<float>(tool_looks.size())));
}

// True where only the chosen tool is shown: a finger needs large ones, and on an upright page the scene is low.
bool folds_tools(const LabView& view, const PanelState& state, const Ui& ui) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const bool is_low = view.program.touch && is_upright(window.x / ui.px(1), window.y / ui.px(1));
    return is_low && !state.scene_input.tools_open && !ui.highlight.starts_with("tool.");
}

void folded_tools(PanelState& state, Ui& ui, Rect bar, ImVec2 size) {
    ImGui::SetCursorScreenPos({bar.x + ui.px(tool_pad), bar.y + ui.px(tool_pad)});
    const Item at = item(ui, "tools", size);
    const bool draws = state.scene_input.tool != SceneInputTool::hand;
    if (draws) line_box(ui, at.rect, ui.palette.accent);
    tool_sign(ui, state.scene_input.tool, {at.middle_x(), at.middle_y()}, ui.palette.text);
    put_icon(ui, {at.right() - ui.px(8), at.rect.y + at.rect.h - ui.px(8)}, icon::folded, ui.palette.second_text,
             Face::small);
    tooltip(ui, at, ui.strings("tools.all"));
    if (at.pressed) state.scene_input.tools_open = true;
}

}  // namespace

float tool_palette_height(float width, float finger) {
    const float size = std::max(tool_size, finger);
    const std::size_t in_a_row = tools_in_a_row(width, size), rows = (tool_looks.size() + in_a_row - 1) / in_a_row;
    return static_cast<float>(rows) * size + 2 * tool_pad;
}

Rect place_of_tool_palette(const LabView& view, const PanelState& state, const Ui& ui, Rect area) {
    if (!view.camera_view || view.mode == Mode::wiring || view.lecture) return {};
    const float width = area.w / ui.px(1), size = ui.tall(tool_size), one = ui.px(size + 2 * tool_pad);
    if (folds_tools(view, state, ui)) return {area.x, area.y, one, one};
    const float row = static_cast<float>(tools_in_a_row(width, size)) * size + 2 * tool_pad;
    return {area.x, area.y, ui.px(row), ui.px(tool_palette_height(width, ui.finger))};
}

void tool_palette(const LabView& view, PanelState& state, Ui& ui, Rect area) {
    const Rect bar = place_of_tool_palette(view, state, ui, area);
    if (bar.w <= 0) return;
    const float size = ui.px(ui.tall(tool_size)), inset = ui.px(tool_pad);
    begin_bar(ui, "tools", bar, false, Corner::box);
    if (folds_tools(view, state, ui)) return folded_tools(state, ui, bar, {size, size}), end_bar();
    const Palette& p = ui.palette;
    const std::size_t in_a_row = tools_in_a_row(area.w / ui.px(1), ui.tall(tool_size));
    for (std::size_t i = 0; i < tool_looks.size(); ++i) {
        const ToolLook& look = tool_looks[i];
        ImGui::SetCursorScreenPos({bar.x + inset + static_cast<float>(i % in_a_row) * size,
                                   bar.y + inset + static_cast<float>(i / in_a_row) * size});
        const Item at = item(ui, look.anchor, {size, size});
        const bool on = state.scene_input.tool == look.tool;
        fill_box(ui, at.rect, on ? mix(p.panel, p.accent, 0.24f) : p.line.with_alpha(0.6f * at.warmth));
        if (on) line_box(ui, at.rect, p.accent);
        tool_sign(ui, look.tool, {at.middle_x(), at.middle_y()}, on ? p.text : mix(p.second_text, p.text, at.warmth));
        tooltip(ui, at, ui.strings(look.words), ui.strings(look.how));
        if (at.pressed) {
            choose_tool(state.scene_input, on ? SceneInputTool::hand : look.tool);
            state.scene_input.tools_open = false;
            const bool draws = state.scene_input.tool != SceneInputTool::hand;
            if ((draws || !at.entered) && ui.keyboard) ui.keyboard->focus.clear();  // keys then apply to the tool
        }
    }
    end_bar();
}

}  // namespace braitenlab::ui

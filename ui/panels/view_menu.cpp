// The menu of overlays: sensors, trails, floor pictures, labels, fields. It is below its button in the toolbar and
// stays open after a choice.
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <imgui.h>

#include "core/scene/enums.h"
#include "ui/panels/panels.h"
#include "ui/strings.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"

namespace braitenlab::ui {

namespace {

constexpr float view_menu_width = 300, view_pad = 12, view_row_height = 32;  // layout pixels

struct ViewRow {
    std::string id;
    bool on = false;
    std::optional<Action> action;    // of a switch
    std::optional<Channel> field{};  // of a choice; none: no field
};

ViewRow switch_row(Action action, bool on) { return {"view." + std::string(name(action)), on, action}; }

std::vector<ViewRow> switches(const LabView& view) {
    const Overlays& shown = view.settings.overlays;
    return {switch_row(Action::sensors, view.settings.sensors), switch_row(Action::outlines, view.settings.outlines),
            switch_row(Action::trails, shown.trails),           switch_row(Action::surfaces, shown.surfaces),
            switch_row(Action::memory, shown.memory),           switch_row(Action::labels, shown.labels)};
}

std::vector<ViewRow> fields(const LabView& view) {
    std::vector<ViewRow> rows{{"view.none", !view.settings.overlays.field, std::nullopt}};
    for (const Channel c : channels_with_intensity(*view.now))
        rows.push_back({"view." + std::string(word(c)), view.settings.overlays.field == c, std::nullopt, c});
    return rows;
}

std::string_view view_words(const Ui& ui, const ViewRow& row) {
    if (row.action) return ui.strings("action." + std::string(name(*row.action)));
    return row.field ? ui.strings("view.channel." + std::string(word(*row.field))) : ui.strings("view.no_field");
}

bool draw_view_row(Ui& ui, const ViewRow& row, ImVec2 at) {
    ImGui::SetCursorScreenPos(at);
    const Item here = item(ui, row.id, {ui.px(view_menu_width - 2 * view_pad), ui.px(view_row_height)});
    fill_box(ui, here.rect, ui.palette.line.with_alpha(std::max(0.6f * here.warmth, here.focused ? 0.6f : 0.0f)));
    const float y = here.middle_y() - line_height(ui, Face::text) / 2;
    if (row.on) {
        if (has_icons(ui))
            put_icon(ui, {here.rect.x + ui.px(16), here.middle_y()}, icon::check, ui.palette.accent);
        else
            fill_box(ui, {here.rect.x + ui.px(10), here.middle_y() - ui.px(5), ui.px(10), ui.px(10)},
                     ui.palette.accent);
    }
    put(ui, {here.rect.x + ui.px(34), y}, view_words(ui, row), row.on ? ui.palette.text : ui.palette.second_text);
    if (row.action)
        put_right(ui, {here.right() - ui.px(10), y}, key_name(*row.action, ui.strings), ui.palette.second_text,
                  Face::small);
    return here.pressed;
}

float view_heading(const Ui& ui, ImVec2 at, std::string_view words, std::string_view key) {
    put(ui, {at.x + ui.px(10), at.y + ui.px(4)}, words, ui.palette.second_text, Face::small);
    put_right(ui, {at.x + ui.px(view_menu_width - 2 * view_pad - 10), at.y + ui.px(4)}, key, ui.palette.second_text,
              Face::small);
    return at.y + line_height(ui, Face::small) + ui.px(8);
}

}  // namespace

bool for_view_menu(const LabView& view, PanelState& state, KeyPress press) {
    if (press.ctrl) return false;
    const bool back = press.key == key::up || (press.key == key::tab && press.shift);
    if (!back && press.key != key::down && press.key != key::tab) return false;
    std::vector<std::string> rows;
    for (const auto& group : {switches(view), fields(view)})
        for (const ViewRow& row : group) rows.push_back(row.id);
    std::string& focus = state.keyboard.focus;
    const auto at = std::find(rows.begin(), rows.end(), focus);
    if (at == rows.end())
        focus = back ? rows.back() : rows.front();
    else if (back)
        focus = at == rows.begin() ? rows.back() : *(at - 1);
    else
        focus = at + 1 == rows.end() ? rows.front() : *(at + 1);
    return true;
}

void view_menu(const LabView& view, PanelState& state, Ui& ui, Rect window, Rect toolbar) {
    const Rect* button = ui.anchors.find("button.view");
    if (!state.view_menu || !button) return;
    const Rect opener = *button;  // what follows records anchors
    const auto all_switches = switches(view), all_fields = fields(view);
    const float heads = 2 * (line_height(ui, Face::small) + ui.px(8)) + ui.px(8);
    const float height = 2 * ui.px(view_pad) + heads +
                         ui.px(view_row_height) * static_cast<float>(all_switches.size() + all_fields.size());
    const Rect menu{std::min(opener.x, window.w - ui.px(view_menu_width + 12)), toolbar.y + toolbar.h + ui.px(8),
                    ui.px(view_menu_width), height};
    // The bar covers the window invisibly: a click beside the menu closes it. It opens another menu (switch_menus())
    // and does nothing else.
    begin_bar(ui, "view", window, true);
    card_ground(ui, menu);
    fill_box(ui, menu, ui.palette.panel);
    line_box(ui, menu, ui.palette.line);
    ImVec2 at{menu.x + ui.px(view_pad), menu.y + ui.px(view_pad)};
    at.y = view_heading(ui, at, ui.strings("view.shown"), {});
    for (const ViewRow& row : all_switches) {
        if (draw_view_row(ui, row, at)) ui.outbox.push_back(*row.action);
        at.y += ui.px(view_row_height);
    }
    at.y += ui.px(8);
    at.y = view_heading(ui, at, ui.strings("view.field"), key_name(Action::next_field, ui.strings));
    for (const ViewRow& row : all_fields) {
        if (draw_view_row(ui, row, at)) {
            Overlays wanted = view.settings.overlays;
            wanted.field = row.field;
            ui.outbox.push_back(OverlaysRequest{wanted});
        }
        at.y += ui.px(view_row_height);
    }
    mark(ui, "card.view", menu);
    if (state.focus_view_menu && ui.keyboard) ui.keyboard->focus = all_switches.front().id;
    state.focus_view_menu = false;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const bool click = ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1);
    if (click && !menu.contains(mouse.x, mouse.y)) state.view_menu = false;
    end_bar();
}

}  // namespace braitenlab::ui

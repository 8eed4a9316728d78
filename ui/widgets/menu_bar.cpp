#include "ui/widgets/menu_bar.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <imgui.h>

#include "ui/imgui_compat.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"

namespace braitenlab::ui {

namespace {

// Layout pixels.
constexpr float menu_pad = spacing::tight, title_pad = spacing::medium, entry_pad = spacing::medium,
                menu_sign_room = 22, before_keys = 28, menu_rule = 7;
constexpr float tallest_entry = 26, lowest_entry = 18, menu_margin = 6;

std::string title_anchor(const MenuTitle& title) { return "menu." + std::string(title.name); }

bool pointer_in(Rect r) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    return r.contains(mouse.x, mouse.y);
}

bool pointer_moves() {
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    return moved.x != 0 || moved.y != 0;
}

bool has_signs(std::span<const MenuEntry> entries) {
    return std::any_of(entries.begin(), entries.end(), [](const MenuEntry& e) { return e.on.has_value() || e.open; });
}

float panel_width(const Ui& ui, std::span<const MenuEntry> entries, bool with_keys) {
    float widest = 0;
    for (const MenuEntry& e : entries) {
        const float keys = e.keys.empty() || !with_keys ? 0 : ui.px(before_keys) + text_width(ui, Face::small, e.keys);
        widest = std::max(widest, text_width(ui, e.heading ? Face::small : Face::text, e.words) + keys);
    }
    const float signs = has_signs(entries) ? ui.px(menu_sign_room) : 0;
    return std::ceil(widest + signs + 2 * ui.px(entry_pad + menu_pad));
}

float rules_height(const Ui& ui, std::span<const MenuEntry> entries) {
    const auto rules = std::count_if(entries.begin(), entries.end(), [](const MenuEntry& e) { return e.rule_above; });
    return ui.px(menu_rule) * static_cast<float>(rules);
}

// Lower rows in a low window; below the least height, or that for a finger, the panel scrolls.
float entry_height(const Ui& ui, std::span<const MenuEntry> entries, float room) {
    const float count = static_cast<float>(std::max<std::size_t>(1, entries.size()));
    const float fits = (room - 2 * ui.px(menu_pad) - rules_height(ui, entries)) / count;
    const float least = std::max(ui.px(ui.tall(lowest_entry)), 0.82f * line_height(ui, Face::text));
    return std::floor(std::clamp(fits, least, std::max(least, ui.px(tallest_entry))));
}

struct EntryLook {
    bool signs, keys;  // with room for signs before the words, with keys after them
    Face face;         // of all rows
};

// The small face where the words of a row have no room else.
Face face_of_rows(const Ui& ui, std::span<const MenuEntry> entries, float width) {
    const float room = width - 2 * ui.px(entry_pad) - (has_signs(entries) ? ui.px(menu_sign_room) : 0);
    const bool fit = std::all_of(entries.begin(), entries.end(), [&](const MenuEntry& e) {
        return e.heading || text_width(ui, Face::text, e.words) <= room;
    });
    return fit ? Face::text : Face::small;
}

void draw_entry(const Ui& ui, const MenuEntry& entry, const Item& at, EntryLook look) {
    const Palette& p = ui.palette;
    const bool by_key = ui.keyboard && ui.keyboard->shown;
    if (entry.enabled && (by_key ? at.focused : at.hovered)) fill_box(ui, at.rect, p.line.with_alpha(0.6f));
    float x = at.rect.x + ui.px(entry_pad);
    if (entry.on.value_or(false)) {
        const float middle = x + ui.px(menu_sign_room) / 2 - ui.px(5);
        if (has_icons(ui))
            put_icon(ui, {middle, at.middle_y()}, icon::check, p.accent);
        else
            fill_box(ui, {middle - ui.px(4), at.middle_y() - ui.px(4), ui.px(8), ui.px(8)}, p.accent);
    }
    if (entry.open)  // not the check mark: that of an exercise says that it is passed
        ImGui::GetWindowDrawList()->AddCircleFilled({x + ui.px(menu_sign_room) / 2 - ui.px(5), at.middle_y()}, ui.px(4),
                                                    paint(p.accent));
    if (look.signs) x += ui.px(menu_sign_room);
    const Colour colour = entry.enabled ? p.text : p.second_text.with_alpha(0.6f);
    const float room = at.right() - ui.px(entry_pad) - x;
    put(ui, {x, at.middle_y() - line_height(ui, look.face) / 2}, shortened(ui, entry.words, look.face, room), colour,
        look.face);
    if (!look.keys) return;
    put_right(ui, {at.right() - ui.px(entry_pad), at.middle_y() - line_height(ui, Face::small) / 2}, entry.keys,
              entry.enabled ? p.second_text : colour, Face::small);
}

// Draws a row at the cursor. True when it was chosen.
bool menu_entry(Ui& ui, const MenuEntry& entry, ImVec2 size, EntryLook look) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (entry.heading) {
        put(ui, {at.x + ui.px(entry_pad), at.y + (size.y - line_height(ui, Face::small)) / 2}, entry.words,
            ui.palette.second_text, Face::small);
        ImGui::Dummy(size);
        return false;
    }
    const Item here = item(ui, entry.anchor, size, entry.enabled);
    draw_entry(ui, entry, here, look);
    if (here.hovered && entry.enabled && pointer_moves() && ui.keyboard) {
        ui.keyboard->focus = entry.anchor;  // arrow keys continue from the row under the pointer
        ui.keyboard->shown = false;
    }
    tooltip(ui, here, entry.how);
    return here.pressed;
}

// `opens`: in the first frame of the menu, which then shows the row that is to be in sight, else the first rows.
int draw_entries(Ui& ui, std::span<const MenuEntry> entries, ImVec2 size, bool with_keys, bool opens) {
    int chosen = -1;
    const auto [width, height] = size;
    const EntryLook look{has_signs(entries), with_keys, face_of_rows(ui, entries, width)};
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    if (opens) ImGui::SetScrollY(0);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (entries[i].rule_above) {
            const ImVec2 from = ImGui::GetCursorScreenPos();
            fill_box(ui, {from.x, std::floor(from.y + ui.px(menu_rule) / 2), width, ui.px(1)}, ui.palette.line,
                     Corner::square);
            ImGui::Dummy({width, ui.px(menu_rule)});
        }
        if (menu_entry(ui, entries[i], size, look)) chosen = static_cast<int>(i);
        const float hidden =
            ImGui::GetCursorPosY() + size.y - ImGui::GetWindowHeight();  // one row below it is shown, too
        if (opens && entries[i].in_sight && hidden > 0) ImGui::SetScrollY(hidden);
    }
    ImGui::PopStyleVar();
    return chosen;
}

struct TitleType {
    Face face;
    float pad;  // on both sides of the words, window pixels
};

// The largest face in which all titles fit; first they move together.
TitleType type_of_titles(const Ui& ui, std::span<const MenuTitle> titles, float room) {
    const float least = ui.px(spacing::tight), count = 2 * static_cast<float>(titles.size());
    for (const Face face : {Face::text, Face::small, Face::label}) {
        float words = 0;
        for (const MenuTitle& title : titles) words += text_width(ui, face, title.words);
        const float pad = (room - words) / count;
        if (pad >= least || face == Face::label) return {face, std::clamp(pad, 0.0f, ui.px(title_pad))};
    }
    return {Face::label, 0};
}

// Follows the pointer to the other titles and closes the menu after a click beside the panel.
void follow_pointer(const Ui& ui, MenuBarState& state, std::span<const MenuTitle> titles) {
    const bool click = ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1);
    for (const MenuTitle& title : titles) {
        const Rect* at = ui.anchors.find(title_anchor(title));
        if (!at || !pointer_in(*at)) continue;
        if (click)
            state.open = state.open == title.name ? std::string_view{} : title.name;
        else if (pointer_moves())
            state.open = title.name;
        return;
    }
    if (click && !pointer_in(state.panel)) state.open.clear();
}

}  // namespace

void menu_titles(Ui& ui, MenuBarState& state, std::span<const MenuTitle> titles, Rect bar) {
    // Tab does not stop at the titles: F10 opens the bar.
    Keyboard* const keyboard = std::exchange(ui.keyboard, nullptr);
    begin_bar(ui, "menu bar", bar);
    float x = bar.x + ui.px(menu_pad);
    const TitleType type = type_of_titles(ui, titles, bar.w - 2 * ui.px(menu_pad));
    for (const MenuTitle& title : titles) {
        const float width = text_width(ui, type.face, title.words) + 2 * type.pad;
        ImGui::SetCursorScreenPos({x, bar.y});
        const Item at = item(ui, title_anchor(title), {width, bar.h});
        const bool open = state.open == title.name;
        fill_box(ui, {at.rect.x, at.rect.y + ui.px(2), at.rect.w, at.rect.h - ui.px(4)},
                 ui.palette.line.with_alpha(open ? 0.8f : 0.6f * at.warmth), Corner::box);
        put(ui, {x + type.pad, at.middle_y() - line_height(ui, type.face) / 2}, title.words, ui.palette.text,
            type.face);
        if (!open) tooltip(ui, at, title.how, title.keys);
        if (at.pressed) state.open = title.name;
        x += width;
    }
    end_bar();
    ui.keyboard = keyboard;
}

int menu_panel(Ui& ui, MenuBarState& state, std::span<const MenuTitle> titles, std::span<const MenuEntry> entries,
               Rect bar, Rect window) {
    const Rect* opener = ui.anchors.find("menu." + state.open);
    if (state.open.empty() || !opener) {
        state.drawn.clear();
        return -1;
    }
    const float top = bar.y + bar.h + ui.px(2), margin = ui.px(menu_margin), pad = ui.px(menu_pad);
    const float room = window.y + window.h - margin - top;
    const float height = entry_height(ui, entries, room);
    const float content = height * static_cast<float>(entries.size()) + rules_height(ui, entries);
    const float scrollbar = content + 2 * pad > room ? ImGui::GetStyle().ScrollbarSize : 0;
    const bool with_keys = panel_width(ui, entries, true) + scrollbar <= window.w - 2 * margin;
    const float width = std::min(panel_width(ui, entries, with_keys) + scrollbar, window.w - 2 * margin);
    state.panel = {std::max(margin, std::min(opener->x, window.x + window.w - margin - width)), top, width,
                   std::min(content + 2 * pad, room)};
    begin_bar(ui, "open menu", window, true);
    hold_keyboard(ui.keyboard);
    const bool opens = std::exchange(state.drawn, state.open) != state.open;
    if (opens && ui.keyboard) ui.keyboard->focus.clear();
    const Rect& panel = state.panel;
    card_ground(ui, panel);
    fill_box(ui, panel, ui.palette.panel);  // opaque, so that words below do not show through
    line_box(ui, panel, ui.palette.line);
    mark(ui, "menu.rows", panel);
    ImGui::SetCursorScreenPos({panel.x + pad, panel.y + pad});
    const float inner = panel.w - 2 * pad;
    // Letters are higher than the lowest rows: those of the last one reach into the margin.
    compat::begin_child(("rows of " + state.open).c_str(), {inner, panel.h - pad - ui.px(1)}, ImGuiWindowFlags_NoNav);
    const int chosen = draw_entries(ui, entries, {inner - scrollbar, height}, with_keys, opens);
    compat::end_child();
    follow_pointer(ui, state, titles);
    if (chosen >= 0 && !entries[static_cast<std::size_t>(chosen)].stays_open) state.open.clear();
    end_bar();
    return chosen;
}

}  // namespace braitenlab::ui

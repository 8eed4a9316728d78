// What can be opened: the exercises by number, then the scenes with their stories. Drops from the toolbar.
#include <algorithm>
#include <string>
#include <vector>

#include <imgui.h>

#include "ui/panels/panels.h"
#include "ui/strings.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"

namespace braitenlab {

namespace {

constexpr float menu_width = 540, pad = 12, row_gap = 2;  // layout pixels

float row_height(const Ui& ui, const CatalogueEntry& entry) {
    return line_height(ui, Face::text) + (entry.story.empty() ? 0 : line_height(ui, Face::small)) + ui.px(12);
}

float heading_height(const Ui& ui) { return line_height(ui, Face::small) + ui.px(10); }

bool is_exercise(const CatalogueEntry& entry) { return entry.number > 0; }

float menu_height(const Ui& ui, const std::vector<CatalogueEntry>& catalogue) {
    float height = 2 * ui.px(pad) + 2 * heading_height(ui);
    for (const CatalogueEntry& entry : catalogue) height += row_height(ui, entry) + ui.px(row_gap);
    return height;
}

// True when it was chosen.
bool entry_row(Ui& ui, const CatalogueEntry& entry, bool current) {
    const Item row = item(ui, "open." + entry.name, {ui.px(menu_width - 2 * pad), row_height(ui, entry)});
    fill_box(ui, row.rect, ui.palette.line.with_alpha(std::max(0.6f * row.warmth, row.focused ? 0.6f : 0.0f)));
    if (current)
        fill_box(ui, {row.rect.x, row.rect.y + ui.px(6), ui.px(3), row.rect.h - ui.px(12)}, ui.palette.accent, 2);
    const float x = row.rect.x + ui.px(12), y = row.rect.y + ui.px(5);
    ImGui::PushClipRect({row.rect.x, row.rect.y}, {row.right() - ui.px(8), row.bottom()}, true);
    const std::string title = is_exercise(entry) ? std::to_string(entry.number) + "  " + entry.title : entry.title;
    put(ui, {x, y}, title, ui.palette.text, Face::strong);
    put(ui, {x, y + line_height(ui, Face::text)}, entry.story, ui.palette.second_text, Face::small);
    ImGui::PopClipRect();
    return row.pressed;
}

// The rows of one group under their heading, from y on; returns where they end.
float group(const LabView& view, PanelState& state, Ui& ui, ImVec2 at, bool exercises, std::string_view heading) {
    put(ui, {at.x + ui.px(12), at.y}, heading, ui.palette.second_text, Face::small);
    float y = at.y + heading_height(ui);
    for (const CatalogueEntry& entry : *view.catalogue) {
        if (is_exercise(entry) != exercises) continue;
        ImGui::SetCursorScreenPos({at.x, y});
        if (entry_row(ui, entry, entry.name == view.opened)) {
            ui.outbox.push_back(OpenRequest{entry.path});
            state.open_menu = false;
        }
        y += row_height(ui, entry) + ui.px(row_gap);
    }
    return y;
}

}  // namespace

bool for_open_menu(const LabView& view, PanelState& state, KeyPress press) {
    if (!view.catalogue || view.catalogue->empty() || press.ctrl) return false;
    const bool back = press.key == key::up || (press.key == key::tab && press.shift);
    if (!back && press.key != key::down && press.key != key::tab) return false;
    std::vector<std::string> rows;  // from top to bottom
    for (const bool exercises : {true, false})
        for (const CatalogueEntry& entry : *view.catalogue)
            if (is_exercise(entry) == exercises) rows.push_back("open." + entry.name);
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

void open_menu(const LabView& view, PanelState& state, Ui& ui, const WindowLayout& layout) {
    if (!state.open_menu || !view.catalogue) return;
    const Rect menu{ui.px(12), layout.toolbar.y + layout.toolbar.h + ui.px(8), ui.px(menu_width),
                    menu_height(ui, *view.catalogue)};
    begin_bar(ui, "open", layout.window, true);
    fill_box(ui, layout.window, ui.palette.ground.with_alpha(0.35f), 0);
    fill_box(ui, menu, ui.palette.panel);
    line_box(ui, menu, ui.palette.line);
    const ImVec2 at{menu.x + ui.px(pad), menu.y + ui.px(pad)};
    const float y = group(view, state, ui, at, true, ui.strings("open.exercises"));
    group(view, state, ui, {at.x, y}, false, ui.strings("open.scenes"));
    mark(ui, "card.open", menu);
    // The rows are known to the keyboard now; Tab and Enter go on from what is open.
    if (state.focus_open_menu && ui.keyboard) ui.keyboard->focus = "open." + view.opened;
    state.focus_open_menu = false;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const Rect* button = ui.anchors.find("button.open");  // a click there toggles by itself
    const bool elsewhere = !menu.contains(mouse.x, mouse.y) && !(button && button->contains(mouse.x, mouse.y));
    if (ImGui::IsMouseClicked(0) && elsewhere) state.open_menu = false;
    end_bar();
}

}  // namespace braitenlab

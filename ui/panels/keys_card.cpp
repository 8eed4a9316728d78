// All keys, over everything, from the one table of shortcuts.
#include <algorithm>
#include <string>
#include <vector>

#include <imgui.h>

#include "ui/imgui_compat.h"
#include "ui/panels/panels.h"
#include "ui/shortcuts.h"
#include "ui/strings.h"
#include "ui/theme.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/paint.h"

namespace braitenlab {

namespace {

// Each action once, with the key to show for it.
std::vector<Shortcut> listed() {
    std::vector<Shortcut> list;
    for (const Shortcut& shortcut : shortcuts()) {
        const auto same = [&](const Shortcut& other) { return other.action == shortcut.action; };
        if (std::none_of(list.begin(), list.end(), same)) list.push_back(shortcut);
    }
    return list;
}

void row(const Ui& ui, ImVec2 at, float width, std::string_view key, std::string_view words) {
    put(ui, at, words, ui.palette.text);
    put_right(ui, {at.x + width, at.y}, key, ui.palette.second_text, Face::strong);
}

}  // namespace

void keys_card(const LabView&, PanelState& state, Ui& ui, Rect window) {
    if (!state.keys_open) return;
    const std::vector<Shortcut> list = listed();
    const float line = line_height(ui, Face::text) + ui.px(6), column = ui.px(300), pad = ui.px(24), space = ui.px(40);
    const int extra = 3;  // keys of the sliders, which are no actions
    const int rows = (static_cast<int>(list.size()) + extra + 1) / 2;
    const float w = 2 * column + space + 2 * pad;
    const float h =
        line_height(ui, Face::title) + static_cast<float>(rows) * line + ui.px(button_height + 32) + 2 * pad;
    const Rect card{window.x + (window.w - w) / 2, window.y + (window.h - h) / 2, w, h};

    begin_bar(ui, "keys", window, true);
    fill_box(ui, window, ui.palette.ground.with_alpha(0.55f), 0);
    card_ground(ui, card);
    fill_box(ui, card, ui.palette.panel);  // opaque: the cards below it are full of words
    line_box(ui, card, ui.palette.line);
    put(ui, {card.x + pad, card.y + pad}, ui.strings("keys.heading"), ui.palette.text, Face::title);
    const float top = card.y + pad + line_height(ui, Face::title) + ui.px(16);
    int at = 0;
    const auto next = [&](std::string_view key, std::string_view words) {
        const int side = at / rows, index = at % rows;
        ++at;
        row(ui, {card.x + pad + static_cast<float>(side) * (column + space), top + static_cast<float>(index) * line},
            column, key, words);
    };
    for (const Shortcut& shortcut : list)
        next(key_name(shortcut.press, ui.strings), ui.strings("action." + std::string(name(shortcut.action))));
    next("1 2 3 4", ui.strings("keys.sliders"));
    next("← →", ui.strings("keys.nudge"));
    next(key_name(KeyPress{key::tab, true}, ui.strings), ui.strings("keys.panels"));
    ImGui::SetCursorScreenPos({card.x + pad, card.y + card.h - pad - ui.px(button_height)});
    const Item close = button(ui, "keys.close", {{}, ui.strings("keys.close"), Emphasis::primary});
    if (close.pressed ||
        (ImGui::IsMouseClicked(0) && !card.contains(ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y)))
        state.keys_open = false;
    mark(ui, "card.keys", card);
    end_bar();
}

}  // namespace braitenlab

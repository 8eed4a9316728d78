// All keys, over everything, from the one table of shortcuts.
#include <algorithm>
#include <string>
#include <vector>

#include <imgui.h>

#include "ui/panels/panels.h"
#include "ui/shortcuts.h"
#include "ui/strings.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/sheet.h"

namespace braitenlab {

namespace {

struct Row {
    std::string key, words;
};

// Each action once, with the key to show for it, and the keys of widgets, which are no actions.
std::vector<Row> rows(const Strings& strings) {
    std::vector<Row> list;
    std::vector<Action> listed;
    for (const Shortcut& shortcut : shortcuts()) {
        if (std::find(listed.begin(), listed.end(), shortcut.action) != listed.end()) continue;
        listed.push_back(shortcut.action);
        list.push_back(
            {key_name(shortcut.press, strings), std::string(strings("action." + std::string(name(shortcut.action))))});
    }
    list.push_back({"1 2 3 4", std::string(strings("keys.sliders"))});
    list.push_back({"← →", std::string(strings("keys.nudge"))});
    list.push_back({key_name(KeyPress{key::enter}, strings), std::string(strings("keys.press"))});
    list.push_back({key_name(KeyPress{key::tab, true}, strings), std::string(strings("keys.panels"))});
    list.push_back({key_name(KeyPress{key::f1}, strings), std::string(strings("keys.this"))});
    return list;
}

}  // namespace

void keys_card(const LabView&, PanelState& state, Ui& ui, Rect window) {
    if (state.sheet != Sheet::keys) return;
    begin_sheet(ui, state.keys, "card.keys", ui.strings("keys.heading"), 724, window);
    const std::vector<Row> list = rows(ui.strings);
    const float line = line_height(ui, Face::text) + ui.px(6), width = card_width(ui), space = ui.px(40);
    const bool two = width > ui.px(600);
    const int a_column = two ? (static_cast<int>(list.size()) + 1) / 2 : static_cast<int>(list.size());
    const float column = two ? (width - space) / 2 : width;
    const ImVec2 top = ImGui::GetCursorScreenPos();
    for (int i = 0; i < static_cast<int>(list.size()); ++i) {
        const Row& row = list[static_cast<std::size_t>(i)];
        const ImVec2 at{top.x + static_cast<float>(i / a_column) * (column + space),
                        top.y + static_cast<float>(i % a_column) * line};
        put(ui, at, row.words, ui.palette.text);
        put_right(ui, {at.x + column, at.y}, row.key, ui.palette.second_text, Face::strong);
    }
    ImGui::Dummy({width, static_cast<float>(a_column) * line});
    sheet_buttons(ui, state.keys);
    const bool closed = button(ui, "keys.close", {{}, ui.strings("keys.close"), Emphasis::primary}).pressed;
    if (end_sheet(state.keys) || closed) state.sheet = Sheet::none;
}

}  // namespace braitenlab

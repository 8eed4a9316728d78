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
    bool heading = false;
};

std::string_view place_key(KeyPlace place) {
    switch (place) {
        case KeyPlace::view:
            return "keys.place.view";
        case KeyPlace::widget:
            return "keys.place.widget";
        case KeyPlace::canvas:
            return "keys.place.canvas";
        case KeyPlace::stage:
            return "keys.place.stage";
        default:
            return "keys.place.everywhere";
    }
}

// Each action of a place once, with the key to show for it.
void add_rows(std::vector<Row>& list, KeyPlace place, const Strings& strings) {
    list.push_back({"", std::string(strings(place_key(place))), true});
    std::vector<Action> listed;
    for (const Shortcut& shortcut : shortcuts()) {
        if (shortcut.place != place) continue;
        if (std::find(listed.begin(), listed.end(), shortcut.action) != listed.end()) continue;
        listed.push_back(shortcut.action);
        list.push_back(
            {key_name(shortcut.press, strings), std::string(strings("action." + std::string(name(shortcut.action))))});
    }
}

std::vector<Row> rows(const Strings& strings) {
    std::vector<Row> list;
    for (int place = 0; place <= static_cast<int>(last_place); ++place)
        add_rows(list, static_cast<KeyPlace>(place), strings);
    return list;
}

// Where each column ends: all about as long, and no heading alone at the foot of one.
std::vector<std::size_t> column_ends(const std::vector<Row>& list, std::size_t columns) {
    std::vector<std::size_t> ends;
    std::size_t begin = 0;
    for (std::size_t left = columns; left > 0; --left) {
        std::size_t end = left == 1 ? list.size() : begin + (list.size() - begin + left - 1) / left;
        while (end < list.size() && end > begin + 1 && list[end - 1].heading) --end;
        ends.push_back(begin = end);
    }
    return ends;
}

void write_row(const Ui& ui, const Row& row, ImVec2 at, float width, float line) {
    if (row.heading) {
        put(ui, {at.x, at.y + line - line_height(ui, Face::small) - ui.px(4)}, row.words, ui.palette.second_text,
            Face::small);
        return;
    }
    put(ui, at, row.words, ui.palette.text);
    put_right(ui, {at.x + width, at.y}, row.key, ui.palette.second_text, Face::strong);
}

}  // namespace

void keys_card(const LabView&, PanelState& state, Ui& ui, Rect window) {
    if (state.sheet != Sheet::keys) return;
    constexpr float narrowest = 300, space = 36;  // layout pixels
    begin_sheet(ui, state.keys, "card.keys", ui.strings("keys.heading"), 1060, window);
    const std::vector<Row> list = rows(ui.strings);
    const float line = line_height(ui, Face::text) + ui.px(4), width = card_width(ui);
    const auto columns =
        static_cast<std::size_t>(std::clamp((width + ui.px(space)) / ui.px(narrowest + space), 1.0f, 3.0f));
    const float each = (width - ui.px(space) * static_cast<float>(columns - 1)) / static_cast<float>(columns);
    ImVec2 at = ImGui::GetCursorScreenPos();
    const float top = at.y;
    std::size_t i = 0, longest = 0;
    for (const std::size_t end : column_ends(list, columns)) {
        longest = std::max(longest, end - i);
        for (at.y = top; i < end; ++i, at.y += line) write_row(ui, list[i], at, each, line);
        at.x += each + ui.px(space);
    }
    ImGui::Dummy({width, static_cast<float>(longest) * line});
    sheet_buttons(ui, state.keys);
    const Item close = button(ui, "keys.close", {{}, ui.strings("keys.close"), Emphasis::primary});
    tooltip(ui, close, ui.strings("keys.close_how"), key_name({key::escape}, ui.strings));
    const bool closed = close.pressed;
    if (end_sheet(state.keys) || closed) state.sheet = Sheet::none;
}

}  // namespace braitenlab

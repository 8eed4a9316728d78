// The sheet of all shortcuts, from the table in ui/actions.def, and of mouse gestures.
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <imgui.h>

#include "ui/panels/panels.h"
#include "ui/panels/sheets.h"
#include "ui/shortcuts.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

struct KeyRow {
    std::string key, words;
    bool heading = false;
    std::vector<std::string_view> lines{}, key_lines{};  // of the words and of the key, as they fit their columns
};

constexpr float beside_key = spacing::medium, line_gap = spacing::tight;  // layout pixels
constexpr float key_words_share = 0.58f;                                  // of the width; the keys begin behind it

// String keys of a mouse gesture and its effect.
constexpr std::array<std::array<std::string_view, 2>, 17> gestures_of_mouse{{
    {"mouse.click", "mouse_does.click"},
    {"mouse.drag", "mouse_does.drag"},
    {"mouse.knob", "mouse_does.knob"},
    {"mouse.floor", "mouse_does.floor"},
    {"mouse.shift_view", "mouse_does.shift_view"},
    {"mouse.add", "mouse_does.add"},
    {"mouse.select", "mouse_does.select"},
    {"mouse.wheel", "mouse_does.wheel"},
    {"mouse.menu", "mouse_does.menu"},
    {"mouse.draw", "mouse_does.draw"},
    {"mouse.slider_type", "mouse_does.slider_type"},
    {"mouse.slider_file", "mouse_does.slider_file"},
    {"mouse.timeline", "mouse_does.timeline"},
    {"mouse.bookmark", "mouse_does.bookmark"},
    {"mouse.pins", "mouse_does.pins"},
    {"mouse.onto", "mouse_does.onto"},
    {"mouse.canvas", "mouse_does.canvas"},
}};

bool is_bare_arrow(KeyPress press) {
    return !press.ctrl && !press.shift && press.key >= key::right && press.key <= key::up;
}

// The key of an action; all four arrows where the action takes a direction.
std::string keys_of(const Shortcut& first, const Strings& strings) {
    std::string text = key_name(first.press, strings);
    for (const Shortcut& other : shortcuts())
        if (other.place == first.place && other.action == first.action && other.press != first.press &&
            is_bare_arrow(other.press) && is_bare_arrow(first.press))
            text += " " + key_name(other.press, strings);
    return text;
}

// True in a lecture for a key that has another action, or none, there.
bool is_taken_by_lecture(const LabView& view, const Shortcut& shortcut) {
    const auto action = action_for(shortcut.press, KeyPlace::lecture);
    if (!view.lecture || shortcut.place == KeyPlace::lecture || !action) return false;
    return has_effect_in_lecture(*action, view.pages) || *action == Action::notes;
}

// False for keys of pages and notes while no lecture file is open.
bool is_listed(const LabView& view, const Shortcut& shortcut) {
    return shortcut.place != KeyPlace::lecture || !view.lecture || has_effect_in_lecture(shortcut.action, view.pages);
}

// Outside a lecture their rows are before all others.
constexpr std::array actions_of_playing{Action::play_pause, Action::reset,  Action::step,
                                        Action::step_back,  Action::slower, Action::faster};

bool is_of_playing(const LabView& view, Action action) {
    return !view.lecture &&
           std::find(actions_of_playing.begin(), actions_of_playing.end(), action) != actions_of_playing.end();
}

void add_rows_of_playing(std::vector<KeyRow>& list, const Strings& strings) {
    list.push_back({"", std::string(strings("keys.place.playing")), true});
    for (const Action action : actions_of_playing)
        list.push_back({key_name(action, strings), std::string(strings("action." + std::string(name(action))))});
}

// One row per action of a place.
void add_rows(std::vector<KeyRow>& list, const LabView& view, KeyPlace place, const Strings& strings) {
    list.push_back({"", std::string(strings("keys.place." + std::string(name(place)))), true});
    std::vector<Action> listed;
    for (const Shortcut& shortcut : shortcuts()) {
        if (!is_shown(shortcut.press) || shortcut.place != place || is_taken_by_lecture(view, shortcut) ||
            !is_listed(view, shortcut) || is_of_playing(view, shortcut.action))
            continue;
        if (std::find(listed.begin(), listed.end(), shortcut.action) != listed.end()) continue;
        listed.push_back(shortcut.action);
        list.push_back(
            {keys_of(shortcut, strings), std::string(strings("action." + std::string(name(shortcut.action))))});
    }
}

void add_answer_rows(std::vector<KeyRow>& list, const Strings& strings) {
    list.push_back({"", std::string(strings("keys.place.answer")), true});
    list.push_back({"1 … 4", std::string(strings("keys.answer"))});
    list.push_back({key_name({' '}, strings), std::string(strings("keys.answer_space"))});
}

// In a lecture its keys are first, else those of playing, in an exercise then those of the prediction and of sliders.
std::vector<KeyRow> key_rows(const LabView& view, const Strings& strings) {
    std::vector<KeyRow> list;
    const bool in_exercise = view.lesson && !view.lecture;
    if (view.lecture)
        add_rows(list, view, KeyPlace::lecture, strings);
    else
        add_rows_of_playing(list, strings);
    if (in_exercise) add_answer_rows(list, strings), add_rows(list, view, KeyPlace::widget, strings);
    for (int i = 0; i <= static_cast<int>(last_place); ++i) {
        const auto place = static_cast<KeyPlace>(i);
        const bool is_first = place == KeyPlace::lecture ? view.lecture : place == KeyPlace::widget && in_exercise;
        if (!is_first) add_rows(list, view, place, strings);
    }
    if (!in_exercise) add_answer_rows(list, strings);
    list.push_back({"", std::string(strings("keys.place.mouse")), true});
    for (const auto& [gesture, what] : gestures_of_mouse)
        list.push_back({std::string(strings(gesture)), std::string(strings(what))});
    return list;
}

// The lines of the text, broken at spaces.
std::vector<std::string_view> lines_within(const Ui& ui, Face face, std::string_view rest, float width) {
    std::vector<std::string_view> lines;
    while (!rest.empty()) {
        std::size_t end = rest.find(' ');
        while (end < rest.size()) {
            const std::size_t next = rest.find(' ', end + 1);
            if (text_width(ui, face, rest.substr(0, next)) > width) break;
            end = next;
        }
        lines.push_back(rest.substr(0, end));
        rest.remove_prefix(end < rest.size() ? end + 1 : rest.size());
    }
    return lines;
}

// The words are in the left column of a row, its key in the right one. A heading has the whole width.
void break_into_lines(const Ui& ui, KeyRow& row, float width) {
    if (row.heading) {
        row.lines = lines_within(ui, Face::small, row.words, width);
        return;
    }
    row.lines = lines_within(ui, Face::text, row.words, width * key_words_share - ui.px(beside_key));
    row.key_lines = lines_within(ui, Face::strong, row.key, width * (1 - key_words_share));
}

std::size_t lines_of(const KeyRow& row) { return std::max({std::size_t{1}, row.lines.size(), row.key_lines.size()}); }

// The end of each column: about equal lengths, and no heading at the bottom of a column.
std::vector<std::size_t> column_ends(const std::vector<KeyRow>& list, std::size_t columns) {
    std::size_t whole = 0;
    for (const KeyRow& row : list) whole += lines_of(row);
    std::vector<std::size_t> ends;
    std::size_t end = 0, filled = 0;
    for (std::size_t column = 1; column <= columns; ++column) {
        const std::size_t begin = end, wanted = whole * column / columns;
        while (end < list.size() && (filled < wanted || column == columns)) filled += lines_of(list[end++]);
        while (end < list.size() && end > begin + 1 && list[end - 1].heading) filled -= lines_of(list[--end]);
        ends.push_back(end);
    }
    return ends;
}

void write_row(const Ui& ui, const KeyRow& row, ImVec2 at, float width, float line) {
    const auto column = [&](const std::vector<std::string_view>& lines, float x, Colour colour, Face face,
                            float below = 0) {
        float y = at.y + below;
        for (const std::string_view words : lines) put(ui, {x, std::exchange(y, y + line)}, words, colour, face);
    };
    if (row.heading) {
        const float below = line - line_height(ui, Face::small) - ui.px(line_gap);
        return column(row.lines, at.x, ui.palette.second_text, Face::small, below);
    }
    column(row.lines, at.x, ui.palette.text, Face::text);
    column(row.key_lines, at.x + width * key_words_share, ui.palette.second_text, Face::strong);
}

}  // namespace

void keys_card(const LabView& view, PanelState& state, Ui& ui, Rect window) {
    constexpr float narrowest = 300, space = 36;  // layout pixels
    SheetState& sheet = open_sheet(state, ui, Sheet::keys, window);
    std::vector<KeyRow> list = key_rows(view, ui.strings);
    const float line = line_height(ui, Face::text) + ui.px(line_gap), width = card_width(ui);
    const auto columns =
        static_cast<std::size_t>(std::clamp((width + ui.px(space)) / ui.px(narrowest + space), 1.0f, 3.0f));
    const float each = (width - ui.px(space) * static_cast<float>(columns - 1)) / static_cast<float>(columns);
    for (KeyRow& row : list) {
        row.key = with_large_arrows(ui, std::move(row.key));
        break_into_lines(ui, row, each);
    }
    ImVec2 at = ImGui::GetCursorScreenPos();
    const float top = at.y;
    std::size_t i = 0;
    float lowest = top;
    for (const std::size_t end : column_ends(list, columns)) {
        for (at.y = top; i < end; ++i) {
            write_row(ui, list[i], at, each, line);
            at.y += static_cast<float>(lines_of(list[i])) * line;
        }
        lowest = std::max(lowest, at.y);
        at.x += each + ui.px(space);
    }
    ImGui::Dummy({width, lowest - top});
    sheet_buttons(ui, sheet);
    const bool closed = close_button(ui, "keys.close");
    if (end_sheet(sheet) || closed) state.sheet = Sheet::none;
}

}  // namespace braitenlab::ui

// The card of slots A and B: the two stored brains, and the numbers of their runs from the same start.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include <imgui.h>

#include "ui/panels/cards.h"
#include "ui/panels/panels.h"
#include "ui/shortcuts.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

using insight::CompareMeasure;
using insight::CompareNumbers;

constexpr std::array<std::string_view, 2> letters{"A", "B"};
constexpr std::array<std::string_view, 2> slot_anchors{"slot.a", "slot.b"};
constexpr std::array<std::string_view, 2> store_anchors{"slot.a.store", "slot.b.store"};
constexpr float column_space = spacing::small, row_gap = spacing::tight, height_of_all = 380;  // layout pixels

// "aggressor", "empty".
std::string content_of(const LabView& view, const Ui& ui, const SlotView& slot) {
    if (!slot.design) return std::string(ui.strings("slots.empty"));
    const VehicleView* vehicle = selected_vehicle(view);
    if (vehicle && hides_character(view, *vehicle)) return std::string(ui.strings("slots.stored"));
    return std::string(ui.strings("character." + std::string(name(slot.character))));
}

// The letter as a button that puts the brain into the vehicle, or stores where there is none. Returns its rectangle.
Rect letter_button(const LabView& view, Ui& ui, std::size_t slot) {
    const SlotView& shown = view.features.slots.slots[slot];
    const std::string letter(letters[slot]);
    const Item put_it = small_button(ui, {slot_anchors[slot], {}, letters[slot], shown.is_in_vehicle});
    tooltip(ui, put_it,
            fill(ui.strings(!shown.design         ? "slots.store_how"
                            : shown.is_in_vehicle ? "slots.is_in_vehicle"
                                                  : "slots.put_how"),
                 {letter}),
            key_name(Action::slot, ui.strings));
    if (put_it.pressed) ui.outbox.emplace_back(SlotRequest{slot, !shown.design});
    return put_it.rect;
}

void put_content(const LabView& view, Ui& ui, std::size_t slot, Rect of_letter, float right) {
    const SlotView& shown = view.features.slots.slots[slot];
    const float from = of_letter.x + of_letter.w + ui.px(column_space), line = line_height(ui, Face::small);
    put(ui, {from, of_letter.y + (of_letter.h - line) / 2},
        shortened(ui, content_of(view, ui, shown), Face::small, right - from),
        shown.design ? ui.palette.text : ui.palette.second_text, Face::small);
}

// The letter, the content of the slot, and a button that stores.
void slot_row(const LabView& view, Ui& ui, std::size_t slot) {
    const float right = ImGui::GetCursorScreenPos().x + card_width(ui);
    const Rect of_letter = letter_button(view, ui, slot);
    const SmallButton store{store_anchors[slot], icon::save, ui.strings("slots.store")};
    const float width = small_button_width(ui, store, true);
    put_content(view, ui, slot, of_letter, right - width - ui.px(column_space));
    ImGui::SameLine();
    ImGui::SetCursorScreenPos({right - width, of_letter.y});
    if (small_push_button(ui, store, fill(ui.strings("slots.store_how"), {std::string(letters[slot])})))
        ui.outbox.emplace_back(SlotRequest{slot, true});
}

// Both slots in one row without the buttons that store.
void both_slots(const LabView& view, Ui& ui) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float half = card_width(ui) / 2;
    for (std::size_t slot = 0; slot < 2; ++slot) {
        const float left = at.x + half * static_cast<float>(slot);
        ImGui::SetCursorScreenPos({left, at.y});
        put_content(view, ui, slot, letter_button(view, ui, slot), left + half - ui.px(column_space));
    }
}

std::string with_unit(const std::string& number, std::string_view unit) { return number + " " + std::string(unit); }

std::string number_words(const Ui& ui, float number, std::string_view unit) {
    if (std::isnan(number)) return "–";
    if (std::isinf(number)) return std::string(ui.strings("map.never"));
    return with_unit(fixed(ui, number, 1), unit);
}

struct TableRow {
    std::string_view anchor;
    std::string words;
    std::array<std::string, 3> cells;  // A, B, B − A
};

TableRow table_row(const Ui& ui, CompareMeasure measure, const CompareNumbers& a, const CompareNumbers& b) {
    const auto& row = insight::compare_measure_table[static_cast<std::size_t>(measure)];
    const auto index = static_cast<std::size_t>(measure);
    const auto rounded = [](CompareNumbers numbers) {  // the difference is that of the numbers as they are shown
        for (float& number : numbers) number = std::round(10 * number) / 10;
        return numbers;
    };
    const auto differs = insight::difference(rounded(a), rounded(b), measure);
    return {row.word,
            std::string(ui.strings("slots.measure." + std::string(row.word))),
            {number_words(ui, a[index], row.unit), number_words(ui, b[index], row.unit),
             differs ? with_unit(with_sign(ui, *differs, 1), row.unit) : std::string("–")}};
}

// Columns as wide as their widest cell; the words take what is left and are broken into lines. `columns`: 3, or 2
// without the differences, which are also left out of a card in which they leave no room for the words.
void table(const SlotsView& view, Ui& ui, std::size_t columns) {
    std::vector<TableRow> rows;
    for (const auto& row : insight::compare_measure_table)
        rows.push_back(table_row(ui, row.value, *view.slots[0].numbers, *view.slots[1].numbers));
    const float width = card_width(ui), line = line_height(ui, Face::small), space = ui.px(column_space);
    std::array<float, 3> widths{};
    for (const TableRow& row : rows)
        for (std::size_t i = 0; i < columns; ++i)
            widths[i] = std::max(widths[i], text_width(ui, Face::small, row.cells[i]));
    const std::array<std::string_view, 3> heads{"A", "B", "B − A"};
    for (std::size_t i = 0; i < columns; ++i) widths[i] = std::max(widths[i], text_width(ui, Face::strong, heads[i]));
    float of_words = 0;  // the longest single word
    for (const TableRow& row : rows)
        for (const std::string& word : lines_of_words(ui, row.words, Face::small, 1))
            of_words = std::max(of_words, text_width(ui, Face::small, word));
    const float numbers = widths[0] + widths[1] + (columns > 2 ? widths[2] : 0) + space * static_cast<float>(columns);
    if (columns > 2 && of_words + numbers > width) columns = 2;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    std::array<float, 3> rights{};
    float x = at.x + width;
    for (std::size_t i = columns; i-- > 0; x -= widths[i] + space) rights[i] = x;
    float y = at.y;
    const std::array colours{ui.palette.slot_a, ui.palette.slot_b, ui.palette.second_text};
    for (std::size_t i = 0; i < columns; ++i) put_right(ui, {rights[i], y}, heads[i], colours[i], Face::strong);
    y += line_height(ui, Face::strong) + ui.px(row_gap);
    for (const TableRow& row : rows) {
        const float top = y;
        for (std::size_t i = 0; i < columns; ++i)
            put_right(ui, {rights[i], y}, row.cells[i], i < 2 ? ui.palette.text : ui.palette.second_text, Face::small);
        for (const std::string& words : lines_of_words(ui, row.words, Face::small, std::max(x - at.x, ui.px(40)))) {
            put(ui, {at.x, y}, words, ui.palette.second_text, Face::small);
            y += line;
        }
        mark(ui, "slots." + std::string(row.anchor), {at.x, top, width, y - top});
        y += ui.px(row_gap);
    }
    ImGui::Dummy({width, y - at.y});
}

void compare_row(const LabView& view, Ui& ui) {
    const std::string_view why = why_no_comparison(view);
    ButtonLook look{icon::play, ui.strings("button.compare")};
    look.enabled = why.empty(), look.compact = true;
    if (push_button(ui, "button.compare", look, ui.strings(why.empty() ? "tooltip.compare" : why),
                    key_name(Action::compare, ui.strings)))
        ui.outbox.emplace_back(Action::compare);
}

}  // namespace

void slots_card(const LabView& view, PanelState& state, Ui& ui, Rect place, Rect rest) {
    std::array close{HeadingButton{"slots.close", ui.strings("slots.close"), ui.strings("slots.close_how")}};
    const bool open = open_card(state, ui, Card::slots, place, std::span(close).first(view.lecture ? 0 : 1));
    if (close[0].pressed) ui.outbox.emplace_back(EmptySlotsRequest{});
    if (open) {
        const SlotsView& slots = view.features.slots;
        const bool has_numbers = slots.slots[0].numbers && slots.slots[1].numbers;
        // Where type is large and the column low, the numbers have the room of the buttons that store, of the
        // differences and of the note.
        const bool is_short = has_numbers && view.lecture && rest.h < ui.px(height_of_all);
        if (is_short) both_slots(view, ui);
        for (std::size_t slot = 0; slot < 2 && !is_short; ++slot) slot_row(view, ui, slot);
        gap(ui, 4);
        compare_row(view, ui);
        if (has_numbers) {
            gap(ui, is_short ? 2 : 8);
            table(slots, ui, is_short ? 2 : 3);
            if (!is_short)
                paragraph(ui, fill(ui.strings("slots.how"), {fixed(ui, slots.seconds, 0)}), ui.palette.second_text,
                          Face::label);
        } else if (slots.is_computing) {
            paragraph(ui, ui.strings("slots.computing"), ui.palette.second_text, Face::small);
        }
    }
    end_card(ui, state.card(Card::slots));
}

}  // namespace braitenlab::ui

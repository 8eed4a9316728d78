#include "ui/panels/sheets.h"

#include <algorithm>

#include "ui/panels/course/author_state.h"
#include "ui/panels/panels.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

// Letters search what ships; arrows move in the grid of exercises.
bool key_for_files(PanelState& state, KeyPress press) {
    if (search_by_typing(state.sheets.files, press)) return true;
    const bool in_gallery = state.keyboard.focus.starts_with("gallery.");
    if (!in_gallery || press.key < key::right || press.key > key::up) return false;
    state.keyboard.presses.push_back(press);
    return true;
}

bool key_for_children(PanelState& state, KeyPress press) {
    if (press.key < '1' || press.key > '9') return false;
    state.keyboard.presses.push_back(press);
    return true;
}

#define SHEET(id, draws, ...) {.sheet = Sheet::id, .draw = draws, __VA_ARGS__},
#define FOLLOWED_SHEET(id, draws, follows, ...) {.sheet = Sheet::id, .draw = draws, .follow = follows, __VA_ARGS__},

constexpr SheetTraits sheet_traits[]{
#include "ui/panels/sheet_table.def"
};
static_assert(std::size(sheet_traits) == sheet_count);

// Scrolls the body of the sheet.
bool scrolls_sheet(SheetState& sheet, bool reads, KeyPress press) {
    constexpr float all = 1000, line = 0.12f;  // pages
    const float pages = press.key == key::page_down       ? 1
                        : press.key == key::page_up       ? -1
                        : reads && press.key == key::down ? line
                        : reads && press.key == key::up   ? -line
                        : reads && press.key == key::home ? -all
                        : reads && press.key == key::end  ? all
                                                          : 0;
    sheet.scroll += pages;
    return pages != 0;
}

}  // namespace

std::span<const SheetTraits> sheets() { return sheet_traits; }

const SheetTraits& traits(Sheet sheet) { return sheet_traits[static_cast<std::size_t>(sheet)]; }

void draw_sheets(const LabView& view, PanelState& state, Ui& ui, Rect window) {
    for (const SheetTraits& row : sheet_traits) {
        if (row.follow) row.follow(view, state, ui);
        if (state.sheet != row.sheet) continue;
        SheetState& sheet = state.state_of(row.sheet);
        sheet.is_resized = false;
        row.draw(view, state, ui, window);
        state.is_unsettled |= sheet.is_resized;
    }
}

SheetState& open_sheet(PanelState& state, Ui& ui, Sheet which, Rect window, std::string_view heading,
                       float layout_width) {
    const SheetTraits& row = traits(which);
    SheetState& sheet = state.state_of(which);
    begin_sheet(ui, sheet, row.anchor, heading.empty() ? ui.strings(row.heading) : heading,
                layout_width > 0 ? layout_width : row.width, window);
    return sheet;
}

bool close_button(Ui& ui, std::string_view id, Emphasis emphasis) {
    return push_button(ui, id, {{}, ui.strings("keys.close"), emphasis}, ui.strings("keys.close_how"),
                       key_name({key::escape}, ui.strings));
}

bool key_for_sheet_text(PanelState& state, KeyPress press) {
    if (state.sheet == Sheet::none || !traits(state.sheet).fields) return false;
    const std::vector<TextField*> fields = traits(state.sheet).fields(state);
    return std::any_of(fields.begin(), fields.end(),
                       [press](TextField* field) { return for_text_field(*field, press); });
}

// On a sheet Down and Up are Tab and Shift+Tab, unless they scroll it or the sheet takes them. Other keys do nothing.
void key_for_sheet(PanelState& state, KeyPress press) {
    const SheetTraits& row = traits(state.sheet);
    if (scrolls_sheet(state.state_of(row.sheet), row.reads, press)) return;
    if (row.keys && row.keys(state, press)) return;
    if (press.key == key::escape) state.sheet = Sheet::none;
    if (press.key == key::down) press = {key::tab};
    if (press.key == key::up) press = {key::tab, false, true};
    if (press.key == key::tab || press.key == key::enter || press.key == key::left || press.key == key::right)
        state.keyboard.presses.push_back(press);
}

void keep_drawn_fields(PanelState& state) {
    for (const SheetTraits& row : sheet_traits)
        if (row.fields)
            for (TextField* field : row.fields(state)) (void)keep_drawn(*field);
}

}  // namespace braitenlab::ui

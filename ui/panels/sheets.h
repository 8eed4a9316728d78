// The fields of ui/panels/sheet_table.def, which has one row per sheet. Drawing, keys and scrolling are derived from
// this table.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "ui/lab_view.h"
#include "ui/panels/panel_state.h"
#include "ui/widgets/button.h"
#include "ui/widgets/sheet.h"
#include "ui/widgets/text_field.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

// Esc, and a click beside it, close a sheet. While it is open, only keys of the window work beside its own.
struct SheetTraits {
    Sheet sheet;
    // While the sheet is open, after follow().
    void (*draw)(const LabView&, PanelState&, Ui&, Rect window) = nullptr;
    // Once a frame, also while the sheet is closed: opens or closes it, or reacts to its end. May be null.
    void (*follow)(const LabView&, PanelState&, Ui&) = nullptr;
    std::string_view anchor;   // "card.keys"
    std::string_view heading;  // string key; empty: given to open_sheet()
    float width = 0;           // layout pixels; 0: given to open_sheet()

    // The text fields, which receive keys before all else. Null: none.
    std::vector<TextField*> (*fields)(PanelState&) = nullptr;
    // Handles a key of the sheet; it comes before Esc and the keys of the focus. True if the key is handled. May be
    // null.
    bool (*keys)(PanelState&, KeyPress) = nullptr;
    bool reads = false;  // has only words to read: Up, Down, Home and End scroll it
};

// In the order of Sheet.
std::span<const SheetTraits> sheets();
const SheetTraits& traits(Sheet);  // precondition: not Sheet::none

// Calls follow() of all sheets and draws the open one. Call once a frame, after the cards.
void draw_sheets(const LabView&, PanelState&, Ui&, Rect window);

// begin_sheet() with anchor, heading and width of the table's row; `heading` and `layout_width` replace the row's.
// Follow with sheet_buttons() and end_sheet() of the returned state.
SheetState& open_sheet(PanelState&, Ui&, Sheet, Rect window, std::string_view heading = {}, float layout_width = 0);

// The button that closes a sheet, which Esc does, too. True when it is pressed.
bool close_button(Ui&, std::string_view id, Emphasis = Emphasis::primary);

// Handles a key for the text fields of the open sheet. Returns true if it is handled.
bool key_for_sheet_text(PanelState&, KeyPress);

// Handles a key while a sheet is open, after its text fields: scrolls it, closes it or moves the focus.
void key_for_sheet(PanelState&, KeyPress);

// Call at the end of a frame: text fields of sheets that were not drawn in it receive no more text.
void keep_drawn_fields(PanelState&);

}  // namespace braitenlab::ui

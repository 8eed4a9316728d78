// The canvas's menu: the actions for the selection, for the empty canvas, or at the end of a dropped wire.
#pragma once

#include <string_view>
#include <vector>

#include "core/brain/edit.h"
#include "ui/request.h"
#include "ui/wiring/view.h"

namespace braitenlab::wiring {

enum class MenuCommand {
    add,  // a neuron of MenuRow::kind
    edit_numbers,
    probe,
    chart,  // shows the nodes' signals on the chart card
    join,   // begins a wire that is drawn with keys
    insert,
    flip,  // the sign of a weight
    lesion,
    copy,
    cut,
    paste,
    duplicate,
    detach,
    erase,
    column,
    row,
    even_down,
    even_across,
    select_all,
    tidy,
    fit,
};

struct MenuRow {
    MenuCommand command{};
    std::string_view words;          // string key
    std::optional<Action> action{};  // the action with the same effect, for its shortcut
    std::size_t kind = 0;            // of add: index in neuron_kinds
    bool begins_group = false;       // a line above it
};

struct CanvasMenu {
    std::vector<MenuRow> rows;       // empty: the menu is closed
    std::string_view heading, note;  // string keys; empty: none
    int current = -1;                // row under the pointer or chosen with arrow keys; −1: none
    maths::vec2 at;                  // window pixel where it was opened
    maths::vec2 canvas_at;           // the same in canvas units: position of an added neuron
    Hit loose;                       // pin that a dropped wire starts from; Part::nothing: no wire
    Rect rect;                       // window pixels; set by place_menu()
    float ui_scale = 1;
    bool for_finger = false;  // rows have the height for a finger
    float row_height = 0;     // layout pixels; set by place_menu()
    bool open() const { return !rows.empty(); }
};

// The string key of a row of neuron_kinds: "wiring.kind.hump".
std::string_view kind_key(std::size_t kind);

// Rows for a selection; for an empty one, rows for the canvas.
std::vector<MenuRow> menu_rows(const BrainGraph&, const CanvasSelection&, bool can_paste);

// Rows for the end of a dropped wire: the kinds of neurons.
std::vector<MenuRow> drop_rows();

// Sets heading and note of a menu of neurons.
void set_heading(CanvasMenu&);

// The height of heading and note, window pixels.
float heading_height(const CanvasMenu&);

// Sets the menu's rectangle within the area. `width`: window pixels.
void place_menu(CanvasMenu&, Rect area, float ui_scale, float width);

// Window pixels.
Rect row_rect(const CanvasMenu&, std::size_t row);

// The row under a pixel; −1: none.
int row_at(const CanvasMenu&, maths::vec2 pixel);

struct Pen;

// Places the menu in the area and draws it; nothing when it is closed.
void draw_menu(const Pen&, CanvasMenu&, Rect area);

}  // namespace braitenlab::wiring

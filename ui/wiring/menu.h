// The canvas's menu: what a right click or Enter offers on whatever is there, and what a wire dropped on empty ground
// can end at. Drawn and hit by the canvas itself, as everything on it.
#pragma once

#include <string_view>
#include <vector>

#include "core/brain/edit.h"
#include "ui/request.h"
#include "ui/wiring/hit.h"

namespace braitenlab {

enum class MenuCommand {
    add,  // a neuron; MenuRow::kind says which
    edit_numbers,
    join,  // a wire from here, by keys
    insert,
    flip,  // excites ↔ inhibits
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
    std::string_view words;       // string key
    std::optional<Action> key{};  // its shortcut
    std::size_t kind = 0;         // of add: in neuron_kinds
    bool begins_group = false;    // a line above it
};

struct CanvasMenu {
    std::vector<MenuRow> rows;       // none: it is closed
    std::string_view heading, note;  // string keys of what stands above them; empty for nothing
    int current = -1;                // the row that the mouse or the arrow keys stand at; −1: none
    maths::vec2 at;                  // where it was asked for, window pixels
    maths::vec2 place;               // the same in canvas units: what is made comes to stand there
    Hit loose;                       // the pin that a dropped wire comes from; nothing: no wire is waiting
    Rect rect;                       // where it stands, window pixels; set by place_menu()
    float ui_scale = 1;
    bool open() const { return !rows.empty(); }
};

// The string key of a row of neuron_kinds.
std::string_view kind_key(std::size_t kind);

// What there is to do with a selection; with nothing selected, with the canvas.
std::vector<MenuRow> menu_rows(const BrainGraph&, const Caught& selection, bool can_paste);

// The kinds of neuron that a dropped wire can end at.
std::vector<MenuRow> drop_rows();

// What the rows are about, where they do not say so themselves: what is chosen from them is added.
void head_menu(CanvasMenu&);

// How high heading and note stand together, window pixels.
float head_height(const CanvasMenu&);

// Gives the menu its place: as wide as its widest words (window pixels), within the area.
void place_menu(CanvasMenu&, Rect area, float ui_scale, float widest);

// Where a row stands, and the row under a pixel; −1 for none.
Rect row_rect(const CanvasMenu&, std::size_t row);
int row_at(const CanvasMenu&, maths::vec2 pixel);

}  // namespace braitenlab

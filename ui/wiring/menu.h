// The canvas's menu: the actions for the selection, for the empty canvas, or at the end of a dropped wire.
#pragma once

#include <string_view>
#include <vector>

#include "ui/wiring/canvas_state.h"

namespace braitenlab::wiring {

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

// Sets the menu's rectangle within the window; rows of a low one are lower. `width`: window pixels.
void place_menu(CanvasMenu&, Rect window, float ui_scale, float width);

// Window pixels.
Rect row_rect(const CanvasMenu&, std::size_t row);

// The row under a pixel; −1: none.
int row_at(const CanvasMenu&, maths::vec2 pixel);

struct Pen;

// Places the menu in the window and draws it; nothing when it is closed.
void draw_menu(const Pen&, CanvasMenu&, Rect window);

}  // namespace braitenlab::wiring

// What the mouse and the keys do to the canvas; knows nothing of Dear ImGui.
//
// Idle → Pending (pressed, moved less than 4 px) → Pan | Map | Box | MoveNodes | DragWire | DragWeight → Idle.
#pragma once

#include "ui/wiring/canvas.h"

namespace braitenlab {

// The mouse of one frame, in window pixels.
struct Pointer {
    maths::vec2 at;
    bool valid = true;  // false when the window has lost the mouse: a drag is undone
    bool over = true;   // nothing covers the canvas here
    bool left_pressed = false, right_pressed = false, middle_pressed = false;  // this frame
    bool left_down = false, right_down = false, middle_down = false;
    float wheel = 0;  // notches, up is positive
    bool shift = false;
};

struct CanvasFrame {
    const BrainGraph& graph;  // the brain as it runs
    const Layout& layout;
    Rect area;
    Target target;  // whom edits go to
    float ui_scale = 1;
    double wall_seconds = 0;
    Pointer pointer;
};

View view_of(const CanvasState&, Rect area, float ui_scale);
inline View view_of(const CanvasState& state, const CanvasFrame& frame) {
    return view_of(state, frame.area, frame.ui_scale);
}

// Multiplies the zoom (kept within its range) so that the canvas point under the pixel stays there.
void zoom_at(CanvasState&, Rect area, float ui_scale, maths::vec2 pixel, float factor);

// Brings all nodes into the area, below its buttons or beside them, never larger than 1.4 times.
void fit(CanvasState&, const Layout&, Rect area, float ui_scale);

// Moves the view by as little as brings the canvas point into the area, clear of its rim.
void reveal(CanvasState&, Rect area, float ui_scale, maths::vec2 point);

// One frame: mouse and keys become view state and requests.
void interact(CanvasState&, const CanvasFrame&, Outbox&);

// What would happen if the wire being dragged were let go here. Precondition: the phase is drag_wire.
struct WireDrop {
    enum class What { nothing, connect, new_neuron, take_off, refused } what = What::nothing;
    WireEnds ends;         // of connect
    std::string reason{};  // of refused: a string key
};
// The string key of a refusal.
std::string refusal_key(Refusal);

WireDrop drop_of(const CanvasState&, const CanvasFrame&);

// The wire that would take in the neuron being moved if it were let go here: one without any wires, alone.
std::optional<WireEnds> insertion_of(const CanvasState&, const CanvasFrame&);

}  // namespace braitenlab

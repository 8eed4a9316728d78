// What the mouse and the keys do to the canvas; knows nothing of Dear ImGui.
//
// Idle → Pending (pressed, moved less than 4 px) → Pan | Box | MoveNodes | DragWire | DragWeight → Idle.
#pragma once

#include "ui/wiring/canvas.h"

namespace braitenlab {

// The mouse of one frame, in window pixels.
struct Pointer {
    maths::vec2 at;
    bool valid = true;                               // false when the window has lost the mouse: a drag is undone
    bool over = true;                                // nothing covers the canvas here
    bool left_pressed = false, pan_pressed = false;  // this frame; pan: right or middle button
    bool left_down = false, pan_down = false;
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

// Multiplies the zoom (kept in 0.3..3) so that the canvas point under the pixel stays there.
void zoom_at(CanvasState&, Rect area, float ui_scale, maths::vec2 pixel, float factor);

// Brings all nodes into the area, below its buttons, never larger than 1.4 times.
void fit(CanvasState&, const Layout&, Rect area, float ui_scale);

// One frame: mouse and keys become view state and requests.
void interact(CanvasState&, const CanvasFrame&, Outbox&);

// What would happen if the wire being dragged were let go here. Precondition: the phase is drag_wire.
struct WireDrop {
    enum class What { nothing, connect, new_neuron, refused } what = What::nothing;
    WireEnds ends;              // of connect
    std::string_view reason{};  // of refused: a string key
};
WireDrop drop_of(const CanvasState&, const CanvasFrame&);

}  // namespace braitenlab

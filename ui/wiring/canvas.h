// The wiring canvas: a brain as a picture that can be rewired with the mouse.
//
// It reads the selected vehicle's brain from the snapshot every frame and keeps only what a person sees: where nodes
// were moved, the view, the selection, the drag in progress. Every change leaves as an EditRequest through ui.outbox:
// TurnDial for the weights of LL, LR, RL, RR (a slider and a wire are the same number), SetBrain for everything else.
// All edits of one drag carry one gesture.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ui/lab_view.h"
#include "ui/widgets/ui.h"
#include "ui/wiring/hit.h"
#include "ui/wiring/moment.h"

namespace braitenlab {

enum class CanvasPhase { idle, pending, pan, box, move_nodes, drag_wire, drag_weight };

enum class CanvasKey {
    cancel,  // Esc: the drag in progress is undone, else the selection is cleared
    erase,   // Del: removes the selected wires and neurons
    fit,     // F, Home: everything in sight
};

// From the press of a button to its release; what it began with, so that Esc can bring it back.
struct CanvasDrag {
    CanvasPhase phase = CanvasPhase::idle;
    Hit pressed;
    bool panning_button = false;  // right or middle
    maths::vec2 press, last;      // window pixels
    BrainGraph graph;
    Places places;
    Caught selection;
    float weight = 0, travel = 0, sent = 0;  // of DragWeight: at press, dragged since, last one asked for
    std::uint64_t gesture = 0;
};

// Why something was refused, shown at the cursor for a moment.
struct CanvasRefusal {
    std::string key;   // of the reason's string; empty for none
    maths::vec2 at;    // window pixels
    double until = 0;  // LabView::wall_seconds
};

inline constexpr float least_zoom = 0.1f, most_zoom = 3;

struct CanvasState {
    std::map<int, Places> places;  // nodes that were moved, by the vehicle's kind
    maths::vec2 middle;            // the canvas point in the middle of the area
    float zoom = 1;                // least_zoom..most_zoom
    bool own_view = false;         // panned or zoomed by hand: no automatic fit
    Caught selection;
    CanvasDrag drag;
    CanvasRefusal refusal;
    Hit hovered;
    KeptLayout layout;
    Moment moment;

    int kind = -1;  // what was shown last, and how: a change fits the view again
    std::size_t nodes = 0;
    Rect fitted_area;
    int last_frame = -1;                      // a drag that was not drawn for a frame is dropped
    std::uint64_t next_gesture = 1ULL << 40;  // far from the sliders' numbers
    WireEnds wheel_wire;                      // notches over the same label are one gesture
    std::uint64_t wheel_gesture = 0;
    std::vector<CanvasKey> keys;  // waiting for the next frame
    bool keys_from_imgui = true;  // false where the app forwards keys with press_key()
};

// Draws the canvas over `area` (window pixels: the part of the window that no card covers) and reports what the person
// did there. Anchors: canvas, canvas.arrange, canvas.fit, pin.<node>.out, pin.<node>.in, node.<node>, wire.LL … or
// wire.<from>-<to> (the weight's label).
void wiring_canvas(const LabView&, CanvasState&, Ui&, Rect area);

// Hands a key to the canvas; it acts when drawn next. For apps that keep their own queue of keys (Dear ImGui 1.86 loses
// quick presses); such an app sets keys_from_imgui to false. True when the canvas has a use for the key now: an Esc
// that returns false is free to leave the wiring mode.
bool press_key(CanvasState&, CanvasKey);

}  // namespace braitenlab

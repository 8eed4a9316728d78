// The wiring canvas: a brain as a picture that can be rewired with the mouse, or with the keys alone.
//
// It reads the selected vehicle's brain from the snapshot every frame and keeps only what a person sees: the view, the
// selection, the drag in progress. Every change leaves as an EditRequest through ui.outbox: TurnDial for the weights of
// LL, LR, RL, RR (a slider and a wire are the same number), PlaceNodes for where nodes stand, SetBrain for everything
// else. All edits of one drag carry one gesture.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/brain/fragment.h"
#include "ui/lab_view.h"
#include "ui/widgets/card.h"
#include "ui/widgets/ui.h"
#include "ui/wiring/hit.h"
#include "ui/wiring/menu.h"
#include "ui/wiring/moment.h"

namespace braitenlab {

enum class CanvasPhase { idle, pending, pan, map, box, move_nodes, drag_wire, drag_weight };

// From the press of a button to its release; what it began with, so that Esc can bring it back.
struct CanvasDrag {
    CanvasPhase phase = CanvasPhase::idle;
    Hit pressed;
    bool left = true, right = false;  // the button; neither: the middle one
    maths::vec2 press, last;          // window pixels
    BrainGraph graph;
    Places places;  // of move_nodes: where those in the hand stood
    Caught selection;
    float weight = 0, travel = 0, sent = 0;  // of drag_weight: at press, dragged since, last one asked for
    NodeId fixed = 0;                        // of drag_wire: the node that the wire stays at
    bool outwards = true;                    // and whether it begins there
    std::optional<WireEnds> taken;           // the wire whose end was taken off; nothing: a new wire
    std::uint64_t gesture = 0;
};

// Why something was refused, shown at the cursor for a moment.
struct CanvasRefusal {
    std::string key;   // of the reason's string; empty for none
    maths::vec2 at;    // window pixels
    double until = 0;  // LabView::wall_seconds
};

// What was shown a frame ago, and where: changes of it move the view, or must not.
struct CanvasShown {
    std::uint64_t sitting = 0;
    int kind = -1;  // the vehicle's
    std::shared_ptr<const BrainGraph> brain{};
    Rect area{};
    maths::vec2 window{};  // its size, pixels
    float ui_scale = 1;
};

inline constexpr float least_zoom = 0.1f, most_zoom = 3;

struct CanvasState {
    maths::vec2 middle;     // the canvas point in the middle of the area
    float zoom = 1;         // least_zoom..most_zoom
    bool own_view = false;  // panned or zoomed by hand: no automatic fit
    Places held;            // nodes in the hand, and those just let go until the lab has put them there
    Caught selection;
    Hit focus;                      // a node or a label: where the arrow keys stand
    std::optional<NodeId> joining;  // a wire is being drawn by keys from this node to the one in focus
    CanvasDrag drag;
    CanvasMenu menu;
    BrainFragment clipboard;
    Hit rested;  // what the pointer has lain on, and since when (LabView::wall_seconds)
    double rested_since = 0;
    CanvasRefusal refusal;
    Hit hovered;
    KeptLayout layout;
    CanvasMoment moment;

    CanvasShown shown;
    bool entered = false;  // the canvas was not drawn a frame ago
    int last_frame = -1;   // a drag that was not drawn for a frame is dropped
    std::uint64_t next_gesture = gestures::canvas;
    WireEnds wheel_wire;  // notches over the same label are one gesture
    std::uint64_t wheel_gesture = 0;
    maths::vec2 pointer;  // window pixels, where the mouse was seen last
    CardState inspector;
    std::optional<MenuRow> wanted;  // asked for by the inspector's buttons, for the next frame
    bool edit_numbers = false;      // the inspector is to take the keyboard
    std::vector<Action> keys;       // waiting for the next frame
};

// Draws the canvas over `area` (window pixels: the part of the window that no card covers) and reports what the person
// did there. Anchors: canvas, canvas.arrange, canvas.fit, canvas.minimap, pin.<node>.out, pin.<node>.in, node.<node>,
// wire.LL … or wire.<from>-<to> (the weight's label), curve.LL … (a point of the curve beside its label); menu.<row>
// while a menu is open; says.<node> while a note says what it senses; selected.<node or wire>; refused.<reason>.
void wiring_canvas(const LabView&, CanvasState&, Ui&, Rect area);

// Hands a key's action to the canvas, which acts when drawn next. True when the canvas has a use for it now: an Esc
// that returns false is free to leave the wiring mode.
bool press_key(CanvasState&, Action);

}  // namespace braitenlab

// What the wiring canvas stores: view state only. The graph is that of the snapshot.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/brain/fragment.h"
#include "ui/lab_view.h"
#include "ui/widgets/card.h"
#include "ui/wiring/view.h"

namespace braitenlab::wiring {

inline constexpr const char* canvas_window = "wiring canvas";  // its name in Dear ImGui

// The anchor of the canvas, and the keyboard focus of a canvas that is watched beside the scene.
inline constexpr std::string_view canvas_focus = "canvas";

enum class DragPhase { idle, pending, pan, map, box, move_nodes, drag_wire, drag_weight };

// A drag, from a button's press to its release, with the state at the press, which Esc restores.
struct Drag {
    DragPhase phase = DragPhase::idle;
    Hit pressed;
    bool left = true, right = false;  // the button; neither: the middle one
    maths::vec2 press, last;          // window pixels
    BrainGraph graph;
    Positions positions;  // of move_nodes: of the moved nodes
    CanvasSelection selection;
    float weight = 0, travel = 0, sent = 0;  // of drag_weight: at the press, dragged since then, last one sent
    NodeId fixed = 0;                        // of drag_wire: the node at the other end of the wire
    bool outwards = true;                    // of drag_wire: whether the wire starts at `fixed`
    std::optional<WireEnds> taken;           // of drag_wire: the wire whose end is dragged; nullopt: a new wire
    std::uint64_t gesture = 0;
};

// The reason of a refusal, shown at the pointer for a moment.
struct RefusalNote {
    std::string key;   // string key; empty: none
    maths::vec2 at;    // window pixels
    double until = 0;  // LabView::wall_seconds
};

// The view of the previous frame. A change of it can move the camera.
struct ShownBefore {
    std::uint64_t run_id = 0;
    int kind = -1;  // the vehicle's
    std::shared_ptr<const BrainGraph> brain{};
    Rect area{};
    maths::vec2 window{};  // its size, pixels
    float ui_scale = 1;
    bool watched = false;  // beside the scene
};

// The values and signals of nodes and wires in the snapshot, in the order of the layout.
struct Readings {
    std::vector<float> nodes;    // as Layout::nodes: a sensor's reading, a neuron's or a motor's value
    std::vector<float> learned;  // as Layout::wires: the learned part of a Hebbian wire's weight, else 0
    std::vector<float> carried;  // as Layout::wires: the signal that the wire delivers
};

// Equals node_value(), learned() and signal() of each node and wire. Precondition: the layout is of the vehicle's brain
// `graph`.
void update(Readings&, const Snapshot&, const VehicleView&, const BrainGraph& graph, const Layout&);

// What a row of the menu does that is no Action.
enum class MenuCommand {
    add,  // a neuron of MenuRow::kind
    edit_numbers,
    chart,  // shows the nodes' signals on the chart card
    join,   // begins a wire that is drawn with keys
    insert,
    flip,  // the sign of a weight
    detach,
    column,
    row,
    even_down,
    even_across,
};

struct MenuRow {
    std::string_view words;  // string key
    std::variant<Action, MenuCommand> effect;
    std::size_t kind = 0;       // of add: index in neuron_kinds
    bool begins_group = false;  // a line above it
    bool adds() const { return effect == decltype(effect)(MenuCommand::add); }
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
    float finger = 0;      // Ui::finger
    float row_height = 0;  // layout pixels; set by place_menu()
    bool open() const { return !rows.empty(); }
};

// The part under the pointer, and since when.
struct PointerRest {
    Hit on;
    double since = 0;  // LabView::wall_seconds
};

// Wheel notches over the label of one wire are one gesture.
struct WheelGesture {
    WireEnds wire;
    std::uint64_t gesture = 0;  // 0: none
};

struct CanvasState {
    CanvasCamera camera;
    Positions held;  // of dragged nodes, until the snapshot has their new positions after the release
    CanvasSelection selection;
    std::vector<std::string> for_chart;  // names of nodes that the menu sends to the chart; the panels take them
    std::set<std::string> probes;        // names of nodes whose last seconds are shown; kept for every brain
    Hit focus;                           // node or label that arrow keys start from
    std::optional<NodeId> joining;       // start of a wire that is drawn with keys, to the node in focus
    Drag drag;
    CanvasMenu menu;
    BrainFragment clipboard;
    RefusalNote refusal;
    Hit hovered;  // part under the pointer
    PointerRest rest;
    maths::vec2 last_pointer;  // window pixels, in the previous frame
    LayoutCache layout;
    Readings readings;

    ShownBefore shown;
    bool entered = false;  // the previous frame did not draw the canvas
    int last_frame = -1;   // Dear ImGui's count; a drag ends when a frame does not draw the canvas
    std::uint64_t next_gesture = gestures::canvas;
    WheelGesture wheel;
    ui::CardState inspector;
    bool edit_numbers = false;          // the keyboard focus moves to the inspector in the next frame
    std::vector<Action> actions;        // keys' actions, executed in the next frame
    std::optional<MenuRow> chosen_row;  // chosen with the inspector's buttons, executed in the next frame
};

// The mouse in one frame, window pixels.
struct Pointer {
    maths::vec2 at;
    bool valid = true;  // false when the window has lost the mouse: a drag is cancelled
    bool over = true;   // no other window covers the canvas here
    bool left_pressed = false, right_pressed = false, middle_pressed = false;  // in this frame
    bool left_down = false, right_down = false, middle_down = false;
    float wheel = 0;  // notches, up is positive
    bool shift = false;
};

// The input of one frame.
struct CanvasFrame {
    const BrainGraph& graph;  // the vehicle's brain
    const Layout& layout;
    Rect area;
    Target target;  // vehicle or kind that edits apply to
    float ui_scale = 1;
    double wall_seconds = 0;
    Pointer pointer;
    bool has_buttons = true;  // Arrange and Fit
    float reach = 1;          // finger_reach()
    float least_type = 0;     // of letters, window pixels; as Ui::least_type
};

inline View view_of(const CanvasState& state, const CanvasFrame& frame) {
    return view_of(state.camera, frame.area, frame.ui_scale);
}

// The part of the picture under the pointer.
inline Hit hit(const CanvasState& state, const CanvasFrame& frame) {
    const View view = view_of(state, frame);
    return hit(frame.layout, view, frame.pointer.at, frame.ui_scale * frame.reach,
               is_map(view, frame.ui_scale, frame.least_type));
}

}  // namespace braitenlab::wiring

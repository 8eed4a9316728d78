// Mouse and keyboard input over the 3D view. It reads the snapshot and stores only the user's current gesture: the
// object under the pointer, the drag in progress, the tool, the corners drawn so far. Changes are sent as EditRequests;
// all edits of one drag have the same gesture number.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "render/view/label_space.h"
#include "render/view/pick.h"
#include "ui/lab_view.h"
#include "ui/scene_input/path_drawing.h"
#include "ui/scene_input/point_handles.h"
#include "ui/scene_input/sensor_handles.h"
#include "ui/shortcuts.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

// The effect of a click into the scene: hand takes an object, lamp adds a lamp, box and zone draw a rectangle from
// corner to corner, polygon draws a polygon by its corners, tape draws a line of tape, ruler measures.
enum class SceneInputTool { hand, lamp, box, polygon, zone, tape, ruler };
inline constexpr std::array<std::string_view, 7> tool_words{"hand", "lamp", "box", "polygon", "zone", "tape", "ruler"};
static_assert(has_enumerators<SceneInputTool, tool_words.size()>());
constexpr std::string_view word(SceneInputTool tool) { return tool_words[static_cast<std::size_t>(tool)]; }

// The current effect of the mouse. pending: a button is down and the mouse has moved less than 4 px. span: a tool draws
// from the press to the pointer. select: Shift and a drag draw the rectangle that selects. handle: a handle of a
// sensor's field, a corner or a waypoint is dragged.
enum class SceneInputPhase { idle, pending, move, turn, orbit, pan, span, select, handle };

// The object or the handle that a press of the button takes.
struct SceneInputHit {
    SceneObject object;
    bool handle = false;  // the ring around the chosen object, which turns it
    explicit operator bool() const { return handle || object; }
    friend bool operator==(const SceneInputHit&, const SceneInputHit&) = default;
};

// From press to release of a button, with the initial state, which Esc restores.
struct SceneInputDrag {
    SceneInputPhase phase = SceneInputPhase::idle;
    bool left = true;  // else the right or middle button, which moves the camera
    bool right = false;
    SceneInputHit on;
    SceneObject
        click;  // what a click selects beside `on`: an unselected zone, one of several objects, or with Shift any
    bool selects = false;  // with Shift: a click adds to the selection, a drag selects all within a rectangle
    std::vector<std::pair<SceneObject, Pose>> others;  // moved together with `on`, and their poses at the press
    maths::vec2 press;                                 // window pixels
    maths::vec2 last;                                  // pointer in the last frame, window pixels
    maths::vec2 moved;                                 // of the pointer since then
    Pose began, put;                                   // pose of the object at the press, and the last one requested
    std::optional<std::uint64_t> moment;               // of the trail at the press, see trail_moment_at_pointer()
    maths::vec2 offset;                                // m, from the pointer's position on the floor to the object's
    float bearing = 0;  // rad, from the object to the pointer, at the press of the handle
    std::uint64_t gesture = 0;
};

// The reason why an input was refused, shown at the pointer for some seconds.
struct SceneInputRefusal {
    std::string key;   // string key of the reason; empty: none
    double until = 0;  // LabView::wall_seconds
};

enum class MenuPage { top, brains };

struct SceneInputMenu {
    bool open = false;
    bool by_key = false;  // opened by key: the first row gets the focus
    bool placed = false;  // has been drawn since it was opened
    SceneObject object;   // the object of the menu; none: the floor
    maths::vec2 place;    // m, of the press
    maths::vec2 at;       // window pixels
    MenuPage page = MenuPage::top;
    std::vector<std::string> rows;  // anchors of last frame's rows, from top to bottom
};

struct SceneInputState {
    SceneInputTool tool = SceneInputTool::hand;
    // Set with the tool so far, m: corners of a polygon, points of a line, the first corner of a box or zone; one or
    // both ends of a measurement.
    std::vector<maths::vec2> corners;
    std::string redrawn;  // name of the zone that gets the drawn polygon; empty: the polygon is a new obstacle
    std::optional<maths::vec2> crosshair;  // m, moved by arrow keys while a tool draws; none: the mouse points
    maths::vec2 pointer;                   // of the last frame, window pixels
    bool over = false;                     // the pointer was over the scene in the last frame, not over a card
    maths::vec2 middle;                    // of the area free of cards in the last frame, window pixels
    SceneInputHit hovered;
    std::optional<std::uint64_t> trail_moment;  // tick of the point of the trail under the pointer
    SceneInputDrag drag;
    SceneInputRefusal refusal;
    SceneInputMenu menu;
    SensorHandleState sensors;
    PointHandleState points;
    PathDrawing path;
    LabelSpace labels;        // what is written over the scene in this frame, window pixels
    bool below_menu = false;  // the view menu is open over the whole window; a right click into the scene closes it
    std::uint64_t gesture = 0;
    SceneObject nudged;        // by arrow keys; presses within a second are one gesture
    double nudged_at = -1;     // wall seconds; negative: never
    std::uint64_t run_id = 0;  // LabView::run_id of the document that the values above belong to
};

// Takes a tool, and discards what another one has begun.
inline void choose_tool(SceneInputState& state, SceneInputTool tool) {
    state.tool = tool;
    state.corners.clear();
    state.redrawn.clear();
    state.crosshair.reset();
}

// The object that Delete, Ctrl+D, the arrow keys and the handle act on: the selected lamp, obstacle or zone, else the
// selected vehicle.
SceneObject chosen(const LabView&);

// Handles one frame of mouse input, and draws rings, handles and previews below the cards. Notes are within `area`,
// which no card covers, and beside the `tools` over it. Does nothing without view.camera_view. Anchor: stage.knob, the
// handle of the chosen object.
void scene_input(const LabView&, SceneInputState&, Ui&, Rect area, Rect tools);

// Handles a key: Esc, Enter, Backspace and arrows while a tool draws, arrows for the chosen lamp, obstacle or zone
// (with Ctrl also for vehicles), and keys of the open menu. Returns false if the key is not used.
bool press_key(const LabView&, SceneInputState&, Keyboard&, KeyPress, Outbox&);

// Gesture number of the last press of a key that moved an object, less than a second ago; 0: there was none.
std::uint64_t gesture_by_keys(const SceneInputState&, double wall_seconds);

// True if the arrow keys move an object or the crosshair of a tool and not the camera.
bool takes_arrows(const LabView&, const SceneInputState&, bool ctrl);

}  // namespace braitenlab::ui

// What the scene's input stores: the user's current gesture, that is the object under the pointer, the drag in
// progress, the tool and the corners drawn so far.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/enum_table.h"
#include "core/maths/vec.h"
#include "core/world/command.h"
#include "render/view/label_space.h"
#include "render/view/pick.h"
#include "ui/lab_view.h"
#include "ui/request.h"
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

// ── Handles that move points of the scene, point_handles.h ──
enum class PointKind { none, corner, waypoint };

struct PointHandle {
    PointKind kind = PointKind::none;
    std::size_t index = 0;  // of the corner or the waypoint
    explicit operator bool() const { return kind != PointKind::none; }
    friend bool operator==(const PointHandle&, const PointHandle&) = default;
};

struct PointDrag {
    PointHandle handle;               // none: no drag
    SceneObject object;               // that has the corner
    int kind = -1;                    // that has the waypoint
    std::vector<maths::vec2> points;  // all corners or waypoints at the press, m
    maths::vec2 offset;               // m, from the pointer's position on the floor to the point
    maths::vec2 put;                  // m, the last position requested
    Command restored;                 // by Esc
    std::uint64_t gesture = 0;
};

struct PointHandleState {
    PointHandle hovered;
    PointDrag drag;
};

// ── Handles of a sensor, sensor_handles.h ──
// axis: in the middle of the arc; along the arc it turns the sensor, outwards it changes the range. left, right: ends
// of the arc; they change the opening angle. mount: the sensor's position.
enum class SensorHandle { none, axis, left, right, mount };
inline constexpr std::array<std::string_view, 5> sensor_handle_words{"none", "axis", "left", "right", "mount"};
static_assert(has_enumerators<SensorHandle, sensor_handle_words.size()>());
constexpr std::string_view word(SensorHandle handle) { return sensor_handle_words[static_cast<std::size_t>(handle)]; }

// What a drag of the handle `axis` changes; undecided until the pointer has moved by some pixels.
enum class AxisDrag { undecided, angle, range };

struct SensorDrag {
    SensorHandle handle = SensorHandle::none;  // none: no drag
    AxisDrag axis = AxisDrag::undecided;
    VehicleId vehicle = no_vehicle;
    Target target;                     // of the edits
    std::vector<Sensor> began;         // all sensors of the vehicle at the press
    std::vector<SetSensors> restored;  // by Esc: the target's sensors at the press, and the own ones of its vehicles
    std::string name, opposite;  // of the sensor and of that on the other side, which changes, too; empty: none does
    maths::vec2 press;           // of the pointer at the press, from the mount, in the vehicle's frame; m
    maths::vec2 press_pixel;     // window pixels
    std::uint64_t gesture = 0;
};

struct SensorHandleState {
    // Set by the window before each frame from the sensor card.
    bool shown = false;
    std::string sensor;  // name; the first sensor if the vehicle has none of this name
    bool alone = false;  // edits do not apply to the sensor on the other side

    SensorHandle hovered = SensorHandle::none;
    SensorDrag drag;
};

// ── A path drawn freehand, path_drawing.h ──
struct PathDrawing {
    bool on = false;                  // the next drag draws the path
    bool held = false;                // the button is down since the line was begun
    std::vector<maths::vec2> points;  // m; the first is the vehicle's position. Drawn by keys if the button is up
};

struct SceneInputState {
    SceneInputTool tool = SceneInputTool::hand;
    bool tools_open = false;  // all tools are shown where there is room for one
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
    // The system's clipboard when objects were copied last; a later link is opened.
    std::string clipboard_at_copy;
};

// Takes a tool, and discards what another one has begun.
inline void choose_tool(SceneInputState& state, SceneInputTool tool) {
    state.tool = tool;
    state.corners.clear();
    state.redrawn.clear();
    state.crosshair.reset();
}

// The mouse in one frame, in window pixels.
struct SceneInputPointer {
    maths::vec2 at;
    bool over = true;                                                          // no card covers the scene here
    bool left_pressed = false, right_pressed = false, middle_pressed = false;  // in this frame
    bool left_double = false;                                                  // the second press of a double click
    bool left_down = false, right_down = false, middle_down = false;
    bool shift = false;
};

struct SceneInputFrame {
    const LabView& view;
    const CameraView& camera_view;
    float scale = 1;  // window pixels per layout pixel
    Rect area;        // free of cards
    SceneInputPointer pointer;
    LabelSpace* labels = nullptr;  // of this frame; null: a note avoids vehicles and bulbs only
};

}  // namespace braitenlab::ui

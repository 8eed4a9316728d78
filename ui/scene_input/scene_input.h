// The scene under the hand. It reads the moment and keeps only what a person is doing: what lies under the pointer,
// the drag in progress, the tool, the corners drawn so far. Every change leaves as an EditRequest through the outbox;
// all edits of one drag carry one gesture.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/view/pick.h"
#include "ui/lab_view.h"
#include "ui/shortcuts.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/ui.h"

namespace braitenlab {

// What a click into the scene does: take things, set up a lamp, draw a box from corner to corner or a polygon by its
// corners.
enum class SceneInputTool { hand, lamp, box, polygon };

// What the mouse is doing: nothing, not yet clear what, moving or turning a thing, moving the camera, drawing a box.
enum class SceneInputPhase { idle, pending, move, turn, orbit, pan, box };

// What a press of the button would take hold of.
struct SceneInputHit {
    SceneObject object;
    bool handle = false;  // the ring round the chosen thing, which turns it
    explicit operator bool() const { return handle || object; }
    friend bool operator==(const SceneInputHit&, const SceneInputHit&) = default;
};

// From the press of a button to its release; what it began with, so that Esc can bring it back.
struct SceneInputDrag {
    SceneInputPhase phase = SceneInputPhase::idle;
    bool left = true;  // else the right or middle button, which moves the camera
    bool right = false;
    SceneInputHit on;
    maths::vec2 press;  // window pixels
    maths::vec2 last;   // where the pointer was when it was last reckoned with, and how far it has come since, px
    maths::vec2 moved;
    Pose began, put;     // of the thing: at first, and where the hand has put it
    maths::vec2 offset;  // m, from the pointer's place on the floor to the thing's
    float bearing = 0;   // rad, of the pointer as seen from the thing, at the press of its handle
    maths::vec2 corner;  // m, of the box
    std::uint64_t gesture = 0;
};

// Why something was refused, shown at the pointer for a moment.
struct SceneInputRefusal {
    std::string key;   // of the reason's string; empty for none
    double until = 0;  // LabView::wall_seconds
};

enum class MenuPage { top, brains };

struct SceneInputMenu {
    bool open = false;
    bool by_key = false;  // opened by key: the first row takes the focus
    bool placed = false;  // it has been drawn since it opened
    SceneObject object;   // what it is about; none: the floor
    maths::vec2 place;    // m, of the press
    maths::vec2 at;       // window pixels
    MenuPage page = MenuPage::top;
    std::vector<std::string> rows;  // anchors of last frame's rows, from top to bottom
};

struct SceneInputState {
    SceneInputTool tool = SceneInputTool::hand;
    std::vector<maths::vec2> corners;  // of the polygon being drawn, m
    SceneInputHit hovered;
    SceneInputDrag drag;
    SceneInputRefusal refusal;
    SceneInputMenu menu;
    std::uint64_t gesture = 0;
    SceneObject nudged;  // by arrow keys; quick presses are one gesture
    double nudged_at = 0;
};

// What Delete, Ctrl+D, the arrows and the handle act on: the lamp or obstacle that was clicked last, else the selected
// vehicle.
SceneObject chosen(const LabView&);

// One frame: what the mouse does, and rings, handles and previews below the cards; words keep to the area that no card
// covers. Nothing without view.sight.
// Anchor: stage.knob, by which the chosen thing is turned.
void scene_input(const LabView&, SceneInputState&, Ui&, Rect area);

// Keys that mean something here: Esc, Enter and Backspace while drawing, arrows for the chosen lamp or obstacle (with
// Ctrl for vehicles too), the menu's rows while it is open. False when the key is free.
bool press_key(const LabView&, SceneInputState&, Keyboard&, KeyPress, Outbox&);

// Whether the arrow keys belong to the scene's things now, and not to the camera.
bool takes_arrows(const LabView&, bool ctrl);

}  // namespace braitenlab

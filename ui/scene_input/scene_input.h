// Mouse and keyboard input over the 3D view. It reads the snapshot and stores only the user's current gesture: the
// object under the pointer, the drag in progress, the tool, the corners drawn so far. Changes are sent as EditRequests;
// all edits of one drag have the same gesture number.
#pragma once

#include <cstdint>

#include "ui/scene_input/state.h"
#include "ui/shortcuts.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

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

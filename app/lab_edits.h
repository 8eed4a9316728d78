// Edits of the open scene: commands, undo and redo, the clipboard. Manual driving of the selected vehicle.
#pragma once

#include <cstdint>
#include <optional>

#include "app/workspace.h"

namespace braitenlab {

// Applies an edit to the session, or shows why it failed. Returns true on success. Edits with the same `gesture`
// (not 0) are one step of undo.
bool apply(Workspace&, const Command&, std::uint64_t gesture = 0);

// Shows a notice if an edit has removed or restored the recorded time after the current tick. `latest_before`:
// Session::latest() before the edit.
void report_time_change(Workspace&, std::uint64_t latest_before);

void undo(Workspace&);
void redo(Workspace&);

// Applies the edit and selects what it has added. An edit in the wiring diagram pauses, so that the vehicle stays where
// it is while the brain is edited further.
void edit(Workspace&, const EditRequest&);

// Adds copied objects, with their middle at `at`, as one step of undo and selects them.
void paste(Workspace&, const Scene& copy, std::optional<maths::vec2> at);

// Erases, duplicates, cuts, copies or selects objects of the scene; other actions do nothing. The wiring canvas has
// its own while it replaces the scene.
void act_on_objects(Workspace&, Action);

// Switches the selected vehicle between manual driving and the driver of its kind.
void drive(Workspace&);

// Drives the selected vehicle by arrow keys; `right` and `ahead` are −1, 0 or 1. Returns false if the vehicle is not
// driven manually: then the arrow keys move the camera.
bool steer_by_keys(Workspace&, float right, float ahead);

}  // namespace braitenlab

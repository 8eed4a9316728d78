// Edits of the open scene: commands, undo and redo, the clipboard.
#pragma once

#include <cstdint>
#include <optional>

#include "app/lab.h"

namespace braitenlab {

// Applies an edit to the session, or shows why it failed. Returns true on success. Edits with the same `gesture`
// (not 0) are one step of undo.
bool apply(Lab&, const Command&, std::uint64_t gesture = 0);

// Shows a notice if an edit has removed or restored the recorded time after the current tick. `latest_before`:
// Session::latest() before the edit.
void report_time_change(Lab&, std::uint64_t latest_before);

void undo(Lab&);
void redo(Lab&);

// Applies the edit and selects what it has added. An edit in the wiring diagram pauses, so that the vehicle stays where
// it is while the brain is edited further.
void edit(Lab&, const EditRequest&);

// Adds copied objects, with their middle at `at`, as one step of undo and selects them.
void paste(Lab&, const Scene& copy, std::optional<maths::vec2> at);

// Erases, duplicates, cuts, copies or selects objects of the scene; other actions do nothing. The wiring canvas has
// its own while it replaces the scene.
void act_on_objects(Lab&, Action);

}  // namespace braitenlab

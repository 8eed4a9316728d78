// Executes the requests that panels, keys and the mouse make.
#pragma once

#include <cstdint>

#include "app/lab.h"

namespace braitenlab {

void handle(Lab&, const Request&);

// Executes requests in order. Moves of one gesture that follow each other are one command: their cost does not grow
// with the square of their number.
void handle_all(Lab&, const Outbox&);

// Applies an edit to the session, or shows why it failed. Returns true on success. Edits with the same `gesture`
// (not 0) are one step of undo.
bool apply(Lab&, const Command&, std::uint64_t gesture = 0);

// Shows a notice if an edit has removed or restored the recorded time after the current tick. `latest_before`:
// Session::latest() before the edit.
void report_time_change(Lab&, std::uint64_t latest_before);

}  // namespace braitenlab

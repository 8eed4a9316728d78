// What an undo or a redo has changed, in a word for its notice.
#pragma once

#include <string>

#include "core/world/snapshot.h"

namespace braitenlab {

// What an edit has changed from one snapshot of a session to another at the same tick: a string key, or the names of
// the dials of a brain's first pair, "LL, RR", where no other part of the brain differs.
std::string what_changed(const Snapshot& before, const Snapshot& after);

}  // namespace braitenlab

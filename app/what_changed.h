// What an undo or a redo has changed, in a word for its notice.
#pragma once

#include <string>

#include "core/world/snapshot.h"

namespace braitenlab {

// The difference of two snapshots of a session at the same tick: a string key "changed.*", or the names of the dials of
// a brain's first pair, "LL, RR", where no other part of the brain differs.
std::string what_changed(const Snapshot& before, const Snapshot& after);

}  // namespace braitenlab

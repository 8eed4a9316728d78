// Going to another tick of the recorded run, and bookmarks. The world, the undo history and the referee of an exercise
// are then those of that tick.
#pragma once

#include <cstdint>

#include "app/workspace.h"

namespace braitenlab {

void seek(Workspace&, const SeekRequest&);
void seek_by(Workspace&, std::int64_t ticks);

// Bookmarks the current moment. The oldest bookmark is removed when there are more than twenty.
void set_bookmark(Workspace&);
void handle_bookmark(Workspace&, const BookmarkRequest&);
void go_to_last_bookmark(Workspace&);

}  // namespace braitenlab

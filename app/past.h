// Going back in time: restores the world, the undo history and the referee of an exercise at an earlier tick.
#pragma once

#include <cstdint>

#include "app/lab.h"

namespace braitenlab {

void seek(Lab&, const SeekRequest&);
void seek_by(Lab&, std::int64_t ticks);

// Bookmarks the current moment. The oldest bookmark is removed when there are more than twenty.
void set_bookmark(Lab&);
void handle_bookmark(Lab&, const BookmarkRequest&);
void go_to_last_bookmark(Lab&);

}  // namespace braitenlab

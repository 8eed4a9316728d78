// Going to another tick of the recorded run, and bookmarks. The world, the undo history and the referee of an exercise
// are then those of that tick.
#pragma once

#include <cstdint>

#include "app/workspace.h"

namespace braitenlab {

// Where ticks are costly (work_of_a_tick(); 100 vehicles that see each other) the run goes to the keyframe before the
// tick at once, and then repeats the ticks between in parts, by continue_seeking(), so that the window answers
// meanwhile. A dragged playhead stays at the keyframe.
void seek(Workspace&, const SeekRequest&);
void seek_by(Workspace&, std::int64_t ticks);

// Repeats ticks for `budget` (s of wall time), at least one, up to Playback::seeks. False if the run is on no such way.
bool continue_seeking(Workspace&, double budget);

// Bookmarks the current moment. The oldest bookmark is removed when there are more than twenty.
void set_bookmark(Workspace&);
void handle_bookmark(Workspace&, const BookmarkRequest&);
void go_to_last_bookmark(Workspace&);

}  // namespace braitenlab

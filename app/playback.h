// Playback of simulated time: mode, speed, going back in time and bookmarks.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "app/document.h"
#include "core/session/session.h"
#include "core/world/snapshot.h"
#include "ui/lab_view.h"
#include "ui/request.h"

namespace braitenlab {

inline constexpr float least_time_scale = 0.125f, largest_time_scale = 16;  // simulated seconds per second

struct Lab;

// Measured speed of simulated time while playing.
struct Pace {
    double wall = 0, simulated = 0;  // s, in the interval being measured
    std::optional<float> reached;    // simulated seconds per second in the last interval; nullopt: as requested
};

// A moment of the run.
struct TimeMark {
    Bookmark moment;
    std::vector<RunPlace> path{};  // Lesson::path at that moment; empty: no exercise
};

struct Playback {
    Mode mode = Mode::paused;
    float time_scale = 1;               // simulated seconds per second
    std::vector<VehicleView> previous;  // vehicles one tick ago, to interpolate between two ticks
    double debt = 0;                    // simulated seconds that are due and not stepped yet
    Pace pace;
    std::int64_t toggles = 0;  // changes between playing and not playing
    std::vector<TimeMark> bookmarks;
    bool held = false;  // true while the playhead is dragged; the simulation is paused
};

void set_mode(Lab&, Mode);

// Runs one tick in any mode.
void tick(Lab&);

// Advances by wall time: runs the ticks that are due while playing and no sheet is open, for at most 12 ms. Ticks that
// exceed this time are dropped, so that a slow computer runs in slow motion and the debt does not grow. `seen` gets the
// shown snapshot after each tick.
void advance(Lab&, double wall_seconds, const std::function<void(const Snapshot&)>& seen = {});

// Position of the picture between the previous tick (0) and the last one (1); 1 while the simulation is paused.
float between_ticks(const Lab&);

// Going back in time restores the world, the undo history and the referee of an exercise at the earlier tick.
void seek(Lab&, const SeekRequest&);
void seek_by(Lab&, std::int64_t ticks);

// Bookmarks the current moment. The oldest bookmark is removed when there are more than twenty.
void set_bookmark(Lab&);
void handle_bookmark(Lab&, const BookmarkRequest&);
void go_to_last_bookmark(Lab&);

}  // namespace braitenlab

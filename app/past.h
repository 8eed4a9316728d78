// Going back in time with everything that belongs to a moment: the world, what can be undone, and what an exercise's
// judge had seen by then.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "core/lesson/referee.h"
#include "core/session/session.h"
#include "ui/request.h"

namespace braitenlab {

struct Lab;

struct Past {
    struct Judged {
        std::uint64_t tick = 0;
        Referee referee;
    };
    struct Mark {
        Bookmark moment;
        std::optional<Referee> referee;  // of an exercise
    };
    std::deque<Judged> judged;  // of the recorded minute, by ascending tick
    std::vector<Mark> bookmarks;
    bool held = false;  // the playhead is in a hand: time waits
};

// After each tick: what the judge has seen so far.
void remember_judge(Lab&);

void seek(Lab&, const SeekRequest&);
void seek_by(Lab&, std::int64_t ticks);

// Marks the moment shown; the oldest mark goes when there are too many.
void set_bookmark(Lab&);
void handle_bookmark(Lab&, const BookmarkRequest&);
void go_to_last_bookmark(Lab&);

}  // namespace braitenlab

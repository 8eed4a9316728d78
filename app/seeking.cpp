#include "app/seeking.h"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "app/course/lesson_view.h"
#include "app/lab_selection.h"
#include "core/scene/size_limits.h"

namespace braitenlab {

namespace {

constexpr std::size_t most_bookmarks = 20;
constexpr double most_at_once = most_work / 300;  // of a tick, of which 300 follow a keyframe

void arrive(Workspace& space) {
    forget_motion(space);
    forget_vehicle_notice(space);
    keep_selection(space);
    watch(space);
}

bool is_costly(const Workspace& space) { return work_of_a_tick(space.document.session.edited_scene()) > most_at_once; }

void go_to_tick(Workspace& space, std::uint64_t tick) {
    Session& session = space.document.session;
    if (!is_costly(space)) {
        session.seek(tick);
        return arrive(space);
    }
    tick = std::clamp(tick, session.earliest(), session.latest());
    const std::uint64_t now = session.snapshot().tick;
    if (tick < now || session.keyframe_before(tick) > now) session.seek_roughly(tick);
    arrive(space);
    space.playback.seeks = tick;
}

}  // namespace

void seek(Workspace& space, const SeekRequest& request) {
    space.playback.held = request.held;
    // Where the person lets go of the playhead, a change is to take effect: the run does not go on by itself.
    const bool goes_back = request.held && request.tick < space.document.session.latest();
    if (goes_back && space.playback.mode == Mode::playing) set_mode(space, Mode::paused);
    if (request.held && is_costly(space) && !space.document.lesson) {
        space.document.session.seek_roughly(request.tick);
        arrive(space);
    } else {
        go_to_tick(space, request.tick);
    }
}

void seek_by(Workspace& space, std::int64_t ticks) {
    const auto now = static_cast<std::int64_t>(space.document.session.snapshot().tick);
    go_to_tick(space, static_cast<std::uint64_t>(std::max<std::int64_t>(0, now + ticks)));
}

bool continue_seeking(Workspace& space, double budget) {
    if (!space.playback.seeks) return false;
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(budget);
    Session& session = space.document.session;
    // An edit on the way removes the later ticks.
    const std::uint64_t to = std::min(*space.playback.seeks, session.latest());
    while (session.snapshot().tick < to) {
        session.step();
        if (Clock::now() >= end) break;
    }
    arrive(space);
    if (session.snapshot().tick < to) space.playback.seeks = to;
    return true;
}

void set_bookmark(Workspace& space) {
    auto& bookmarks = space.playback.bookmarks;
    const std::uint64_t now = space.document.session.snapshot().tick;
    std::erase_if(bookmarks, [now](const TimeMark& mark) { return mark.moment.tick() == now; });
    if (bookmarks.size() >= most_bookmarks) bookmarks.erase(bookmarks.begin());
    bookmarks.push_back({space.document.session.bookmark(), {}});
    if (space.document.lesson) bookmarks.back().path = space.document.lesson->path;
}

void handle_bookmark(Workspace& space, const BookmarkRequest& request) {
    auto& bookmarks = space.playback.bookmarks;
    if (request.index < 0 || static_cast<std::size_t>(request.index) >= bookmarks.size()) return;
    const auto mark = bookmarks.begin() + request.index;
    if (request.remove) {
        say(space, {NoticeKind::done, "notice.mark_removed",
                    fmt::format("{:.1f}", static_cast<float>(mark->moment.tick()) / 60), "", true});
        bookmarks.erase(mark);
        return;
    }
    space.document.session.go_to(mark->moment);
    if (space.document.lesson) space.document.lesson->path = mark->path;
    arrive(space);
}

void go_to_last_bookmark(Workspace& space) {
    handle_bookmark(space, {static_cast<int>(space.playback.bookmarks.size()) - 1, false});
}

}  // namespace braitenlab

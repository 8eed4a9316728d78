#include "app/past.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/lab_lesson.h"
#include "app/lab_selection.h"

namespace braitenlab {

namespace {

constexpr std::uint64_t between_copies = 6;  // ticks between two copies of the referee
constexpr std::size_t most_bookmarks = 20;
constexpr std::size_t most_for_exact_drag = 300;  // vehicles; above, a dragged playhead moves between keyframes

// The latest copy of the referee at or before the tick; a new referee if there is none.
RefereeAtTick referee_before(const Lab& lab, std::uint64_t tick) {
    const auto& referees = lab.playback.referees;
    const auto after = std::find_if(referees.begin(), referees.end(), [tick](const auto& r) { return r.tick > tick; });
    if (after != referees.begin()) return *(after - 1);
    return {lab.document.session.earliest() == 0 ? 0 : tick, Referee(*lab.document.lesson->exercise)};
}

// Clears `previous`: interpolating from it would show a jump.
void arrive(Lab& lab) {
    lab.playback.previous.clear();
    lab.playback.debt = 0;
    keep_selection(lab);
    watch(lab);
}

void go_to_tick(Lab& lab, std::uint64_t tick) {
    tick = std::clamp(tick, lab.document.session.earliest(), lab.document.session.latest());
    if (lab.document.lesson) {
        RefereeAtTick found = referee_before(lab, tick);
        lab.document.session.seek(found.tick);
        lab.document.lesson->referee = std::move(found.referee);
        while (lab.document.session.snapshot().tick < tick) {
            lab.document.session.step();
            lab.document.lesson->referee.watch(lab.document.session.snapshot());
        }
    } else {
        lab.document.session.seek(tick);
    }
    arrive(lab);
}

}  // namespace

void record_referee(Lab& lab) {
    const std::uint64_t now = lab.document.session.snapshot().tick;
    if (!lab.document.lesson || lab.document.session.latest() > now) return;  // recorded already
    auto& referees = lab.playback.referees;
    while (!referees.empty() && referees.back().tick >= now) referees.pop_back();
    if (now % between_copies == 0) referees.push_back({now, lab.document.lesson->referee});
    while (!referees.empty() && referees.front().tick < lab.document.session.earliest()) referees.pop_front();
}

void seek(Lab& lab, const SeekRequest& request) {
    lab.playback.held = request.held;
    const bool roughly =
        request.held && lab.document.session.snapshot().vehicles.size() > most_for_exact_drag && !lab.document.lesson;
    if (roughly) {
        lab.document.session.seek_roughly(request.tick);
        arrive(lab);
    } else {
        go_to_tick(lab, request.tick);
    }
}

void seek_by(Lab& lab, std::int64_t ticks) {
    const auto now = static_cast<std::int64_t>(lab.document.session.snapshot().tick);
    go_to_tick(lab, static_cast<std::uint64_t>(std::max<std::int64_t>(0, now + ticks)));
}

void set_bookmark(Lab& lab) {
    auto& bookmarks = lab.playback.bookmarks;
    const std::uint64_t now = lab.document.session.snapshot().tick;
    std::erase_if(bookmarks, [now](const TimeMark& mark) { return mark.moment.tick() == now; });
    if (bookmarks.size() >= most_bookmarks) bookmarks.erase(bookmarks.begin());
    bookmarks.push_back({lab.document.session.bookmark(), {}});
    if (lab.document.lesson) bookmarks.back().referee = lab.document.lesson->referee;
}

void handle_bookmark(Lab& lab, const BookmarkRequest& request) {
    auto& bookmarks = lab.playback.bookmarks;
    if (request.index < 0 || static_cast<std::size_t>(request.index) >= bookmarks.size()) return;
    const auto mark = bookmarks.begin() + request.index;
    if (request.remove) {
        say(lab, {NoticeKind::done, "notice.mark_removed",
                  fmt::format("{:.1f}", static_cast<double>(mark->moment.tick()) / 60)});
        bookmarks.erase(mark);
        return;
    }
    lab.document.session.go_to(mark->moment);
    if (lab.document.lesson && mark->referee) {
        lab.document.lesson->referee = *mark->referee;
        std::erase_if(lab.playback.referees, [&](const auto& r) { return r.tick > lab.document.session.latest(); });
    }
    arrive(lab);
}

void go_to_last_bookmark(Lab& lab) {
    handle_bookmark(lab, {static_cast<int>(lab.playback.bookmarks.size()) - 1, false});
}

}  // namespace braitenlab

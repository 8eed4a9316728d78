#include "app/past.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/lab_parts.h"

namespace braitenlab {

namespace {

constexpr std::uint64_t between_copies = 6;  // ticks between what is kept of the judge
constexpr std::size_t most_bookmarks = 20;
constexpr std::size_t most_for_exact_drag =
    300;  // vehicles; with more, a dragged playhead goes from keyframe to keyframe

// The latest copy of the judge that is not after the moment; a new one where none is that old.
Past::Judged judge_before(const Lab& lab, std::uint64_t tick) {
    const auto& judged = lab.past.judged;
    const auto after = std::find_if(judged.begin(), judged.end(), [tick](const auto& j) { return j.tick > tick; });
    if (after != judged.begin()) return *(after - 1);
    return {lab.session.earliest() == 0 ? 0 : tick, Referee(*lab.lesson->exercise)};
}

// A picture between the tick before and this one would show a jump.
void arrive(Lab& lab) {
    lab.before.clear();
    lab.debt = 0;
    keep_selection(lab);
    watch(lab);
}

void stand_at(Lab& lab, std::uint64_t tick) {
    tick = std::clamp(tick, lab.session.earliest(), lab.session.latest());
    if (lab.lesson) {
        Past::Judged judge = judge_before(lab, tick);
        lab.session.seek(judge.tick);
        lab.lesson->referee = std::move(judge.referee);
        while (lab.session.snapshot().tick < tick) {
            lab.session.step();
            lab.lesson->referee.watch(lab.session.snapshot());
        }
    } else {
        lab.session.seek(tick);
    }
    arrive(lab);
}

}  // namespace

void remember_judge(Lab& lab) {
    const std::uint64_t now = lab.session.snapshot().tick;
    if (!lab.lesson || lab.session.latest() > now) return;  // in the recorded past, it is known already
    auto& judged = lab.past.judged;
    while (!judged.empty() && judged.back().tick >= now) judged.pop_back();
    if (now % between_copies == 0) judged.push_back({now, lab.lesson->referee});
    while (!judged.empty() && judged.front().tick < lab.session.earliest()) judged.pop_front();
}

void seek(Lab& lab, const SeekRequest& request) {
    lab.past.held = request.held;
    const bool roughly = request.held && lab.session.snapshot().vehicles.size() > most_for_exact_drag && !lab.lesson;
    if (roughly) {
        lab.session.seek_roughly(request.tick);
        arrive(lab);
    } else {
        stand_at(lab, request.tick);
    }
}

void seek_by(Lab& lab, std::int64_t ticks) {
    const auto now = static_cast<std::int64_t>(lab.session.snapshot().tick);
    stand_at(lab, static_cast<std::uint64_t>(std::max<std::int64_t>(0, now + ticks)));
}

void set_bookmark(Lab& lab) {
    auto& bookmarks = lab.past.bookmarks;
    const std::uint64_t now = lab.session.snapshot().tick;
    std::erase_if(bookmarks, [now](const Past::Mark& mark) { return mark.moment.tick() == now; });
    if (bookmarks.size() >= most_bookmarks) bookmarks.erase(bookmarks.begin());
    bookmarks.push_back({lab.session.bookmark(), {}});
    if (lab.lesson) bookmarks.back().referee = lab.lesson->referee;
}

void handle_bookmark(Lab& lab, const BookmarkRequest& request) {
    auto& bookmarks = lab.past.bookmarks;
    if (request.index < 0 || static_cast<std::size_t>(request.index) >= bookmarks.size()) return;
    const auto mark = bookmarks.begin() + request.index;
    if (request.remove) {
        say(lab, {NoticeKind::done, "notice.mark_removed",
                  fmt::format("{:.1f}", static_cast<double>(mark->moment.tick()) / 60)});
        bookmarks.erase(mark);
        return;
    }
    lab.session.go_to(mark->moment);
    if (lab.lesson && mark->referee) {
        lab.lesson->referee = *mark->referee;
        std::erase_if(lab.past.judged, [&](const auto& j) { return j.tick > lab.session.latest(); });
    }
    arrive(lab);
}

void go_to_last_bookmark(Lab& lab) { handle_bookmark(lab, {static_cast<int>(lab.past.bookmarks.size()) - 1, false}); }

}  // namespace braitenlab

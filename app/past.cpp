#include "app/past.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/lab_lesson.h"
#include "app/lab_selection.h"

namespace braitenlab {

namespace {

constexpr std::size_t most_bookmarks = 20;
constexpr std::size_t most_for_exact_drag = 300;  // vehicles; above, a dragged playhead moves between keyframes

// Clears `previous`, because an interpolation from it would show a jump.
void arrive(Lab& lab) {
    lab.playback.previous.clear();
    lab.playback.debt = 0;
    forget_death_notice(lab);
    keep_selection(lab);
    watch(lab);
}

void go_to_tick(Lab& lab, std::uint64_t tick) {
    lab.document.session.seek(tick);
    recompute_referee(lab.document);
    arrive(lab);
}

}  // namespace

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
    if (const RefereeState* state = referee_at_keyframe(lab.document)) bookmarks.back().referee = *state;
}

void handle_bookmark(Lab& lab, const BookmarkRequest& request) {
    auto& bookmarks = lab.playback.bookmarks;
    if (request.index < 0 || static_cast<std::size_t>(request.index) >= bookmarks.size()) return;
    const auto mark = bookmarks.begin() + request.index;
    if (request.remove) {
        say(lab, {NoticeKind::done, "notice.mark_removed",
                  fmt::format("{:.1f}", static_cast<double>(mark->moment.tick()) / 60), "", true});
        bookmarks.erase(mark);
        return;
    }
    lab.document.session.go_to(mark->moment);
    restore_referee(lab.document, mark->referee);
    arrive(lab);
}

void go_to_last_bookmark(Lab& lab) {
    handle_bookmark(lab, {static_cast<int>(lab.playback.bookmarks.size()) - 1, false});
}

}  // namespace braitenlab

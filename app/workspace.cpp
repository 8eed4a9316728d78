#include "app/workspace.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "app/platform/platform.h"
#include "core/maths/angle.h"

namespace braitenlab {

const Snapshot& shown_snapshot(const Workspace& space) {
    return space.together ? space.together->shown : space.document.session.snapshot();
}

Preferences own_preferences(const Workspace& space) {
    Preferences p = space.preferences;
    if (space.before_lecture) p.theme = space.before_lecture->theme, p.type_size = space.before_lecture->type_size;
    return p;
}

std::uint64_t new_gesture(Workspace& space) { return gestures::lab + ++space.gesture; }

void say(Workspace& space, Notice notice, double least_seconds) {
    constexpr double letters_a_second = 15;  // reading speed, with time to notice the message
    const double least = notice.kind == NoticeKind::failure  ? 10
                         : space.before_lecture              ? 5  // it takes the place of the title
                         : notice.kind == NoticeKind::notice ? 6
                                                             : 5;
    const double seconds =
        std::max({least_seconds, least, static_cast<double>(notice.words.size()) / letters_a_second});
    std::string& words = notice.words;
    const bool begins_with_file = notice.error && !notice.error->file.empty();
    if (notice.key.empty() && !begins_with_file && !words.empty() && words[0] >= 'a' && words[0] <= 'z')
        words[0] = static_cast<char>(words[0] - 'a' + 'A');
    space.notice = std::move(notice);
    space.notice_until = space.wall_seconds + seconds;
}

Error for_user(Error error) {
    if (saves_by_download()) error.file = std::filesystem::path(error.file).filename().string();
    return error;
}

void say(Workspace& space, const Error& error) {
    const Error told = for_user(error);
    Notice notice{NoticeKind::failure, "", told.text()};
    notice.error = told;
    say(space, std::move(notice));
}

void say_downloaded(Workspace& space, std::string_view key, const std::filesystem::path& path) {
    const std::string_view said = may_refuse_downloads() ? std::string_view("notice.framed_download") : key;
    say(space, {NoticeKind::notice, std::string(said), path.filename().string()});
}

void set_mode(Workspace& space, Mode mode) {
    Playback& playback = space.playback;
    const bool was_playing = playback.mode == Mode::playing, plays = mode == Mode::playing;
    if (was_playing != plays) ++playback.toggles;
    if (plays) playback.debt = 0;
    if (plays && space.notice.key == "notice.page_pauses") space.notice = {};
    playback.pace = {};
    playback.mode = mode;
}

void forget_motion(Workspace& space) {
    space.playback.previous.clear();
    space.playback.debt = 0;
    space.playback.seeks.reset();
}

float between_ticks(const Workspace& space) {
    if (space.playback.mode != Mode::playing || space.playback.held) return 1;
    return std::clamp(static_cast<float>(space.playback.debt / tick_length), 0.0f, 1.0f);
}

void begin_together(Workspace& space, Together together) {
    space.together = std::move(together);
    show(*space.together);
    forget_motion(space);
    set_mode(space, Mode::playing);
}

void end_together(Workspace& space) {
    if (!space.together) return;
    space.together.reset();
    forget_motion(space);
    set_mode(space, Mode::paused);
}

namespace {

Pose between(Pose a, Pose b, float t) {
    return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t,
            maths::wrap_angle(a.heading + maths::wrap_angle(b.heading - a.heading) * t)};
}

}  // namespace

std::optional<GhostView> ghost_at(const Workspace& space, const ReferencePath& path, const Body& body) {
    const auto tick = static_cast<std::size_t>(space.document.session.snapshot().tick);
    if (tick >= path.size()) return std::nullopt;
    const Pose now = path[tick];
    // As the vehicles are drawn; a vehicle that crosses the seam of a torus is not drawn between two ticks.
    const Pose before = tick > 0 && !space.playback.previous.empty() ? path[tick - 1] : now;
    const bool jumps = std::hypot(now.x - before.x, now.y - before.y) > 1;
    return GhostView{jumps ? now : between(before, now, between_ticks(space)), body.length, body.width, &path,
                     tick + 1};
}

}  // namespace braitenlab

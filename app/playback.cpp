#include "app/playback.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "app/course/lesson_view.h"
#include "app/lab_selection.h"
#include "app/platform/platform.h"
#include "app/seeking.h"

namespace braitenlab {

namespace {

constexpr double stepping_budget = 0.012;  // s of wall time per frame

// Measures once per second. A shortfall of less than 5 % is not reported, because it is not visible.
void measure_pace(Playback& playback, double wall_seconds, double simulated) {
    constexpr double interval = 1, tolerated = 0.95;
    Pace& pace = playback.pace;
    pace.wall += wall_seconds, pace.simulated += simulated;
    if (pace.wall < interval) return;
    const double reached = pace.simulated / pace.wall;
    pace.reached.reset();
    if (reached < tolerated * static_cast<double>(playback.time_scale)) pace.reached = static_cast<float>(reached);
    pace.wall = pace.simulated = 0;
}

constexpr double slow_tick = 0.1, tolerated_slow = 0.5;  // s of processor time: of a tick, of such ticks in a row
constexpr const char* slow_notice = "notice.slow_ticks";

// True if the run pauses because its ticks take so long. `began`: real seconds from the beginning of the frame to that
// of the last tick; `processor_began`: thread_time() at the beginning of the frame, which is asked by a call of the
// system and therefore not for each tick. The thread has used at most `began` before the tick. The notice stays while
// ticks are slow; until then a person who goes on is not stopped again.
bool pauses_slow_run(Lab& lab, double began, double ended, double processor_began) {
    const double seconds = ended - began > slow_tick ? thread_time() - processor_began - began : 0;
    const bool is_told = lab.notice.key == slow_notice;
    double& slow = lab.playback.pace.slow;
    slow = seconds > slow_tick ? slow + seconds : 0;
    if (slow == 0 && is_told) lab.notice = {};
    if (slow < tolerated_slow || is_told) return false;
    constexpr double stays = 3600;  // s
    set_mode(lab, Mode::paused);
    say(lab, {NoticeKind::notice, slow_notice, fmt::format("{:.1f}", seconds), "", true}, stays);
    return true;
}

// The next hint is available after a while, also without a run.
void follow_hint(Lesson& lesson, double wall_seconds) {
    const double left = seconds_between_hints - (wall_seconds - lesson.last_hint_at);
    if (left <= 0) lesson.attempt.answers.hint_ready = true;
}

// Adds the place of the first vehicle before a step to a new tick. A step in the recorded past adds nothing.
void add_to_path(Document& document) {
    const Snapshot& now = document.session.snapshot();
    if (!document.lesson || now.tick % path_ticks != 0 || document.session.latest() != now.tick) return;
    auto& path = document.lesson->path;
    while (!path.empty() && path.back().tick >= now.tick) path.pop_back();
    for (const VehicleView& vehicle : now.vehicles)
        if (vehicle.start == 0) path.push_back({now.tick, {vehicle.x, vehicle.y}});
}

// True at the moment at which the page of a lecture pauses its run.
bool page_pauses_here(const Lab& lab) {
    if (!lab.pages || lab.pages->current().pause <= 0) return false;
    const auto at = std::lround(static_cast<double>(lab.pages->current().pause) / tick_length);
    return shown_snapshot(lab).tick == static_cast<std::uint64_t>(at);
}

// True unless the page has gone on beyond the step that starts the run: the notice would be beside the answer.
bool is_pause_news(const LectureView& page) {
    if (page.step == 0) return true;
    const PageParts& last = page.current().reveal[static_cast<std::size_t>(page.step) - 1];
    return last[static_cast<std::size_t>(PagePart::play)];
}

// Pauses the run where its page or, in a lecture, the end of a comparison of two brains does, so that both vehicles
// stay in the picture. Says so where a person may wait for more. True if it pauses.
bool pauses_here(Lab& lab) {
    const bool of_page = page_pauses_here(lab), of_slots = lab.before_lecture && ends_comparison(lab.slots, lab);
    if (!of_page && !of_slots) return false;
    set_mode(lab, Mode::paused);
    const bool covers_failure = lab.notice.kind == NoticeKind::failure && !lab.notice.empty();
    if (!covers_failure && (of_slots || is_pause_news(*lab.pages)))
        say(lab, {NoticeKind::notice, of_slots ? "notice.comparison_pauses" : "notice.page_pauses"});
    return true;
}

}  // namespace

void tick(Lab& lab) {
    if (lab.together) {
        lab.playback.previous = lab.together->shown.vehicles;
        return step(*lab.together);
    }
    Session& session = lab.document.session;
    lab.playback.previous = session.snapshot().vehicles;
    const VehicleView* selected = selected_vehicle(lab);
    const std::optional<VehicleView> before = selected ? std::optional(*selected) : std::nullopt;
    add_to_path(lab.document);
    record_paths(lab.last_run, lab);
    session.step();
    if (before) reselect_after_death(lab, *before), tell_fall(lab, before->id);
    keep_selection(lab);
    if (auto& lesson = lab.document.lesson) {
        lesson->attempt.work.has_run = true;
        const bool begins = session.snapshot().tick == 1;
        lesson->attempt.work.runs += begins;
        if (begins) lesson->attempt.answers.hint_ready = true;  // each run makes one hint available
    }
    record_moment(lab.explanation, lab);
    watch(lab);
}

void advance(Lab& lab, double wall_seconds, const std::function<void(const Snapshot&)>& seen) {
    lab.wall_seconds += wall_seconds;
    if (lab.pages) lab.pages->seconds = lab.wall_seconds - lab.lectures.began;
    if (lab.wall_seconds >= lab.notice_until) lab.notice = {};
    if (lab.document.lesson) follow_hint(*lab.document.lesson, lab.wall_seconds);
    Playback& playback = lab.playback;
    if (continue_seeking(lab, stepping_budget)) return;
    if (playback.mode != Mode::playing || playback.held || lab.sheet_open) return;

    using Clock = std::chrono::steady_clock;
    const auto began = Clock::now();
    const auto spent = [&] { return std::chrono::duration<double>(Clock::now() - began).count(); };
    playback.debt += wall_seconds * static_cast<double>(playback.time_scale);
    const double before = shown_snapshot(lab).seconds, processor_began = thread_time();
    while (playback.debt >= tick_length) {
        const double tick_began = spent();
        if (tick_began >= stepping_budget) break;
        tick(lab);
        if (seen) seen(shown_snapshot(lab));
        playback.debt -= tick_length;
        if (pauses_slow_run(lab, tick_began, spent(), processor_began) || pauses_here(lab)) return;
    }
    // A long frame counts as a shorter one, so that the run does not jump; its ticks take their time all the same.
    measure_pace(playback, std::max(wall_seconds, spent()), shown_snapshot(lab).seconds - before);
    if (playback.debt >= tick_length) playback.debt = 0;
}

}  // namespace braitenlab

#include "app/features/predictions.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "app/course/lesson_view.h"
#include "app/lab_selection.h"
#include "app/workspace.h"

namespace braitenlab {

namespace {

using insight::Path;
using insight::Question;

constexpr std::uint64_t fan_size = 8;
constexpr std::uint64_t asked_again = 6;     // ticks, while time passes during a drag
constexpr std::size_t most_for_a_fan = 200;  // vehicles
constexpr double fan_wait = 0.05;            // s; a newer edit waits so long for the fan of the path before

PredictionSubject subject_of(const Workspace& space) {
    return {space.document.run_id, space.document.edits, space.document.session.snapshot().tick,
            space.view.selection.vehicle};
}

Question question_of(const Workspace& space) {
    return {.from = space.document.session.bookmark().checkpoint,
            .vehicle = space.view.selection.vehicle,
            .ticks = static_cast<std::size_t>(space.view.overlays.prediction) * 60};
}

// Ticks of one step of a job: a millisecond or less.
std::size_t steps_at_once(const Workspace& space) {
    constexpr std::size_t vehicles_times_steps = 1200;  // of about 0.8 µs
    const std::size_t vehicles = std::max<std::size_t>(1, space.document.session.snapshot().vehicles.size());
    return std::clamp<std::size_t>(vehicles_times_steps / vehicles, 1, 60);
}

// The path of a question as a part of a job. The run is copied in its first step, not on the window's thread.
class PathPiece {
public:
    PathPiece(Question question, std::size_t steps) : question_(std::move(question)), steps_(steps) {}
    std::optional<Path> operator()() {
        if (!prediction_) prediction_.emplace(question_);
        if (!prediction_->advance(steps_)) return std::nullopt;
        return prediction_->path();
    }
    float progress() const { return prediction_ ? prediction_->progress() : 0; }

private:
    Question question_;
    std::size_t steps_;
    std::optional<insight::Prediction> prediction_{};
};

// Takes the fan of the shown path, which comes after the path. The fan of the edit before stays until then, at most a
// moment, so that a drag does not flicker.
void take_fan(Predictions& p, double now) {
    if (p.path.is_computing()) return;
    p.fan.take();
    const bool is_awaited = p.fan.is_computing() && now - p.asked_at <= fan_wait;
    if (p.fan.answer() && !is_awaited && !(p.path.answered() && *p.fan.answered() == *p.path.answered()))
        p.fan.forget_answer();
}

void forget_paths(Predictions& p) {
    p.path.forget(), p.before.forget(), p.fan.forget();
    p.is_what_if = false;
}

// True while the vehicle is on the path: nothing but time has changed, and the path is not driven to its end.
bool still_holds(const PredictionSubject& of, const Path& path, const PredictionSubject& now,
                 const VehicleView& vehicle) {
    const bool is_of_now = of.run == now.run && of.edits == now.edits && of.vehicle == now.vehicle &&
                           of.tick <= now.tick && now.tick < of.tick + path.size();
    return is_of_now &&
           path[static_cast<std::size_t>(now.tick - of.tick)] == Pose{vehicle.x, vehicle.y, vehicle.heading};
}

void ask(Predictions& p, const Workspace& space, Jobs& jobs, const PredictionSubject& subject) {
    Question question = question_of(space);
    question.changes = subject.changes;
    const std::size_t steps = steps_at_once(space);
    p.path.ask(subject);
    p.path.begin([&](const PredictionSubject&) { return jobs.submit_first(PathPiece(question, steps)); });
    p.asked_at = space.wall_seconds;
    const Snapshot& now = space.document.session.snapshot();
    if (now.vehicles.size() > most_for_a_fan || !insight::depends_on_chance(now)) return p.fan.forget();
    p.fan.ask(subject);
    p.fan.begin([&](const PredictionSubject&) {
        return jobs.submit(fan_size, [shared = std::make_shared<const Question>(question), steps](std::size_t part) {
            return PathPiece(insight::with_other_chance(*shared, part + 1), steps);
        });
    });
}

// True while the path of a newer edit is not asked for: until the path of the last one is known, and for a moment until
// its fan is.
bool must_wait(const Predictions& p, double now) {
    return p.path.is_computing() || (p.fan.is_computing() && now - p.asked_at <= fan_wait);
}

void ask_before(Predictions& p, const Workspace& space, Jobs& jobs, const Question& question,
                const PredictionSubject& subject) {
    if (p.before.is_about(subject)) return;
    p.before.ask(subject);
    p.before.begin([&](const PredictionSubject&) { return jobs.submit(PathPiece(question, steps_at_once(space))); });
}

// True if nothing but a moment of time has passed since the path was asked for.
bool is_moved_on(const PredictionSubject& asked, const PredictionSubject& now) {
    return asked.run == now.run && asked.edits == now.edits && asked.vehicle == now.vehicle && asked.tick <= now.tick &&
           now.tick < asked.tick + asked_again;
}

// While the pointer is over a preset or a wire.
void follow_what_if(Predictions& p, const Workspace& space, Jobs& jobs, PredictionSubject now) {
    const PredictionSubject* asked = p.path.question();
    const bool is_same = p.is_what_if && asked && asked->changes == p.what_if;
    if (is_same && is_moved_on(*asked, now)) return;
    if (!is_same) forget_paths(p);
    p.is_what_if = true;
    if (must_wait(p, space.wall_seconds) || p.before.is_computing()) return;  // of an earlier tick
    ask_before(p, space, jobs, question_of(space), now);
    now.changes = p.what_if;
    if (!p.path.is_about(now)) ask(p, space, jobs, now);
}

// While something is dragged that has changed the run.
void follow_drag(Predictions& p, const Workspace& space, Jobs& jobs, const PredictionSubject& now) {
    if (p.is_what_if || (p.before.question() && !p.before.is_about(p.subject_at_press))) forget_paths(p);
    ask_before(p, space, jobs, *p.at_press, p.subject_at_press);
    if (must_wait(p, space.wall_seconds) || p.path.is_about(now)) return;
    if (p.path.question() && is_moved_on(*p.path.question(), now)) return;
    ask(p, space, jobs, now);
}

}  // namespace

bool is_computing(const Predictions& p) {
    return p.path.is_computing() || p.before.is_computing() || p.fan.is_computing();
}

void note_press(Predictions& p, const Workspace& space, bool down, std::uint64_t keys) {
    if ((down && !p.button) || (keys != 0 && keys != p.keys)) {
        p.at_press = question_of(space);
        p.subject_at_press = subject_of(space);
    }
    p.button = down;
    p.keys = keys;
    p.pressed = down || keys != 0;
}

void update_predictions(Predictions& p, const Workspace& space, Jobs& jobs) {
    const PredictionSubject now = subject_of(space);
    const VehicleView* vehicle = selected_vehicle(space);
    const bool is_on = space.view.overlays.prediction > 0 && disclosure_of(space).future && !space.together &&
                       vehicle && !space.sheet_open;
    if (!is_on) {
        p.at_press.reset();
        return forget_paths(p);
    }
    p.path.take(), p.before.take();
    take_fan(p, space.wall_seconds);
    const bool drags = p.pressed && p.at_press && p.subject_at_press.run == now.run &&
                       p.subject_at_press.vehicle == now.vehicle && p.subject_at_press.edits != now.edits;
    if (drags) return follow_drag(p, space, jobs, now);
    if (!p.pressed && !p.what_if.empty()) return follow_what_if(p, space, jobs, now);
    if (p.is_what_if) return forget_paths(p);
    if (p.pressed) return;
    // After a drag: the path of the last edit stays until it is driven.
    if (p.path.is_computing() || !p.path.answered()) return;
    const PredictionSubject &asked = *p.path.question(), &known = *p.path.answered();
    if (asked.edits != now.edits && p.subject_at_press.edits != now.edits && known.run == now.run &&
        known.vehicle == now.vehicle)
        return ask(p, space, jobs, now);
    if (!still_holds(known, *p.path.answer(), now, *vehicle)) forget_paths(p);
}

std::optional<PredictionView> prediction_of(const Predictions& p, const Workspace& space) {
    const std::uint64_t tick = space.document.session.snapshot().tick;
    static const std::vector<Path> no_fan;
    const auto begun = [&](const Asked<PredictionSubject, Path>& asked) {
        return asked.answer() && !asked.answer()->empty() && asked.answered()->tick <= tick &&
               asked.answered()->run == space.document.run_id;
    };
    if (!begun(p.path)) return std::nullopt;
    PredictionView view{
        .path = p.path.answer(), .fan = p.fan.answer() ? p.fan.answer() : &no_fan, .tick = p.path.answered()->tick};
    if (begun(p.before)) view.before = p.before.answer(), view.before_tick = p.before.answered()->tick;
    constexpr double long_wait = 0.15;  // s
    view.is_outdated = p.path.is_computing() && space.wall_seconds - p.asked_at > long_wait;
    return view;
}

}  // namespace braitenlab

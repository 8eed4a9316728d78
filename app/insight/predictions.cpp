#include "app/insight/predictions.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "app/course/lesson_view.h"
#include "app/lab.h"
#include "app/lab_selection.h"

namespace braitenlab {

namespace {

using insight::Path;
using insight::Question;

constexpr std::uint64_t fan_size = 8;
constexpr std::uint64_t asked_again = 6;     // ticks, while time passes during a drag
constexpr std::size_t most_for_a_fan = 200;  // vehicles
constexpr double fan_wait = 0.05;            // s; a newer edit waits so long for the fan of the path before

PredictionSubject subject_of(const Lab& lab) {
    return {lab.document.run_id, lab.document.edits, lab.document.session.snapshot().tick, lab.view.selection.vehicle};
}

Question question_of(const Lab& lab) {
    return {.from = lab.document.session.bookmark().checkpoint,
            .vehicle = lab.view.selection.vehicle,
            .ticks = static_cast<std::size_t>(lab.view.overlays.prediction) * 60};
}

// Ticks of one step of a job: a millisecond or less.
std::size_t steps_at_once(const Lab& lab) {
    constexpr std::size_t vehicles_times_steps = 1200;  // of about 0.8 µs
    const std::size_t vehicles = std::max<std::size_t>(1, lab.document.session.snapshot().vehicles.size());
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

// Takes the result of a job, if it is there.
void take_path(std::optional<Job<Path>>& job, const std::optional<PredictionSubject>& asked,
               std::optional<PredictedPaths>& into) {
    if (!job || !asked) return;
    auto done = job->take();
    if (!done) return;
    job.reset();
    if (!*done || (*done)->empty()) return into.reset();
    if (!into) into.emplace();
    into->of = *asked;
    into->path = std::move(**done);
}

// Takes the fan of the shown path, which comes after the path. The fan of the edit before stays until then, at most a
// moment, so that a drag does not flicker.
void take_fan(Predictions& p, double now) {
    if (p.job) return;
    if (!p.shown) return p.job_fan.reset();
    if (auto done = p.job_fan ? p.job_fan->take() : std::nullopt) {
        p.job_fan.reset();
        p.shown->fan = *done ? std::move(**done) : std::vector<Path>{};
        p.shown->fan_of = p.shown->of;
    }
    const bool is_awaited = p.job_fan && now - p.asked_at <= fan_wait;
    if (p.shown->fan_of != p.shown->of && !is_awaited) p.shown->fan.clear();
}

void forget_paths(Predictions& predictions) {
    predictions.shown.reset(), predictions.before.reset();
    predictions.asked.reset(), predictions.asked_before.reset();
    predictions.job.reset(), predictions.job_before.reset(), predictions.job_fan.reset();
    predictions.is_what_if = false;
}

// True while the vehicle is on the path: nothing but time has changed, and the path is not driven to its end.
bool still_holds(const PredictedPaths& paths, const PredictionSubject& now, const VehicleView& vehicle) {
    const PredictionSubject& of = paths.of;
    const bool is_of_now = of.run == now.run && of.edits == now.edits && of.vehicle == now.vehicle &&
                           of.tick <= now.tick && now.tick < of.tick + paths.path.size();
    return is_of_now &&
           paths.path[static_cast<std::size_t>(now.tick - of.tick)] == Pose{vehicle.x, vehicle.y, vehicle.heading};
}

void ask(Lab& lab, Jobs& jobs, const PredictionSubject& subject) {
    Predictions& p = lab.predictions;
    Question question = question_of(lab);
    question.changes = subject.changes;
    const std::size_t steps = steps_at_once(lab);
    p.job = jobs.submit_first(PathPiece(question, steps));
    p.job_fan.reset();
    const Snapshot& now = lab.document.session.snapshot();
    if (now.vehicles.size() <= most_for_a_fan && insight::depends_on_chance(now))
        p.job_fan = jobs.submit(
            fan_size, [shared = std::make_shared<const Question>(std::move(question)), steps](std::size_t part) {
                return PathPiece(insight::with_other_chance(*shared, part + 1), steps);
            });
    p.asked = subject;
    p.asked_at = lab.wall_seconds;
}

// True while the path of a newer edit is not asked for: until the path of the last one is known, and for a moment until
// its fan is.
bool must_wait(const Predictions& p, double now) { return p.job || (p.job_fan && now - p.asked_at <= fan_wait); }

void ask_before(Lab& lab, Jobs& jobs, const Question& question, const PredictionSubject& subject) {
    Predictions& p = lab.predictions;
    if (p.asked_before == subject) return;
    p.job_before = jobs.submit(PathPiece(question, steps_at_once(lab)));
    p.asked_before = subject;
}

// While the pointer is over a preset or a wire.
void follow_what_if(Lab& lab, Jobs& jobs, PredictionSubject now) {
    Predictions& p = lab.predictions;
    const bool is_moving = p.is_what_if && p.asked && p.asked->changes == p.what_if && p.asked->run == now.run &&
                           p.asked->edits == now.edits && p.asked->tick <= now.tick &&
                           now.tick < p.asked->tick + asked_again;
    if (is_moving) return;
    if (!p.is_what_if || !p.asked || p.asked->changes != p.what_if) forget_paths(p);
    p.is_what_if = true;
    if (must_wait(p, lab.wall_seconds) || p.job_before) return;  // of an earlier tick
    ask_before(lab, jobs, question_of(lab), now);
    now.changes = p.what_if;
    if (p.asked != now) ask(lab, jobs, now);
}

// While something is dragged that has changed the run.
void follow_drag(Lab& lab, Jobs& jobs, const PredictionSubject& now) {
    Predictions& p = lab.predictions;
    if (p.is_what_if || (p.asked_before && *p.asked_before != p.subject_at_press)) forget_paths(p);
    if (!p.asked_before) ask_before(lab, jobs, *p.at_press, p.subject_at_press);
    if (must_wait(p, lab.wall_seconds) || p.asked == now) return;
    const bool same_edits = p.asked && p.asked->edits == now.edits && p.asked->vehicle == now.vehicle;
    if (same_edits && now.tick >= p.asked->tick && now.tick < p.asked->tick + asked_again) return;
    ask(lab, jobs, now);
}

}  // namespace

bool is_computing(const Predictions& p) { return p.job || p.job_before || p.job_fan; }

void note_press(Lab& lab, bool down, std::uint64_t keys) {
    Predictions& p = lab.predictions;
    if ((down && !p.button) || (keys != 0 && keys != p.keys)) {
        p.at_press = question_of(lab);
        p.subject_at_press = subject_of(lab);
    }
    p.button = down;
    p.keys = keys;
    p.pressed = down || keys != 0;
}

void update_predictions(Lab& lab, Jobs& jobs) {
    Predictions& p = lab.predictions;
    const PredictionSubject now = subject_of(lab);
    const VehicleView* vehicle = selected_vehicle(lab);
    const bool is_on =
        lab.view.overlays.prediction > 0 && disclosure_of(lab).future && !lab.together && vehicle && !lab.sheet_open;
    if (!is_on) {
        p.at_press.reset();
        return forget_paths(p);
    }
    take_path(p.job, p.asked, p.shown);
    take_path(p.job_before, p.asked_before, p.before);
    take_fan(p, lab.wall_seconds);
    const bool drags = p.pressed && p.at_press && p.subject_at_press.run == now.run &&
                       p.subject_at_press.vehicle == now.vehicle && p.subject_at_press.edits != now.edits;
    if (drags) return follow_drag(lab, jobs, now);
    if (!p.pressed && !p.what_if.empty()) return follow_what_if(lab, jobs, now);
    if (p.is_what_if) return forget_paths(p);
    if (p.pressed) return;
    // After a drag: the path of the last edit stays until it is driven.
    if (p.asked && p.asked->edits != now.edits && !p.job && p.subject_at_press.edits != now.edits && p.shown &&
        p.shown->of.run == now.run && p.shown->of.vehicle == now.vehicle)
        return ask(lab, jobs, now);
    if (!p.job && p.shown && !still_holds(*p.shown, now, *vehicle)) forget_paths(p);
}

std::optional<PredictionView> prediction_of(const Lab& lab) {
    const Predictions& p = lab.predictions;
    const std::uint64_t tick = lab.document.session.snapshot().tick;
    const auto begun = [&](const std::optional<PredictedPaths>& paths) {
        return paths && paths->of.tick <= tick && paths->of.run == lab.document.run_id;
    };
    if (!begun(p.shown) || p.shown->path.empty()) return std::nullopt;
    PredictionView view{.path = &p.shown->path, .fan = &p.shown->fan, .tick = p.shown->of.tick};
    if (begun(p.before) && !p.before->path.empty()) view.before = &p.before->path, view.before_tick = p.before->of.tick;
    constexpr double long_wait = 0.15;  // s
    view.is_outdated = p.job && lab.wall_seconds - p.asked_at > long_wait;
    return view;
}

}  // namespace braitenlab

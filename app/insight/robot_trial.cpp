#include "app/insight/robot_trial.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/course/lesson_view.h"
#include "app/lab.h"
#include "app/lab_selection.h"

namespace braitenlab {

namespace {

using insight::Robots;
using insight::RobotsQuestion;

constexpr double scene_seconds = 20;  // of a run, without an exercise
// A trial that takes no longer than this is completed before the next one begins, so that dots move while a value is
// dragged. Wall seconds.
constexpr double patience = 0.4;

void forget_trial(RobotTrial& trial) {
    trial.is_on = false;
    trial.job.cancel();
    trial.question.reset(), trial.report.reset();
    trial.asked.reset(), trial.robots.reset();
    trial.edits = -1;
}

// The vehicle that is tried: of an exercise the first, else the selected one. Null: there is none, or no brain drives
// it.
const VehicleView* tried_vehicle(const Lab& lab) {
    const Snapshot& now = lab.document.session.snapshot();
    const VehicleView* vehicle = find_vehicle(now, lab.view.selection.vehicle);
    if (lab.document.lesson) {
        const auto first = std::find_if(now.vehicles.begin(), now.vehicles.end(),
                                        [](const VehicleView& each) { return each.start == 0; });
        vehicle = first == now.vehicles.end() ? nullptr : &*first;
    }
    return vehicle && vehicle->driver == Driver::brain ? vehicle : nullptr;
}

RobotsQuestion question_of(const Lab& lab, const VehicleView& vehicle) {
    const Document& document = lab.document;
    RobotsQuestion question{
        .scene = document.session.edited_scene(), .seed = document.session.seed(), .reality = lab.robots.reality};
    question.vehicle = id_at_start(question.scene, question.seed, document.session.snapshot(), vehicle);
    const double seconds = document.lesson ? static_cast<double>(document.lesson->exercise->seconds) : scene_seconds;
    question.ticks = static_cast<std::size_t>(std::llround(seconds * 60));
    return question;
}

// Begins the trial anew when the scene, the seed, the vehicle or the reality has changed.
void follow_question(Lab& lab, Jobs& jobs, const VehicleView& vehicle) {
    RobotTrial& trial = lab.robots;
    if (trial.question && trial.edits == lab.document.edits && trial.compared_run == lab.document.run_id &&
        trial.compared_vehicle == vehicle.id && trial.compared_reality == trial.reality &&
        trial.question->seed == lab.document.session.seed())
        return;
    if (trial.job.active() && lab.wall_seconds - trial.began < patience) return;
    trial.edits = lab.document.edits, trial.compared_run = lab.document.run_id;
    trial.compared_vehicle = vehicle.id, trial.compared_reality = trial.reality;
    RobotsQuestion question = question_of(lab, vehicle);
    if (trial.question && trial.run == lab.document.run_id && *trial.question == question) return;
    if (trial.run != lab.document.run_id) trial.report.reset();
    trial.run = lab.document.run_id;
    trial.question = question;
    auto robots = Robots::create(std::move(question));
    if (!robots) return forget_trial(trial);
    trial.asked = *robots;
    const std::shared_ptr<const Exercise> exercise =
        lab.document.lesson ? lab.document.lesson->exercise : std::shared_ptr<const Exercise>();
    trial.job = submit_robots(jobs, trial.asked, exercise);
    trial.began = lab.wall_seconds;
}

void take_report(RobotTrial& trial) {
    auto done = trial.job.take();
    if (!done) return;
    if (!*done) return forget_trial(trial);
    trial.report = std::move(**done);
    trial.robots = trial.asked;
}

bool is_replay(const Lab& lab) { return lab.together && lab.together->robot; }

}  // namespace

void update_robots(Lab& lab, Jobs& jobs) {
    RobotTrial& trial = lab.robots;
    const VehicleView* vehicle = tried_vehicle(lab);
    if (!lab.view.reality || !vehicle || !disclosure_of(lab).robots) {
        if (is_replay(lab)) end_together(lab);
        return forget_trial(trial);
    }
    take_report(trial);
    if (trial.is_on && !is_replay(lab)) follow_question(lab, jobs, *vehicle);
}

void handle_robots(Lab& lab, const RobotsRequest& wanted) {
    RobotTrial& trial = lab.robots;
    if (wanted.reality) {
        if (is_replay(lab)) end_together(lab);
        trial.reality = std::clamp(*wanted.reality, 0.0f, insight::limits::reality);
    }
    if (wanted.tries && *wanted.tries) trial.is_on = true, trial.edits = -1;
    if (wanted.tries && !*wanted.tries) forget_trial(trial);
    if (wanted.replays && !*wanted.replays && is_replay(lab)) end_together(lab);
    if (!wanted.replays || !*wanted.replays || !trial.report) return;
    const int count = trial.robots->question().robots;
    const int robot = **wanted.replays;
    Together together;
    for (int i = 0; i < count; ++i) {
        if (robot != every_robot && i != robot) continue;
        if (auto world = World::create(trial.robots->scene(), trial.robots->seed_of(i)))
            together.worlds.push_back(std::move(*world));
    }
    if (together.worlds.empty()) return;
    together.robot = robot;
    begin_together(lab, std::move(together));
}

void restart_replay(Lab& lab) {
    if (is_replay(lab)) handle_robots(lab, {.replays = std::optional<int>(*lab.together->robot)});
}

bool is_computing(const RobotTrial& trial) { return trial.job.active(); }

std::optional<RobotsView> robots_of(const Lab& lab) {
    const RobotTrial& trial = lab.robots;
    const VehicleView* vehicle = tried_vehicle(lab);
    if (!lab.view.reality || !vehicle || !disclosure_of(lab).robots) return std::nullopt;
    const Snapshot& now = lab.document.session.snapshot();
    const int kind = vehicle->kind;
    const Kind& of_vehicle = now.scene->kinds[static_cast<std::size_t>(kind)];
    RobotsView shown{.reality = trial.reality, .is_typical = insight::is_ideal(of_vehicle), .is_on = trial.is_on};
    Scene alone;
    alone.kinds = {of_vehicle};
    shown.figures = insight::reality_of(insight::with_reality(std::move(alone), 0, trial.reality).kinds[0]);
    if (trial.job.active()) shown.progress = std::min(trial.job.progress().fraction, 0.999f);
    if (trial.report) shown.report = &*trial.report;
    shown.judged = lab.document.lesson.has_value();
    shown.hovered = trial.hovered;
    if (lab.together) shown.replayed = lab.together->robot;
    return shown;
}

}  // namespace braitenlab

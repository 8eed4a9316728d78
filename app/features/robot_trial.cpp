#include "app/features/robot_trial.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/course/lesson_view.h"
#include "app/lab_selection.h"
#include "app/workspace.h"

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
    trial.report.forget();
    trial.compared.reset();
}

// The vehicle that is tried: of an exercise the first, else the selected one. Null: there is none, or no brain drives
// it.
const VehicleView* tried_vehicle(const Workspace& space) {
    const Snapshot& now = space.document.session.snapshot();
    const VehicleView* vehicle = find_vehicle(now, space.view.selection.vehicle);
    if (space.document.lesson) {
        const auto first = std::find_if(now.vehicles.begin(), now.vehicles.end(),
                                        [](const VehicleView& each) { return each.start == 0; });
        vehicle = first == now.vehicles.end() ? nullptr : &*first;
    }
    return vehicle && vehicle->driver == Driver::brain ? vehicle : nullptr;
}

RobotsQuestion question_of(const Workspace& space, const VehicleView& vehicle, float reality) {
    const Document& document = space.document;
    RobotsQuestion question{
        .scene = document.session.edited_scene(), .seed = document.session.seed(), .reality = reality};
    question.vehicle = id_at_start(question.scene, question.seed, document.session.snapshot(), vehicle);
    const double seconds = document.lesson ? static_cast<double>(document.lesson->exercise->seconds) : scene_seconds;
    question.ticks = static_cast<std::size_t>(std::llround(seconds * 60));
    return question;
}

// Begins the trial anew when the scene, the seed, the vehicle or the reality has changed.
void follow_question(RobotTrial& trial, const Workspace& space, const VehicleView& vehicle) {
    const RobotsKey key{space.document.edits, space.document.run_id, space.document.session.seed(), vehicle.id,
                        trial.reality};
    if (trial.compared == key) return;
    if (trial.report.is_computing() && space.wall_seconds - trial.began < patience) return;
    trial.compared = key;
    RobotsQuestion question = question_of(space, vehicle, trial.reality);
    if (std::exchange(trial.run, key.run) != key.run) trial.report.forget();
    if (trial.report.is_about(question)) return;
    trial.report.ask(std::move(question));
    trial.began = space.wall_seconds;
}

Result<Job<insight::RobotsReport>> submit(Jobs& jobs, const RobotsQuestion& question, const Workspace& space) {
    const auto robots = Robots::create(question);
    if (!robots) return robots.error();
    const auto& lesson = space.document.lesson;
    return submit_robots(jobs, *robots, lesson ? lesson->exercise : nullptr);
}

bool is_replay(const Workspace& space) { return space.together && space.together->robot; }

}  // namespace

void update_robots(RobotTrial& trial, Workspace& space, Jobs& jobs) {
    const VehicleView* vehicle = tried_vehicle(space);
    if (!space.view.reality || !vehicle || !disclosure_of(space).robots) {
        if (is_replay(space)) end_together(space);
        return forget_trial(trial);
    }
    trial.report.take();
    if (trial.is_on && !is_replay(space)) follow_question(trial, space, *vehicle);
    trial.report.begin([&](const RobotsQuestion& question) { return submit(jobs, question, space); });
    if (trial.report.error()) forget_trial(trial);
}

void handle_robots(RobotTrial& trial, Workspace& space, const RobotsRequest& wanted) {
    if (wanted.reality) {
        if (is_replay(space)) end_together(space);
        trial.reality = std::clamp(*wanted.reality, 0.0f, insight::limits::reality);
    }
    if (wanted.tries && *wanted.tries) trial.is_on = true, trial.compared.reset();
    if (wanted.tries && !*wanted.tries) forget_trial(trial);
    if (wanted.replays && !*wanted.replays && is_replay(space)) end_together(space);
    if (!wanted.replays || !*wanted.replays || !trial.report.answer()) return;
    const auto robots = insight::Robots::create(*trial.report.answered());
    if (!robots) return;
    const int robot = **wanted.replays;
    Together together;
    for (int i = 0; i < (*robots)->question().robots; ++i) {
        if (robot != every_robot && i != robot) continue;
        if (auto world = World::create((*robots)->scene(), (*robots)->seed_of(i)))
            together.worlds.push_back(std::move(*world));
    }
    if (together.worlds.empty()) return;
    together.robot = robot;
    begin_together(space, std::move(together));
}

void restart_replay(RobotTrial& trial, Workspace& space) {
    if (is_replay(space)) handle_robots(trial, space, {.replays = std::optional<int>(*space.together->robot)});
}

bool is_computing(const RobotTrial& trial) { return trial.report.is_computing(); }

std::optional<RobotsView> robots_of(const RobotTrial& trial, const Workspace& space) {
    const VehicleView* vehicle = tried_vehicle(space);
    if (!space.view.reality || !vehicle || !disclosure_of(space).robots) return std::nullopt;
    const Snapshot& now = space.document.session.snapshot();
    const int kind = vehicle->kind;
    const Kind& of_vehicle = now.scene->kinds[static_cast<std::size_t>(kind)];
    RobotsView shown{.reality = trial.reality, .is_typical = insight::is_ideal(of_vehicle), .is_on = trial.is_on};
    Scene alone;
    alone.kinds = {of_vehicle};
    shown.figures = insight::reality_of(insight::with_reality(std::move(alone), 0, trial.reality).kinds[0]);
    if (is_computing(trial)) shown.progress = std::min(trial.report.progress().fraction, 0.999f);
    shown.report = trial.report.answer();
    shown.judged = space.document.lesson.has_value();
    shown.hovered = trial.hovered;
    if (space.together) shown.replayed = space.together->robot;
    return shown;
}

}  // namespace braitenlab

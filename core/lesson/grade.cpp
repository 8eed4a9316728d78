#include "core/lesson/grade.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/brain/brain.h"

namespace braitenlab {

namespace {

const Kind& shipped_kind(const Exercise& exercise) {
    return exercise.scene.kinds[static_cast<std::size_t>(subject_kind(exercise.scene))];
}

Scene scene_with(const Exercise& exercise, const Submission& submission) {
    Scene scene = exercise.scene;
    Kind& kind = scene.kinds[static_cast<std::size_t>(subject_kind(scene))];
    kind.brain = submission.brain;
    kind.sensors = submission.sensors;
    kind.body = submission.body;
    if (!scene.starts.empty()) scene.starts.front().sensors.reset();
    return scene;
}

}  // namespace

Submission as_shipped(const Exercise& exercise) {
    const Kind& kind = shipped_kind(exercise);
    const std::vector<Start>& starts = exercise.scene.starts;
    const bool has_own_sensors = !starts.empty() && starts.front().sensors;
    return {kind.brain, has_own_sensors ? *starts.front().sensors : kind.sensors, kind.body};
}

Submission with_brain(const Exercise& exercise, BrainGraph brain) {
    Submission submission = as_shipped(exercise);
    submission.brain = std::move(brain);
    return submission;
}

Submission with_solution(const Exercise& exercise) { return with_brain(exercise, make_graph(exercise.solution)); }

Submission submission_of(const Exercise& exercise, const Snapshot& now) {
    const auto subject = std::find_if(now.vehicles.begin(), now.vehicles.end(),
                                      [](const VehicleView& vehicle) { return vehicle.start == 0; });
    const auto index =
        static_cast<std::size_t>(subject == now.vehicles.end() ? subject_kind(exercise.scene) : subject->kind);
    if (index >= now.scene->kinds.size()) return as_shipped(exercise);  // the kind was removed
    const BrainGraph& brain =
        subject == now.vehicles.end() ? *now.kind_brains[index] : *now.brains[static_cast<std::size_t>(subject->brain)];
    const Kind& kind = subject == now.vehicles.end() ? now.scene->kinds[index] : kind_of(now, *subject);
    return {brain, kind.sensors, kind.body};
}

Trial::Trial(const Exercise& exercise, const Submission& submission, std::uint64_t seed) : referee_(exercise) {
    auto world = World::create(scene_with(exercise, submission), seed);
    if (!world) return;
    world_ = std::move(*world);
    world_->capture(snapshot_);
    referee_.watch(snapshot_);
    ticks_left_ = std::lround(exercise.seconds / tick_seconds);
}

std::optional<bool> Trial::run(int ticks) {
    for (; ticks > 0 && ticks_left_ > 0 && !referee_.passed(); --ticks, --ticks_left_) {
        world_->step();
        world_->capture(snapshot_);
        referee_.watch(snapshot_);
    }
    if (world_ && referee_.passed()) return true;
    return ticks_left_ > 0 ? std::nullopt : std::optional(false);
}

bool passes(const Exercise& exercise, const Submission& submission, std::uint64_t seed) {
    Trial trial(exercise, submission, seed);
    return *trial.run(std::numeric_limits<int>::max());
}

Grade grade_of(const Exercise& exercise, std::vector<bool> passed) {
    Grade grade{std::move(passed)};
    grade.count = static_cast<int>(std::count(grade.passed.begin(), grade.passed.end(), true));
    grade.good = grade.count >= exercise.needed;
    return grade;
}

Grade grade(const Exercise& exercise, const Submission& submission) {
    std::vector<bool> passed;
    for (int seed = 1; seed <= exercise.starts; ++seed)
        passed.push_back(passes(exercise, submission, static_cast<std::uint64_t>(seed)));
    return grade_of(exercise, std::move(passed));
}

}  // namespace braitenlab

#include "core/lesson/referee.h"

#include <algorithm>
#include <cmath>

#include "core/brain/brain.h"
#include "core/maths/angle.h"
#include "core/maths/vec.h"
#include "core/world/world.h"

namespace braitenlab {

namespace {

// A vehicle that hardly moves at first would multiply its speed by any factor.
constexpr float slowest_first_speed = 0.05f;  // m/s

maths::vec2 way_to(const Snapshot& snapshot, int source, const VehicleView& vehicle) {
    const SourceView& view = snapshot.sources[static_cast<std::size_t>(source)];
    return {view.x - vehicle.x, view.y - vehicle.y};
}

// How far the source lies off the heading, 0..180 degrees.
float degrees_off(maths::vec2 way, float heading) {
    return std::fabs(maths::degrees(maths::wrap_angle(maths::arctangent2(way.y, way.x) - heading)));
}

Verdict undecided(const Check& check) {
    switch (check.goal) {
        case Goal::runs:
            return {false, 0, check.seconds, "s", false};
        case Goal::turns_to:
            return {false, 180, check.degrees, "°", true};
        case Goal::touches:
            return {false, INFINITY, check.metres, "m", true};
        case Goal::speeds_up:
            return {false, 0, check.factor, "×", false};
    }
    return {};
}

}  // namespace

Referee::Referee(const Exercise& exercise) {
    for (const Step& step : exercise.steps) {
        checks_.push_back(step.check);
        verdicts_.push_back(undecided(step.check));
    }
    sources_ = exercise.scene.sources;
    if (exercise.scene.starts.empty()) return;
    start_ = exercise.scene.starts.front();
    if (const int kind = pupil_kind(exercise.scene); kind >= 0)
        driver_ = exercise.scene.kinds[static_cast<std::size_t>(kind)].driver;
}

void Referee::begin(const Snapshot& snapshot) {
    begun_ = true;
    disturbed_ = by_hand_ = false;
    first_speed_ = 0;
    pupil_ = snapshot.vehicles.empty() ? no_vehicle : snapshot.vehicles.front().id;  // the one placed first
    was_outside_.assign(checks_.size(), false);
    over_.assign(checks_.size(), false);
    for (std::size_t i = 0; i < checks_.size(); ++i) verdicts_[i] = undecided(checks_[i]);
}

void Referee::watch(const Snapshot& snapshot) {
    const bool new_run = !begun_ || snapshot.tick == 0 || snapshot.tick < last_tick_;
    if (!new_run && snapshot.tick == last_tick_) return;
    if (new_run) begin(snapshot);
    last_tick_ = snapshot.tick;
    const VehicleView* pupil = find_vehicle(snapshot, pupil_);
    if (!pupil) return;
    by_hand_ = disturbed_ || !is_as_given(snapshot, *pupil);
    if (by_hand_) return;
    if (first_speed_ == 0 && snapshot.seconds >= 1)
        first_speed_ = std::max(std::fabs(pupil->speed), slowest_first_speed);
    for (std::size_t i = 0; i < checks_.size(); ++i)
        if (!verdicts_[i].done) judge(i, snapshot, *pupil);
}

// No lamp elsewhere, none too many; one that is missing helps nobody.
bool Referee::is_as_given(const Snapshot& snapshot, const VehicleView& pupil) const {
    const auto& sources = snapshot.scene->sources;
    const bool lit_as_given = std::all_of(sources.begin(), sources.end(), [&](const Source& source) {
        return std::find(sources_.begin(), sources_.end(), source) != sources_.end();
    });
    const auto& starts = snapshot.scene->starts;
    const bool starts_as_given = !start_ || (!starts.empty() && starts.front() == *start_);
    return lit_as_given && starts_as_given && (!start_ || pupil.driver == driver_);
}

void Referee::judge(std::size_t i, const Snapshot& snapshot, const VehicleView& pupil) {
    const Check& check = checks_[i];
    Verdict& verdict = verdicts_[i];
    if (check.goal == Goal::runs) {
        verdict.measured = static_cast<float>(snapshot.seconds);
        verdict.done = verdict.measured >= check.seconds;
        return;
    }
    const int source = find_source(*snapshot.scene, check.source);  // others may have been added or removed
    if (source < 0) return;
    const maths::vec2 way = way_to(snapshot, source, pupil);
    const float distance = maths::length(way);
    switch (check.goal) {
        case Goal::turns_to: {
            const float off = degrees_off(way, pupil.heading);
            if (off > check.degrees) was_outside_[i] = true;
            verdict.measured = std::min(verdict.measured, off);
            verdict.done = was_outside_[i] && off <= check.degrees;
            break;
        }
        case Goal::touches:
            verdict.measured = std::min(verdict.measured, distance);
            verdict.done = distance <= check.metres;
            break;
        case Goal::speeds_up:
            if (first_speed_ == 0 || over_[i]) break;
            verdict.measured = std::fabs(pupil.speed) / first_speed_;
            over_[i] = distance <= check.metres;  // what it does later is another story
            verdict.done = over_[i] && verdict.measured >= check.factor;
            break;
        case Goal::runs:
            break;
    }
}

bool Referee::passed() const {
    return std::all_of(verdicts_.begin(), verdicts_.end(), [](const Verdict& v) { return v.done; });
}

namespace {

bool passes(const Exercise& exercise, const Scene& scene, std::uint64_t seed) {
    auto world = World::create(scene, seed);
    if (!world) return false;
    Referee referee(exercise);
    Snapshot snapshot;
    world->capture(snapshot);
    referee.watch(snapshot);
    const int ticks = static_cast<int>(std::lround(exercise.seconds / tick_seconds));
    for (int tick = 0; tick < ticks && !referee.passed(); ++tick) {
        world->step();
        world->capture(snapshot);
        referee.watch(snapshot);
    }
    return referee.passed();
}

}  // namespace

Grade grade(const Exercise& exercise, const BrainGraph& brain) {
    Scene scene = exercise.scene;
    scene.kinds[static_cast<std::size_t>(pupil_kind(scene))].brain = brain;
    Grade grade;
    for (int seed = 1; seed <= exercise.starts; ++seed)
        grade.passed.push_back(passes(exercise, scene, static_cast<std::uint64_t>(seed)));
    grade.count = static_cast<int>(std::count(grade.passed.begin(), grade.passed.end(), true));
    grade.good = grade.count >= exercise.needed;
    return grade;
}

}  // namespace braitenlab

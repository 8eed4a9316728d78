// Runs that tests of goals build by hand: a scene, and what happens in it tick by tick.
#pragma once

#include <utility>
#include <vector>

#include "core/brain/brain.h"
#include "core/lesson/referee.h"
#include "core/lesson/reference.h"
#include "core/maths/angle.h"

namespace braitenlab::tests {

// Two lamps at (0, 0) and (10, 0), two vehicles, and one step.
inline Exercise exercise_with(Check check) {
    Exercise exercise;
    exercise.scene.sources = {{.name = "lamp"}, {.name = "fire", .x = 10}};
    exercise.scene.kinds.emplace_back().name = "kind";
    exercise.scene.kinds.back().sensors.emplace_back().name = "S";
    exercise.scene.starts = {{.name = "one", .kind = "kind"}, {.name = "two", .kind = "kind"}};
    exercise.steps.push_back({"", std::move(check)});
    return exercise;
}

// What the first vehicle does at one tick; the second stands at (50, 0) unless it is placed.
struct Moment {
    double seconds = 0;
    maths::vec2 at;
    float degrees = 0;  // heading
    float speed = 0, energy = 1, reading = 0;
    maths::vec2 other{50, 0};
    EventCounts events{};
};

inline Snapshot snapshot_of(const Exercise& exercise, const Moment& moment) {
    Snapshot now;
    now.tick = static_cast<std::uint64_t>(moment.seconds * 60 + 0.5);
    now.seconds = moment.seconds;
    now.scene = std::make_shared<const Scene>(exercise.scene);
    for (std::size_t i = 0; i < exercise.scene.sources.size(); ++i) {
        const Source& source = exercise.scene.sources[i];
        now.sources.push_back({static_cast<int>(i), source.channel, source.x, source.y, source.strength});
    }
    for (const Obstacle& obstacle : exercise.scene.obstacles) now.obstacles.push_back({obstacle.x, obstacle.y, 0});
    now.vehicles.resize(2);
    for (int i = 0; i < 2; ++i) {
        VehicleView& vehicle = now.vehicles[static_cast<std::size_t>(i)];
        vehicle.id = vehicle.start = vehicle.first_sensed = i;
        vehicle.x = i == 0 ? moment.at.x : moment.other.x;
        vehicle.y = i == 0 ? moment.at.y : moment.other.y;
    }
    now.vehicles[0].heading = maths::radians(moment.degrees);
    now.vehicles[0].speed = moment.speed;
    now.vehicles[0].energy = moment.energy;
    now.sensed = {moment.reading, 0};
    now.events = moment.events;
    return now;
}

// The verdict on the step after these moments.
inline Verdict verdict_on(const Exercise& exercise, const std::vector<Moment>& run) {
    Referee referee(exercise);
    for (const Moment& moment : run) referee.watch(snapshot_of(exercise, moment));
    return referee.verdicts().front();
}
inline Verdict verdict_on(const Goal& goal, const std::vector<Moment>& run) {
    return verdict_on(exercise_with({goal}), run);
}
inline bool is_done(const Goal& goal, const std::vector<Moment>& run) { return verdict_on(goal, run).done; }
inline bool is_lost(const Goal& goal, const std::vector<Moment>& run) { return verdict_on(goal, run).lost; }
inline float value_of(const Goal& goal, const std::vector<Moment>& run) {
    return verdict_on(goal, run).measures.front().value;
}

}  // namespace braitenlab::tests

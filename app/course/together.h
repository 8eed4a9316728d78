// The graded starts of a passed exercise, run at once in one picture: each start has a world of its own, as it was
// graded, so its vehicles neither sense nor touch those of another start. The exercise's own run stays as it is.
#pragma once

#include <optional>
#include <vector>

#include "core/lesson/exercise.h"
#include "core/lesson/grade.h"
#include "core/lesson/submission.h"
#include "core/world/snapshot.h"
#include "core/world/world.h"

namespace braitenlab {

inline constexpr std::size_t most_together = 10;  // starts

struct Together {
    std::vector<World> worlds;   // at the same tick
    Snapshot shown{};            // all of them; see merged()
    std::optional<int> robot{};  // a replay of robots (app/features/robot_trial.h): RobotsView::replayed
};

// One snapshot of the same moment in several worlds of one scene. The vehicles of the first keep their ids; those of
// the others get larger ones. Obstacles, sources and events are those of the first. Precondition: there is one.
Snapshot merged(const std::vector<Snapshot>&);

// The first starts of the grade, at most most_together, at tick 0. Starts whose world cannot begin are left out.
Together begin_together(const Exercise&, const Submission&, const Grade&);

// Makes the snapshot of its worlds. Precondition: there is one.
void show(Together&);

// Runs one tick in each world and shows them.
void step(Together&);

}  // namespace braitenlab

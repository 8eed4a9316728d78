// What a student hands in for an exercise, and whether it passes.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/lesson/exercise.h"
#include "core/lesson/referee.h"
#include "core/world/snapshot.h"
#include "core/world/world.h"

namespace braitenlab {

// Everything that the student may change: these parts of the kind of the scene's first vehicle (see subject_kind).
struct Submission {
    BrainGraph brain;
    std::vector<Sensor> sensors;
    Body body;
    friend bool operator==(const Submission&, const Submission&) = default;
};

Submission as_shipped(const Exercise&);
Submission with_brain(const Exercise&, BrainGraph);  // as shipped but for the brain
Submission with_solution(const Exercise&);           // as shipped but for the brain, which is the exercise's solution

// What the first vehicle of a run of the exercise has now; when it is gone, what its kind has.
Submission submission_of(const Exercise&, const Snapshot&);

// A run of the exercise's scene from one seed with a submission. It passes when every step is done within
// Exercise::seconds; with a submission that is not valid, e.g. whose brain does not compile, it fails. Deterministic;
// uses nothing but its arguments, so that several may run on several threads.
class Trial {
public:
    Trial(const Exercise&, const Submission&, std::uint64_t seed);

    // Runs at most `ticks` ticks and returns whether the trial passes, or nullopt while that is undecided.
    std::optional<bool> run(int ticks);

private:
    std::optional<World> world_;  // nullopt: the submission is not valid
    Referee referee_;
    Snapshot snapshot_;
    long ticks_left_ = 0;
};

// The result of a whole Trial.
bool passes(const Exercise&, const Submission&, std::uint64_t seed);

struct Grade {
    std::vector<bool> passed;  // one per start, seeds 1, 2, …
    int count = 0;             // number of starts that passed
    bool good = false;         // count >= Exercise::needed
};

// The grade of `passed`, which holds one result of passes() for each of the seeds 1 .. Exercise::starts.
Grade grade_of(const Exercise&, std::vector<bool> passed);

// Runs all starts one after the other. Takes a fraction of a second to some seconds.
Grade grade(const Exercise&, const Submission&);

}  // namespace braitenlab

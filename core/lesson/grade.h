// Whether a submission passes an exercise.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/lesson/exercise.h"
#include "core/lesson/referee.h"
#include "core/lesson/submission.h"
#include "core/world/snapshot.h"
#include "core/world/world.h"

namespace braitenlab {

// A run from one start, judged.
struct StartResult {
    std::uint64_t seed = 0;
    bool passed = false;            // every step is done
    std::vector<Verdict> verdicts;  // one per step; empty: the submission is not valid
    std::vector<maths::vec2> path;  // m, positions of the first vehicle, one per path_ticks from tick 0
    float seconds = 0;              // until it passed, could not pass any more, or ended
};

// Index of the step that made the trial fail: the first one that could not be done any more, else the first that was
// not done. The number of verdicts if there is none.
std::size_t failed_step(const StartResult&);

inline constexpr int path_ticks = 15;

// A run of the exercise's scene from one seed with a submission. It passes when every step is done within
// Exercise::seconds; with a submission that is not valid, e.g. whose brain does not compile, it fails. Deterministic;
// uses nothing but its arguments, so that several may run on several threads.
class Trial {
public:
    Trial(const Exercise&, const Submission&, std::uint64_t seed);

    // Runs at most `ticks` ticks and returns the result, or nullopt while the trial is undecided.
    std::optional<StartResult> run(int ticks);

private:
    void add_to_path();

    std::optional<World> world_;  // nullopt: the submission is not valid
    Referee referee_;
    Snapshot snapshot_;
    StartResult result_;
    long ticks_left_ = 0;
};

// The result of a whole Trial.
StartResult try_start(const Exercise&, const Submission&, std::uint64_t seed);
inline bool passes(const Exercise& exercise, const Submission& submission, std::uint64_t seed) {
    return try_start(exercise, submission, seed).passed;
}

// Indices in Prediction::shows of the checks that belong to the option of this index.
std::vector<std::size_t> checks_of_option(const Prediction&, std::size_t option);

// The run with the submission and Exercise::seed, judged by the checks of the option for Prediction::after seconds.
StartResult shown_run(const Exercise&, const Submission&, std::size_t option);
// The same with the shipped brain.
StartResult shown_run(const Exercise&, std::size_t option);

// Index of an option other than the answer whose checks the run meets; nullopt: none.
std::optional<std::size_t> other_option_shown(const Exercise&);

struct Grade {
    std::vector<StartResult> starts;
    int count = 0;      // number of starts that passed
    bool good = false;  // count >= Exercise::needed
};

std::vector<bool> passed_starts(const Grade&);

// What the step of the rule has measured in each start: its first measure; 0 for a submission that is not valid.
std::vector<float> measured_values(const MedianRule&, const std::vector<StartResult>&);

// The mean of the two middle values for an even number of values; 0 without values.
float median(std::vector<float>);

// The grade of these starts.
Grade grade_of(const Exercise&, std::vector<StartResult>);

// Runs Exercise::starts starts with the seeds from `first_seed` on, one after the other. Takes a fraction of a second
// to some seconds.
Grade grade(const Exercise&, const Submission&, std::uint64_t first_seed = 1);

}  // namespace braitenlab

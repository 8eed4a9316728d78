// Judges an exercise's checks from what anyone can see of a run; the window and the command line use it alike.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/lesson/exercise.h"
#include "core/world/snapshot.h"

namespace braitenlab {

// One step, judged: done stays done once reached.
struct Verdict {
    bool done = false;
    float measured = 0, needed = 0;  // the live value beside the one asked for; best so far where it is an extreme
    std::string_view unit;           // "s", "m", "°", "×"
};

class Referee {
public:
    explicit Referee(const Exercise&);

    // Call once a tick, and for the start. A snapshot whose tick is not later than the last one begins a new run.
    void watch(const Snapshot&);

    const std::vector<Verdict>& verdicts() const { return verdicts_; }
    bool passed() const;

private:
    struct Memory;
    void judge(std::size_t step, const Snapshot&, const VehicleView&);

    std::vector<Step> steps_;
    std::vector<Verdict> verdicts_;
    std::uint64_t last_tick_ = 0;
    bool started_ = false;
    bool was_outside_ = false;   // for turns_to
    float first_speed_ = 0;      // m/s after the first second; 0 before
};

struct Grade {
    std::vector<bool> passed;  // one per start, seeds 1, 2, …
    int count = 0;             // how many passed
    bool good = false;         // count >= Exercise::needed
};

// Runs the exercise's starts with this brain in its first vehicle's kind. Deterministic; a fraction of a second.
Grade grade(const Exercise&, const BrainGraph&);

}  // namespace braitenlab

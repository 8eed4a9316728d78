// Judges an exercise's checks from what anyone can see of a run; the window and the command line use it alike.
#pragma once

#include <cstdint>
#include <optional>
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
    bool at_most = false;            // done when measured <= needed; else when measured >= needed
};

class Referee {
public:
    explicit Referee(const Exercise&);

    // Call for the start and after every tick. A snapshot from before the last one, or of tick 0, begins a new run; the
    // same moment again changes nothing.
    void watch(const Snapshot&);

    // Somebody took something of the scene into their hands in the middle of the run: it counts no more.
    void disturb() { disturbed_ = by_hand_ = true; }

    // Whether this run does not count: it was disturbed, or it did not begin as the exercise does (lamps elsewhere,
    // another start, somebody at the wheel). Steps that were done before stay done.
    bool by_hand() const { return by_hand_; }

    const std::vector<Verdict>& verdicts() const { return verdicts_; }
    bool passed() const;

private:
    void begin(const Snapshot&);
    void judge(std::size_t step, const Snapshot&, const VehicleView&);
    bool is_as_given(const Snapshot&, const VehicleView&) const;

    std::vector<Check> checks_;
    std::vector<Source> sources_;  // of the exercise
    std::optional<Start> start_;   // the pupil's, and who drives there
    Driver driver_ = Driver::brain;
    std::vector<Verdict> verdicts_;
    std::vector<bool> was_outside_;  // for turns_to, one a check
    std::vector<bool> over_;         // for speeds_up: the touch has come and decided
    VehicleId pupil_ = no_vehicle;
    std::uint64_t last_tick_ = 0;
    bool begun_ = false;
    bool disturbed_ = false, by_hand_ = false;
    float first_speed_ = 0;  // m/s after the first second
};

struct Grade {
    std::vector<bool> passed;  // one per start, seeds 1, 2, …
    int count = 0;             // how many passed
    bool good = false;         // count >= Exercise::needed
};

// Runs the exercise's starts with this brain in its first vehicle's kind. Deterministic; a fraction of a second. A
// brain that does not compile passes nothing.
Grade grade(const Exercise&, const BrainGraph&);

}  // namespace braitenlab

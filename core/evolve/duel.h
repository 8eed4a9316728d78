// A trial as it can be watched.
#pragma once

#include "core/evolve/breeding.h"
#include "core/world/snapshot.h"

namespace braitenlab::evolve {

struct Duel {
    BySide<std::vector<Pose>> paths;  // one pose a tick, from tick 0 on
    bool is_eaten = false;            // the prey; unless the fitness is a measure, this is the end

    float seconds() const { return static_cast<float>(paths.front().size() - 1) / 60; }
};

// run_of() the trial of this duel.
float number_of(const BreedingBase&, const Trial&, const Duel&);

// The same run as run_of(), some ticks at a time.
class DuelRun {
public:
    // The trial's scene is that of the base: World::create does not fail.
    DuelRun(const BreedingBase&, const Trial&);

    // True once the run has ended.
    bool advance(std::size_t ticks);
    // Precondition: advance() has returned true.
    const Duel& duel() const { return duel_; }

private:
    void record();

    World world_;
    std::size_t most_;  // ticks
    bool ends_with_capture_;
    Snapshot now_;
    Duel duel_;
};

}  // namespace braitenlab::evolve

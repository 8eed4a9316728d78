// Judges one vehicle of a running world: a Judge (behaviour.h) that takes its poses from the world.
#pragma once

#include <vector>

#include "core/insight/behaviour.h"
#include "core/world/world.h"

namespace braitenlab::insight {

class RunJudge {
public:
    // Precondition: the world is at the start of the run and has the vehicle.
    RunJudge(const World&, VehicleId);

    // The world's present tick; the first call is for the start. False once the vehicle's run has ended: it left the
    // world or fell over an edge. Then no more calls.
    bool add(const World&);

    Pose pose() const { return now_.pose; }  // at the last add() that returned true
    // Precondition: the world's present tick has been added.
    Outcome outcome(const World&) const;

private:
    Judge judge_;
    VehicleId vehicle_;
    std::vector<maths::vec2> others_;  // positions, as Judge::others()
    VehicleTrace now_;
    bool is_gone_ = false;
};

}  // namespace braitenlab::insight

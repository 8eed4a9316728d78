// One run in pieces, judged (run_judge.h): the path of one vehicle, and what the run shows.
#pragma once

#include <cstddef>
#include <optional>

#include "core/insight/behaviour.h"
#include "core/insight/predict.h"
#include "core/insight/run_judge.h"
#include "core/result.h"
#include "core/world/world.h"

namespace braitenlab::insight {

class JudgedRun {
public:
    // From the present tick of the world, for this many ticks. An Error, or a world without the vehicle: complete at
    // once.
    JudgedRun(Result<World>, VehicleId, std::size_t ticks);

    // Computes at most this many ticks. True once the run is complete: after all ticks, or when the vehicle has left.
    bool advance(std::size_t ticks);

    const Outcome& outcome() const { return outcome_; }  // valid once complete
    const Path& path() const { return path_; }           // one pose per tick
    float progress() const;                              // 0..1

private:
    void add_pose();

    std::size_t ticks_;
    std::optional<World> world_;  // nullopt: complete
    std::optional<RunJudge> judge_;
    Path path_;
    Outcome outcome_;
};

}  // namespace braitenlab::insight

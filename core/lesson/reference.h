// The run of an exercise with its solution, or with another submission: the path of one vehicle.
#pragma once

#include <cstdint>
#include <optional>

#include "core/lesson/exercise.h"
#include "core/lesson/goal.h"
#include "core/world/world.h"

namespace braitenlab {

class Reference {
public:
    // The first vehicle of the run with the solution.
    Reference(const Exercise&, std::uint64_t seed);
    // The vehicle of this start of the run with another submission.
    Reference(const Exercise&, const Submission&, std::size_t start, std::uint64_t seed);

    // The path up to this tick at least. Computes the ticks that are missing; a path that ends earlier belongs to a
    // vehicle that left the scene.
    const ReferencePath& until(std::uint64_t tick);

    std::uint64_t seed() const { return seed_; }

private:
    void add_pose();

    std::uint64_t seed_;
    std::optional<World> world_;  // nullopt: the scene cannot be built, or the vehicle left it
    VehicleId subject_ = no_vehicle;
    ReferencePath path_;
};

}  // namespace braitenlab

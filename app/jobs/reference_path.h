// The path of one vehicle of a run of an exercise, computed in the background as far as it has been asked for.
#pragma once

#include <cstdint>
#include <memory>

#include "app/jobs/asked.h"
#include "core/lesson/exercise.h"
#include "core/lesson/goal.h"

namespace braitenlab {

class BackgroundPath {
public:
    // The run with the seed, for `ticks` ticks at least. Another seed begins anew. Call once per turn, with the same
    // exercise, submission and start. `start`: index in Scene::starts.
    void follow(Jobs&, const std::shared_ptr<const Exercise>&, const Submission&, std::size_t start, std::uint64_t seed,
                std::size_t ticks);

    // Empty until it is known. A path shorter than asked for belongs to a vehicle that left the scene.
    const ReferencePath& path() const;
    std::uint64_t seed() const { return run_.question() ? run_.question()->seed : 0; }
    bool is_known() const { return !path().empty(); }

private:
    struct Run {
        std::uint64_t seed = 0;
        std::size_t ticks = 0;
    };
    Asked<Run, ReferencePath> run_;
};

}  // namespace braitenlab

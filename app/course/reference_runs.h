// Runs of the open exercise that are computed in the background: the one with the solution, which is shown beside the
// student's, and the one with the shipped brain, which a drawn prediction is compared with.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "app/jobs/jobs.h"
#include "core/lesson/exercise.h"
#include "core/lesson/goal.h"

namespace braitenlab {

struct Lab;
struct GhostView;

// The path of one vehicle of a run, computed as far as it has been asked for.
class BackgroundPath {
public:
    // The run with the seed, for `ticks` ticks at least. Another seed begins anew. Call once per turn, with the same
    // exercise, submission and start. `start`: index in Scene::starts.
    void follow(Jobs&, const std::shared_ptr<const Exercise>&, const Submission&, std::size_t start, std::uint64_t seed,
                std::size_t ticks);

    // Empty until it is known. A path shorter than asked for belongs to a vehicle that left the scene.
    const ReferencePath& path() const { return path_; }
    std::uint64_t seed() const { return seed_; }
    bool is_known() const { return !path_.empty(); }

private:
    std::uint64_t seed_ = 0;
    std::size_t asked_ = 0;  // ticks
    ReferencePath path_;
    std::optional<Job<ReferencePath>> job_;
};

struct ReferenceRuns {
    BackgroundPath solution, shipped;
};

// Call once per turn, after Jobs::deliver. Asks for the runs that the lesson needs and writes the real path and its
// distance to the drawn one to the attempt. Without an open exercise does nothing.
void update_reference_runs(Lab&, Jobs&);

// The vehicle of the run with the solution at the displayed time. nullopt while it is not compared or not known, once
// it has left the scene, and while the student's run does not count, because its start or scene was changed by hand.
std::optional<GhostView> ghost_of(const Lab&);

// The vehicle of another run with this path and body at the displayed time; nullopt once the path has ended. It points
// to the path.
std::optional<GhostView> ghost_at(const Lab&, const ReferencePath&, const Body&);

}  // namespace braitenlab

// Predictions: the coming path of one vehicle, computed on a copy of a run. The run itself does not change.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/world/world.h"

namespace braitenlab::insight {

// One pose per tick; the first is that of the present tick. It ends early where the vehicle leaves the world.
using Path = std::vector<Pose>;

// What is predicted.
struct Question {
    Checkpoint from;                      // the run at the present tick
    std::vector<Command> changes{};       // executed at this tick in the copy; a refused one changes nothing
    VehicleId vehicle = no_vehicle;       // whose path
    std::size_t ticks = 0;                // after the present one
    std::optional<std::uint64_t> seed{};  // other random numbers from this tick on; nullopt: those of the run
};

// A prediction in pieces, for a time slice or a thread. With the numbers of the run and the same changes, its path is
// bit for bit the one that the run then takes if nothing else is changed: it repeats the run from its last keyframe,
// because a copy that begins with a keyframe of its own would differ in the last bits after a contact.
class Prediction {
public:
    explicit Prediction(const Question&);

    // Computes at most this many ticks or commands. True once the path is complete.
    bool advance(std::size_t steps);

    const Path& path() const { return path_; }
    float progress() const;  // 0..1

private:
    void begin();
    void add_pose();

    Question question_;
    std::optional<World> world_;  // nullopt: complete
    std::size_t repeated_ = 0;    // of the commands since the keyframe
    bool has_begun_ = false;      // the copy is at the present tick and has the changes
    Path path_;
};

// The whole prediction.
Path predict(const Question&);

// The question with other random numbers: the same run with other noise from the present tick on. number: from 1.
Question with_other_chance(Question, std::uint64_t number);

// True if the noise of sensors, a sensor for `random` or a wandering driver changes the run of this world, so that its
// coming path depends on the seed.
bool depends_on_chance(const Snapshot&);

}  // namespace braitenlab::insight

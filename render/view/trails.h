// Trails: the recent path of every vehicle. More points are recorded than drawn, so that trails also exist after a
// rewind.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <unordered_map>

#include "core/maths/vec.h"
#include "core/world/snapshot.h"

namespace braitenlab::render {

// The path of one vehicle up to the displayed tick.
class Trail {
public:
    static constexpr std::size_t capacity = 48;  // points that are drawn
    static constexpr float jump = 2.5f;          // m: points farther apart are not joined

    std::size_t count() const;
    // i = 0 is the newest point, i = count() − 1 the oldest.
    maths::vec2 at(std::size_t i) const { return places_[places_.size() - later_ - 1 - i].at; }

    // Adds the vehicle's position at a tick. `most`: number of recorded points.
    void extend(std::uint64_t tick, maths::vec2 place, const Arena&, std::size_t most);

private:
    struct Place {
        maths::vec2 at;
        std::uint64_t tick = 0;
    };
    bool is_on_the_known_way(maths::vec2 place) const;

    std::deque<Place> places_;  // oldest first
    std::size_t later_ = 0;     // number of points at the end that are later than the displayed tick
    std::uint64_t tick_ = 0;    // the displayed tick
};

class Trails {
public:
    // Records the positions of all vehicles. After a rewind a trail ends at the vehicle's position; later points are
    // reused while the vehicle follows the same path. A new run clears all trails. A jump of a vehicle clears its
    // trail.
    void record(const Snapshot&);

    // The vehicle's trail, or null.
    const Trail* of(VehicleId) const;

private:
    std::unordered_map<VehicleId, Trail> trails_;
    std::uint64_t seed_ = 0;
    int generation_ = 0;
    std::string scene_;  // its name
};

}  // namespace braitenlab::render

// Trails: the path of every vehicle since the start of the run, of many vehicles the recent part of it.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/maths/vec.h"
#include "core/world/snapshot.h"
#include "render/view/trail_colour.h"

namespace braitenlab::render {

// The path of one vehicle up to the displayed tick.
class Trail {
public:
    static constexpr std::uint64_t ticks_between = 6;  // least distance of two points: a tenth of a second

    // Number of points up to the displayed tick.
    std::size_t count() const { return places_.size() - later_; }
    // i = 0 is the newest point, i = count() − 1 the oldest.
    maths::vec2 at(std::size_t i) const { return places_[places_.size() - later_ - 1 - i].at; }

    // True if the vehicle drove from the previous point, i + 1, to point i. False where it was moved by hand, and at
    // the edge of a torus.
    bool is_joined(std::size_t i) const { return places_[places_.size() - later_ - 1 - i].is_joined; }

    // What the vehicle did at point i.
    const TrailMoment& moment(std::size_t i) const { return places_[places_.size() - later_ - 1 - i].moment; }

    // The number of point i, counted from the beginning of the path; it does not change while the path grows.
    std::size_t serial(std::size_t i) const { return dropped_ + count() - 1 - i; }

    // Adds the vehicle's position at a tick, unless it is near the newest point. A position that the vehicle cannot
    // have driven to is not joined to the path; far away it starts a new path. `most`: number of recorded points.
    // True if it adds a point.
    bool extend(std::uint64_t tick, maths::vec2 place, const Arena&, std::size_t most);
    // Sets what the vehicle does at the newest point. Readings of other sensors than these become unknown.
    void note(const TrailMoment&, const std::vector<Sensor>&);

private:
    struct Place {
        maths::vec2 at;
        std::uint64_t tick = 0;
        bool is_joined = false;  // to the place before
        TrailMoment moment{};
    };
    bool is_on_the_known_way(maths::vec2 place) const;

    std::deque<Place> places_;          // oldest first
    std::size_t later_ = 0;             // number of points at the end that are later than the displayed tick
    std::size_t dropped_ = 0;           // number of points removed at the beginning
    std::uint64_t tick_ = 0;            // the displayed tick
    maths::vec2 place_{};               // the vehicle's position at that tick
    std::vector<std::string> sensors_;  // names of those whose readings are recorded
};

class Trails {
public:
    // Records the positions of all vehicles. After a rewind a trail ends at the vehicle's position; later points are
    // reused while the vehicle follows the same path. A new population clears all trails.
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

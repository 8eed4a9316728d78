// Where vehicles were a moment ago: a short pen line behind each.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <unordered_map>

#include "core/maths/vec.h"
#include "core/world/snapshot.h"

namespace braitenlab {

// The newest places of one vehicle, a ring that overwrites its oldest.
struct Trail {
    static constexpr std::size_t capacity = 48;
    static constexpr float jump = 2.5f;  // m: what lies farther apart was not driven, or went round a torus
    std::array<maths::vec2, capacity> places{};
    std::size_t count = 0, newest = 0;
    std::uint64_t seen = 0;  // the tick it was last extended at

    // i = 0 is the newest, count − 1 the oldest.
    maths::vec2 at(std::size_t i) const { return places[(newest + capacity - i) % capacity]; }
};

class Trails {
public:
    // Notes where the vehicles are. Forgets everything when time went back or another run began, and a vehicle's trail
    // when it jumped.
    void record(const Snapshot&);

    // The vehicle's trail, or null.
    const Trail* of(VehicleId) const;

private:
    std::unordered_map<VehicleId, Trail> trails_;
    std::uint64_t tick_ = 0, seed_ = 0;
    int generation_ = 0;
    std::string scene_;  // its name
};

}  // namespace braitenlab

// Where vehicles were a moment ago: a short pen line behind each. More of the way is remembered than is drawn, so that
// it is there, too, after going back in time.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <unordered_map>

#include "core/maths/vec.h"
#include "core/world/snapshot.h"

namespace braitenlab::render {

// The way of one vehicle, up to the moment shown.
class Trail {
public:
    static constexpr std::size_t capacity = 48;  // places that are drawn
    static constexpr float jump = 2.5f;          // m: what lies farther apart was not driven, or went round a torus

    std::size_t count() const;
    // i = 0 is the newest, count() − 1 the oldest.
    maths::vec2 at(std::size_t i) const { return places_[places_.size() - later_ - 1 - i].at; }

    // The vehicle is here at this tick. `most` places are remembered.
    void extend(std::uint64_t tick, maths::vec2 place, const Arena&, std::size_t most);

private:
    struct Place {
        maths::vec2 at;
        std::uint64_t tick = 0;
    };
    bool is_on_the_known_way(maths::vec2 place) const;

    std::deque<Place> places_;  // oldest first
    std::size_t later_ = 0;     // of them, how many at the end are later than the moment shown
    std::uint64_t tick_ = 0;    // the moment shown
};

class Trails {
public:
    // Notes where the vehicles are. When time went back, each trail ends where its vehicle is then; what came later
    // counts again as time goes on, until the vehicle takes another way. Forgets everything when another run began, and
    // a vehicle's trail when it jumped.
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

// State: everything that a tick changes, as plain values that can be copied and stored. Inside core/world and core/io
// only.
//
// A running world is a state and what is derived from it (core/world/world_data.h): two worlds made from the same state
// evolve identically, bit for bit.
//
// Vehicles are rows of parallel arrays by ascending id; row i of every array, and of the bodies in Physics, is the same
// vehicle.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/mechanics/motion.h"
#include "core/world/compiled.h"
#include "core/world/snapshot.h"

namespace braitenlab::world {

// Two vehicles in contact, the lower id first; or one vehicle and the environment (other == no_vehicle).
struct Touch {
    VehicleId one = no_vehicle, other = no_vehicle;
    friend auto operator<=>(const Touch&, const Touch&) = default;
};

// A bite of a pair; the same pair bites again one second later at the earliest.
struct Bite {
    Touch pair;
    std::uint64_t tick = 0;
};

// A position (m) that a vehicle remembers, and the tick of its last visit.
struct Mark {
    VehicleId owner = no_vehicle;
    maths::vec2 position;
    std::uint64_t tick = 0;
};

struct Vehicles {
    std::vector<VehicleId> id;
    std::vector<std::int32_t> kind;
    std::vector<std::int32_t> start;  // in Scene::starts; −1: part of the population
    std::vector<Driver> driver;
    std::vector<mechanics::Motion> motion;
    std::vector<float> energy;
    std::vector<std::array<float, 2>> steered;      // wheel commands of the manual driver, −1..1
    std::vector<std::int32_t> waypoint;             // index of the next waypoint
    std::vector<std::array<float, 2>> gain;         // of each motor, 1 without mismatch
    std::vector<std::array<float, 2>> motor;        // wheel commands, −1..1
    std::vector<std::array<float, 2>> wheel_angle;  // rad, for display only
    std::vector<SharedBrain> brain;
    std::vector<std::uint32_t> first_sensed, first_neuron, first_delayed;  // into the three arrays below
    std::vector<float> sensed, neurons;
    std::vector<float> delayed;  // readings not yet received by the brain: a ring buffer per sensor with latency

    std::size_t size() const { return id.size(); }

    // Calls f with every array that has one element per vehicle.
    template <class Self, class F>
    static void each_column(Self& v, F f) {
        f(v.id), f(v.kind), f(v.start), f(v.driver), f(v.motion), f(v.energy), f(v.steered), f(v.waypoint), f(v.gain);
        f(v.motor), f(v.wheel_angle), f(v.brain), f(v.first_sensed), f(v.first_neuron), f(v.first_delayed);
    }
};

struct State {
    std::shared_ptr<const Scene> scene;    // with all edits
    std::vector<SharedBrain> kind_brains;  // by kind: the brain of vehicles that enter
    std::uint64_t seed = 0, tick = 0;
    std::int32_t generation = 1;
    std::uint32_t still_ticks = 0;  // ticks since any vehicle moved
    VehicleId next_id = 0;
    EventCounts events;
    std::vector<Bite> bites;  // of the last second, sorted by pair
    std::vector<Mark> marks;  // by owner, then oldest first
    Vehicles vehicles;
    std::vector<mechanics::Motion> obstacles;  // as Scene::obstacles
    std::vector<Touch> touching;               // sorted
};

}  // namespace braitenlab::world

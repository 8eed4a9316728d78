// All that a tick changes: the state of a run at one moment, as plain values that can be copied and kept.
//
// A world is a moment and what is worked out from it (core/world/state.h): two worlds made from the same moment go on
// in the same way, bit for bit. Inside core/world only.
//
// Vehicles are rows of parallel arrays, by ascending id; row i of every array, and of the bodies in Physics, is the
// same vehicle.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/world/compiled.h"
#include "core/world/motion.h"
#include "core/world/snapshot.h"

namespace braitenlab {

// A bite counts once a second and pair.
struct Bite {
    Touch pair;
    std::uint64_t tick = 0;
};

// A place that a vehicle remembers, and when it was last there.
struct Mark {
    VehicleId owner = no_vehicle;
    maths::vec2 place;
    std::uint64_t tick = 0;
};

struct Vehicles {
    std::vector<VehicleId> id;
    std::vector<std::int32_t> kind;
    std::vector<std::int32_t> start;  // in Scene::starts, −1: placed at random or by hand
    std::vector<Driver> driver;
    std::vector<Motion> motion;
    std::vector<float> energy;
    std::vector<std::array<float, 2>> hand;         // what a person steers, −1..1
    std::vector<std::int32_t> waypoint;             // the next one of a path
    std::vector<std::array<float, 2>> gain;         // of each motor: 1 but for a mismatch
    std::vector<std::array<float, 2>> motor;        // −1..1
    std::vector<std::array<float, 2>> wheel_angle;  // rad, for the eye only
    std::vector<SharedDesign> design;
    std::vector<std::uint32_t> first_sensed, first_neuron, first_late;  // into the three below
    std::vector<float> sensed, neurons;
    std::vector<float> late;  // what slow sensors read and have not passed on: a ring for each

    std::size_t size() const { return id.size(); }

    // Calls f with every array that has one element a vehicle.
    template <class F>
    void each_column(F f) {
        f(id), f(kind), f(start), f(driver), f(motion), f(energy), f(hand), f(waypoint), f(gain), f(motor);
        f(wheel_angle), f(design), f(first_sensed), f(first_neuron), f(first_late);
    }
};

struct Moment {
    std::shared_ptr<const Scene> scene;   // the designs as edited up to now
    std::vector<SharedDesign> newcomers;  // by kind: the brain that those who enter get
    std::uint64_t seed = 0, tick = 0;
    std::int32_t generation = 1;
    std::uint32_t still_ticks = 0;  // since anything moved
    VehicleId next_id = 0;
    EventCounts events;
    std::vector<Bite> bites;  // of the last second, sorted by pair
    std::vector<Mark> marks;  // by owner, the oldest first
    Vehicles vehicles;
    std::vector<Motion> obstacles;  // as Scene::obstacles
    std::vector<Touch> touching;    // who touches whom or the environment, sorted
};

}  // namespace braitenlab

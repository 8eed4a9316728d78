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
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <tuple>
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

// The begin of a vehicle's contact with a wall, post or obstacle, or with another vehicle, for display; of one pair at
// most once a second.
struct Strike {
    VehicleId vehicle = no_vehicle;
    maths::vec2 at;  // m
    std::uint64_t tick = 0;
    VehicleId other = no_vehicle;  // the vehicle that is struck, with the larger id
    Touch pair() const { return {vehicle, other}; }
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
    std::vector<double> energy;                     // steps of a float are too coarse for a drain of hours
    std::vector<std::array<float, 2>> steered;      // wheel commands of the manual driver, −1..1
    std::vector<std::int32_t> waypoint;             // index of the next waypoint
    std::vector<std::array<float, 2>> gain;         // of each motor, 1 without mismatch
    std::vector<std::array<float, 2>> motor;        // wheel commands, −1..1
    std::vector<std::array<float, 2>> wheel_angle;  // rad, for display only
    std::vector<SharedBrain> brain;                 // compiled for the vehicle's sensors
    std::vector<SharedDesign> design;               // of a vehicle with sensors of its own; null: those of its kind
    std::vector<std::uint32_t> first_sensed, first_neuron, first_delayed;  // into the three arrays below
    std::vector<float> sensed, neurons;
    // Per sensor: the sample that it holds, then a ring of readings on their way to the brain.
    std::vector<float> delayed;

    std::size_t size() const { return id.size(); }

    // Calls f with every array that has one element per vehicle.
    template <class Self, class F>
    static void each_column(Self& vehicles, F f);
};

// A value that each vehicle has once, and its traits. Run files, the hash, loading and spawning are derived from the
// table of these values, so that a new one needs a member of Vehicles, a row of the table, and the law that changes it.
template <class T>
struct VehicleValue {
    std::string_view word;  // key in run files
    std::vector<T> Vehicles::*column;
    T initial{};                                   // of a vehicle that is added
    std::optional<std::array<float, 2>> limits{};  // inclusive, of each component; nullopt: io::check_state has a rule
    bool reset = false;                            // a vehicle that respawns has the initial value again
    bool hashed = true;                            // false: every tick computes it again, or it is only displayed
};

inline constexpr float any_finite = std::numeric_limits<float>::max();

// In the order of the hash.
inline constexpr std::tuple vehicle_values{
    VehicleValue<VehicleId>{"id", &Vehicles::id},
    VehicleValue<std::int32_t>{"kind", &Vehicles::kind},
    VehicleValue<std::int32_t>{"start", &Vehicles::start, -1},
    VehicleValue<mechanics::Motion>{"motion", &Vehicles::motion},
    VehicleValue<Driver>{"driver", &Vehicles::driver},
    VehicleValue<std::array<float, 2>>{"hand", &Vehicles::steered, {}, {{-1, 1}}},
    VehicleValue<std::array<float, 2>>{"gain", &Vehicles::gain, {1, 1}, {{0.5f, 1.5f}}},
    VehicleValue<std::int32_t>{.word = "waypoint", .column = &Vehicles::waypoint, .reset = true},
    VehicleValue<double>{
        .word = "energy", .column = &Vehicles::energy, .initial = 1, .limits = {{0, 1}}, .reset = true},
    VehicleValue<std::array<float, 2>>{"motor", &Vehicles::motor, {}, {{-1, 1}}, true, false},
    VehicleValue<std::array<float, 2>>{
        "wheel_angle", &Vehicles::wheel_angle, {}, {{-any_finite, any_finite}}, true, false},
};

// Calls f with every VehicleValue.
template <class F>
void each_vehicle_value(F f) {
    std::apply([&f](const auto&... value) { (f(value), ...); }, vehicle_values);
}

template <class Self, class F>
void Vehicles::each_column(Self& vehicles, F f) {
    each_vehicle_value([&](const auto& value) { f(vehicles.*value.column); });
    f(vehicles.brain), f(vehicles.design), f(vehicles.first_sensed), f(vehicles.first_neuron),
        f(vehicles.first_delayed);
}

struct State {
    std::shared_ptr<const Scene> scene;    // with all edits
    std::vector<SharedBrain> kind_brains;  // by kind: the brain of vehicles that enter
    std::uint64_t seed = 0, tick = 0;
    std::uint64_t parts_seed =
        0;  // of the errors of sensors and wheels: the seed of the start, kept by World::fork(seed)
    std::int32_t generation = 1;
    std::uint32_t still_ticks = 0;  // ticks since any vehicle moved
    VehicleId next_id = 0;
    EventCounts events;
    std::vector<Bite> bites;         // of the last second, sorted by pair
    std::vector<Strike> strikes;     // of the last second, by ascending pair; not hashed
    std::vector<VehicleId> fallen;   // over an open edge in the last tick, ascending; not hashed, not in files
    std::vector<Mark> marks;         // by owner, then oldest first
    std::vector<VehicleLook> looks;  // of vehicles of the population, by vehicle; display only
    Vehicles vehicles;
    std::vector<mechanics::Motion> obstacles;  // as Scene::obstacles
    std::vector<Touch> touching;               // sorted
};

}  // namespace braitenlab::world

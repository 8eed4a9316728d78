// Everything a running world holds. Inside core/world only.
//
// Vehicles are rows of parallel arrays, by ascending id; row i of every array, and of the bodies in Physics, is the
// same vehicle.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/world/compiled.h"
#include "core/world/field.h"
#include "core/world/physics.h"
#include "core/world/snapshot.h"
#include "core/world/world.h"

namespace braitenlab {

// A bite counts once a second and pair.
struct Bite {
    Touch pair;
    std::uint64_t tick = 0;
};

struct Vehicles {
    std::vector<VehicleId> id;
    std::vector<std::int32_t> kind;
    std::vector<std::int32_t> start;  // in Scene::starts, −1: placed at random
    std::vector<Motion> motion;
    std::vector<float> energy;
    std::vector<std::array<float, 2>> motor;        // −1..1
    std::vector<std::array<float, 2>> wheel_angle;  // rad, for the eye only
    std::vector<SharedDesign> design;
    std::vector<std::uint32_t> first_sensed, first_neuron;  // into the two below
    std::vector<float> sensed, neurons;

    std::size_t size() const { return id.size(); }
};

struct WorldState {
    WorldState(const Scene&, std::uint64_t seed);  // nobody in it yet, kinds without brains

    std::shared_ptr<const Scene> scene;
    std::uint64_t seed;
    std::vector<CompiledKind> kinds;
    std::vector<Outline> outlines;  // walls and obstacles, for eyes
    std::array<bool, channel_count> sensed_channel{};
    std::array<Field, channel_count> fields;
    std::vector<Stimulus> stimuli;        // scratch
    bool eyes_are_stale = true;           // something moved since they looked
    std::vector<float> foreseen_neurons;  // what the next tick would make of them; empty: as they are

    std::uint64_t tick = 0;
    std::int32_t generation = 1;
    std::uint32_t still_ticks = 0;  // since anything moved
    VehicleId next_id = 0;
    EventCounts events;
    std::vector<Bite> bites;           // of the last second, sorted by pair
    std::vector<maths::vec2> sources;  // places; the rest is in the scene
    Vehicles vehicles;
    Physics physics;

    Role role(std::size_t row) const { return scene->kinds[static_cast<std::size_t>(vehicles.kind[row])].role; }
    std::optional<std::size_t> row_of(VehicleId) const;
};

// ── The tick, in order ──────────────────────────────────────────────────────────────────────────────────────────────
void sense(WorldState&);           // sense.cpp   eyes read the fields of their channels
void think(WorldState&);           // world.cpp   brains turn readings into wheel commands
void drive(WorldState&);           // drive.cpp   wheels push bodies
void touch_and_live(WorldState&);  // live.cpp  bites, energy, deaths and births, the inactivity timer

// ── Who is in the world ─────────────────────────────────────────────────────────────────────────────────────────────
void populate(WorldState&);    // populate.cpp  the first generation
void repopulate(WorldState&);  // the next one: as many again, elsewhere
void add_vehicle(WorldState&, int kind, int start, VehicleId, SharedDesign, const Pose&);
void remove_vehicle(WorldState&, std::size_t row);
Pose free_place(const WorldState&, VehicleId);   // at random, clear of others where there is room
int kind_due(const WorldState&);                 // the kind that the shares ask for next
void read_motion(WorldState&, std::size_t row);  // takes over where the body is now

// ── From outside and to the outside ────────────────────────────────────────────────────────────────────────────────
std::optional<Error> carry_out(WorldState&, const Command&);  // commands.cpp
void capture(const WorldState&, Snapshot&);                   // capture.cpp
std::uint64_t hash(const WorldState&);                        // hash.cpp

}  // namespace braitenlab

// A running world: the state and everything derived from it. Inside core/world only.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/sensing/environment.h"
#include "core/world/command.h"
#include "core/world/free_space.h"
#include "core/world/physics.h"
#include "core/world/state.h"

namespace braitenlab::world {

// Input of the sensors, refilled in each tick.
struct SensingBuffers {
    sensing::StimulusGrids grids;
    std::vector<Touch> touched;  // all touches in both directions, sorted; filled when there are bumpers
    std::vector<sensing::PointSource> point_sources;
    std::vector<Role> roles;
    std::vector<sensing::Stimulus> stimuli;
    std::vector<sensing::Outline> touched_outlines;
};

// Readings, neurons and wheel commands as the next tick will compute them.
struct Preview {
    std::vector<float> sensed, neurons;
    std::vector<std::array<float, 2>> motor;
};

struct WorldData : State {
    // Keeps the state unchanged and derives kinds, environment and bodies from it alone. After an edit of the scene and
    // at every keyframe, a world is rebuilt from its own state.
    explicit WorldData(State);
    void rebuild();  // the same as  *this = WorldData(State(*this)),  but keeps what depends on the scene alone

    std::shared_ptr<const Scene> compiled_scene;  // from which kinds and ground were derived
    std::vector<CompiledKind> kinds;
    sensing::Environment environment;
    std::array<bool, channel_count> sensed_channel{};  // by any kind or vehicle
    bool any_memory = false;                           // any kind has a place memory
    bool readings_are_stale = true;                    // something moved since the sensors were read
    std::vector<Bump> bumps;                           // of this tick; filled if any_memory
    std::vector<Touch> begun;                          // contacts that began in the last step, sorted
    std::vector<Bump> struck;                          // those with the environment, by ascending vehicle
    SensingBuffers sensing_buffers;
    Physics physics;

    Role role(std::size_t row) const { return vehicles.brain[row]->role; }
    std::size_t kind(std::size_t row) const { return static_cast<std::size_t>(vehicles.kind[row]); }
    // The vehicle's kind with the vehicle's sensors, as edited and as compiled.
    const Kind& design(std::size_t row) const {
        return vehicles.design[row] ? vehicles.design[row]->kind : scene->kinds[kind(row)];
    }
    const CompiledKind& compiled(std::size_t row) const {
        return vehicles.design[row] ? vehicles.design[row]->compiled : kinds[kind(row)];
    }
    // Lays out the grids for the sensors of all kinds and vehicles. Call after a vehicle gets sensors of its own.
    void lay_out_grids();
    void add_bodies();  // of all vehicles
    std::optional<std::size_t> row_of(VehicleId) const;
};

// ── The tick, in order ──────────────────────────────────────────────────────────────────────────────────────────────
void sense(WorldData&);           // sense.cpp     sensors read their channels
void think(WorldData&);           // think.cpp     drivers turn readings into wheel commands
void drive(WorldData&);           // drive.cpp     wheels push bodies
void keep_inside(WorldData&);     // boundary.cpp  torus and walls
void remember(WorldData&);        // memory.cpp    marks at contacts with walls, posts and obstacles
void touch_and_live(WorldData&);  // ecology.cpp   bites, strikes, energy, deaths and births, the inactivity timer

// Results of sense() and think() without changing the world, for a snapshot between a command and the next tick.
Preview preview(const WorldData&);
std::vector<float> sense_preview(const WorldData&);  // the readings of a preview

// ── Vehicles ────────────────────────────────────────────────────────────────────────────────────────────────────────
void spawn_population(WorldData&);  // spawn.cpp  the first generation
void new_generation(WorldData&);    //            the same numbers at new random poses
// `design`: null for the sensors of the kind; else call lay_out_grids() afterwards.
void add_vehicle(WorldData&, int kind, int start, VehicleId, SharedBrain, const Pose&, SharedDesign design = nullptr);
void remove_vehicles(WorldData&, const std::vector<std::size_t>& rows);  // ascending rows
void respawn(WorldData&, std::size_t row);  // at its start, or at a random pose; energy, brain and marks are reset
// A random pose, clear of others where there is room; the position is occupied afterwards. `number` selects the random
// numbers: for the first generation the number in the population, so that a reset gives the same poses when a vehicle
// with a start has been added; later the id.
Pose free_pose(const WorldData&, FreeSpace&, int kind, int number);
// The pose if it is inside no vehicle and no obstacle, else the nearest free position on a grid around it with the same
// heading. The pose itself if there is none within twenty times the vehicle's reach.
Pose nearest_free_pose(const WorldData&, int kind, const Pose&);  // free_space.cpp
// Gains of the left and right motor: 1 ± Body::mismatch of the kind, from the seed and the id. spawn.cpp
std::array<float, 2> motor_gains(const WorldData&, int kind, VehicleId);
int next_kind(const WorldData&);                // the kind that the shares require next
bool is_outside(const Arena&, maths::vec2);     // boundary.cpp
void read_motion(WorldData&, std::size_t row);  // copies the body's motion from the physics to the state

// ── Commands, display, hash ─────────────────────────────────────────────────────────────────────────────────────────
std::optional<Error> execute(WorldData&, const Command&);  // commands.cpp, edits.cpp, add_remove.cpp
float strength(const State&, const Mark&);                 // memory.cpp: what is left of a mark, 0..1
// Sum of a sensor's responses to its own vehicle's marks.
float read_memory(const WorldData&, const sensing::CompiledSensor&, const sensing::SensorPose&, std::size_t row);
void capture(const WorldData&, Snapshot&);  // capture.cpp
bool trace(const WorldData&, VehicleId, VehicleTrace&);
std::uint64_t hash(const State&);  // hash.cpp

}  // namespace braitenlab::world

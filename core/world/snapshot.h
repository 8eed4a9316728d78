// Snapshot: a complete read-only copy of a world at one tick, for the window and for files. Plain values, no references
// to the world.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/brain/graph.h"
#include "core/scene/scene.h"

namespace braitenlab {

namespace sensing {
struct IntensityInput;  // core/sensing/intensity.h
}

// Unique in a run and never reused for another vehicle. New vehicles get ascending ids.
using VehicleId = std::int32_t;
inline constexpr VehicleId no_vehicle = -1;

struct Pose {
    float x = 0, y = 0, heading = 0;  // m, m, rad
    friend bool operator==(const Pose&, const Pose&) = default;
};

struct VehicleView {
    VehicleId id = no_vehicle;
    int kind = 0;            // in Scene::kinds
    int start = -1;          // in Scene::starts; −1: part of the population
    Role role = Role::none;  // predator, prey or none; never `wiring`
    Driver driver = Driver::brain;
    float x = 0, y = 0, heading = 0;     // m, m, rad in [-pi, pi)
    float speed = 0;                     // m/s along the heading, negative backwards
    float energy = 1;                    // 0..1
    std::array<float, 2> motor{};        // commanded wheel speeds left and right, −1..1
    std::array<float, 2> wheel_angle{};  // rad the driven wheels have turned
    int brain = 0;                       // in Snapshot::brains
    int design = -1;                     // in Snapshot::designs; −1: its sensors are those of its kind
    int first_sensed = 0;                // readings: sensed[first_sensed + i], i as in kind_of().sensors
    // Unit states: neurons[first_neuron + i], i < neuron_count: hidden neurons by ascending id, left motor, right
    // motor. Learned parts of the Hebbian wires: neurons[first_neuron + neuron_count + i].
    int first_neuron = 0;
    int neuron_count = 0;
};

struct SourceView {
    int source = 0;  // in Scene::sources
    Channel channel = Channel::light;
    float x = 0, y = 0;
    float strength = 1;  // at this time; 0 while the source is off
};

// The look that a vehicle of the population has of its own.
struct VehicleLook {
    VehicleId vehicle = no_vehicle;
    Look look;
    friend bool operator==(const VehicleLook&, const VehicleLook&) = default;
};
// That of a vehicle in a list by ascending id; null if it has none.
const Look* find_look(const std::vector<VehicleLook>&, VehicleId);
// Sets or, where it is empty, removes that of a vehicle.
void set_look(std::vector<VehicleLook>&, VehicleId, const Look&);

// A remembered position.
struct MarkView {
    VehicleId owner = no_vehicle;
    float x = 0, y = 0, strength = 0;  // m, m, 0..1
};

// A bite of a predator and prey.
struct BiteView {
    VehicleId one = no_vehicle, other = no_vehicle;  // one < other
    float age = 0;                                   // s
};

// The begin of a vehicle's contact with a wall, post or obstacle, or with another vehicle.
struct StrikeView {
    VehicleId vehicle = no_vehicle;
    float x = 0, y = 0, age = 0;   // m, m, s
    VehicleId other = no_vehicle;  // the vehicle that is struck, with the larger id
};

// Numbers of events since the start of the run. A fall over an open edge counts as a fall and a death; the respawn that
// follows it counts as a birth.
struct EventCounts {
    std::int64_t captures = 0, deaths = 0, births = 0, contacts = 0, falls = 0;
    friend bool operator==(const EventCounts&, const EventCounts&) = default;
};

struct Snapshot {
    std::uint64_t tick = 0;
    double seconds = 0;  // s of simulated time
    std::uint64_t seed = 0;
    int generation = 1;
    float inactivity_left = 0;  // s until a new generation starts if no vehicle moves; 0 without a timer
    EventCounts events;
    bool is_preview = false;            // readings and commands are those of the next tick: an edit changes them
    int predators = 0, prey = 0;        // numbers of vehicles; all: vehicles.size()
    std::vector<VehicleView> vehicles;  // by ascending id
    std::vector<float> sensed;          // 0..1
    std::vector<float> neurons;
    std::vector<std::shared_ptr<const BrainGraph>> brains;       // all brains in use, with edits
    std::vector<std::shared_ptr<const BrainGraph>> kind_brains;  // brains of new vehicles, as Scene::kinds
    std::vector<std::shared_ptr<const Kind>> designs;  // kinds with the sensors of vehicles that have their own
    std::vector<SourceView> sources;     // as Scene::sources; without the lamps of vehicles, which are in Scene::kinds
    std::vector<Pose> obstacles;         // current poses, as Scene::obstacles
    std::vector<VehicleLook> looks;      // by vehicle; those with a start have theirs in Scene::starts
    std::vector<MarkView> marks;         // by owner, then oldest first
    std::vector<BiteView> bites;         // of the last second, by pair
    std::vector<StrikeView> strikes;     // of the last second, by pair
    std::vector<VehicleId> fallen;       // over an open edge in the last tick, ascending; they are at a start again
    std::shared_ptr<const Scene> scene;  // with all edits except those of brains, see kind_brains
};

// One vehicle at one tick, cheaper than a full snapshot. Wheel commands and readings are those of the last tick.
struct VehicleTrace {
    std::uint64_t tick = 0;
    Pose pose;                     // heading in [-pi, pi)
    std::array<float, 2> motor{};  // commanded wheel speeds left and right, −1..1
    std::vector<float> sensed;     // 0..1, as kind_of().sensors
};

// The vehicle with this id, or null.
const VehicleView* find_vehicle(const Snapshot&, VehicleId);

// Number in the random population, from 0, that the vehicle with this id has or would have (see Member).
int number_in_population(const Snapshot&, VehicleId);

// The vehicle's kind, with all edits and with the vehicle's own sensors if it has any. Precondition: the vehicle is in
// the snapshot.
inline const Kind& kind_of(const Snapshot& now, const VehicleView& vehicle) {
    if (vehicle.design >= 0) return *now.designs[static_cast<std::size_t>(vehicle.design)];
    return now.scene->kinds[static_cast<std::size_t>(vehicle.kind)];
}

// The vehicle's own name and colour.
Look look_of(const Snapshot&, const VehicleView&);

// Brain of the vehicle. Precondition: the vehicle is in the snapshot.
inline const std::shared_ptr<const BrainGraph>& brain_of(const Snapshot& now, const VehicleView& vehicle) {
    return now.brains[static_cast<std::size_t>(vehicle.brain)];
}

// Value of a node of the vehicle's brain: the reading of a sensor, the state of a neuron or motor. 0 for a node that is
// silenced or that the brain does not have.
float node_value(const Snapshot&, const VehicleView&, NodeId);

// Learned part of a Hebbian wire's weight, which adds to the weight in the graph; 0 for any other wire.
float learned(const Snapshot&, const VehicleView&, NodeId from, NodeId to);

// Input for the intensity of a channel as the vehicle `asking` senses it, or for no vehicle: uses its sensor of that
// channel, leaves out its own stimuli, and for `memory` takes its own marks.
sensing::IntensityInput intensity_input(const Snapshot&, Channel, VehicleId asking);

// Channels that have an intensity and a sensor or source in the scene, in the order of Channel. Colours of light are
// included only when a sensor distinguishes them.
std::vector<Channel> channels_with_intensity(const Snapshot&);

}  // namespace braitenlab

// What the window and the files see of a world at one moment: plain values, complete, never a way back into the world.
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

using VehicleId = std::int32_t;  // unique in a run, never used again; ascending in the order of entering
inline constexpr VehicleId no_vehicle = -1;

struct Pose {
    float x = 0, y = 0, heading = 0;  // m, m, rad
    friend bool operator==(const Pose&, const Pose&) = default;
};

struct VehicleView {
    VehicleId id = no_vehicle;
    int kind = 0;            // in Scene::kinds
    int start = -1;          // in Scene::starts; −1: one of the population
    Role role = Role::none;  // predator, prey or none: never `wiring`
    Driver driver = Driver::brain;
    float x = 0, y = 0, heading = 0;     // m, m, rad in [-pi, pi)
    float speed = 0;                     // m/s along the heading, negative backwards
    float energy = 1;                    // 0..1
    std::array<float, 2> motor{};        // commanded wheel speeds left and right, −1..1
    std::array<float, 2> wheel_angle{};  // rad the driven wheels have turned
    int brain = 0;                       // in Snapshot::brains
    int first_sensed = 0;                // its sensors' values: sensed[first_sensed + i], i as in Kind::sensors
    int first_neuron = 0;  // its units' values: neurons[first_neuron + i], hidden by ascending id, left, right motor,
    int neuron_count = 0;  // then what its Hebbian wires have learned: neurons[first_neuron + neuron_count + i]
};

struct SourceView {
    int source = 0;  // in Scene::sources
    Channel channel = Channel::light;
    float x = 0, y = 0, strength = 1;
};

// A place that a vehicle remembers.
struct MarkView {
    VehicleId owner = no_vehicle;
    float x = 0, y = 0, strength = 0;  // m, m, 0..1
};

// Counted since the run began. Falls (over an open edge) are among the deaths, and who fell and enters again among the
// births.
struct EventCounts {
    std::int64_t captures = 0, deaths = 0, births = 0, contacts = 0, falls = 0;
    friend bool operator==(const EventCounts&, const EventCounts&) = default;
};

struct Snapshot {
    std::uint64_t tick = 0;
    double seconds = 0;  // simulated
    std::uint64_t seed = 0;
    int generation = 1;
    float inactivity_left = 0;  // s until a new generation begins if nothing moves; 0 when the scene has no timer
    EventCounts events;
    int predators = 0, prey = 0;        // the population is vehicles.size()
    std::vector<VehicleView> vehicles;  // by ascending id
    std::vector<float> sensed;          // 0..1
    std::vector<float> neurons;
    std::vector<std::shared_ptr<const BrainGraph>> brains;       // every brain in use, as edited
    std::vector<std::shared_ptr<const BrainGraph>> kind_brains;  // what newcomers get, as Scene::kinds
    std::vector<SourceView> sources;     // as Scene::sources; lamps that vehicles carry are in their kinds
    std::vector<Pose> obstacles;         // where they are now, as Scene::obstacles
    std::vector<MarkView> marks;         // by owner, the oldest first
    std::shared_ptr<const Scene> scene;  // the designs as edited up to now; its kinds' brains are in kind_brains
};

// One vehicle at one tick, without a full snapshot. Wheel commands and readings are those of the last tick.
struct VehicleTrace {
    std::uint64_t tick = 0;
    Pose pose;                     // heading in [-pi, pi)
    std::array<float, 2> motor{};  // commanded wheel speeds left and right, −1..1
    std::vector<float> sensed;     // 0..1, as Kind::sensors
};

// The vehicle with this id, or null.
const VehicleView* find_vehicle(const Snapshot&, VehicleId);

// The vehicle's brain. Precondition: the vehicle is in the snapshot.
inline const std::shared_ptr<const BrainGraph>& brain_of(const Snapshot& now, const VehicleView& vehicle) {
    return now.brains[static_cast<std::size_t>(vehicle.brain)];
}

// The value the snapshot holds for a node of a vehicle's brain: a sensor's reading, a neuron's or motor's state. 0 for
// a node that is silenced or that the brain does not have.
float node_value(const Snapshot&, const VehicleView&, NodeId);

// What a Hebbian wire of a vehicle's brain has learned, to be added to its weight; 0 for any other wire.
float learned(const Snapshot&, const VehicleView&, NodeId from, NodeId to);

// What the intensity of a channel depends on, as the vehicle `asking` senses it (or no_vehicle): its own sensor for the
// channel measures, its own stimuli do not count, and `memory` shows its own marks.
sensing::IntensityInput intensity_input(const Snapshot&, Channel, VehicleId asking);

// The channels with an intensity of which the scene has a sensor or a source, in the order of Channel. Colours of light
// are listed only when a sensor distinguishes them.
std::vector<Channel> channels_with_intensity(const Snapshot&);

}  // namespace braitenlab

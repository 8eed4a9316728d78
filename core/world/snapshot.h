// What the window and the files see of a world at one moment: plain values, complete, never a way back into the world.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/brain/graph.h"
#include "core/scene/scene.h"

namespace braitenlab {

using VehicleId = std::int32_t;  // unique in a run, never used again; ascending in the order of entering
inline constexpr VehicleId no_vehicle = -1;

struct VehicleView {
    VehicleId id = no_vehicle;
    int kind = 0;  // in Scene::kinds
    Role role = Role::none;
    float x = 0, y = 0, heading = 0;     // m, m, rad in [-pi, pi)
    float speed = 0;                     // m/s along the heading, negative backwards
    float energy = 1;                    // 0..1
    std::array<float, 2> motor{};        // commanded wheel speeds left and right, −1..1
    std::array<float, 2> wheel_angle{};  // rad the driven wheels have turned
    int brain = 0;                       // in Snapshot::brains
    int first_sensed = 0;                // its sensors' values: sensed[first_sensed + i], i as in Kind::sensors
    int first_neuron = 0;  // its units' values: neurons[first_neuron + i], hidden by ascending id, left, right motor
    int neuron_count = 0;
};

struct SourceView {
    int source = 0;  // in Scene::sources
    Channel channel = Channel::light;
    float x = 0, y = 0, strength = 1;
};

// Counted since the run began.
struct EventCounts {
    std::int64_t captures = 0, deaths = 0, births = 0, contacts = 0;
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
    std::vector<SourceView> sources;
    std::shared_ptr<const Scene> scene;  // what the run began from: arena, kinds, obstacles
};

// The vehicle with this id, or null.
const VehicleView* find_vehicle(const Snapshot&, VehicleId);

// The value the snapshot holds for a node of a vehicle's brain: a sensor's reading, a neuron's or motor's state. 0 for
// a node that the brain does not have.
float node_value(const Snapshot&, const VehicleView&, NodeId);

}  // namespace braitenlab

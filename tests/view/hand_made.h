// Hand-made snapshots: tests of pictures need no running world.
#pragma once

#include <memory>
#include <utility>

#include "core/maths/angle.h"
#include "core/world/snapshot.h"

namespace braitenlab::hand_made {

// Two eyes for one channel that point 35 degrees outwards.
inline std::vector<Sensor> two_eyes(Channel channel) {
    Sensor left, right;
    left.name = "SL", left.y = 0.24f, left.angle = maths::radians(35);
    right.name = "SR", right.y = -0.24f, right.angle = maths::radians(-35);
    left.channel = right.channel = channel;
    return {left, right};
}

// Sensors 1 and 2, motors 3 and 4, and the wires whose weights are not 0.
inline BrainGraph wired(float LL, float LR, float RL, float RR) {
    BrainGraph brain;
    const auto node = [&](NodeId id, NodeKind kind, const char* name) {
        Node n;
        n.id = id, n.kind = kind, n.name = name;
        brain.nodes.push_back(n);
    };
    node(1, NodeKind::sensor, "SL"), node(2, NodeKind::sensor, "SR");
    node(3, NodeKind::motor, "ML"), node(4, NodeKind::motor, "MR");
    const auto wire = [&](NodeId from, NodeId to, float weight) {
        Wire w;
        w.from = from, w.to = to, w.weight = weight;
        brain.wires.push_back(w);
    };
    wire(1, 3, LL), wire(2, 3, LR), wire(1, 4, RL), wire(2, 4, RR);
    return brain;
}

// Three kinds: 0 plain (crossed, light), 1 predator (crossed, senses prey), 2 prey (straight, senses predators).
inline std::shared_ptr<Scene> scene() {
    auto scene = std::make_shared<Scene>();
    const auto kind = [&](const char* name, Role role, Channel channel, const BrainGraph& brain) {
        Kind k;
        k.name = name, k.role = role, k.sensors = two_eyes(channel), k.brain = brain;
        scene->kinds.push_back(k);
    };
    kind("plain", Role::none, Channel::light, wired(0, 1, 1, 0));
    kind("predator", Role::predator, Channel::prey, wired(-0.4f, 1.5f, 1.5f, -0.4f));
    kind("prey", Role::prey, Channel::predator, wired(1.5f, 0, 0, 1.5f));
    return scene;
}

inline Snapshot empty(std::shared_ptr<const Scene> scene) {
    Snapshot now;
    for (const Kind& kind : scene->kinds) now.brains.push_back(std::make_shared<BrainGraph>(kind.brain));
    now.scene = std::move(scene);
    return now;
}

inline VehicleId add(Snapshot& now, int kind, float x, float y, float heading, float left_sees = 0,
                     float right_sees = 0) {
    VehicleView v;
    v.id = now.vehicles.empty() ? 0 : now.vehicles.back().id + 1;
    v.kind = v.brain = kind;
    v.role = now.scene->kinds[static_cast<unsigned>(kind)].role;
    v.x = x, v.y = y, v.heading = heading;
    v.first_sensed = static_cast<int>(now.sensed.size());
    v.first_neuron = static_cast<int>(now.neurons.size());
    v.neuron_count = 2;
    now.sensed.insert(now.sensed.end(), {left_sees, right_sees});
    now.neurons.insert(now.neurons.end(), {0, 0});
    now.vehicles.push_back(v);
    return v.id;
}

// Adds three vehicles far outside the arena: of more than three, low quality rounds only the selected one.
inline void add_others(Snapshot& now) {
    for (const float x : {100.0f, 110.0f, 120.0f}) add(now, 0, x, 100, 0);
}

inline void add_source(Snapshot& now, Channel channel, float x, float y, float strength = 1) {
    now.sources.push_back({static_cast<int>(now.sources.size()), channel, x, y, strength});
}

}  // namespace braitenlab::hand_made

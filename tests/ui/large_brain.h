// Brains of any size: two eyes, two motors and a given number of neurons and wires.
#pragma once

#include <cstdint>
#include <memory>

#include "core/brain/four_neurons.h"
#include "core/maths/random.h"
#include "core/world/snapshot.h"

namespace braitenlab::tests {

// `nodes` includes the eyes and motors. Precondition: far fewer wires than pairs of nodes.
inline BrainGraph large_brain(int nodes, int wires) {
    BrainGraph graph = make_graph({.LR = 1.5f, .RL = 1.5f});
    maths::Random chance{7, 1};
    for (NodeId id = 4; id < nodes; ++id) {
        Node node;
        node.id = id, node.name = "N" + std::to_string(id - 3);
        node.curve.response = responses[static_cast<std::size_t>(id) % responses.size()].value;
        graph.nodes.push_back(node);
    }
    while (static_cast<int>(graph.wires.size()) < wires) {
        Wire wire;
        wire.from = static_cast<NodeId>(chance.uniform(0, static_cast<float>(nodes)));
        wire.to = static_cast<NodeId>(chance.uniform(2, static_cast<float>(nodes)));
        wire.weight = chance.uniform(-2, 2);
        const bool fits = wire.from < nodes && wire.to < nodes && find_wire(graph, wire.from, wire.to) == nullptr;
        if (fits) graph.wires.push_back(wire);
    }
    return graph;
}

// A snapshot of one vehicle with this brain; most neurons have a value other than 0.
inline Snapshot snapshot_with(const BrainGraph& graph) {
    Snapshot now;
    Scene scene;
    scene.kinds.resize(1);
    scene.kinds[0].sensors.resize(2);
    scene.kinds[0].sensors[0].name = "SL", scene.kinds[0].sensors[1].name = "SR";
    now.scene = std::make_shared<Scene>(scene);
    now.sensed = {0.4f, 0.2f};
    VehicleView vehicle;
    vehicle.id = 0;
    for (const Node& node : graph.nodes) vehicle.neuron_count += node.kind != NodeKind::sensor;
    for (int i = 0; i < vehicle.neuron_count; ++i) now.neurons.push_back(static_cast<float>(i % 7) / 4 - 0.6f);
    now.vehicles = {vehicle};
    now.brains = {std::make_shared<BrainGraph>(graph)};
    now.kind_brains = now.brains;
    return now;
}

}  // namespace braitenlab::tests

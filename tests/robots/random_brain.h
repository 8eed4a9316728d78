// Random brains with two eyes: hidden neurons with every curve, thresholds, memories and loops.
#pragma once

#include <string>

#include "core/brain/four_neurons.h"
#include "core/maths/random.h"

namespace braitenlab::tests {

// `smooth`: no steps and no thresholds, so that a small error of a sum stays small.
inline BrainGraph random_brain(maths::Random& random, bool smooth) {
    BrainGraph graph =
        make_graph({.LL = random.uniform(-2, 2), .RR = random.uniform(-2, 2), .LM = random.uniform(-1, 1)});
    const auto curve = [&] {
        Curve made{responses[random.next() % responses.size()].value, random.uniform(-1, 1), random.uniform(0.1f, 1)};
        if (smooth && made.response == Response::step) made.response = Response::rectified;
        return made;
    };
    const int neurons = 1 + static_cast<int>(random.next() % 4);
    for (int i = 0; i < neurons; ++i)
        graph.nodes.push_back({.id = 50 + i,
                               .kind = NodeKind::neuron,
                               .name = "N" + std::to_string(i),
                               .curve = curve(),
                               .bias = random.uniform(-1, 1),
                               .time_constant = random.next() % 3 == 0 ? random.uniform(0, 1) : 0});
    for (const Node& from : graph.nodes)
        for (const Node& to : graph.nodes) {
            if (to.kind == NodeKind::sensor || find_wire(graph, from.id, to.id) || random.next() % 2 == 0) continue;
            Wire wire{.from = from.id, .to = to.id, .weight = random.uniform(-1, 1)};
            if (random.next() % 4 == 0) wire.curve = curve();
            if (!smooth && random.next() % 4 == 0) wire.threshold = random.uniform(0, 1);
            graph.wires.push_back(wire);
        }
    return graph;
}

}  // namespace braitenlab::tests

#include "core/brain/mutate.h"

#include <algorithm>

namespace braitenlab {

namespace {

float with_error(float value, float deviation, float low, float high, maths::Random& chance) {
    return std::clamp(value + deviation * chance.normal(), low, high);
}

// An index below `count`. Precondition: count > 0.
std::size_t any_of(std::size_t count, maths::Random& chance) { return chance.next() % count; }

// The ends of every wire that the graph could have besides its own.
std::vector<WireEnds> unjoined(const BrainGraph& graph) {
    std::vector<WireEnds> free;
    for (const Node& from : graph.nodes)
        for (const Node& to : graph.nodes)
            if (from.kind != NodeKind::motor && to.kind != NodeKind::sensor && !find_wire(graph, from.id, to.id))
                free.push_back({from.id, to.id});
    return free;
}

void rewire(BrainGraph& graph, const Mutation& mutation, maths::Random& chance) {
    const bool adds = chance.uniform(0, 1) < 0.5f;
    if (!adds && !graph.wires.empty()) {
        graph.wires.erase(graph.wires.begin() + static_cast<std::ptrdiff_t>(any_of(graph.wires.size(), chance)));
        return;
    }
    if (!adds || graph.wires.size() >= static_cast<std::size_t>(limits::wires)) return;
    const std::vector<WireEnds> free = unjoined(graph);
    if (free.empty()) return;
    const WireEnds ends = free[any_of(free.size(), chance)];
    Wire wire{.from = ends.from, .to = ends.to};
    wire.weight = with_error(0, mutation.strength, -limits::weight, limits::weight, chance);
    graph.wires.push_back(wire);
}

}  // namespace

BrainGraph mutated(BrainGraph graph, const Mutation& mutation, maths::Random& chance) {
    const float strength = mutation.strength;
    for (Wire& wire : graph.wires) {
        if (mutation.weights) wire.weight = with_error(wire.weight, strength, -limits::weight, limits::weight, chance);
        if (mutation.thresholds)
            wire.threshold = with_error(wire.threshold, strength / 4, 0, limits::threshold, chance);
    }
    for (Node& node : graph.nodes)
        if (mutation.biases && node.kind != NodeKind::sensor)
            node.bias = with_error(node.bias, strength / 2, -limits::bias, limits::bias, chance);
    if (mutation.rewiring > 0 && chance.uniform(0, 1) < mutation.rewiring) rewire(graph, mutation, chance);
    return graph;
}

}  // namespace braitenlab

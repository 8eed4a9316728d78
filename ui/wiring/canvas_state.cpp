#include "ui/wiring/canvas_state.h"

namespace braitenlab::wiring {

namespace {

float value_of(const Snapshot& now, const VehicleView& vehicle, const Node& node, const NodeShape& shape) {
    if (node.kind != NodeKind::neuron) return node_value(now, vehicle, node.id);
    // By rank: faster than a search for each of many neurons.
    return now.neurons[static_cast<std::size_t>(vehicle.first_neuron + shape.unit)];
}

}  // namespace

void update(Readings& readings, const Snapshot& now, const VehicleView& vehicle, const BrainGraph& graph,
            const Layout& layout) {
    readings.nodes.clear();
    readings.learned.clear();
    readings.carried.clear();
    for (const NodeShape& shape : layout.nodes)
        readings.nodes.push_back(value_of(now, vehicle, graph.nodes[shape.node], shape));
    for (const WireShape& shape : layout.wires) {
        if (shape.wire < 0) {
            readings.learned.push_back(0);
            readings.carried.push_back(0);
            continue;
        }
        const auto learner = static_cast<std::size_t>(vehicle.first_neuron + vehicle.neuron_count + shape.learner);
        const bool learnt = shape.learner >= 0 && learner < now.neurons.size();
        readings.learned.push_back(learnt ? now.neurons[learner] : 0);
        readings.carried.push_back(signal(graph.wires[static_cast<std::size_t>(shape.wire)], readings.nodes[shape.from],
                                          readings.learned.back()));
    }
}

}  // namespace braitenlab::wiring

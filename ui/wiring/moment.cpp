#include "ui/wiring/moment.h"

namespace braitenlab {
namespace {

float value_of(const Snapshot& now, const VehicleView& vehicle, const Node& node, const NodeShape& shape) {
    if (node.kind != NodeKind::neuron) return node_value(now, vehicle, node.id);
    // A large brain's neurons are many: read by their rank, not looked up one by one.
    return now.neurons[static_cast<std::size_t>(vehicle.first_neuron + shape.unit)];
}

}  // namespace

void read(CanvasMoment& moment, const Snapshot& now, const VehicleView& vehicle, const BrainGraph& graph,
          const Layout& layout) {
    moment.nodes.clear();
    moment.learned.clear();
    moment.carried.clear();
    for (const NodeShape& shape : layout.nodes)
        moment.nodes.push_back(value_of(now, vehicle, graph.nodes[shape.node], shape));
    for (const WireShape& shape : layout.wires) {
        if (shape.wire < 0) {
            moment.learned.push_back(0);
            moment.carried.push_back(0);
            continue;
        }
        const auto learner = static_cast<std::size_t>(vehicle.first_neuron + vehicle.neuron_count + shape.learner);
        const bool learnt = shape.learner >= 0 && learner < now.neurons.size();
        moment.learned.push_back(learnt ? now.neurons[learner] : 0);
        moment.carried.push_back(
            signal(graph.wires[static_cast<std::size_t>(shape.wire)], moment.nodes[shape.from], moment.learned.back()));
    }
}

}  // namespace braitenlab

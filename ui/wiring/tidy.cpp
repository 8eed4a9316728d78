#include "ui/wiring/tidy.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace braitenlab {
namespace {

constexpr float column_gap = 256, row_gap = 132;  // between centres
constexpr float outer_room = 36;                  // more beside the sensors and the motors, whose cards are wider
constexpr float direct_gap = 520;                 // from sensors to motors when nothing stands between them
constexpr float direct_spread = 300;              // from the left eye to the right one, at least
constexpr std::size_t rows_at_least = 6;          // a longer column is broken into several

// As many rows as make many columns about as wide as high.
std::size_t rows_at_most(std::size_t neurons) {
    return std::max(rows_at_least, static_cast<std::size_t>(std::sqrt(static_cast<double>(neurons) * 1.3)));
}

// Left above, right below, what has no side between.
int side(const Node& node) {
    if (node.name.empty()) return 1;
    return node.name.back() == 'L' ? 0 : node.name.back() == 'R' ? 2 : 1;
}

std::vector<const Node*> of_kind(const BrainGraph& graph, NodeKind kind) {
    std::vector<const Node*> found;
    for (const Node& node : graph.nodes)
        if (node.kind == kind) found.push_back(&node);
    std::sort(found.begin(), found.end(),
              [](const Node* a, const Node* b) { return side(*a) != side(*b) ? side(*a) < side(*b) : a->id < b->id; });
    return found;
}

// How many wires a signal crosses from the nearest sensor; 1 for a neuron that no sensor reaches.
std::map<NodeId, int> depths(const BrainGraph& graph) {
    std::map<NodeId, int> depth;
    std::vector<NodeId> edge;
    for (const Node& node : graph.nodes)
        if (node.kind == NodeKind::sensor) depth[node.id] = 0, edge.push_back(node.id);
    for (std::size_t i = 0; i < edge.size(); ++i)
        for (const Wire& wire : graph.wires) {
            if (wire.from != edge[i] || wire.weight == 0 || depth.count(wire.to) > 0) continue;
            depth[wire.to] = depth[edge[i]] + 1;
            edge.push_back(wire.to);
        }
    for (const Node& node : graph.nodes)
        if (node.kind == NodeKind::neuron) depth.try_emplace(node.id, 1);
    return depth;
}

std::vector<std::vector<NodeId>> hidden_columns(const BrainGraph& graph) {
    const auto depth = depths(graph);
    std::map<int, std::vector<NodeId>> by_depth;
    for (const Node* node : of_kind(graph, NodeKind::neuron)) by_depth[depth.at(node->id)].push_back(node->id);
    std::vector<std::vector<NodeId>> columns;
    for (const auto& [steps, ids] : by_depth) {
        const std::size_t most = rows_at_most(depth.size());
        const std::size_t parts = (ids.size() + most - 1) / most;
        const std::size_t rows = (ids.size() + parts - 1) / parts;
        for (std::size_t first = 0; first < ids.size(); first += rows)
            columns.emplace_back(ids.begin() + static_cast<std::ptrdiff_t>(first),
                                 ids.begin() + static_cast<std::ptrdiff_t>(std::min(first + rows, ids.size())));
    }
    return columns;
}

void place_column(Places& places, const std::vector<NodeId>& ids, float x, float height) {
    const auto count = ids.size();
    for (std::size_t i = 0; i < count; ++i) {
        const float share = count > 1 ? static_cast<float>(i) / static_cast<float>(count - 1) : 0.5f;
        places[ids[i]] = {x, (share - 0.5f) * height};
    }
}

// A neuron stands near the height of what feeds it, so that wires cross less.
void order_by_sources(const BrainGraph& graph, const Places& placed, std::vector<NodeId>& ids) {
    std::map<NodeId, float> height;
    for (const NodeId id : ids) {
        float sum = 0, count = 0;
        for (const Wire& wire : graph.wires)
            if (const auto source = placed.find(wire.from); wire.to == id && wire.weight != 0 && source != placed.end())
                sum += source->second.y, count += 1;
        height[id] = count > 0 ? sum / count : 0;
    }
    std::stable_sort(ids.begin(), ids.end(), [&](NodeId a, NodeId b) { return height[a] < height[b]; });
}

}  // namespace

Places tidy(const BrainGraph& graph) {
    auto columns = hidden_columns(graph);
    std::vector<NodeId> sensors, motors;
    for (const Node* node : of_kind(graph, NodeKind::sensor)) sensors.push_back(node->id);
    for (const Node* node : of_kind(graph, NodeKind::motor)) motors.push_back(node->id);

    std::size_t rows = 0;
    for (const auto& column : columns) rows = std::max(rows, column.size());
    const auto height_of = [](std::size_t count) { return static_cast<float>(count > 0 ? count - 1 : 0) * row_gap; };
    // The outer columns reach beyond the inner ones, so that the direct wires LL and RR run past the hidden neurons.
    const float outer = std::max({direct_spread, rows > 0 ? height_of(rows) + 1.5f * row_gap : 0,
                                  height_of(sensors.size()), height_of(motors.size())});
    Places places;
    place_column(places, sensors, 0, outer);
    float x = 0;
    for (auto& column : columns) {
        x += x == 0 ? column_gap + outer_room : column_gap;
        order_by_sources(graph, places, column);
        place_column(places, column, x, height_of(column.size()));
    }
    // A tall column stands far from the motors, or its wires are so steep that they and their labels crowd.
    place_column(places, motors, std::max({x + column_gap + outer_room, direct_gap, outer}), outer);
    return places;
}

}  // namespace braitenlab

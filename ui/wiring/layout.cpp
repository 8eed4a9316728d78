#include "ui/wiring/layout.h"

#include <algorithm>
#include <cmath>

namespace braitenlab {
namespace {

using maths::vec2;

constexpr float column_gap = 256, row_gap = 132;  // between centres
constexpr float outer_room = 36;                  // more beside the sensors and the motors, whose cards are wider
constexpr float direct_gap = 520;                 // from sensors to motors when nothing stands between them
constexpr float direct_spread = 300;              // from the left eye to the right one, at least
constexpr std::size_t rows_at_most = 6;           // a longer column is broken into several
constexpr float arrival_gap = 18;                 // between wires that arrive at one pin

vec2 size_of(NodeKind kind) { return kind == NodeKind::neuron ? vec2{150, 80} : vec2{204, 100}; }

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
        const std::size_t parts = (ids.size() + rows_at_most - 1) / rows_at_most;
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

Places arrange(const BrainGraph& graph) {
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

void place_nodes(Layout& layout, const BrainGraph& graph, const Places& moved) {
    const Places arranged = arrange(graph);
    const bool has_neurons = !of_kind(graph, NodeKind::neuron).empty();
    for (const Node& node : graph.nodes) {
        NodeShape shape;
        shape.id = node.id, shape.kind = node.kind, shape.size = size_of(node.kind);
        const auto own = moved.find(node.id);
        shape.centre = own != moved.end() ? own->second : arranged.at(node.id);
        shape.has_in = node.kind != NodeKind::sensor;
        // A motor can feed neurons; where there is none, a pin would only raise questions.
        shape.has_out = node.kind != NodeKind::motor || has_neurons;
        layout.nodes.push_back(shape);
        const vec2 half = shape.size / 2;
        const vec2 low = shape.centre - half, high = shape.centre + half;
        const bool first = layout.nodes.size() == 1;
        layout.low = first ? low : vec2{std::min(layout.low.x, low.x), std::min(layout.low.y, low.y)};
        layout.high = first ? high : vec2{std::max(layout.high.x, high.x), std::max(layout.high.y, high.y)};
    }
}

void list_wires(Layout& layout, const BrainGraph& graph) {
    std::vector<WireEnds> all;
    for (const Dial dial : weight_dials)
        if (const auto ends = direct_ends(graph, dial)) all.push_back(*ends);
    const std::size_t direct = all.size();
    for (const Wire& wire : graph.wires) {
        const WireEnds ends{wire.from, wire.to};
        if (std::find(all.begin(), all.end(), ends) == all.end()) all.push_back(ends);
    }
    std::sort(all.begin() + static_cast<std::ptrdiff_t>(direct), all.end());
    for (std::size_t i = 0; i < all.size(); ++i) {
        WireShape shape;
        shape.ends = all[i];
        shape.direct = i < direct;
        shape.ghost = weight_of(graph, all[i]) == 0;
        shape.label_size = shape.direct ? vec2{108, 34} : vec2{72, 28};
        if (find_shape(layout, all[i].from) != nullptr && find_shape(layout, all[i].to) != nullptr)
            layout.wires.push_back(shape);
    }
}

// Wires that end at one pin arrive one below the other, in the order of their sources.
void draw_curves(Layout& layout) {
    for (NodeShape& node : layout.nodes) {
        std::vector<std::pair<vec2, WireShape*>> arriving;
        for (WireShape& wire : layout.wires)
            if (wire.ends.to == node.id) arriving.emplace_back(find_shape(layout, wire.ends.from)->out_pin(), &wire);
        std::stable_sort(arriving.begin(), arriving.end(),
                         [](const auto& a, const auto& b) { return a.first.y < b.first.y; });
        const auto gaps = static_cast<float>(arriving.empty() ? 0 : arriving.size() - 1);
        node.in_spread = std::min(gaps * arrival_gap, node.size.y - 28);
        for (std::size_t i = 0; i < arriving.size(); ++i) {
            const float share = gaps > 0 ? static_cast<float>(i) / gaps - 0.5f : 0;
            const vec2 end = node.in_pin() + vec2{-8, share * node.in_spread};  // 8: the pin's own radius
            arriving[i].second->bezier = wire_curve(arriving[i].first, end);
        }
    }
}

bool overlap(vec2 a, vec2 a_size, vec2 b, vec2 b_size) {
    return std::abs(a.x - b.x) * 2 < a_size.x + b_size.x && std::abs(a.y - b.y) * 2 < a_size.y + b_size.y;
}

bool covered(const Layout& layout, std::size_t index, vec2 at, vec2 size) {
    for (std::size_t i = 0; i < index; ++i)
        if (overlap(at, size, layout.wires[i].label, layout.wires[i].label_size)) return true;
    return std::any_of(layout.nodes.begin(), layout.nodes.end(),
                       [&](const NodeShape& node) { return overlap(at, size, node.centre, node.size); });
}

// In the middle, or at a third of a wire that climbs or falls, since crossing wires meet at the middle; from there the
// nearest place along the wire that covers no card and none of the labels before it.
void place_label(const Layout& layout, std::size_t index, WireShape& wire) {
    const bool climbs = std::abs(wire.bezier[3].y - wire.bezier[0].y) > 80;
    const float wanted = climbs ? 0.3f : 0.5f;
    wire.label = bezier_point(wire.bezier, wanted);
    for (int i = 0; i < 32; ++i) {
        const float t = wanted + (i % 2 == 0 ? 0.03f : -0.03f) * static_cast<float>((i + 1) / 2);
        if (t < 0.12f || t > 0.88f) continue;
        const vec2 at = bezier_point(wire.bezier, t);
        if (covered(layout, index, at, wire.label_size + vec2{8, 6})) continue;
        wire.label = at;
        return;
    }
}

}  // namespace

Layout lay_out(const BrainGraph& graph, const Places& moved) {
    Layout layout;
    place_nodes(layout, graph, moved);
    list_wires(layout, graph);
    draw_curves(layout);
    for (std::size_t i = 0; i < layout.wires.size(); ++i) place_label(layout, i, layout.wires[i]);
    return layout;
}

const NodeShape* find_shape(const Layout& layout, NodeId id) {
    for (const NodeShape& node : layout.nodes)
        if (node.id == id) return &node;
    return nullptr;
}

const WireShape* find_shape(const Layout& layout, WireEnds ends) {
    for (const WireShape& wire : layout.wires)
        if (wire.ends == ends) return &wire;
    return nullptr;
}

std::array<vec2, 4> wire_curve(vec2 from, vec2 to) {
    const vec2 along = to - from;
    if (along.x > 40) {
        const float reach = std::max(60.0f, along.x / 2);
        return {from, from + vec2{reach, 0}, to - vec2{reach, 0}, to};
    }
    const float reach = 110, rise = -150 - std::abs(along.x) * 0.1f;
    return {from, from + vec2{reach, rise}, to + vec2{-reach, rise}, to};
}

vec2 bezier_point(const std::array<vec2, 4>& b, float t) {
    const float s = 1 - t;
    return b[0] * (s * s * s) + b[1] * (3 * s * s * t) + b[2] * (3 * s * t * t) + b[3] * (t * t * t);
}

}  // namespace braitenlab

#include "ui/wiring/layout.h"

#include <algorithm>
#include <cmath>

#include "ui/wiring/occupied.h"

namespace braitenlab {
namespace {

using maths::vec2;

constexpr float arrival_gap = 18;  // between wires that arrive at one pin

vec2 lower(vec2 a, vec2 b) { return {std::min(a.x, b.x), std::min(a.y, b.y)}; }
vec2 upper(vec2 a, vec2 b) { return {std::max(a.x, b.x), std::max(a.y, b.y)}; }

void number_neurons(Layout& layout) {
    int unit = 0;
    for (const auto& [id, index] : layout.by_id)
        if (layout.nodes[index].kind == NodeKind::neuron) layout.nodes[index].unit = unit++;
    layout.has_neurons = unit > 0;
}

// In the hand, else where a person has put it.
std::optional<vec2> own_place(const Node& node, const Places& held) {
    const auto in_hand = held.find(node.id);
    return in_hand != held.end() ? std::optional(in_hand->second) : node.place;
}

void place_nodes(Layout& layout, const BrainGraph& graph, const Places& held) {
    const auto is_put = [&](const Node& node) { return own_place(node, held).has_value(); };
    const bool all_put = std::all_of(graph.nodes.begin(), graph.nodes.end(), is_put);
    const Places arranged = all_put ? Places{} : tidy(graph);
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
        const Node& node = graph.nodes[i];
        NodeShape shape;
        shape.id = node.id, shape.kind = node.kind, shape.size = card_size(node.kind), shape.node = i;
        const auto own = own_place(node, held);
        shape.centre = own ? *own : arranged.at(node.id);
        shape.has_in = node.kind != NodeKind::sensor;
        layout.by_id.emplace_back(node.id, i);
        const vec2 half = shape.size / 2;
        layout.low = i == 0 ? shape.centre - half : lower(layout.low, shape.centre - half);
        layout.high = i == 0 ? shape.centre + half : upper(layout.high, shape.centre + half);
        layout.nodes.push_back(shape);
    }
    std::sort(layout.by_id.begin(), layout.by_id.end());
    number_neurons(layout);
    // A motor can feed neurons; where there is none, a pin would only raise questions.
    for (NodeShape& shape : layout.nodes) shape.has_out = shape.kind != NodeKind::motor || layout.has_neurons;
}

// The direct places, then every other wire by its ends.
std::vector<WireShape> wires_in_order(const BrainGraph& graph) {
    std::map<WireEnds, WireShape> by_ends;
    int learner = 0;
    for (std::size_t i = 0; i < graph.wires.size(); ++i) {
        WireShape& shape = by_ends[{graph.wires[i].from, graph.wires[i].to}];
        shape.wire = static_cast<int>(i);
        shape.ghost = graph.wires[i].weight == 0 && !learns(graph.wires[i]);
    }
    for (auto& [ends, shape] : by_ends) {
        shape.ends = ends;
        if (learns(graph.wires[static_cast<std::size_t>(shape.wire)])) shape.learner = learner++;
    }
    std::vector<WireShape> all;
    for (const Dial dial : weight_dials) {
        const auto ends = direct_ends(graph, dial);
        if (!ends) continue;
        WireShape shape;
        shape.ghost = true;
        if (const auto made = by_ends.find(*ends); made != by_ends.end()) shape = made->second, by_ends.erase(made);
        shape.ends = *ends, shape.direct = true;
        all.push_back(shape);
    }
    for (const auto& [ends, shape] : by_ends) all.push_back(shape);
    return all;
}

void list_wires(Layout& layout, const BrainGraph& graph) {
    for (WireShape& shape : wires_in_order(graph)) {
        const NodeShape *from = find_shape(layout, shape.ends.from), *to = find_shape(layout, shape.ends.to);
        if (from == nullptr || to == nullptr) continue;
        shape.from = static_cast<std::size_t>(from - layout.nodes.data());
        shape.to = static_cast<std::size_t>(to - layout.nodes.data());
        shape.label_size = shape.direct ? vec2{108, 34} : vec2{72, 28};
        layout.wires.push_back(shape);
    }
}

// Wires that end at one pin arrive one below the other, in the order of their sources.
void draw_curves(Layout& layout) {
    std::vector<std::vector<WireShape*>> arriving(layout.nodes.size());
    for (WireShape& wire : layout.wires) arriving[wire.to].push_back(&wire);
    const auto start = [&](const WireShape* wire) { return layout.nodes[wire->from].out_pin(); };
    for (std::size_t n = 0; n < layout.nodes.size(); ++n) {
        NodeShape& node = layout.nodes[n];
        std::stable_sort(arriving[n].begin(), arriving[n].end(),
                         [&](const WireShape* a, const WireShape* b) { return start(a).y < start(b).y; });
        const auto gaps = static_cast<float>(arriving[n].empty() ? 0 : arriving[n].size() - 1);
        node.in_spread = std::min(gaps * arrival_gap, node.size.y - 28);
        for (std::size_t i = 0; i < arriving[n].size(); ++i) {
            const float share = gaps > 0 ? static_cast<float>(i) / gaps - 0.5f : 0;
            const vec2 end = node.in_pin() + vec2{-8, share * node.in_spread};  // 8: the pin's own radius
            arriving[n][i]->bezier = wire_curve(start(arriving[n][i]), end);
        }
    }
}

// In the middle, or at a third of a wire that climbs or falls, since crossing wires meet at the middle; from there the
// nearest place along the wire that covers no card and none of the labels before it.
void place_label(const Occupied& taken, WireShape& wire) {
    const bool climbs = std::abs(wire.bezier[3].y - wire.bezier[0].y) > 80;
    const float wanted = climbs ? 0.3f : 0.5f;
    wire.label = bezier_point(wire.bezier, wanted);
    for (int i = 0; i < 32; ++i) {
        const float t = wanted + (i % 2 == 0 ? 0.03f : -0.03f) * static_cast<float>((i + 1) / 2);
        if (t < 0.12f || t > 0.88f) continue;
        const vec2 at = bezier_point(wire.bezier, t);
        if (taken.touches(at, wire.label_size + vec2{8, 6})) continue;
        wire.label = at;
        return;
    }
}

void place_labels(Layout& layout) {
    Occupied taken;
    for (const NodeShape& node : layout.nodes) taken.add(node.centre, node.size);
    for (WireShape& wire : layout.wires) {
        place_label(taken, wire);
        taken.add(wire.label, wire.label_size);
        wire.low = wire.label - wire.label_size / 2, wire.high = wire.label + wire.label_size / 2;
        for (const vec2 corner : wire.bezier) wire.low = lower(wire.low, corner), wire.high = upper(wire.high, corner);
    }
}

}  // namespace

Layout lay_out(const BrainGraph& graph, const Places& held) {
    Layout layout;
    place_nodes(layout, graph, held);
    list_wires(layout, graph);
    draw_curves(layout);
    place_labels(layout);
    return layout;
}

const Layout& KeptLayout::of(const std::shared_ptr<const BrainGraph>& graph, const Places& held) {
    if (graph_ != graph || held_ != held) {
        layout_ = lay_out(*graph, held);
        graph_ = graph;
        held_ = held;
    }
    return layout_;
}

vec2 card_size(NodeKind kind) { return kind == NodeKind::neuron ? vec2{150, 80} : vec2{204, 100}; }

vec2 free_place(const Layout& layout, vec2 wanted, vec2 size) {
    Occupied taken;
    for (const NodeShape& node : layout.nodes) taken.add(node.centre, node.size);
    for (const WireShape& wire : layout.wires) taken.add(wire.label, wire.label_size);
    constexpr float step = 28;  // between tries
    constexpr int rings = 40;
    for (int ring = 0; ring <= rings; ++ring) {
        std::optional<vec2> best;
        for (int x = -ring; x <= ring; ++x)
            for (int y = -ring; y <= ring; ++y) {
                if (std::max(std::abs(x), std::abs(y)) != ring) continue;
                const vec2 at = wanted + vec2{static_cast<float>(x), static_cast<float>(y)} * step;
                const bool nearer = !best || maths::distance(at, wanted) < maths::distance(*best, wanted);
                if (nearer && !taken.touches(at, size)) best = at;
            }
        if (best) return *best;
    }
    return wanted;
}

BrainGraph placed(BrainGraph graph, const Layout& shown) {
    for (Node& node : graph.nodes)
        if (const NodeShape* shape = find_shape(shown, node.id)) node.place = shape->centre;
    return graph;
}

BrainGraph in_place(BrainGraph edited, const Layout& shown) {
    const auto shape_of = [&](const Node& node) { return find_shape(shown, node.id); };
    const Places arranged = tidy(edited);
    const auto would_move = [&](const Node& node) {
        const NodeShape* shape = shape_of(node);
        return shape != nullptr && (node.place ? *node.place : arranged.at(node.id)) != shape->centre;
    };
    if (std::any_of(edited.nodes.begin(), edited.nodes.end(), would_move))
        for (Node& node : edited.nodes)
            if (const NodeShape* shape = shape_of(node)) node.place = shape->centre;
    return edited;
}

const NodeShape* find_shape(const Layout& layout, NodeId id) {
    const auto found = std::lower_bound(layout.by_id.begin(), layout.by_id.end(), std::pair(id, std::size_t{0}));
    return found == layout.by_id.end() || found->first != id ? nullptr : &layout.nodes[found->second];
}

const WireShape* find_shape(const Layout& layout, WireEnds ends) {
    const auto found = std::find_if(layout.wires.begin(), layout.wires.end(),
                                    [&](const WireShape& wire) { return wire.ends == ends; });
    return found == layout.wires.end() ? nullptr : &*found;
}

std::string name_of(const BrainGraph& graph, const Layout& layout, const WireShape& shape) {
    if (shape.direct) return wire_name(graph, shape.ends);
    return graph.nodes[layout.nodes[shape.from].node].name + "-" + graph.nodes[layout.nodes[shape.to].node].name;
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

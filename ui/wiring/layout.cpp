#include "ui/wiring/layout.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/brain/four_neurons.h"

namespace braitenlab::wiring {

namespace {

using maths::vec2;

constexpr float end_gap = 18;      // between wires that end at one pin
constexpr float one_column = 380;  // a wire that runs farther back would cross the cards in between
constexpr float rows_apart = 110;  // from one node to another with room for a wire between their cards

vec2 lower(vec2 a, vec2 b) { return {std::min(a.x, b.x), std::min(a.y, b.y)}; }
vec2 upper(vec2 a, vec2 b) { return {std::max(a.x, b.x), std::max(a.y, b.y)}; }

void number_neurons(Layout& layout) {
    int unit = 0;
    for (const auto& [id, index] : layout.by_id)
        if (layout.nodes[index].kind == NodeKind::neuron) layout.nodes[index].unit = unit++;
    layout.has_neurons = unit > 0;
}

std::optional<vec2> own_position(const Node& node, const Positions& held) {
    const auto found = held.find(node.id);
    return found != held.end() ? std::optional(found->second) : node.place;
}

void add_nodes(Layout& layout, const BrainGraph& graph, const Positions& held) {
    const auto has_position = [&](const Node& node) { return own_position(node, held).has_value(); };
    const bool all_have = std::all_of(graph.nodes.begin(), graph.nodes.end(), has_position);
    const Positions arranged = all_have ? Positions{} : tidy(graph);
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
        const Node& node = graph.nodes[i];
        NodeShape shape;
        shape.id = node.id, shape.kind = node.kind, shape.size = card_size(node.kind), shape.node = i;
        if (node.kind == NodeKind::neuron) shape.size.x = layout.room.neuron_width;
        const auto own = own_position(node, held);
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
    // A motor can feed neurons only.
    for (NodeShape& shape : layout.nodes) shape.has_out = shape.kind != NodeKind::motor || layout.has_neurons;
}

// The four direct places, then all other wires by their ends.
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

void add_wires(Layout& layout, const BrainGraph& graph) {
    for (WireShape& shape : wires_in_order(graph)) {
        const NodeShape *from = find_shape(layout, shape.ends.from), *to = find_shape(layout, shape.ends.to);
        if (from == nullptr || to == nullptr) continue;
        shape.from = static_cast<std::size_t>(from - layout.nodes.data());
        shape.to = static_cast<std::size_t>(to - layout.nodes.data());
        // The label of a learning wire also shows what it has learned.
        const bool has_learned = shape.wire >= 0 && learns(graph.wires[static_cast<std::size_t>(shape.wire)]);
        constexpr float much = 1.5f;  // between enlarged letters and the rim of their label there is less room
        const bool is_tight = layout.room.label_growth > much;
        shape.label_size = shape.direct ? vec2{108, 34} : is_tight ? vec2{58, 23} : vec2{72, 28};
        if (has_learned) shape.label_size.x += 60;
        const std::vector<NodeId>& aside = layout.room.aside;
        shape.aside = !shape.direct && std::find(aside.begin(), aside.end(), shape.ends.from) != aside.end();
        const bool has_label = !shape.aside && (!shape.ghost || layout.room.has_free_labels);
        shape.label_size = shape.label_size * (has_label ? layout.room.label_growth : 0);
        layout.wires.push_back(shape);
    }
}

// Wires that end at one pin end one below the other, in the vertical order of their starts.
void shape_curves(Layout& layout) {
    std::vector<std::vector<WireShape*>> ending(layout.nodes.size());
    for (WireShape& wire : layout.wires) ending[wire.to].push_back(&wire);
    const auto start = [&](const WireShape* wire) { return layout.nodes[wire->from].out_pin(); };
    for (std::size_t n = 0; n < layout.nodes.size(); ++n) {
        NodeShape& node = layout.nodes[n];
        std::stable_sort(ending[n].begin(), ending[n].end(),
                         [&](const WireShape* a, const WireShape* b) { return start(a).y < start(b).y; });
        const auto gaps = static_cast<float>(ending[n].empty() ? 0 : ending[n].size() - 1);
        node.in_spread = std::min(gaps * end_gap, node.size.y - 28);
        for (std::size_t i = 0; i < ending[n].size(); ++i) {
            const float share = gaps > 0 ? static_cast<float>(i) / gaps - 0.5f : 0;
            const vec2 end = node.in_pin() + vec2{-8, share * node.in_spread};  // 8: the pin's radius
            ending[n][i]->bezier = wire_curve(start(ending[n][i]), end);
        }
    }
}

// The position nearest to `wanted` where a label covers no card and no earlier label, if there is one between the
// corners of all cards; `wanted` if there is none. A label outside would make a fitted brain smaller.
vec2 place_beside(const OccupiedBoxes& taken, vec2 wanted, vec2 size, vec2 low, vec2 high) {
    constexpr float step = 12;
    constexpr int rings = 20, rings_beyond = 6;  // beyond the first place, which is outside
    const auto is_between = [&](vec2 at) {
        return at.x - size.x / 2 >= low.x && at.x + size.x / 2 <= high.x && at.y - size.y / 2 >= low.y &&
               at.y + size.y / 2 <= high.y;
    };
    std::optional<vec2> outside;
    int last = rings;
    for (int ring = 1; ring <= last; ++ring)
        for (int i = -ring; i <= ring; ++i)
            for (const vec2 cell : {vec2{0, -1}, vec2{0, 1}, vec2{-1, 0}, vec2{1, 0}}) {
                const auto far = static_cast<float>(ring), aside = static_cast<float>(i);
                const vec2 at = wanted + (cell * far + vec2{cell.y, cell.x} * aside) * step;
                const bool is_better = is_between(at) || !outside;
                if (!is_better || taken.overlaps(at, size)) continue;
                if (is_between(at)) return at;
                outside = at, last = std::min(rings, ring + rings_beyond);
            }
    return outside.value_or(wanted);
}

// At the middle, or at 0.3 of a steep wire because crossing wires meet at the middle; from there the nearest point
// along the wire where the label covers no card and no earlier label. If there is none on the wire, beside it.
void place_label(const OccupiedBoxes& taken, const Layout& layout, WireShape& wire, bool may_leave_wire) {
    const bool climbs = std::abs(wire.bezier[3].y - wire.bezier[0].y) > 80;
    const float wanted = climbs ? 0.3f : 0.5f;
    wire.label = bezier_point(wire.bezier, wanted);
    if (wire.label_size.x <= 0) return;
    for (int i = 0; i < 32; ++i) {
        const float t = wanted + (i % 2 == 0 ? 0.03f : -0.03f) * static_cast<float>((i + 1) / 2);
        if (t < 0.12f || t > 0.88f) continue;
        const vec2 at = bezier_point(wire.bezier, t);
        if (taken.overlaps(at, wire.label_size + vec2{8, 6})) continue;
        wire.label = at;
        return;
    }
    if (may_leave_wire)
        wire.label = place_beside(taken, wire.label, wire.label_size + vec2{8, 6}, layout.low, layout.high);
}

void place_labels(Layout& layout) {
    constexpr std::size_t many_wires = 200;  // the search beside so many wires takes too long for a drag
    OccupiedBoxes taken;
    for (const NodeShape& node : layout.nodes) taken.add(node.centre, node.size);
    for (WireShape& wire : layout.wires) {
        place_label(taken, layout, wire, layout.wires.size() <= many_wires);
        if (wire.label_size.x > 0) taken.add(wire.label, wire.label_size);
        wire.low = wire.label - wire.label_size / 2, wire.high = wire.label + wire.label_size / 2;
        for (const vec2 corner : wire.bezier) wire.low = lower(wire.low, corner), wire.high = upper(wire.high, corner);
    }
}

constexpr float cell_size = 128;  // units; about as large as a card

// Calls the visitor for every cell that the box overlaps, until it returns true.
template <class Visitor>
bool visit_cells(vec2 centre, vec2 size, Visitor visitor) {
    const auto cell = [](float at) { return static_cast<std::int32_t>(std::floor(at / cell_size)); };
    for (std::int32_t x = cell(centre.x - size.x / 2); x <= cell(centre.x + size.x / 2); ++x)
        for (std::int32_t y = cell(centre.y - size.y / 2); y <= cell(centre.y + size.y / 2); ++y)
            if (visitor(std::uint64_t{static_cast<std::uint32_t>(x)} << 32U | static_cast<std::uint32_t>(y)))
                return true;
    return false;
}

}  // namespace

Layout lay_out(const BrainGraph& graph, const Positions& held, const LetterRoom& room) {
    Layout layout;
    layout.room = room;
    add_nodes(layout, graph, held);
    add_wires(layout, graph);
    shape_curves(layout);
    place_labels(layout);
    return layout;
}

const Layout& LayoutCache::get(const std::shared_ptr<const BrainGraph>& graph, const Positions& held,
                               const LetterRoom& room) {
    if (graph_ != graph || held_ != held || layout_.room != room) {
        layout_ = lay_out(*graph, held, room);
        graph_ = graph;
        held_ = held;
    }
    return layout_;
}

vec2 card_size(NodeKind kind) { return kind == NodeKind::neuron ? vec2{150, 80} : vec2{204, 100}; }

vec2 free_position(const Layout& layout, vec2 wanted, vec2 size) {
    OccupiedBoxes taken;
    for (const NodeShape& node : layout.nodes) taken.add(node.centre, node.size);
    for (const WireShape& wire : layout.wires)
        if (wire.label_size.x > 0) taken.add(wire.label, wire.label_size);
    constexpr float step = 28;  // between tries
    constexpr int rings = 40;
    for (int ring = 0; ring <= rings; ++ring) {
        std::optional<vec2> best;
        for (int x = -ring; x <= ring; ++x)
            for (int y = -ring; y <= ring; ++y) {
                if (std::max(std::abs(x), std::abs(y)) != ring) continue;
                const vec2 at = wanted + vec2{static_cast<float>(x), static_cast<float>(y)} * step;
                const bool nearer = !best || maths::distance(at, wanted) < maths::distance(*best, wanted);
                if (nearer && !taken.overlaps(at, size)) best = at;
            }
        if (best) return *best;
    }
    return wanted;
}

BrainGraph with_positions(BrainGraph graph, const Layout& shown) {
    for (Node& node : graph.nodes)
        if (const NodeShape* shape = find_shape(shown, node.id)) node.place = shape->centre;
    return graph;
}

BrainGraph keep_positions(BrainGraph edited, const Layout& shown) {
    const Positions arranged = tidy(edited);
    const auto would_move = [&](const Node& node) {
        const NodeShape* shape = find_shape(shown, node.id);
        return shape != nullptr && (node.place ? *node.place : arranged.at(node.id)) != shape->centre;
    };
    const bool moves = std::any_of(edited.nodes.begin(), edited.nodes.end(), would_move);
    return moves ? with_positions(std::move(edited), shown) : edited;
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
    const float reach = 110;
    if (std::abs(along.y) > rows_apart && along.x > -one_column) {  // turns at half the height, between the cards
        const vec2 out{reach, along.y * 0.75f};
        return {from, from + out, to - out, to};
    }
    const float rise = -150 - std::abs(along.x) * 0.1f;
    return {from, from + vec2{reach, rise}, to + vec2{-reach, rise}, to};
}

vec2 bezier_point(const std::array<vec2, 4>& b, float t) {
    const float s = 1 - t;
    return b[0] * (s * s * s) + b[1] * (3 * s * s * t) + b[2] * (3 * s * t * t) + b[3] * (t * t * t);
}

void OccupiedBoxes::add(vec2 centre, vec2 size) {
    visit_cells(centre, size, [&](std::uint64_t cell) {
        cells_[cell].push_back({centre, size});
        return false;
    });
}

bool OccupiedBoxes::overlaps(vec2 centre, vec2 size) const {
    return visit_cells(centre, size, [&](std::uint64_t cell) {
        const auto found = cells_.find(cell);
        if (found == cells_.end()) return false;
        for (const Box& box : found->second)
            if (std::abs(centre.x - box.centre.x) * 2 < size.x + box.size.x &&
                std::abs(centre.y - box.centre.y) * 2 < size.y + box.size.y)
                return true;
        return false;
    });
}

}  // namespace braitenlab::wiring

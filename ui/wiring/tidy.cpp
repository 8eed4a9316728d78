#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/brain/fragment.h"
#include "ui/wiring/layout.h"

namespace braitenlab::wiring {

namespace {

using maths::vec2;

constexpr float column_gap = 256, row_gap = 132, outer_row_gap = 116;  // between centres
constexpr float outer_room = 36;          // added beside sensors and motors, whose cards are wider
constexpr float direct_gap = 520;         // from sensors to motors without neurons between them, at least
constexpr float direct_spread = 300;      // from the first sensor to the last, at least
constexpr float slope = 1.3f;             // least width of the brain in units of its height
constexpr std::size_t rows_at_least = 6;  // a longer column is broken into several

// Rows in a column; columns of many neurons together are about as wide as high.
std::size_t rows_at_most(std::size_t neurons) {
    return std::max(rows_at_least, static_cast<std::size_t>(std::sqrt(static_cast<double>(neurons) * 1.3)));
}

// 0 for the vehicle's left side, 2 for its right side, 1 for neither.
int side_of(const Node& node) {
    if (node.name.empty()) return 1;
    return node.name.back() == 'L' ? 0 : node.name.back() == 'R' ? 2 : 1;
}

using Index = std::size_t;  // in BrainGraph::nodes

// A wire with a weight, as indices of its nodes: ids are looked up once, not once per column.
struct Feed {
    Index from, to;
};

std::vector<Feed> feeds_of(const BrainGraph& graph) {
    std::vector<std::pair<NodeId, Index>> by_id;
    for (Index i = 0; i < graph.nodes.size(); ++i) by_id.emplace_back(graph.nodes[i].id, i);
    std::sort(by_id.begin(), by_id.end());
    const auto index_of = [&](NodeId id) {
        const auto found = std::lower_bound(by_id.begin(), by_id.end(), std::pair(id, Index{0}));
        return found != by_id.end() && found->first == id ? found->second : graph.nodes.size();
    };
    std::vector<Feed> feeds;
    for (const Wire& wire : graph.wires) {
        const Feed feed{index_of(wire.from), index_of(wire.to)};
        if (wire.weight != 0 && feed.from < graph.nodes.size() && feed.to < graph.nodes.size()) feeds.push_back(feed);
    }
    return feeds;
}

std::vector<Index> of_kind(const BrainGraph& graph, NodeKind kind) {
    std::vector<Index> found;
    for (Index i = 0; i < graph.nodes.size(); ++i)
        if (graph.nodes[i].kind == kind) found.push_back(i);
    std::sort(found.begin(), found.end(), [&](Index a, Index b) {
        const Node &one = graph.nodes[a], &other = graph.nodes[b];
        return side_of(one) != side_of(other) ? side_of(one) < side_of(other) : one.id < other.id;
    });
    return found;
}

// For every node the least number of wires from a sensor; 1 for a neuron that no sensor reaches.
std::vector<int> depths(const BrainGraph& graph, const std::vector<Feed>& feeds) {
    constexpr int unreached = -1;
    std::vector<int> depth(graph.nodes.size(), unreached);
    for (Index i = 0; i < graph.nodes.size(); ++i)
        if (graph.nodes[i].kind == NodeKind::sensor) depth[i] = 0;
    bool grows = true;
    for (int reached = 0; grows; ++reached) {
        grows = false;
        for (const Feed& feed : feeds)
            if (depth[feed.from] == reached && depth[feed.to] == unreached) depth[feed.to] = reached + 1, grows = true;
    }
    for (int& steps : depth) steps = steps == unreached ? 1 : steps;
    return depth;
}

std::vector<std::vector<Index>> hidden_columns(const BrainGraph& graph, const std::vector<Feed>& feeds) {
    const auto depth = depths(graph, feeds);
    std::map<int, std::vector<Index>> by_depth;
    for (const Index node : of_kind(graph, NodeKind::neuron)) by_depth[depth[node]].push_back(node);
    std::vector<std::vector<Index>> columns;
    for (const auto& [steps, nodes] : by_depth) {
        const std::size_t most = rows_at_most(graph.nodes.size());
        const std::size_t parts = (nodes.size() + most - 1) / most;
        const std::size_t rows = (nodes.size() + parts - 1) / parts;
        for (std::size_t first = 0; first < nodes.size(); first += rows)
            columns.emplace_back(nodes.begin() + static_cast<std::ptrdiff_t>(first),
                                 nodes.begin() + static_cast<std::ptrdiff_t>(std::min(first + rows, nodes.size())));
    }
    return columns;
}

using Placed = std::vector<std::optional<vec2>>;

void place_column(Placed& placed, const std::vector<Index>& nodes, float x, float height) {
    const auto count = nodes.size();
    for (std::size_t i = 0; i < count; ++i) {
        const float share = count > 1 ? static_cast<float>(i) / static_cast<float>(count - 1) : 0.5f;
        placed[nodes[i]] = {std::round(x), std::round((share - 0.5f) * height)};  // whole units keep files short
    }
}

// Sorts neurons by the mean height of the nodes that feed them, so that fewer wires cross.
void order_by_sources(const std::vector<Feed>& feeds, const Placed& placed, std::vector<Index>& nodes) {
    std::vector<float> sum(placed.size(), 0.0f), count(placed.size(), 0.0f);
    for (const Feed& feed : feeds)
        if (placed[feed.from]) sum[feed.to] += placed[feed.from]->y, count[feed.to] += 1;
    const auto height = [&](Index node) { return count[node] > 0 ? sum[node] / count[node] : 0; };
    std::stable_sort(nodes.begin(), nodes.end(), [&](Index a, Index b) { return height(a) < height(b); });
}

constexpr float card_gap = 24;  // least distance between cards, units

// One coordinate: y when `down`, else x.
float& along(vec2& v, bool down) { return down ? v.y : v.x; }
float along(const vec2& v, bool down) { return down ? v.y : v.x; }

std::vector<NodeShape> sorted(const Layout& layout, const std::set<NodeId>& nodes, bool down) {
    std::vector<NodeShape> shapes;
    for (const NodeId id : nodes)
        if (const NodeShape* shape = find_shape(layout, id)) shapes.push_back(*shape);
    std::stable_sort(shapes.begin(), shapes.end(), [down](const NodeShape& a, const NodeShape& b) {
        return along(a.centre, down) < along(b.centre, down);
    });
    return shapes;
}

// Moves all to their mean coordinate across, and apart along the line where they would overlap.
void line_up(std::vector<NodeShape>& shapes, bool down) {
    float sum = 0;
    for (const NodeShape& shape : shapes) sum += along(shape.centre, !down);
    for (NodeShape& shape : shapes) along(shape.centre, !down) = sum / static_cast<float>(shapes.size());
    for (std::size_t i = 1; i < shapes.size(); ++i) {
        const float apart = (along(shapes[i - 1].size, down) + along(shapes[i].size, down)) / 2 + card_gap;
        float& at = along(shapes[i].centre, down);
        at = std::max(at, along(shapes[i - 1].centre, down) + apart);
    }
}

void spread(std::vector<NodeShape>& shapes, bool down) {
    const float first = along(shapes.front().centre, down), last = along(shapes.back().centre, down);
    const auto gaps = static_cast<float>(shapes.size() - 1);
    for (std::size_t i = 1; i + 1 < shapes.size(); ++i)
        along(shapes[i].centre, down) = first + (last - first) * static_cast<float>(i) / gaps;
}

}  // namespace

Positions tidy(const BrainGraph& graph) {
    const auto feeds = feeds_of(graph);
    auto columns = hidden_columns(graph, feeds);
    const auto sensors = of_kind(graph, NodeKind::sensor), motors = of_kind(graph, NodeKind::motor);

    std::size_t rows = 0;
    for (const auto& column : columns) rows = std::max(rows, column.size());
    const auto height_of = [](std::size_t count, float gap = row_gap) {
        return static_cast<float>(count > 0 ? count - 1 : 0) * gap;
    };
    // The outer columns are taller than the inner ones, so that the direct wires LL and RR pass the neurons.
    const float outer = std::max({direct_spread, rows > 0 ? height_of(rows) + 1.5f * row_gap : 0,
                                  height_of(sensors.size(), outer_row_gap), height_of(motors.size(), outer_row_gap)});
    Placed placed(graph.nodes.size());
    place_column(placed, sensors, 0, outer);
    float x = 0;
    for (auto& column : columns) {
        x += x == 0 ? column_gap + outer_room : column_gap;
        order_by_sources(feeds, placed, column);
        place_column(placed, column, x, height_of(column.size()));
    }
    // The width increases with the height, because steep wires and their labels are too close together.
    place_column(placed, motors, std::max({x + column_gap + outer_room, direct_gap, outer * slope}), outer);
    Positions positions;
    for (Index i = 0; i < placed.size(); ++i) positions[graph.nodes[i].id] = *placed[i];
    return positions;
}

Positions arranged(const Layout& layout, const std::set<NodeId>& nodes, Arrangement arrangement) {
    const bool down = arrangement == Arrangement::column || arrangement == Arrangement::even_down;
    const bool even = arrangement == Arrangement::even_down || arrangement == Arrangement::even_across;
    std::vector<NodeShape> shapes = sorted(layout, nodes, down);
    if (shapes.size() < (even ? 3u : 2u)) return {};
    if (even)
        spread(shapes, down);
    else
        line_up(shapes, down);
    Positions positions;
    for (const NodeShape& shape : shapes) positions[shape.id] = rounded_position(shape.centre);
    return positions;
}

}  // namespace braitenlab::wiring

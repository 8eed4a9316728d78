#include "ui/wiring/tidy.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace braitenlab {
namespace {

constexpr float column_gap = 256, row_gap = 132, outer_row_gap = 116;  // between centres
constexpr float outer_room = 36;          // more beside the sensors and the motors, whose cards are wider
constexpr float direct_gap = 520;         // from sensors to motors when nothing stands between them
constexpr float direct_spread = 300;      // from the left eye to the right one, at least
constexpr float slope = 1.3f;             // from sensors to motors at least, for every unit from the first to the last
constexpr std::size_t rows_at_least = 6;  // a longer column is broken into several

// As many rows as make many columns about as wide as high.
std::size_t rows_at_most(std::size_t neurons) {
    return std::max(rows_at_least, static_cast<std::size_t>(std::sqrt(static_cast<double>(neurons) * 1.3)));
}

// Left above, right below, what has no side between.
int side(const Node& node) {
    if (node.name.empty()) return 1;
    return node.name.back() == 'L' ? 0 : node.name.back() == 'R' ? 2 : 1;
}

using Index = std::size_t;  // in BrainGraph::nodes

// The wires that carry something, as pairs of indices: looked up once, not once a column.
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
        return side(one) != side(other) ? side(one) < side(other) : one.id < other.id;
    });
    return found;
}

// How many wires a signal crosses from the nearest sensor, node by node; 1 for a neuron that no sensor reaches.
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

using Placed = std::vector<std::optional<maths::vec2>>;

void place_column(Placed& placed, const std::vector<Index>& nodes, float x, float height) {
    const auto count = nodes.size();
    for (std::size_t i = 0; i < count; ++i) {
        const float share = count > 1 ? static_cast<float>(i) / static_cast<float>(count - 1) : 0.5f;
        placed[nodes[i]] = {std::round(x), std::round((share - 0.5f) * height)};  // whole units: short in a file
    }
}

// A neuron stands near the height of what feeds it, so that wires cross less.
void order_by_sources(const std::vector<Feed>& feeds, const Placed& placed, std::vector<Index>& nodes) {
    std::vector<float> sum(placed.size(), 0.0f), count(placed.size(), 0.0f);
    for (const Feed& feed : feeds)
        if (placed[feed.from]) sum[feed.to] += placed[feed.from]->y, count[feed.to] += 1;
    const auto height = [&](Index node) { return count[node] > 0 ? sum[node] / count[node] : 0; };
    std::stable_sort(nodes.begin(), nodes.end(), [&](Index a, Index b) { return height(a) < height(b); });
}

}  // namespace

Places tidy(const BrainGraph& graph) {
    const auto feeds = feeds_of(graph);
    auto columns = hidden_columns(graph, feeds);
    const auto sensors = of_kind(graph, NodeKind::sensor), motors = of_kind(graph, NodeKind::motor);

    std::size_t rows = 0;
    for (const auto& column : columns) rows = std::max(rows, column.size());
    const auto height_of = [](std::size_t count, float gap = row_gap) {
        return static_cast<float>(count > 0 ? count - 1 : 0) * gap;
    };
    // The outer columns reach beyond the inner ones, so that the direct wires LL and RR run past the hidden neurons.
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
    // A tall column stands far from the motors, or its wires are so steep that they and their labels crowd.
    place_column(placed, motors, std::max({x + column_gap + outer_room, direct_gap, outer * slope}), outer);
    Places places;
    for (Index i = 0; i < placed.size(); ++i) places[graph.nodes[i].id] = *placed[i];
    return places;
}

}  // namespace braitenlab

#include "render/view/deck.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/scene/sensor_edits.h"

namespace braitenlab::render {

using maths::vec2;

namespace {

// A node on the deck. Row 0 holds the sensors; rows count backwards, motors are behind all rows.
struct Placed {
    vec2 place;
    int row = 0;
    bool is_set = false;
};
using Places = std::map<NodeId, Placed>;

// End of a motor's wires: inside its first wheel; nullopt when no wheel has this motor.
std::optional<vec2> terminal(const Body& body, const std::string& motor_name) {
    const Motor motor = motor_name == "ML" ? Motor::left : motor_name == "MR" ? Motor::right : Motor::none;
    if (motor == Motor::none) return std::nullopt;
    for (const Wheel& wheel : body.wheels)
        if (wheel.motor == motor) return vec2{wheel.x - 0.10f * body.length, wheel.y * 0.52f};
    return std::nullopt;
}

bool is_shown(const Wire& wire) { return wire.weight != 0 || learns(wire); }

// Positions of sensors and motors.
Places fixed_places(const BrainGraph& brain, const Kind& kind) {
    Places places;
    for (const Node& node : brain.nodes) {
        if (node.kind == NodeKind::sensor) {
            if (const Sensor* s = find_sensor(kind.sensors, node.name))
                places[node.id] = {{s->x - 0.07f * kind.body.length, s->y * 0.86f}, 0, true};
        } else if (node.kind == NodeKind::motor) {
            if (const auto end = terminal(kind.body, node.name)) places[node.id] = {*end, 0, true};
        }
    }
    return places;
}

// Sets the neurons' rows: one behind the nearest input. Returns the number of rows.
int set_rows(const BrainGraph& brain, Places& places) {
    std::size_t kept = 0;
    for (const Node& node : brain.nodes)
        if (node.kind == NodeKind::neuron && kept++ < most_deck_neurons) places[node.id] = {};
    int rows = 0;
    for (bool found = true; found;) {
        found = false;
        for (const Wire& wire : brain.wires) {
            const auto from = places.find(wire.from), to = places.find(wire.to);
            if (!is_shown(wire) || from == places.end() || to == places.end()) continue;
            if (!from->second.is_set || to->second.is_set || from->second.row != rows) continue;
            to->second.row = rows + 1, to->second.is_set = true;
            found = true;
        }
        rows += found;
    }
    for (auto& [id, placed] : places)  // neurons without input: first row
        if (!placed.is_set) placed.row = 1, placed.is_set = true, rows = std::max(rows, 1);
    return rows;
}

// Mean lateral position, m, of a neuron's inputs in the rows before it.
float mean_input_side(const BrainGraph& brain, const Places& places, NodeId id, int row) {
    float sum = 0;
    int count = 0;
    for (const Wire& wire : brain.wires) {
        const auto from = places.find(wire.from);
        if (wire.to != id || !is_shown(wire) || from == places.end() || from->second.row >= row) continue;
        sum += from->second.place.y, ++count;
    }
    return count > 0 ? sum / static_cast<float>(count) : 0;
}

// 0 for a name that ends in L, 2 for one that ends in R, else 1.
int side_of_name(const Node& node) { return node.name.ends_with('L') ? 0 : node.name.ends_with('R') ? 2 : 1; }

// Spreads the neurons of one row across the deck; returns their distance, m.
float spread_row(const BrainGraph& brain, Places& places, int row, float x, float half_width) {
    std::vector<std::pair<float, NodeId>> across;
    for (const Node& node : brain.nodes) {
        const auto found = places.find(node.id);
        if (node.kind == NodeKind::neuron && found != places.end() && found->second.row == row)
            across.push_back({mean_input_side(brain, places, node.id, row), node.id});
    }
    // From right to left, as y points. Of several at one place the order is that of tidy() from the last to the first.
    std::stable_sort(across.begin(), across.end(), [&](const auto& a, const auto& b) {
        const auto rank = [&](NodeId id) { return std::pair(side_of_name(*find_node(brain, id)), id); };
        return a.first != b.first ? a.first < b.first : rank(a.second) > rank(b.second);
    });
    const float apart = std::min(0.14f, 2 * half_width / static_cast<float>(std::max<std::size_t>(across.size(), 1)));
    for (std::size_t i = 1; i < across.size(); ++i)
        across[i].first = std::max(across[i].first, across[i - 1].first + apart);
    const float over = across.empty() ? 0 : std::max(0.0f, across.back().first - half_width);
    for (std::size_t i = across.size(); i-- > 0;) {
        float& y = across[i].first;
        if (i + 1 == across.size())
            y -= over;
        else
            y = std::min(y, across[i + 1].first - apart);
        places[across[i].second].place = {x, y};
    }
    return apart;
}

vec2 bend_of(vec2 from, vec2 to, bool direct, float width) {
    const vec2 middle = (from + to) / 2;
    if (direct) {
        // An uncrossed wire runs along its side, a crossed one diagonally.
        const bool crossed = from.y * to.y < 0;
        return crossed ? middle + vec2{0.03f, 0} : vec2{middle.x, to.y * 1.12f};
    }
    const vec2 along = to - from;
    // Wires towards the front bend wider, to differ from those towards the axle.
    const float swing = along.x > 0 ? 0.45f : 0.10f;
    const float outwards = middle.y < 0 ? -1.0f : 1.0f;
    return {middle.x, std::clamp(middle.y + outwards * swing * std::fabs(along.x), -width, width)};
}

DeckWire run(const BrainGraph& brain, const Places& places, std::size_t i, const DeckPlan& plan, float width) {
    const Wire& wire = brain.wires[i];
    const vec2 from = places.at(wire.from).place, to = places.at(wire.to).place;
    const float r = plan.neuron_radius;
    if (wire.from == wire.to) {
        // A loop beside its neuron, on the outer side.
        const float out = from.y < 0 ? -1.0f : 1.0f;
        return {i, from + vec2{r, out * r * 0.4f}, from + vec2{-r, out * r * 0.4f}, from + vec2{0, out * r * 5}};
    }
    const bool direct =
        find_node(brain, wire.from)->kind == NodeKind::sensor && find_node(brain, wire.to)->kind == NodeKind::motor;
    const vec2 bend = bend_of(from, to, direct, width);
    // The tip is at the neuron's rim, not below it.
    const bool ends_at_neuron = find_node(brain, wire.to)->kind == NodeKind::neuron;
    const vec2 tip = ends_at_neuron ? to + maths::normalise(bend - to) * r : to;
    return {i, from, tip, bend};
}

bool is_silenced(const BrainGraph& brain, NodeKind kind, const std::string& name) {
    return std::any_of(brain.nodes.begin(), brain.nodes.end(),
                       [&](const Node& node) { return node.kind == kind && node.name == name && node.silenced; });
}

}  // namespace

DeckRows rows_on(const Body& body) { return {0.16f * body.length, -0.04f * body.length, 0.30f * body.width}; }

DeckPlan plan_deck(const BrainGraph& brain, const Kind& kind, const DeckRows& area) {
    const auto [front, back, half_width] = area;
    DeckPlan plan;
    for (const Sensor& sensor : kind.sensors) plan.covered.push_back(is_silenced(brain, NodeKind::sensor, sensor.name));
    plan.stopped = {is_silenced(brain, NodeKind::motor, "ML"), is_silenced(brain, NodeKind::motor, "MR")};
    Places places = fixed_places(brain, kind);
    const int rows = set_rows(brain, places);
    float closest = 0.14f;
    for (int row = 1; row <= rows; ++row) {
        const float t = rows > 1 ? static_cast<float>(row - 1) / static_cast<float>(rows - 1) : 0.4f;
        closest = std::min(closest, spread_row(brain, places, row, front + (back - front) * t, half_width));
    }
    if (rows > 1) closest = std::min(closest, (front - back) / static_cast<float>(rows - 1));
    plan.neuron_radius = std::clamp(0.36f * closest, 0.008f, 0.042f);
    for (const Node& node : brain.nodes)
        if (node.kind == NodeKind::neuron && places.contains(node.id))
            plan.neurons.push_back({node.id, places[node.id].place, node.silenced});

    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < brain.wires.size(); ++i)
        if (is_shown(brain.wires[i]) && places.contains(brain.wires[i].from) && places.contains(brain.wires[i].to))
            shown.push_back(i);
    if (shown.size() > most_deck_wires) {
        std::stable_sort(shown.begin(), shown.end(), [&](std::size_t a, std::size_t b) {
            return std::fabs(brain.wires[a].weight) > std::fabs(brain.wires[b].weight);
        });
        shown.resize(most_deck_wires);
        std::sort(shown.begin(), shown.end());
    }
    for (const std::size_t i : shown) plan.wires.push_back(run(brain, places, i, plan, half_width * 1.25f));
    return plan;
}

}  // namespace braitenlab::render

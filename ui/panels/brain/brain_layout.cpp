#include "ui/panels/brain/brain_layout.h"

#include <algorithm>

#include "core/brain/four_neurons.h"
#include "render/view/deck.h"

namespace braitenlab::ui::sketch {

namespace {

using maths::vec2;

struct PairWire {
    std::string_view letters;
    int sensor = 0, motor = 0;  // 0 left, 1 right
};
constexpr std::array<PairWire, 4> pair_wires{{{"LR", 1, 0}, {"RL", 0, 1}, {"LL", 0, 0}, {"RR", 1, 1}}};

constexpr std::array<std::string_view, 2> motor_names{"ML", "MR"};

bool has_effect(const Wire& wire) { return wire.weight != 0 || wire.cut || learns(wire); }

std::string lesion_anchor(std::string_view part) { return "lesion." + std::string(part); }

NodeMark mark_of(const BrainGraph& brain, std::string_view name, ImVec2 at) {
    return {find_node(brain, std::string(name)), std::string(name), lesion_anchor(name), at};
}

constexpr float row_half_width = 0.30f;  // of the neurons, in units of GraphFrame

// The frame in which plan_deck() places the graph: x points up, y to the left. Sideways, x points to the left, y up.
// The picture is wider than a deck.
struct GraphFrame {
    ImVec2 middle;
    float along = 1, across = 1;  // window pixels per unit of x and of y
    bool is_sideways = false;
    ImVec2 pixel(vec2 place) const {
        const float x = place.x * along, y = place.y * across;
        return is_sideways ? ImVec2{middle.x - x, middle.y - y} : ImVec2{middle.x - y, middle.y - x};
    }
    vec2 place(ImVec2 pixel) const {
        const float x = middle.x - pixel.x, y = middle.y - pixel.y;
        return is_sideways ? vec2{x / along, y / across} : vec2{y / along, x / across};
    }
};

// A cubic curve equal to the quadratic one of a deck wire.
WirePath cubic(ImVec2 from, ImVec2 bend, ImVec2 to) {
    const auto between = [](ImVec2 a, ImVec2 b) {
        return ImVec2{a.x + (b.x - a.x) * 2 / 3, a.y + (b.y - a.y) * 2 / 3};
    };
    return {from, between(from, bend), between(to, bend), to};
}

// The point at the rim of a neuron where a wire from `before` ends.
ImVec2 rim(ImVec2 neuron, ImVec2 before, float radius) {
    const vec2 towards = maths::normalise(vec2{before.x - neuron.x, before.y - neuron.y});
    return {neuron.x + towards.x * radius, neuron.y + towards.y * radius};
}

// A wire from a neuron to itself: a loop on the side away from the middle.
WirePath loop(ImVec2 neuron, const GraphFrame& frame, float radius) {
    const float outward = frame.is_sideways ? neuron.y - frame.middle.y : neuron.x - frame.middle.x;
    const float side = outward < 0 ? -radius : radius;
    const auto at = [&](float out, float along) {
        return frame.is_sideways ? ImVec2{neuron.x + along * radius, neuron.y + out * side}
                                 : ImVec2{neuron.x + out * side, neuron.y + along * radius};
    };
    return {at(0.8f, -0.6f), at(3.2f, -2.4f), at(3.2f, 2.4f), at(0.8f, 0.6f)};
}

// Spreads the ends of the wires to each motor, so that their signs are side by side.
void spread_ends(std::vector<WireMark>& wires, const BrainGraph& brain, const std::array<NodeMark, 2>& motors,
                 bool is_sideways, float scale) {
    float ImVec2::*const axis = is_sideways ? &ImVec2::y : &ImVec2::x;
    for (const NodeMark& motor : motors) {
        std::vector<WireMark*> ending;
        for (WireMark& each : wires)
            if (motor.node && brain.wires[static_cast<std::size_t>(each.wire)].to == motor.node->id)
                ending.push_back(&each);
        std::stable_sort(ending.begin(), ending.end(),
                         [&](const WireMark* a, const WireMark* b) { return a->path[0].*axis < b->path[0].*axis; });
        const float gap =
            std::min(14 * scale, 48 * scale / static_cast<float>(std::max<std::size_t>(ending.size(), 1)));
        for (std::size_t i = 0; i < ending.size(); ++i) {
            const float shift = (static_cast<float>(i) - static_cast<float>(ending.size() - 1) / 2) * gap;
            ending[i]->path[3].*axis += shift;
            ending[i]->path[2].*axis += shift;
        }
    }
}

WirePath path_of(const BrainLayout& parts, const render::DeckPlan& plan, const Wire& wire,
                 const render::DeckWire& planned, const GraphFrame& frame, float scale) {
    const ImVec2 from = frame.pixel(planned.from), bend = frame.pixel(planned.bend);
    const auto neuron = std::find_if(plan.neurons.begin(), plan.neurons.end(),
                                     [&](const render::DeckNeuron& each) { return each.id == wire.to; });
    if (neuron == plan.neurons.end()) return cubic(from, bend, frame.pixel(planned.to));
    const ImVec2 at = frame.pixel(neuron->place);
    const float reach = parts.neuron_radius + 3 * scale;
    if (wire.from == wire.to) return loop(at, frame, reach);
    return cubic(from, bend, rim(at, bend, reach));
}

// A flat vehicle for plan_deck(): its wires begin at `starts` and end at `ends`, window pixels.
Kind flat_vehicle(const GraphFrame& frame, std::vector<Sensor> sensors, const std::vector<ImVec2>& starts,
                  const std::array<ImVec2, 2>& ends) {
    Kind flat;
    flat.body.length = 1;
    flat.body.wheels.clear();
    for (std::size_t i = 0; i < sensors.size(); ++i) {
        // plan_deck() starts a wire at (x − 0.07 length, 0.86 y).
        const vec2 start = frame.place(starts[i]);
        sensors[i].x = start.x + 0.07f, sensors[i].y = start.y / 0.86f;
    }
    flat.sensors = std::move(sensors);
    for (std::size_t side = 0; side < 2; ++side) {
        // plan_deck() ends a wire at (x − 0.10 length, 0.52 y).
        const vec2 end = frame.place(ends[side]);
        flat.body.wheels.push_back({end.x + 0.10f, end.y / 0.52f});
        flat.body.wheels.back().motor = side == 0 ? Motor::left : Motor::right;
    }
    return flat;
}

// Adds the neurons and the wires as plan_deck() places them.
void add_graph(BrainLayout& p, const BrainGraph& brain, const SensorPair& pair, const GraphFrame& frame,
               const Kind& flat, const render::DeckRows& rows, float scale) {
    const render::DeckPlan plan = render::plan_deck(brain, flat, rows);
    p.neuron_radius = std::max(plan.neuron_radius * std::min(frame.along, frame.across), 3 * scale);
    for (const render::DeckNeuron& neuron : plan.neurons) {
        const Node& node = *find_node(brain, neuron.id);
        p.neurons.push_back({&node, node.name, lesion_anchor(node.name), frame.pixel(neuron.place)});
    }
    for (const render::DeckWire& each : plan.wires) {
        const Wire& wire = brain.wires[each.wire];
        WireMark made;
        made.wire = static_cast<int>(each.wire);
        made.letters = wire_name(brain, {wire.from, wire.to}, pair);
        made.anchor = lesion_anchor(made.letters);
        made.path = path_of(p, plan, wire, each, frame, scale);
        p.wires.push_back(std::move(made));
    }
    spread_ends(p.wires, brain, p.motors, frame.is_sideways, scale);
}

}  // namespace

std::vector<Sensor> read_sensors(const BrainGraph& brain, const Kind& kind) {
    std::vector<Sensor> read;
    for (const Sensor& sensor : kind.sensors) {
        const Node* node = find_node(brain, sensor.name);
        const auto leaves = [&](const Wire& wire) { return node && wire.from == node->id && has_effect(wire); };
        if (std::any_of(brain.wires.begin(), brain.wires.end(), leaves)) read.push_back(sensor);
    }
    std::stable_sort(read.begin(), read.end(), [](const Sensor& a, const Sensor& b) { return a.y > b.y; });
    return read;
}

bool is_four_wires(const BrainGraph& brain, const SensorPair& pair) {
    return std::all_of(brain.wires.begin(), brain.wires.end(), [&](const Wire& wire) {
        return !has_effect(wire) || direct_dial(brain, {wire.from, wire.to}, pair);
    });
}

BrainLayout lay_out_pair(const BrainGraph& brain, const SensorPair& pair, Rect area, float scale) {
    BrainLayout p;
    const float middle = area.x + area.w / 2, half = 50 * scale;
    p.chassis = {middle - half, area.y + 12 * scale, 2 * half, area.h - 24 * scale};
    for (std::size_t side = 0; side < 2; ++side) {
        const float s = side == 0 ? -1.0f : 1.0f;
        p.sensors.push_back(
            mark_of(brain, side == 0 ? pair.left : pair.right, {middle + s * 30 * scale, area.y + 16 * scale}));
        p.motors[side] = mark_of(brain, motor_names[side], {middle + s * 54 * scale, area.y + area.h - 32 * scale});
    }
    for (const PairWire& each : pair_wires) {
        const NodeMark& from = p.sensors[static_cast<std::size_t>(each.sensor)];
        const NodeMark& to = p.motors[static_cast<std::size_t>(each.motor)];
        WireMark made{-1, std::string(each.letters), lesion_anchor(each.letters)};
        const Wire* wire = from.node && to.node ? find_wire(brain, from.node->id, to.node->id) : nullptr;
        if (wire) made.wire = static_cast<int>(wire - brain.wires.data());
        // Wires end above the wheels, the uncrossed one further out, so that the end signs are side by side.
        const float inward = each.motor == 0 ? 1.0f : -1.0f;
        made.path = path({from.at.x, from.at.y + 9 * scale},
                         {to.at.x + inward * (each.sensor == each.motor ? 17 : 31) * scale, to.at.y - 2 * scale});
        p.wires.push_back(std::move(made));
    }
    return p;
}

BrainLayout lay_out_graph(const BrainGraph& brain, const Kind& kind, const SensorPair& pair, Rect area, float scale) {
    BrainLayout p;
    const float middle = area.x + area.w / 2, wheel_y = area.y + area.h - 32 * scale;
    const float half = area.w / 2 - 46 * scale;   // of the sensors' row
    const float wheel = area.w / 2 - 78 * scale;  // from the middle; numbers are outside
    const GraphFrame frame{{middle, area.y + area.h / 2}, area.h, (wheel - 28 * scale) / row_half_width};

    std::vector<Sensor> sensors = read_sensors(brain, kind);
    const auto count = static_cast<float>(sensors.size());
    const float apart = std::min(64 * scale, count > 1 ? 2 * half / (count - 1) : 0.0f);
    if (apart > 0) p.sensor_radius = std::clamp(0.36f * apart / scale, 4.0f, 9.0f);
    std::vector<ImVec2> starts;
    for (std::size_t i = 0; i < sensors.size(); ++i) {
        const ImVec2 at{middle + (static_cast<float>(i) - (count - 1) / 2) * apart, area.y + 26 * scale};
        p.sensors.push_back(mark_of(brain, sensors[i].name, at));
        starts.push_back({at.x, at.y + p.sensor_radius * scale});
    }
    std::array<ImVec2, 2> ends;
    for (std::size_t side = 0; side < 2; ++side) {
        const float s = side == 0 ? -1.0f : 1.0f;
        p.motors[side] = mark_of(brain, motor_names[side], {middle + s * wheel, wheel_y});
        ends[side] = {middle + s * (wheel - 34 * scale), wheel_y - 2 * scale};
    }
    p.chassis = {middle - wheel + 4 * scale, area.y + 20 * scale, 2 * (wheel - 4 * scale), area.h - 32 * scale};
    const float front = frame.place({0, area.y + 52 * scale}).x, back = frame.place({0, wheel_y - 14 * scale}).x;
    add_graph(p, brain, pair, frame, flat_vehicle(frame, std::move(sensors), starts, ends),
              {front, back, row_half_width}, scale);
    return p;
}

BrainLayout lay_out_sideways(const BrainGraph& brain, const Kind& kind, const SensorPair& pair, Rect area,
                             float scale) {
    BrainLayout p;
    p.chassis = area;
    const float inset = 10 * scale;
    const GraphFrame frame{{area.x + area.w / 2, area.y + area.h / 2}, 2 * area.w, 2 * area.h, true};
    std::vector<Sensor> sensors = read_sensors(brain, kind);
    const float each = area.h / static_cast<float>(std::max<std::size_t>(1, sensors.size()));
    std::vector<ImVec2> starts;
    for (std::size_t i = 0; i < sensors.size(); ++i) {
        starts.push_back({area.x + inset, area.y + each * (static_cast<float>(i) + 0.5f)});
        p.sensors.push_back(mark_of(brain, sensors[i].name, starts.back()));
    }
    std::array<ImVec2, 2> ends;
    for (std::size_t side = 0; side < 2; ++side) {
        ends[side] = {area.x + area.w - inset, area.y + area.h * (0.25f + 0.5f * static_cast<float>(side))};
        p.motors[side] = mark_of(brain, motor_names[side], ends[side]);
    }
    const render::DeckRows rows{.front = 0.11f, .back = -0.11f, .half_width = 0.14f};
    add_graph(p, brain, pair, frame, flat_vehicle(frame, std::move(sensors), starts, ends), rows, scale);
    return p;
}

}  // namespace braitenlab::ui::sketch

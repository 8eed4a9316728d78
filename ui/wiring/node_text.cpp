#include "ui/wiring/node_text.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/scene/sensor_edits.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"

namespace braitenlab::wiring {

using namespace ui;

namespace {

std::string_view senses_key(Channel channel) {
    static const auto keys = [] {
        std::array<std::string, channel_count> made;
        for (const ChannelTraits& row : channel_table)
            made[static_cast<std::size_t>(row.value)] = "wiring.senses." + std::string(row.word);
        return made;
    }();
    return keys[static_cast<std::size_t>(channel)];
}

struct Term {
    std::string size;  // without the sign that joins it to the others
    bool negative = false;
};

using Values = std::function<float(NodeId)>;
using Learned = std::function<float(const Wire&)>;
using Named = std::function<std::string(NodeId)>;

// A number with the decimal mark of the language.
struct Decimals {
    char mark;
    std::string operator()(float value) const { return fixed(value, 2, mark); }
};

float weight_now(const Wire& wire, const Learned& learned) { return wire.weight + (learned ? learned(wire) : 0.0f); }

std::vector<const Wire*> feeding_wires(const BrainGraph& graph, NodeId id, const Learned& learned) {
    std::vector<const Wire*> wires;
    for (const Wire& wire : graph.wires)
        if (wire.to == id && !wire.cut && weight_now(wire, learned) != 0) wires.push_back(&wire);
    std::sort(wires.begin(), wires.end(), [](const Wire* a, const Wire* b) { return a->from < b->from; });
    return wires;
}

std::vector<Term> terms_of(const BrainGraph& graph, const Node& node, const Values& value, const Learned& learned,
                           const Named& named, Decimals number) {
    std::vector<Term> terms;
    for (const Wire* wire : feeding_wires(graph, node.id, learned)) {
        const float reading = value(wire->from), input = let_through(*wire, reading);
        const float weight = weight_now(*wire, learned);
        const bool is_masked = reading != 0 && std::abs(reading) < wire->threshold;
        const std::string factor = is_masked   ? "(" + number(reading) + " < θ)"
                                   : input < 0 ? "(" + number(input) + ")"
                                               : number(input);
        const std::string name = named ? named(wire->from) + " " : "";
        terms.push_back(
            {name + factor + "·" + as_factor(weight, 2, number.mark), false});  // as the equations of the brain card
    }
    if (node.bias != 0 || terms.empty()) terms.push_back({number(std::abs(node.bias)), node.bias < 0});
    return terms;
}

// The sum of the terms as they are shown, with two decimals each.
float sum_of_shown(const BrainGraph& graph, const Node& node, const Values& value, const Learned& learned) {
    const auto shown = [](float number) { return std::round(100 * number) / 100; };
    float sum = shown(node.bias);
    for (const Wire* wire : feeding_wires(graph, node.id, learned))
        sum += shown(let_through(*wire, value(wire->from))) * shown(weight_now(*wire, learned));
    return sum;
}

std::string joined(const std::vector<Term>& terms) {
    constexpr std::size_t terms_a_line = 3;
    std::string text;
    std::size_t count = 0;
    for (const Term& term : terms) {
        if (count > 0) text += count % terms_a_line == 0 ? "\n" : " ";
        if (term.negative)
            text += count > 0 ? "− " : "−";
        else if (count > 0)
            text += "+ ";
        text += term.size;
        ++count;
    }
    return text;
}

}  // namespace

std::string_view description_key(const Snapshot& now, const VehicleView& vehicle, const Node& node) {
    if (node.name == "SL") return "wiring.node.SL";
    if (node.name == "SR") return "wiring.node.SR";
    if (node.name == "ML") return "wiring.node.ML";
    if (node.name == "MR") return "wiring.node.MR";
    if (node.kind == NodeKind::motor) return "wiring.node.motor";
    if (node.kind == NodeKind::neuron) return "wiring.node.neuron";
    const Sensor* sensor = find_sensor(kind_of(now, vehicle).sensors, node.name);
    return sensor ? senses_key(sensor->channel) : "wiring.node.sensor";
}

std::string_view channel_symbol(Channel channel) {
    struct Row {
        Channel value;
        std::string_view symbol;
    };
    // clang-format off
    static constexpr Row rows[]{
        {Channel::light, icon::light}, {Channel::red, "\uf0ebr"}, {Channel::green, "\uf0ebg"}, {Channel::blue, "\uf0ebb"},
        {Channel::heat, icon::heat}, {Channel::smell, icon::smell}, {Channel::oxygen, icon::oxygen},
        {Channel::obstacle, icon::obstacle}, {Channel::predator, icon::predator}, {Channel::prey, icon::prey},
        {Channel::vehicle, icon::vehicle}, {Channel::memory, icon::memory}, {Channel::touch, icon::touch},
        {Channel::floor, icon::floor}, {Channel::energy, icon::energy}, {Channel::random, icon::random}};
    // clang-format on
    static_assert(std::size(rows) == channel_count);
    const auto* row = std::find_if(std::begin(rows), std::end(rows), [&](const Row& r) { return r.value == channel; });
    return row == std::end(rows) ? std::string_view() : row->symbol;
}

bool has_code_as_name(const Sensor& sensor) {
    const std::string& name = sensor.name;
    const std::size_t digits = name.find_last_not_of("0123456789") + 1;
    return digits > 0 && digits <= 2 &&
           std::all_of(name.begin(), name.begin() + static_cast<std::ptrdiff_t>(digits),
                       [](char c) { return c >= 'A' && c <= 'Z'; });
}

std::string symbol_name(const Sensor& sensor) {
    const float side = sensor.y != 0 ? sensor.y : sensor.angle;
    return std::string(channel_symbol(sensor.channel)) + (side > 0 ? "L" : side < 0 ? "R" : "");
}

std::string short_name(const std::vector<Sensor>& sensors, const std::string& node) {
    const Sensor* sensor = find_sensor(sensors, node);
    if (!sensor || !has_code_as_name(*sensor) || (sensor->channel == Channel::light && node.front() == 'S'))
        return node;
    return symbol_name(*sensor) + node.substr(node.find_last_not_of("0123456789") + 1);
}

std::string short_wire_name(const std::vector<Sensor>& sensors, const BrainGraph& graph, WireEnds ends,
                            const SensorPair& pair) {
    std::string name = wire_name(graph, ends, pair);
    const Node *from = find_node(graph, ends.from), *to = find_node(graph, ends.to);
    if (!from || !to || name != from->name + "-" + to->name) return name;
    return short_name(sensors, from->name) + "-" + to->name;
}

float sum_of(const BrainGraph& graph, NodeId id, const Values& value, const Learned& learned) {
    const Node* node = find_node(graph, id);
    if (node == nullptr) return 0;
    float sum = node->bias;
    for (const Wire* wire : feeding_wires(graph, id, learned))
        sum += signal(*wire, value(wire->from), learned ? learned(*wire) : 0);
    return sum;
}

float shown_value(const Node& node, float value) {
    return node.kind == NodeKind::motor ? std::clamp(value, -1.0f, 1.0f) : value;
}

std::string sum_text(const BrainGraph& graph, NodeId id, const Values& value, const Learned& learned, char decimal_mark,
                     const Named& named) {
    const Node* node = find_node(graph, id);
    if (node == nullptr || node->kind == NodeKind::sensor) return {};
    const Decimals number{decimal_mark};
    const float sum = sum_of(graph, id, value, learned);
    const bool fits = number(sum_of_shown(graph, *node, value, learned)) == number(sum);
    const std::string equals = fits ? " = " : " ≈ ", limited = number(shown_value(*node, value(id)));
    std::string result = " → " + limited;
    std::string text = joined(terms_of(graph, *node, value, learned, named, number));
    if (node->curve.response == Response::step)
        return text + equals + number(sum) + (sum >= node->curve.peak ? " ≥ " : " < ") + number(node->curve.peak) +
               result;
    const bool has_curve = node->curve.response != Response::linear;
    if (has_curve || shown_value(*node, value(id)) != value(id))
        text += equals + number(sum);
    else if (!fits && limited == number(sum))
        result = equals + limited;
    if (has_curve) text += "\nf(" + number(sum) + ") = " + number(respond(node->curve, sum));
    return text + result;
}

}  // namespace braitenlab::wiring

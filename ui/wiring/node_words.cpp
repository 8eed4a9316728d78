#include "ui/wiring/node_words.h"

#include <array>

#include "core/scene/scene.h"

namespace braitenlab {

namespace {

// In the order of Channel.
constexpr std::array<std::string_view, channel_count> senses_keys{
    "wiring.senses.light",    "wiring.senses.red",   "wiring.senses.green",   "wiring.senses.blue",
    "wiring.senses.heat",     "wiring.senses.smell", "wiring.senses.oxygen",  "wiring.senses.obstacle",
    "wiring.senses.predator", "wiring.senses.prey",  "wiring.senses.vehicle", "wiring.senses.memory",
    "wiring.senses.touch",    "wiring.senses.floor", "wiring.senses.energy"};

}  // namespace

std::string_view node_words(const Snapshot& now, const VehicleView& vehicle, const Node& node) {
    if (node.name == "SL") return "wiring.node.SL";
    if (node.name == "SR") return "wiring.node.SR";
    if (node.name == "ML") return "wiring.node.ML";
    if (node.name == "MR") return "wiring.node.MR";
    if (node.kind == NodeKind::motor) return "wiring.node.motor";
    if (node.kind == NodeKind::neuron) return "wiring.node.neuron";
    const Kind& kind = now.scene->kinds.at(static_cast<std::size_t>(vehicle.kind));
    for (const Sensor& sensor : kind.sensors)
        if (sensor.name == node.name) return senses_keys.at(static_cast<std::size_t>(sensor.channel));
    return "wiring.node.sensor";
}

}  // namespace braitenlab

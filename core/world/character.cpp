#include "core/world/character.h"

#include <algorithm>

#include "core/scene/sensor_edits.h"

namespace braitenlab {

namespace {

bool is_wired_sensor(const BrainGraph& brain, const Node& node) {
    return node.kind == NodeKind::sensor &&
           std::any_of(brain.wires.begin(), brain.wires.end(), [&](const Wire& w) { return w.from == node.id; });
}

bool is_wired(const BrainGraph& brain, const SensorPair& pair) {
    return std::any_of(brain.nodes.begin(), brain.nodes.end(), [&](const Node& node) {
        return (node.name == pair.left || node.name == pair.right) && is_wired_sensor(brain, node);
    });
}

}  // namespace

std::vector<Reading> readings_beside_pairs(const Snapshot& now, const VehicleView& vehicle) {
    const Kind& kind = kind_of(now, vehicle);
    const std::vector<KindPair> pairs = sensor_pairs(kind);
    std::vector<Reading> readings;
    for (std::size_t i = 0; i < kind.sensors.size(); ++i) {
        const std::string& name = kind.sensors[i].name;
        const bool is_paired = std::any_of(pairs.begin(), pairs.end(), [&](const KindPair& pair) {
            return pair.sensors.left == name || pair.sensors.right == name;
        });
        if (!is_paired) readings.push_back({name, now.sensed[static_cast<std::size_t>(vehicle.first_sensed) + i]});
    }
    return readings;
}

std::vector<PairCharacter> characters_of(const BrainGraph& brain, const Kind& kind,
                                         std::span<const Reading> meanwhile) {
    std::vector<PairCharacter> characters;
    for (const KindPair& pair : sensor_pairs(kind))
        characters.push_back({pair, is_wired(brain, pair.sensors), recognise(brain, pair.sensors, meanwhile)});
    return characters;
}

Character character_of(const Snapshot& now, const VehicleView& vehicle) {
    const BrainGraph& brain = *brain_of(now, vehicle);
    const std::vector<Reading> meanwhile = readings_beside_pairs(now, vehicle);
    for (const PairCharacter& each : characters_of(brain, kind_of(now, vehicle), meanwhile))
        if (each.is_wired) return each.character;
    return recognise(brain, {}, meanwhile);
}

std::vector<std::string> missing_sensors(const BrainGraph& brain, const Kind& kind) {
    std::vector<std::string> missing;
    for (const Node& node : brain.nodes)
        if (is_wired_sensor(brain, node) && !find_sensor(kind.sensors, node.name)) missing.push_back(node.name);
    return missing;
}

}  // namespace braitenlab

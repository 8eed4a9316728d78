#include "core/world/snapshot.h"

#include <algorithm>

#include "core/scene/sensor_edits.h"
#include "core/sensing/intensity.h"

namespace braitenlab {

const Look* find_look(const std::vector<VehicleLook>& looks, VehicleId vehicle) {
    const auto found = std::lower_bound(looks.begin(), looks.end(), vehicle,
                                        [](const VehicleLook& each, VehicleId id) { return each.vehicle < id; });
    return found != looks.end() && found->vehicle == vehicle ? &found->look : nullptr;
}

void set_look(std::vector<VehicleLook>& looks, VehicleId vehicle, const Look& look) {
    const auto place = std::lower_bound(looks.begin(), looks.end(), vehicle,
                                        [](const VehicleLook& each, VehicleId id) { return each.vehicle < id; });
    const bool is_set = place != looks.end() && place->vehicle == vehicle;
    if (look == Look{}) {
        if (is_set) looks.erase(place);
    } else if (is_set) {
        place->look = look;
    } else {
        looks.insert(place, {vehicle, look});
    }
}

Look look_of(const Snapshot& now, const VehicleView& vehicle) {
    const auto start = static_cast<std::size_t>(vehicle.start);
    if (vehicle.start >= 0 && now.scene && start < now.scene->starts.size())
        return {now.scene->starts[start].name, now.scene->starts[start].colour};
    const Look* own = find_look(now.looks, vehicle.id);
    return own ? *own : Look{};
}

const VehicleView* find_vehicle(const Snapshot& now, VehicleId id) {
    const auto found = std::lower_bound(now.vehicles.begin(), now.vehicles.end(), id,
                                        [](const VehicleView& v, VehicleId wanted) { return v.id < wanted; });
    return found != now.vehicles.end() && found->id == id ? &*found : nullptr;
}

int number_in_population(const Snapshot& now, VehicleId id) {
    int number = 0;
    for (const VehicleView& v : now.vehicles) number += v.id < id && v.start < 0;
    return number;
}

namespace {

float sensor_value(const Snapshot& now, const VehicleView& vehicle, const std::string& name) {
    const auto& sensors = kind_of(now, vehicle).sensors;
    const Sensor* sensor = find_sensor(sensors, name);
    return sensor ? now.sensed[static_cast<std::size_t>(vehicle.first_sensed + (sensor - sensors.data()))] : 0;
}

// Poses of the obstacles: those of the snapshot, and of the scene where the snapshot has none.
std::vector<mechanics::Motion> obstacles_of(const Snapshot& now) {
    std::vector<mechanics::Motion> obstacles;
    for (std::size_t i = 0; i < now.scene->obstacles.size(); ++i) {
        const Obstacle& o = now.scene->obstacles[i];
        const Pose pose = i < now.obstacles.size() ? now.obstacles[i] : Pose{o.x, o.y, o.heading};
        obstacles.push_back(mechanics::at_rest({pose.x, pose.y}, pose.heading));
    }
    return obstacles;
}

std::vector<sensing::Stimulus> marks_of(const Snapshot& now, VehicleId owner) {
    std::vector<sensing::Stimulus> stimuli;
    for (const MarkView& mark : now.marks)
        if (mark.owner == owner) stimuli.push_back({{mark.x, mark.y}, mark.strength});
    return stimuli;
}

// All stimuli of the channel but those of one vehicle.
std::vector<sensing::Stimulus> stimuli_beside(const Snapshot& now, Channel channel, VehicleId left_out) {
    std::vector<sensing::PointSource> sources;
    for (const SourceView& s : now.sources) {
        const auto i = static_cast<std::size_t>(s.source);
        const float candela = i < now.scene->sources.size() ? now.scene->sources[i].candela : 0;
        sources.push_back({s.channel, {s.x, s.y}, s.strength, candela});
    }
    std::vector<mechanics::Motion> motion;
    std::vector<std::int32_t> kind;
    std::vector<Role> role;
    for (const VehicleView& v : now.vehicles) {
        if (v.id == left_out) continue;
        motion.push_back(mechanics::at_rest({v.x, v.y}, v.heading));
        kind.push_back(v.kind);
        role.push_back(v.role);
    }
    std::vector<sensing::Stimulus> stimuli;
    const sensing::Seam seam(now.scene->arena);
    sensing::gather_stimuli({sources, now.scene->kinds, motion, kind, role}, seam, channel, stimuli);
    return stimuli;
}

}  // namespace

float node_value(const Snapshot& now, const VehicleView& vehicle, NodeId id) {
    const BrainGraph& brain = *brain_of(now, vehicle);
    const Node* node = find_node(brain, id);
    if (!node || node->silenced) return 0;
    if (node->kind == NodeKind::sensor) return sensor_value(now, vehicle, node->name);
    // Units stand in the order of a compiled brain: hidden neurons by ascending id, the left motor, the right motor.
    auto unit = static_cast<std::size_t>(vehicle.first_neuron);
    if (node->kind == NodeKind::motor) {
        unit += static_cast<std::size_t>(vehicle.neuron_count) - (node->name == "ML" ? 2 : 1);
    } else {
        for (const Node& other : brain.nodes) unit += other.kind == NodeKind::neuron && other.id < id;
    }
    return now.neurons[unit];
}

float learned(const Snapshot& now, const VehicleView& vehicle, NodeId from, NodeId to) {
    const BrainGraph& brain = *brain_of(now, vehicle);
    const Wire* wire = find_wire(brain, from, to);
    if (!wire || !learns(*wire)) return 0;
    auto place = static_cast<std::size_t>(vehicle.first_neuron + vehicle.neuron_count);
    for (const Wire& other : brain.wires)
        if (learns(other) && std::pair(other.from, other.to) < std::pair(from, to)) ++place;
    return now.neurons[place];
}

sensing::IntensityInput intensity_input(const Snapshot& now, Channel channel, VehicleId asking) {
    sensing::IntensityInput input;
    const VehicleView* vehicle = find_vehicle(now, asking);
    const Kind* kind = now.scene && vehicle ? &kind_of(now, *vehicle) : nullptr;
    input.sensor = sensing::measuring_sensor(kind, channel);
    input.scene = now.scene;
    if (!now.scene) return input;
    if (channel == Channel::obstacle || is_blocked_by_obstacles(channel)) input.obstacles = obstacles_of(now);
    input.stimuli = channel == Channel::memory ? marks_of(now, asking) : stimuli_beside(now, channel, asking);
    return input;
}

std::vector<Channel> channels_with_intensity(const Snapshot& now) {
    std::vector<Channel> found;
    if (!now.scene) return found;
    const std::vector<Kind>& kinds = now.scene->kinds;
    const auto any_seen_as = [](const auto& emitters, Channel c) {
        return std::any_of(emitters.begin(), emitters.end(), [&](const auto& e) { return is_seen_as(e.channel, c); });
    };
    for (int i = 0; i < channel_count; ++i) {
        const auto c = static_cast<Channel>(i);
        if (!row_of(c).is_mapped) continue;
        const auto senses = [&](const Kind& kind) {
            return std::any_of(kind.sensors.begin(), kind.sensors.end(),
                               [&](const Sensor& s) { return s.channel == c; });
        };
        const bool is_sensed =
            std::any_of(kinds.begin(), kinds.end(), senses) ||
            std::any_of(now.designs.begin(), now.designs.end(), [&](const auto& design) { return senses(*design); });
        const bool is_carried =
            std::any_of(kinds.begin(), kinds.end(), [&](const Kind& kind) { return any_seen_as(kind.lamps, c); });
        const bool is_given = any_seen_as(now.sources, c) || is_carried;
        const bool is_colour = c != Channel::light && is_seen_as(c, Channel::light);
        if (is_colour ? is_given && is_sensed : is_given || is_sensed) found.push_back(c);
    }
    return found;
}

}  // namespace braitenlab

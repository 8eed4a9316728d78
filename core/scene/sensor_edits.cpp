#include "core/scene/sensor_edits.h"

#include <algorithm>
#include <cmath>

#include "core/brain/edit.h"
#include "core/maths/angle.h"
#include "core/scene/sensor_pairs.h"

namespace braitenlab {

namespace {

// The part of a name before the digits at its end.
std::size_t length_without_digits(const std::string& name) {
    std::size_t length = name.size();
    while (length > 0 && name[length - 1] >= '0' && name[length - 1] <= '9') --length;
    return length;
}

// One sensor as it is added for a channel; `side`: 1 left, −1 right, 0 in the middle.
Sensor new_sensor(Channel channel, float side) {
    Sensor sensor;
    sensor.channel = channel;
    sensor.y = 0.24f * side;
    sensor.angle = maths::radians(35) * side;
    sensor.fov = maths::radians(100);
    switch (channel) {
        case Channel::touch:
            sensor.fov = maths::radians(side == 0 ? 200.0f : 100.0f);
            sensor.range = 1;
            sensor.response = SensorResponse::boolean;
            break;
        case Channel::energy:
        case Channel::random:
            sensor.x = 0, sensor.fov = maths::radians(360), sensor.range = 1;
            break;
        case Channel::obstacle:
            sensor.x = 0.45f, sensor.y = 0.3f * side, sensor.range = 2.5f, sensor.half_distance = 1.5f;
            break;
        case Channel::memory:
            sensor.range = 2.5f;
            break;
        default:
            break;
    }
    return sensor;
}

void add_pair(std::vector<Sensor>& sensors, const char* stem, Channel channel, float degrees, float field, float range,
              float half_distance = Sensor{}.half_distance) {
    for (const float side : {1.0f, -1.0f}) {
        Sensor& sensor = sensors.emplace_back(new_sensor(channel, side));
        sensor.name = std::string(stem) + (side > 0 ? "L" : "R");
        sensor.x = 0.3f, sensor.y = side * 0.24f;
        sensor.angle = side * maths::radians(degrees), sensor.fov = maths::radians(field);
        sensor.range = range, sensor.half_distance = half_distance;
    }
}

// The tortoise's photocell, which sees a light above it.
Sensor photocell() {
    Sensor sensor = new_sensor(Channel::light, 0);
    sensor.name = "UP", sensor.shape = SensorShape::omni;
    sensor.x = 0, sensor.fov = maths::radians(360), sensor.range = 3;
    return sensor;
}

// True for a preset whose eyes sense a certain channel.
bool is_about_channels(const std::vector<Sensor>& sensors) {
    return sensors.size() > 2 || sensors.front().channel != Channel::light;
}

}  // namespace

const Sensor* find_sensor(const std::vector<Sensor>& sensors, const std::string& name) {
    const auto found = std::find_if(sensors.begin(), sensors.end(), [&](const Sensor& s) { return s.name == name; });
    return found == sensors.end() ? nullptr : &*found;
}

Sensor* find_sensor(std::vector<Sensor>& sensors, const std::string& name) {
    return const_cast<Sensor*>(find_sensor(std::as_const(sensors), name));
}

Sensor mirrored(Sensor sensor) {
    sensor.y = -sensor.y, sensor.angle = -sensor.angle;
    return sensor;
}

std::string other_side(const std::string& name) {
    const std::size_t length = length_without_digits(name);
    if (length == 0 || (name[length - 1] != 'L' && name[length - 1] != 'R')) return {};
    std::string other = name;
    other[length - 1] = name[length - 1] == 'L' ? 'R' : 'L';
    return other;
}

std::string opposite_of(const std::vector<Sensor>& sensors, const std::string& name) {
    if (std::string other = other_side(name); find_sensor(sensors, other)) return other;
    for (const KindPair& pair : sensor_pairs(sensors)) {
        if (pair.sensors.left == name) return pair.sensors.right;
        if (pair.sensors.right == name) return pair.sensors.left;
    }
    return {};
}

std::vector<Sensor> new_sensors(const std::vector<Sensor>& sensors, Channel channel, bool as_pair,
                                const std::vector<std::string>& taken) {
    const ChannelTraits& traits = row_of(channel);
    const std::string stem(traits.stem);
    const std::string middle = traits.single.empty() ? stem + "C" : std::string(traits.single);
    std::vector<Sensor> added;
    if (as_pair)
        added = {new_sensor(channel, 1), new_sensor(channel, -1)};
    else
        added = {new_sensor(channel, 0)};
    const auto is_free = [&](const Sensor& sensor) {
        return !find_sensor(sensors, sensor.name) && std::find(taken.begin(), taken.end(), sensor.name) == taken.end();
    };
    for (int number = 1;; ++number) {
        const std::string suffix = number == 1 ? "" : std::to_string(number);
        for (std::size_t i = 0; i < added.size(); ++i) {
            added[i].name = as_pair ? stem : middle;
            if (as_pair) added[i].name += i == 0 ? 'L' : 'R';
            added[i].name += suffix;
        }
        if (std::all_of(added.begin(), added.end(), is_free)) return added;
    }
}

std::vector<Sensor> with_mirror_image(std::vector<Sensor> sensors, const std::string& name) {
    const Sensor* sensor = find_sensor(sensors, name);
    if (!sensor || (sensor->y == 0 && sensor->angle == 0)) return sensors;
    Sensor image = mirrored(*sensor);
    image.name = opposite_of(sensors, name);
    if (Sensor* other = find_sensor(sensors, image.name)) {
        *other = image;
        return sensors;
    }
    image.name = other_side(name);
    if (image.name.empty()) image.name = name + (image.y > 0 ? "L" : "R");
    const std::string first_choice = image.name;
    for (int number = 2; find_sensor(sensors, image.name); ++number) image.name = first_choice + std::to_string(number);
    const auto place = sensors.begin() + (sensor - sensors.data()) + 1;
    sensors.insert(place, image);
    return sensors;
}

std::vector<Sensor> with_sensors(std::vector<Sensor> sensors, const std::vector<Sensor>& more) {
    for (const Sensor& sensor : more) {
        if (Sensor* known = find_sensor(sensors, sensor.name))
            *known = sensor;
        else
            sensors.push_back(sensor);
    }
    return sensors;
}

std::vector<Sensor> preset_sensors(const Preset& preset) {
    std::vector<Sensor> sensors;
    if (preset.name == "predator") {
        add_pair(sensors, "S", Channel::prey, 35, 100, 6);
    } else if (preset.name == "prey") {
        add_pair(sensors, "S", Channel::predator, 80, 180, 7, 5);
    } else if (preset.name == "3c-values") {
        add_pair(sensors, "S", Channel::light, 35, 150, 8);
        add_pair(sensors, "H", Channel::heat, 35, 150, 8);
        add_pair(sensors, "N", Channel::smell, 35, 150, 8);
        add_pair(sensors, "A", Channel::oxygen, 35, 150, 8);
    } else if (preset.name == "5-logic") {
        add_pair(sensors, "S", Channel::light, 90, 10, 3.5f);
        for (Sensor& eye : sensors) {
            eye.x = 0, eye.y = std::copysign(0.35f, eye.y);
            eye.response = SensorResponse::boolean;
        }
    } else if (preset.name == "7-mnemotrix") {
        add_pair(sensors, "S", Channel::red, 35, 110, 5);
        add_pair(sensors, "H", Channel::heat, 35, 110, 4);
    } else {
        add_pair(sensors, "S", Channel::light, 35, 150, 15);
    }
    if (preset.name == "tortoise") {
        for (const Channel channel : {Channel::touch, Channel::energy})
            sensors.push_back(new_sensors({}, channel, false).front());
        sensors.push_back(photocell());
        add_pair(sensors, "Q", Channel::memory, 35, 110, 2.5f);
    }
    return sensors;
}

std::vector<Sensor> lacking_for(const std::vector<Sensor>& sensors, const Preset& preset) {
    std::vector<Sensor> lacking;
    const std::vector<Sensor> needed = preset_sensors(preset);
    for (const Sensor& sensor : needed) {
        const Sensor* own = find_sensor(sensors, sensor.name);
        if (!own || (is_about_channels(needed) && own->channel != sensor.channel)) lacking.push_back(sensor);
    }
    return lacking;
}

Sensor sensor_named(const std::string& name) {
    for (const Preset& preset : presets()) {
        const std::vector<Sensor> sensors = preset_sensors(preset);
        if (const Sensor* sensor = find_sensor(sensors, name)) return *sensor;
    }
    const bool has_side = !other_side(name).empty();
    const std::string word = name.substr(0, length_without_digits(name));
    const std::string stem = word.empty() ? "" : word.substr(0, word.size() - 1);
    for (const ChannelTraits& traits : channel_table) {
        if (stem != traits.stem) continue;
        std::vector<Sensor> sensors = new_sensors({}, traits.value, has_side);
        Sensor& sensor = sensors[has_side && word.back() == 'R' ? 1 : 0];
        sensor.name = name;
        return sensor;
    }
    Sensor sensor = new_sensor(Channel::light, has_side ? (word.back() == 'L' ? 1.0f : -1.0f) : 0);
    sensor.name = name;
    return sensor;
}

BrainGraph with_sensor_nodes(BrainGraph brain, const std::vector<Sensor>& sensors) {
    for (const Sensor& sensor : sensors) {
        if (find_node(brain, sensor.name)) continue;
        brain.nodes.push_back({.id = fresh_id(brain), .kind = NodeKind::sensor, .name = sensor.name});
    }
    return brain;
}

BrainGraph without_idle_sensors(BrainGraph brain, const std::vector<std::string>& names) {
    const auto is_idle = [&](const Node& node) {
        const bool is_removed = std::find(names.begin(), names.end(), node.name) != names.end();
        return is_removed && node.kind == NodeKind::sensor && node.name != "SL" && node.name != "SR" &&
               std::none_of(brain.wires.begin(), brain.wires.end(), [&](const Wire& wire) {
                   return wire.from == node.id && (wire.weight != 0 || learns(wire));
               });
    };
    std::vector<NodeId> idle;
    for (const Node& node : brain.nodes)
        if (is_idle(node)) idle.push_back(node.id);
    const auto is_gone = [&](NodeId id) { return std::find(idle.begin(), idle.end(), id) != idle.end(); };
    std::erase_if(brain.wires, [&](const Wire& wire) { return is_gone(wire.from); });
    std::erase_if(brain.nodes, [&](const Node& node) { return is_gone(node.id); });
    return brain;
}

}  // namespace braitenlab

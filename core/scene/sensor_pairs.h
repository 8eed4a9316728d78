// The pairs of sensors of a kind: a left and a right sensor of one channel that are mirror images of each other.
#pragma once

#include <string>
#include <vector>

#include "core/brain/four_neurons.h"
#include "core/scene/scene.h"

namespace braitenlab {

struct KindPair {
    std::string name;  // word of the channel; with a number from 2 on for further pairs of one channel: "light 2"
    Channel channel = Channel::light;
    SensorPair sensors;
    friend bool operator==(const KindPair&, const KindPair&) = default;
};

// In the order of their first sensor. The sensor with the larger y is the left one; if both have the same y, that with
// the larger angle. A sensor belongs to at most one pair. Mirrored are y and angle; x, fov, shape, response, range and
// half-distance are equal.
std::vector<KindPair> sensor_pairs(const std::vector<Sensor>&);
inline std::vector<KindPair> sensor_pairs(const Kind& kind) { return sensor_pairs(kind.sensors); }

// The pair of this name, else SL and SR, else the first pair.
SensorPair chosen_pair(const Kind&, const std::string& name);

// True if the channel senses vehicles: it decides the role of Role::wiring.
bool senses_vehicles(Channel);

}  // namespace braitenlab

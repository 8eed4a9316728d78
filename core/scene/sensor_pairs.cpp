#include "core/scene/sensor_pairs.h"

#include <algorithm>
#include <cmath>

namespace braitenlab {

namespace {

bool is_close(float a, float b) { return std::fabs(a - b) <= 1e-3f * std::max({1.0f, std::fabs(a), std::fabs(b)}); }

bool are_mirrored(const Sensor& a, const Sensor& b) {
    const bool is_centred = is_close(a.y, 0) && is_close(a.angle, 0);
    return !is_centred && a.channel == b.channel && a.shape == b.shape && a.response == b.response &&
           is_close(a.x, b.x) && is_close(a.y, -b.y) && is_close(a.angle, -b.angle) && is_close(a.fov, b.fov) &&
           is_close(a.range, b.range) && is_close(a.half_distance, b.half_distance) && is_close(a.gamma, b.gamma) &&
           a.hard_range == b.hard_range && a.points == b.points;
}

bool is_left(const Sensor& a, const Sensor& b) { return is_close(a.y, b.y) ? a.angle > b.angle : a.y > b.y; }

}  // namespace

std::vector<KindPair> sensor_pairs(const std::vector<Sensor>& sensors) {
    std::vector<KindPair> pairs;
    std::vector<bool> is_paired(sensors.size(), false);
    for (std::size_t i = 0; i < sensors.size(); ++i)
        for (std::size_t j = i + 1; j < sensors.size() && !is_paired[i]; ++j) {
            const Sensor &one = sensors[i], &other = sensors[j];
            if (is_paired[j] || !are_mirrored(one, other)) continue;
            is_paired[i] = is_paired[j] = true;
            const auto earlier =
                std::count_if(pairs.begin(), pairs.end(), [&](const KindPair& p) { return p.channel == one.channel; });
            const bool one_is_left = is_left(one, other);
            pairs.push_back({std::string(word(one.channel)) + (earlier > 0 ? " " + std::to_string(earlier + 1) : ""),
                             one.channel,
                             {one_is_left ? one.name : other.name, one_is_left ? other.name : one.name}});
        }
    return pairs;
}

SensorPair chosen_pair(const Kind& kind, const std::string& name) {
    const std::vector<KindPair> pairs = sensor_pairs(kind);
    for (const KindPair& pair : pairs)
        if (pair.name == name) return pair.sensors;
    // Also where they are no mirror images: a breeding turns each eye by itself, and the sliders stay with them.
    const SensorPair eyes;
    const auto has = [&](const std::string& wanted) {
        return std::any_of(kind.sensors.begin(), kind.sensors.end(), [&](const Sensor& s) { return s.name == wanted; });
    };
    return pairs.empty() || (has(eyes.left) && has(eyes.right)) ? eyes : pairs.front().sensors;
}

bool senses_vehicles(Channel channel) {
    return channel == Channel::vehicle || channel == Channel::predator || channel == Channel::prey;
}

}  // namespace braitenlab

#include "core/scene/scene.h"

#include <algorithm>

namespace braitenlab {

namespace {

template <class Named>
int find_named(const std::vector<Named>& all, const std::string& name) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
    return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

}  // namespace

// Friction in N·s/m per m² of wheel contact, grip as a factor, reflectance 0..1: chosen so that a standard vehicle let
// go at top speed coasts for about five times as long on ice as on the plain floor, and a third as long on carpet.
FloorConstants floor_constants(const Arena& arena, Surface surface) {
    switch (surface) {
        case Surface::none:
            break;
        case Surface::ice:
            return {8, 0.1f, 0.95f};
        case Surface::carpet:
            return {120, 1.1f, 0.45f};
        case Surface::sand:
            return {400, 0.6f, 0.6f};
        case Surface::tape:
            return {arena.friction, arena.grip, 0.05f};
    }
    return {arena.friction, arena.grip, arena.reflectance};
}

std::vector<maths::vec2> corners_of(const Obstacle& obstacle) {
    if (obstacle.corners.empty()) {
        const float l = obstacle.length / 2, w = obstacle.width / 2;
        return {{-l, -w}, {l, -w}, {l, w}, {-l, w}};
    }
    std::vector<maths::vec2> corners;
    for (const PolygonCorner& corner : obstacle.corners) corners.push_back({corner.x, corner.y});
    return corners;
}

bool is_seen_as(Channel given, Channel wanted) {
    const auto is_light = [](Channel c) {
        return c == Channel::light || c == Channel::red || c == Channel::green || c == Channel::blue;
    };
    if (given == wanted) return true;
    return is_light(given) && is_light(wanted) && (given == Channel::light || wanted == Channel::light);
}

bool is_blocked_by_obstacles(Channel channel) {
    switch (channel) {
        case Channel::light:
        case Channel::red:
        case Channel::green:
        case Channel::blue:
        case Channel::predator:
        case Channel::prey:
        case Channel::vehicle:
            return true;
        default:
            return false;
    }
}

int find_kind(const Scene& scene, const std::string& name) { return find_named(scene.kinds, name); }
int find_source(const Scene& scene, const std::string& name) { return find_named(scene.sources, name); }
int find_obstacle(const Scene& scene, const std::string& name) { return find_named(scene.obstacles, name); }

std::vector<std::string> sensor_names(const Kind& kind) {
    std::vector<std::string> names;
    names.reserve(kind.sensors.size());
    for (const Sensor& sensor : kind.sensors) names.push_back(sensor.name);
    return names;
}

}  // namespace braitenlab

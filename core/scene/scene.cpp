#include "core/scene/scene.h"

#include <algorithm>

#include "core/text_parts.h"

namespace braitenlab {

namespace {

template <class Named>
int find_named(const std::vector<Named>& all, const std::string& name) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
    return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

// Of an obstacle or a zone.
template <class Outlined>
std::vector<maths::vec2> outline_corners(const Outlined& object) {
    if (object.corners.empty()) {
        const float l = object.length / 2, w = object.width / 2;
        return {{-l, -w}, {l, -w}, {l, w}, {-l, w}};
    }
    std::vector<maths::vec2> corners;
    for (const PolygonCorner& corner : object.corners) corners.push_back({corner.x, corner.y});
    return corners;
}

}  // namespace

FloorConstants floor_constants(const Arena& arena, Surface surface) {
    const SurfaceTraits& traits = row_of(surface);
    return {traits.friction.value_or(arena.friction), traits.grip.value_or(arena.grip),
            traits.reflectance.value_or(arena.reflectance)};
}

std::vector<maths::vec2> corners_of(const Obstacle& obstacle) { return outline_corners(obstacle); }
std::vector<maths::vec2> corners_of(const Zone& zone) { return outline_corners(zone); }

float strength_at(const Source& source, double seconds) {
    const bool is_on =
        source.on.empty() || std::any_of(source.on.begin(), source.on.end(), [&](const OnTime& time) {
            return seconds >= static_cast<double>(time.from) && seconds < static_cast<double>(time.until);
        });
    return is_on ? source.strength : 0;
}

bool is_seen_as(Channel given, Channel wanted) {
    if (given == wanted) return true;
    return row_of(given).is_light && row_of(wanted).is_light && (given == Channel::light || wanted == Channel::light);
}

bool is_blocked_by_obstacles(Channel channel) { return row_of(channel).is_hidden; }

int find_kind(const Scene& scene, const std::string& name) { return find_named(scene.kinds, name); }
int find_source(const Scene& scene, const std::string& name) { return find_named(scene.sources, name); }
int find_obstacle(const Scene& scene, const std::string& name) { return find_named(scene.obstacles, name); }
int find_zone(const Scene& scene, const std::string& name) { return find_named(scene.zones, name); }

bool is_colour(std::string_view text) {
    return text.size() == 7 && text[0] == '#' &&
           text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string_view::npos;
}

float scale_of(const Arena& arena) { return std::min(1.0f, std::min(arena.width, arena.height) / full_scale_side); }

float voltage_share(const Body& body) { return body.voltage > 0 ? body.voltage / body.nominal_voltage : 1; }

Body resized(const Body& body, float length, float width) {
    Body to = body;
    const float along = length / body.length, across = width / body.width;
    to.length = length, to.width = width;
    for (Wheel& wheel : to.wheels) {
        wheel.x *= along, wheel.y *= across;
        wheel.radius = std::clamp(wheel.radius * along, 0.005f, 5.0f);
        wheel.width = std::clamp(wheel.width * across, 0.002f, 5.0f);
        wheel.area = std::clamp(wheel.area * along * across, 0.0f, 1.0f);
    }
    return to;
}

int number_of(const Member& member) {
    const auto number = whole_number<int>(member.name);
    return number && member.name == std::to_string(*number) ? *number : -1;
}

std::vector<std::string> sensor_names(const Kind& kind) {
    std::vector<std::string> names;
    names.reserve(kind.sensors.size());
    for (const Sensor& sensor : kind.sensors) names.push_back(sensor.name);
    return names;
}

}  // namespace braitenlab

#include "render/view/pick.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/maths/angle.h"

namespace braitenlab {

using maths::vec2;

namespace {

constexpr float generous = 5;        // px, margin around a vehicle's body
constexpr float source_reach = 18;   // px, radius around the foot and the bulb of a source
constexpr float source_foot = 0.3f;  // m, radius of a source's foot

const Kind* kind_or_null(const Snapshot& now, const VehicleView& vehicle) {
    const auto kind = static_cast<std::size_t>(vehicle.kind);
    return now.scene && kind < now.scene->kinds.size() ? &kind_of(now, vehicle) : nullptr;
}

template <class Element>
const Element* element_at(const std::vector<Element>& all, int index) {
    return index >= 0 && static_cast<std::size_t>(index) < all.size() ? &all[static_cast<std::size_t>(index)] : nullptr;
}

const Obstacle* obstacle_at(const Snapshot& now, int index) {
    return now.scene ? element_at(now.scene->obstacles, index) : nullptr;
}

const Zone* zone_at(const Snapshot& now, int index) {
    return now.scene ? element_at(now.scene->zones, index) : nullptr;
}

// The boundary of a zone in its own frame; an ellipse as a polygon.
std::vector<vec2> boundary_of(const Zone& zone) {
    constexpr int ellipse_corners = 48;
    if (!zone.round || !zone.corners.empty()) return corners_of(zone);
    std::vector<vec2> points;
    for (int i = 0; i < ellipse_corners; ++i) {
        const vec2 way = maths::direction(2 * maths::pi * static_cast<float>(i) / ellipse_corners);
        points.push_back({way.x * zone.length / 2, way.y * zone.width / 2});
    }
    return points;
}

// The corners of an obstacle or zone in its own frame; empty for other objects.
std::vector<vec2> own_outline_of(const Snapshot& now, const SceneObject& object) {
    if (object.kind == SceneObjectKind::obstacle)
        if (const Obstacle* obstacle = obstacle_at(now, object.index)) return corners_of(*obstacle);
    if (object.kind == SceneObjectKind::zone)
        if (const Zone* zone = zone_at(now, object.index)) return boundary_of(*zone);
    return {};
}

const SourceView* source_at(const Snapshot& now, int index) {
    const auto found =
        std::find_if(now.sources.begin(), now.sources.end(), [&](const SourceView& s) { return s.source == index; });
    return found == now.sources.end() ? nullptr : &*found;
}

int pick_source(const Snapshot& now, const CameraView& camera_view, vec2 pixel) {
    int found = -1;
    float best = source_reach;
    const float bulb = bulb_height * (now.scene ? scale_of(now.scene->arena) : 1);
    for (const SourceView& source : now.sources) {
        for (const float height : {0.0f, bulb}) {
            const auto at = project(camera_view, {source.x, source.y}, height);
            if (at && maths::distance(*at, pixel) < best) best = maths::distance(*at, pixel), found = source.source;
        }
    }
    return found;
}

// True inside a convex polygon or at most `slack` metres outside.
bool inside(const std::vector<vec2>& corners, vec2 p, float slack) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const vec2 along = maths::normalise(corners[(i + 1) % corners.size()] - corners[i]);
        if (maths::cross(along, p - corners[i]) < -slack) return false;
    }
    return corners.size() >= 3;
}

int pick_obstacle(const Snapshot& now, const CameraView& camera_view, vec2 pixel) {
    if (!now.scene) return -1;
    int found = -1;
    float nearest = std::numeric_limits<float>::max();
    // Test the polygon at several heights between foot and top.
    for (int slice = 0; slice <= 3; ++slice) {
        const auto at =
            unproject(camera_view, pixel, obstacle_height(now.scene->arena) * static_cast<float>(slice) / 3);
        if (!at) continue;
        for (int i = 0; i < static_cast<int>(now.scene->obstacles.size()); ++i) {
            const SceneObject obstacle{SceneObjectKind::obstacle, i};
            const auto place = place_of(now, obstacle);
            const float away = maths::distance(*at, {place->x, place->y});
            if (away >= nearest || away > reach_of(now, obstacle) + 1) continue;
            const float scale = std::max(pixels_per_metre(camera_view, *at), 1.0f);
            if (inside(outline_of(now, obstacle), *at, 3 / scale)) nearest = away, found = i;
        }
    }
    return found;
}

// An upper bound, m.
float reach_of_zone(const Zone& zone) {
    if (zone.corners.empty()) return std::hypot(zone.length, zone.width) / 2;
    float reach = 0;
    for (const auto& corner : zone.corners) reach = std::max(reach, std::hypot(corner.x, corner.y));
    return reach;
}

// True for a point, in metres from the zone's centre along the axes of the scene, in the zone or at most `slack` metres
// outside.
bool is_in_zone(const Zone& zone, vec2 from_centre, float slack) {
    // Beyond the corner of a polygon the slack reaches farther than beyond its edges.
    if (maths::length(from_centre) > reach_of_zone(zone) + 8 * slack) return false;
    const float half_length = zone.length / 2 + slack, half_width = zone.width / 2 + slack;
    const vec2 own = maths::rotate(from_centre, maths::direction(-zone.heading));
    if (!zone.corners.empty() || !zone.round) return inside(corners_of(zone), own, slack);
    const float x = own.x / half_length, y = own.y / half_width;
    return x * x + y * y <= 1;
}

// The last one of the zones there: it is drawn over the others.
int pick_zone(const Snapshot& now, const CameraView& camera_view, vec2 pixel) {
    const auto at = unproject(camera_view, pixel);
    if (!at || !now.scene) return -1;
    const float slack = 3 / std::max(pixels_per_metre(camera_view, *at), 1.0f);
    for (int i = static_cast<int>(now.scene->zones.size()) - 1; i >= 0; --i)
        if (const Zone& zone = now.scene->zones[static_cast<std::size_t>(i)];
            is_in_zone(zone, *at - vec2{zone.x, zone.y}, slack))
            return i;
    return -1;
}

}  // namespace

VehicleId pick(const Snapshot& now, const CameraView& camera_view, vec2 pixel) {
    constexpr float middle = 0.15f;  // m, half a vehicle's height
    VehicleId found = no_vehicle;
    float best = std::numeric_limits<float>::max();
    for (const VehicleView& vehicle : now.vehicles) {
        const auto centre = project(camera_view, {vehicle.x, vehicle.y}, middle);
        if (!centre) continue;
        const Kind* kind = kind_or_null(now, vehicle);
        const float radius = kind ? std::max(kind->body.length, kind->body.width) / 2 : 0.5f;
        const float reach = radius * pixels_per_metre(camera_view, {vehicle.x, vehicle.y}, middle) + generous;
        const float away = maths::distance(*centre, pixel);
        if (away <= reach && away < best) best = away, found = vehicle.id;
    }
    return found;
}

SceneObject pick_object(const Snapshot& now, const CameraView& camera_view, vec2 pixel, bool zones) {
    if (const VehicleId vehicle = pick(now, camera_view, pixel); vehicle != no_vehicle) return vehicle_object(vehicle);
    if (const int source = pick_source(now, camera_view, pixel); source >= 0) return {SceneObjectKind::source, source};
    if (const int obstacle = pick_obstacle(now, camera_view, pixel); obstacle >= 0)
        return {SceneObjectKind::obstacle, obstacle};
    if (const int zone = zones ? pick_zone(now, camera_view, pixel) : -1; zone >= 0)
        return {SceneObjectKind::zone, zone};
    return {};
}

std::optional<Pose> place_of(const Snapshot& now, const SceneObject& object) {
    if (object.kind == SceneObjectKind::vehicle) {
        if (const VehicleView* v = find_vehicle(now, object.index)) return Pose{v->x, v->y, v->heading};
    } else if (object.kind == SceneObjectKind::source) {
        if (const SourceView* s = source_at(now, object.index)) return Pose{s->x, s->y, 0};
    } else if (object.kind == SceneObjectKind::obstacle) {
        // A movable obstacle can have moved since the start of the run.
        const auto index = static_cast<std::size_t>(object.index);
        if (const Obstacle* o = obstacle_at(now, object.index))
            return index < now.obstacles.size() ? now.obstacles[index] : Pose{o->x, o->y, o->heading};
    } else if (object.kind == SceneObjectKind::zone) {
        if (const Zone* z = zone_at(now, object.index)) return Pose{z->x, z->y, z->heading};
    }
    return std::nullopt;
}

float reach_of(const Snapshot& now, const SceneObject& object) {
    if (object.kind == SceneObjectKind::source) return source_at(now, object.index) ? source_foot : 0;
    if (object.kind == SceneObjectKind::vehicle) {
        const VehicleView* vehicle = find_vehicle(now, object.index);
        const Kind* kind = vehicle ? kind_or_null(now, *vehicle) : nullptr;
        return kind ? std::hypot(kind->body.length, kind->body.width) / 2 : vehicle ? 0.6f : 0;
    }
    float reach = 0;
    for (const vec2 corner : own_outline_of(now, object)) reach = std::max(reach, maths::length(corner));
    return reach;
}

std::vector<vec2> outline_of(const Snapshot& now, const SceneObject& object) {
    std::vector<vec2> corners = own_outline_of(now, object);
    if (corners.empty()) return corners;
    const auto place = place_of(now, object);
    const vec2 ahead = maths::direction(place->heading);
    for (vec2& corner : corners) corner = vec2{place->x, place->y} + maths::rotate(corner, ahead);
    return corners;
}

std::vector<SceneObject> objects_beside_vehicles(const Scene& scene) {
    std::vector<SceneObject> all;
    const auto add = [&](SceneObjectKind kind, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) all.push_back({kind, static_cast<int>(i)});
    };
    add(SceneObjectKind::source, scene.sources.size());
    add(SceneObjectKind::obstacle, scene.obstacles.size());
    add(SceneObjectKind::zone, scene.zones.size());
    return all;
}

std::string name_of(const Scene& scene, const SceneObject& object) {
    const auto name = [&](const auto& all) {
        const auto* element = element_at(all, object.index);
        return element ? element->name : std::string();
    };
    if (object.kind == SceneObjectKind::source) return name(scene.sources);
    if (object.kind == SceneObjectKind::obstacle) return name(scene.obstacles);
    return object.kind == SceneObjectKind::zone ? name(scene.zones) : std::string();
}

SceneObject object_named(const Scene& scene, SceneObjectKind kind, const std::string& name) {
    const int index = kind == SceneObjectKind::source     ? find_source(scene, name)
                      : kind == SceneObjectKind::obstacle ? find_obstacle(scene, name)
                      : kind == SceneObjectKind::zone     ? find_zone(scene, name)
                                                          : -1;
    return index < 0 ? SceneObject{} : SceneObject{kind, index};
}

}  // namespace braitenlab

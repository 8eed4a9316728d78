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
    return now.scene && kind < now.scene->kinds.size() ? &now.scene->kinds[kind] : nullptr;
}

const Obstacle* obstacle_at(const Snapshot& now, int index) {
    const bool known = now.scene && index >= 0 && static_cast<std::size_t>(index) < now.scene->obstacles.size();
    return known ? &now.scene->obstacles[static_cast<std::size_t>(index)] : nullptr;
}

const SourceView* source_at(const Snapshot& now, int index) {
    const auto found =
        std::find_if(now.sources.begin(), now.sources.end(), [&](const SourceView& s) { return s.source == index; });
    return found == now.sources.end() ? nullptr : &*found;
}

int pick_source(const Snapshot& now, const CameraView& camera_view, vec2 pixel) {
    int found = -1;
    float best = source_reach;
    for (const SourceView& source : now.sources) {
        for (const float height : {0.0f, bulb_height}) {
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
        const auto at = unproject(camera_view, pixel, obstacle_height * static_cast<float>(slice) / 3);
        if (!at) continue;
        for (int i = 0; i < static_cast<int>(now.scene->obstacles.size()); ++i) {
            const auto place = place_of(now, {SceneObjectKind::obstacle, i});
            const float away = maths::distance(*at, {place->x, place->y});
            if (away >= nearest || away > reach_of(now, {SceneObjectKind::obstacle, i}) + 1) continue;
            const float scale = std::max(pixels_per_metre(camera_view, *at), 1.0f);
            if (inside(outline_of(now, i), *at, 3 / scale)) nearest = away, found = i;
        }
    }
    return found;
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

SceneObject pick_object(const Snapshot& now, const CameraView& camera_view, vec2 pixel) {
    if (const VehicleId vehicle = pick(now, camera_view, pixel); vehicle != no_vehicle) return vehicle_object(vehicle);
    if (const int source = pick_source(now, camera_view, pixel); source >= 0) return {SceneObjectKind::source, source};
    if (const int obstacle = pick_obstacle(now, camera_view, pixel); obstacle >= 0)
        return {SceneObjectKind::obstacle, obstacle};
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
    if (const Obstacle* obstacle = obstacle_at(now, object.index); obstacle && object.kind == SceneObjectKind::obstacle)
        for (const vec2 corner : corners_of(*obstacle)) reach = std::max(reach, maths::length(corner));
    return reach;
}

std::vector<vec2> outline_of(const Snapshot& now, int index) {
    const Obstacle* obstacle = obstacle_at(now, index);
    if (!obstacle) return {};
    const auto place = place_of(now, {SceneObjectKind::obstacle, index});
    const vec2 ahead = maths::direction(place->heading);
    std::vector<vec2> corners = corners_of(*obstacle);
    for (vec2& corner : corners) corner = vec2{place->x, place->y} + maths::rotate(corner, ahead);
    return corners;
}

}  // namespace braitenlab

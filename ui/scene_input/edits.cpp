#include "ui/scene_input/edits.h"

#include <algorithm>

#include "ui/scene_input/room.h"

namespace braitenlab {

using maths::vec2;

namespace {

constexpr float beside = 0.8f;  // m

vec2 inside(const Snapshot& now, vec2 place, float margin = 0) {
    if (!now.scene) return place;
    const float x = std::max(0.0f, now.scene->arena.width / 2 - margin);
    const float y = std::max(0.0f, now.scene->arena.height / 2 - margin);
    return {std::clamp(place.x, -x, x), std::clamp(place.y, -y, y)};
}

// A vehicle keeps off the walls by half its width, so that it can drive away.
float margin_of(const Snapshot& now, const SceneObject& object) {
    const VehicleView* vehicle = object.kind == SceneObjectKind::vehicle ? find_vehicle(now, object.index) : nullptr;
    if (!vehicle || !now.scene || now.scene->arena.edge != Boundary::wall) return 0;
    return now.scene->kinds[static_cast<std::size_t>(vehicle->kind)].body.width / 2;
}

// Beside it, on the side where the arena has more room.
Pose place_beside(const Snapshot& now, const SceneObject& object) {
    const Pose at = *place_of(now, object);
    const float step = beside + reach_of(now, object);
    const vec2 there{at.x + (at.x > 0 ? -step : step), at.y};
    const vec2 within = inside(now, there, margin_of(now, object));
    return {within.x, within.y, at.heading};
}

}  // namespace

std::optional<Command> removal_of(const Snapshot& now, const SceneObject& object) {
    if (!place_of(now, object)) return std::nullopt;
    if (object.kind == SceneObjectKind::vehicle) return RemoveVehicle{object.index};
    if (object.kind == SceneObjectKind::source) return RemoveSource{object.index};
    return RemoveObstacle{object.index};
}

std::optional<Command> copy_of(const Snapshot& now, const SceneObject& object) {
    if (!place_of(now, object)) return std::nullopt;
    const Pose at = place_beside(now, object);
    if (object.kind == SceneObjectKind::vehicle) {
        const VehicleView& vehicle = *find_vehicle(now, object.index);
        const BrainGraph& own = *now.brains[static_cast<std::size_t>(vehicle.brain)];
        const auto kind = static_cast<std::size_t>(vehicle.kind);
        const bool as_its_kind = kind < now.kind_brains.size() && own == *now.kind_brains[kind];
        AddVehicle copy{vehicle.kind, at, std::nullopt, vehicle.energy};
        if (!as_its_kind) copy.brain = own;
        return with_room(now, copy);
    }
    if (object.kind == SceneObjectKind::source) {
        Source source = now.scene->sources[static_cast<std::size_t>(object.index)];
        source.x = at.x, source.y = at.y;
        return with_room(now, AddSource{source});
    }
    Obstacle obstacle = now.scene->obstacles[static_cast<std::size_t>(object.index)];
    obstacle.x = at.x, obstacle.y = at.y, obstacle.heading = at.heading;
    return with_room(now, AddObstacle{obstacle});
}

std::optional<Command> move_of(const Snapshot& now, const SceneObject& object, Pose to) {
    if (!place_of(now, object)) return std::nullopt;
    const vec2 within = inside(now, {to.x, to.y}, margin_of(now, object));
    if (object.kind == SceneObjectKind::vehicle) return MoveVehicle{object.index, within.x, within.y, to.heading};
    if (object.kind == SceneObjectKind::source) return MoveSource{object.index, within.x, within.y};
    return MoveObstacle{object.index, within.x, within.y, to.heading};
}

std::optional<Command> start_of(const Snapshot& now, const Command& move) {
    const auto* to = std::get_if<MoveVehicle>(&move);
    const VehicleView* v = to && now.tick == 0 ? find_vehicle(now, to->vehicle) : nullptr;
    if (!v || v->start < 0) return std::nullopt;
    Start start = now.scene->starts[static_cast<std::size_t>(v->start)];
    start.x = to->x, start.y = to->y, start.heading = to->heading;
    start.facing.clear();
    start.place_spread = start.heading_spread = 0;
    return EditStart{v->start, start};
}

SceneObject added_by(const Snapshot& now, const Command& command) {
    const auto newest = [](SceneObjectKind kind, std::size_t count, int before) {
        const int last = static_cast<int>(count) - 1;
        return SceneObject{kind, before >= 0 ? std::min(before, last) : last};
    };
    if (const auto* vehicle = std::get_if<AddVehicle>(&command); vehicle && vehicle->at && !now.vehicles.empty())
        return vehicle_object(now.vehicles.back().id);
    if (const auto* source = std::get_if<AddSource>(&command))
        return newest(SceneObjectKind::source, now.scene->sources.size(), source->before);
    if (const auto* obstacle = std::get_if<AddObstacle>(&command))
        return newest(SceneObjectKind::obstacle, now.scene->obstacles.size(), obstacle->before);
    return {};
}

}  // namespace braitenlab

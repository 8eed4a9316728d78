#include "ui/stage/edits.h"

#include <algorithm>

#include "ui/stage/room.h"

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
float margin_of(const Snapshot& now, const Thing& thing) {
    const VehicleView* vehicle = thing.kind == ThingKind::vehicle ? find_vehicle(now, thing.index) : nullptr;
    if (!vehicle || !now.scene || now.scene->arena.edge != Boundary::wall) return 0;
    return now.scene->kinds[static_cast<std::size_t>(vehicle->kind)].body.width / 2;
}

// Beside it, on the side where the arena has more room.
Pose place_beside(const Snapshot& now, const Thing& thing) {
    const Pose at = *place_of(now, thing);
    const float step = beside + reach_of(now, thing);
    const vec2 there{at.x + (at.x > 0 ? -step : step), at.y};
    const vec2 within = inside(now, there, margin_of(now, thing));
    return {within.x, within.y, at.heading};
}

}  // namespace

std::optional<Command> removal_of(const Snapshot& now, const Thing& thing) {
    if (!place_of(now, thing)) return std::nullopt;
    if (thing.kind == ThingKind::vehicle) return RemoveVehicle{thing.index};
    if (thing.kind == ThingKind::source) return RemoveSource{thing.index};
    return RemoveObstacle{thing.index};
}

std::optional<Command> copy_of(const Snapshot& now, const Thing& thing) {
    if (!place_of(now, thing)) return std::nullopt;
    const Pose at = place_beside(now, thing);
    if (thing.kind == ThingKind::vehicle) {
        const VehicleView& vehicle = *find_vehicle(now, thing.index);
        const BrainGraph& own = *now.brains[static_cast<std::size_t>(vehicle.brain)];
        const auto kind = static_cast<std::size_t>(vehicle.kind);
        const bool as_its_kind = kind < now.kind_brains.size() && own == *now.kind_brains[kind];
        AddVehicle copy{vehicle.kind, at, std::nullopt, vehicle.energy};
        if (!as_its_kind) copy.brain = own;
        return with_room(now, copy);
    }
    if (thing.kind == ThingKind::source) {
        Source source = now.scene->sources[static_cast<std::size_t>(thing.index)];
        source.x = at.x, source.y = at.y;
        return with_room(now, AddSource{source});
    }
    Obstacle obstacle = now.scene->obstacles[static_cast<std::size_t>(thing.index)];
    obstacle.x = at.x, obstacle.y = at.y, obstacle.heading = at.heading;
    return with_room(now, AddObstacle{obstacle});
}

std::optional<Command> move_of(const Snapshot& now, const Thing& thing, Pose to) {
    if (!place_of(now, thing)) return std::nullopt;
    const vec2 within = inside(now, {to.x, to.y}, margin_of(now, thing));
    if (thing.kind == ThingKind::vehicle) return MoveVehicle{thing.index, within.x, within.y, to.heading};
    if (thing.kind == ThingKind::source) return MoveSource{thing.index, within.x, within.y};
    return MoveObstacle{thing.index, within.x, within.y, to.heading};
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

Thing added_by(const Snapshot& now, const Command& command) {
    const auto newest = [](ThingKind kind, std::size_t count, int before) {
        const int last = static_cast<int>(count) - 1;
        return Thing{kind, before >= 0 ? std::min(before, last) : last};
    };
    if (const auto* vehicle = std::get_if<AddVehicle>(&command); vehicle && vehicle->at && !now.vehicles.empty())
        return vehicle_thing(now.vehicles.back().id);
    if (const auto* source = std::get_if<AddSource>(&command))
        return newest(ThingKind::source, now.scene->sources.size(), source->before);
    if (const auto* obstacle = std::get_if<AddObstacle>(&command))
        return newest(ThingKind::obstacle, now.scene->obstacles.size(), obstacle->before);
    return {};
}

}  // namespace braitenlab

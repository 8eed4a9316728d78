#include "ui/scene_input/edits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/maths/geometry.h"
#include "core/scene/arena.h"
#include "ui/lab_view.h"

namespace braitenlab::ui {

using maths::vec2;

namespace {

constexpr float copy_distance = 0.8f;  // m

vec2 clamped_to_arena(const Snapshot& now, vec2 place, float margin = 0) {
    return now.scene ? moved_inside(now.scene->arena, place, margin) : place;
}

// A vehicle keeps half its width of distance to the walls, so that it can drive away.
float wall_margin(const Snapshot& now, const SceneObject& object) {
    const VehicleView* vehicle = object.kind == SceneObjectKind::vehicle ? find_vehicle(now, object.index) : nullptr;
    if (!vehicle || !now.scene || !has_walls(now.scene->arena.edge)) return 0;
    return kind_of(now, *vehicle).body.width / 2;
}

// Beside the object, on the side where the arena has more room.
Pose pose_beside(const Snapshot& now, const SceneObject& object) {
    const Pose at = *place_of(now, object);
    const float distance = copy_distance + reach_of(now, object);
    const vec2 there{at.x + (at.x > 0 ? -distance : distance), at.y};
    const vec2 within = clamped_to_arena(now, there, wall_margin(now, object));
    return {within.x, within.y, at.heading};
}

// The first body colour that no start and no kind has; the first of all if there is none.
std::string unused_colour(const Scene& scene) {
    const auto has = [](std::string_view colour) {
        return [colour](const auto& entry) { return entry.colour == colour; };
    };
    for (const std::string_view colour : body_colours)
        if (std::none_of(scene.starts.begin(), scene.starts.end(), has(colour)) &&
            std::none_of(scene.kinds.begin(), scene.kinds.end(), has(colour)))
            return std::string(colour);
    return std::string(body_colours[0]);
}

constexpr float search_step = 0.1f;   // m between the positions tried
constexpr float source_reach = 0.3f;  // m, radius of the foot of a lamp

struct Disc {
    vec2 place;
    float reach = 0;
};

// All objects that take room: vehicles, sources and obstacles.
struct Obstructions {
    std::vector<Disc> discs;
    std::vector<std::vector<vec2>> blocks;  // corners, counter-clockwise
};

Obstructions obstructions_in(const Snapshot& now) {
    Obstructions all;
    for (const VehicleView& v : now.vehicles) all.discs.push_back({{v.x, v.y}, reach_of(now, vehicle_object(v.id))});
    for (const SourceView& source : now.sources) all.discs.push_back({{source.x, source.y}, source_reach});
    for (int i = 0; i < static_cast<int>(now.scene->obstacles.size()); ++i)
        all.blocks.push_back(outline_of(now, {SceneObjectKind::obstacle, i}));
    return all;
}

bool overlaps(const std::vector<vec2>& block, vec2 place, float reach) {
    bool inside = block.size() >= 3;
    for (std::size_t i = 0; i < block.size(); ++i) {
        const vec2 a = block[i], b = block[(i + 1) % block.size()];
        if (maths::distance(maths::nearest_on_segment(place, a, b), place) < reach) return true;
        inside &= maths::cross(b - a, place - a) >= 0;
    }
    return inside;
}

bool is_free(const Obstructions& all, vec2 place, float reach) {
    return std::none_of(all.discs.begin(), all.discs.end(),
                        [&](const Disc& d) { return maths::distance(d.place, place) < d.reach + reach; }) &&
           std::none_of(all.blocks.begin(), all.blocks.end(),
                        [&](const auto& block) { return overlaps(block, place, reach); });
}

float reach_of_body(const Body& body) { return std::hypot(body.length, body.width) / 2; }

float reach_of_kind(const Snapshot& now, int kind) {
    const auto& kinds = now.scene->kinds;
    return kind >= 0 && static_cast<std::size_t>(kind) < kinds.size()
               ? reach_of_body(kinds[static_cast<std::size_t>(kind)].body)
               : reach_of_body({});
}

// Radius of the largest disc within the obstacle, so that a long wall may end at the edge.
float reach_of_shape(const Obstacle& obstacle) {
    const vec2 middle;
    const std::vector<vec2> corners = corners_of(obstacle);
    float reach = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < corners.size(); ++i)
        reach = std::min(reach, maths::distance(middle, maths::nearest_on_segment(middle, corners[i],
                                                                                  corners[(i + 1) % corners.size()])));
    return corners.empty() ? 0 : reach;
}

}  // namespace

std::optional<Command> removal_of(const Snapshot& now, const SceneObject& object) {
    if (!place_of(now, object)) return std::nullopt;
    if (object.kind == SceneObjectKind::vehicle) return RemoveVehicle{object.index};
    if (object.kind == SceneObjectKind::source) return RemoveSource{object.index};
    if (object.kind == SceneObjectKind::zone) return RemoveZone{object.index};
    return RemoveObstacle{object.index};
}

std::vector<Command> removals_of(const Snapshot& now, std::vector<SceneObject> objects) {
    std::sort(objects.begin(), objects.end(),
              [](const SceneObject& a, const SceneObject& b) { return a.index > b.index; });
    std::vector<Command> removals;
    for (const SceneObject& object : objects)
        if (auto removal = removal_of(now, object)) removals.push_back(std::move(*removal));
    return removals;
}

std::optional<Command> copy_of(const Snapshot& now, const SceneObject& object) {
    if (!place_of(now, object)) return std::nullopt;
    const Pose at = pose_beside(now, object);
    if (object.kind == SceneObjectKind::vehicle) {
        const VehicleView& vehicle = *find_vehicle(now, object.index);
        const BrainGraph& own = *brain_of(now, vehicle);
        const auto kind = static_cast<std::size_t>(vehicle.kind);
        const bool as_its_kind = kind < now.kind_brains.size() && own == *now.kind_brains[kind];
        AddVehicle copy{vehicle.kind, at, std::nullopt, vehicle.energy};
        if (!as_its_kind) copy.brain = own;
        if (vehicle.design >= 0) copy.sensors = kind_of(now, vehicle).sensors;
        copy.colour = unused_colour(*now.scene);
        return with_room(now, copy);
    }
    if (object.kind == SceneObjectKind::source) {
        Source source = now.scene->sources[static_cast<std::size_t>(object.index)];
        source.x = at.x, source.y = at.y;
        return with_room(now, AddSource{source});
    }
    if (object.kind == SceneObjectKind::zone) {
        Zone zone = now.scene->zones[static_cast<std::size_t>(object.index)];
        zone.x = at.x, zone.y = at.y;
        return AddZone{zone};
    }
    Obstacle obstacle = now.scene->obstacles[static_cast<std::size_t>(object.index)];
    obstacle.x = at.x, obstacle.y = at.y, obstacle.heading = at.heading;
    return with_room(now, AddObstacle{obstacle});
}

std::optional<Command> move_of(const Snapshot& now, const SceneObject& object, Pose to) {
    if (!place_of(now, object)) return std::nullopt;
    const vec2 within = clamped_to_arena(now, {to.x, to.y}, wall_margin(now, object));
    if (object.kind == SceneObjectKind::vehicle) return MoveVehicle{object.index, within.x, within.y, to.heading};
    if (object.kind == SceneObjectKind::source) return MoveSource{object.index, within.x, within.y};
    if (object.kind == SceneObjectKind::zone) return MoveZone{object.index, within.x, within.y, to.heading};
    return MoveObstacle{object.index, within.x, within.y, to.heading};
}

std::optional<Command> start_of(const Snapshot& now, const Command& move) {
    const auto* to = std::get_if<MoveVehicle>(&move);
    const VehicleView* v = to && now.tick == 0 ? find_vehicle(now, to->vehicle) : nullptr;
    if (!v) return std::nullopt;
    if (v->start < 0) {
        const int number = number_in_population(now, v->id);
        Member member;
        for (const Member& known : now.scene->members)
            if (number_of(known) == number) member = known;
        member.placed = true, member.x = to->x, member.y = to->y, member.heading = to->heading;
        return EditMember{number, member};
    }
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
    if (const auto* zone = std::get_if<AddZone>(&command))
        return newest(SceneObjectKind::zone, now.scene->zones.size(), zone->before);
    return {};
}

using maths::vec2;

vec2 free_place(const Snapshot& now, vec2 wanted, float reach) {
    if (!now.scene) return wanted;
    const Obstructions all = obstructions_in(now);
    const Arena& arena = now.scene->arena;
    const float margin = arena.edge == Boundary::torus ? 0 : reach;  // on a torus a disc may overlap the edge
    const vec2 from = moved_inside(arena, wanted, margin);
    // Rings around it, each starting on the side of the arena's middle, where there is most room.
    const float towards_middle = std::atan2(-from.y, -from.x), farthest = std::hypot(arena.width, arena.height);
    for (float ring = 0; ring <= farthest; ring += search_step) {
        const int places =
            ring == 0 ? 1 : static_cast<int>(std::ceil(2 * std::numbers::pi_v<float> * ring / search_step));
        for (int i = 0; i < places; ++i) {
            const float turn = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(places);
            const vec2 at = from + ring * vec2{std::cos(towards_middle + turn), std::sin(towards_middle + turn)};
            if (is_inside(arena, at, margin) && is_free(all, at, reach)) return at;
        }
    }
    return from;
}

Command with_room(const Snapshot& now, Command command) {
    if (!now.scene) return command;
    if (auto* vehicle = std::get_if<AddVehicle>(&command); vehicle && vehicle->at) {
        const vec2 at = free_place(now, {vehicle->at->x, vehicle->at->y}, reach_of_kind(now, vehicle->kind));
        vehicle->at->x = at.x, vehicle->at->y = at.y;
    } else if (auto* source = std::get_if<AddSource>(&command)) {
        const vec2 at = free_place(now, {source->object.x, source->object.y}, source_reach);
        source->object.x = at.x, source->object.y = at.y;
    } else if (auto* obstacle = std::get_if<AddObstacle>(&command)) {
        const vec2 at = free_place(now, {obstacle->object.x, obstacle->object.y}, reach_of_shape(obstacle->object));
        obstacle->object.x = at.x, obstacle->object.y = at.y;
    }
    return command;
}

}  // namespace braitenlab::ui

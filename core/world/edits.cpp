#include "core/world/edits.h"

#include "core/maths/angle.h"
#include "core/scene/names.h"
#include "core/world/scene_edit.h"

namespace braitenlab {

namespace {

Error not_finite() { return {"a place takes finite numbers only"}; }

}  // namespace

std::optional<Error> carry_out(WorldState& s, const SetSensors& c) {
    if (auto error = missing(s.scene->kinds, c.kind, "kind")) return error;
    Scene scene = *s.scene;
    Kind& kind = scene.kinds[static_cast<std::size_t>(c.kind)];
    kind.sensors = c.sensors;
    kind.brain = s.newcomers[static_cast<std::size_t>(c.kind)]->graph;
    if (auto error = check_scene(scene)) return error;

    // Brains find their sensors by name; every design of the kind is made again with the new ones.
    std::vector<std::pair<SharedDesign, SharedDesign>> made;
    const auto again = [&](SharedDesign& design) {
        for (const auto& [before, after] : made)
            if (before == design) return void(design = after);
        made.emplace_back(design, *make_design(design->graph, kind));
        design = made.back().second;
    };
    again(s.newcomers[static_cast<std::size_t>(c.kind)]);
    Vehicles& v = s.vehicles;
    for (std::size_t row = 0; row < v.size(); ++row)
        if (v.kind[row] == c.kind) again(v.design[row]);
    v.sensed.clear();
    v.late.clear();
    for (std::size_t row = 0; row < v.size(); ++row) {
        const Kind& of_row = scene.kinds[s.kind(row)];
        v.first_sensed[row] = static_cast<std::uint32_t>(v.sensed.size());
        v.sensed.resize(v.sensed.size() + of_row.sensors.size(), 0.0f);
        v.first_late[row] = static_cast<std::uint32_t>(v.late.size());
        v.late.resize(v.late.size() + late_readings(of_row), 0.0f);
    }
    take_over(s, std::move(scene));
    return std::nullopt;
}

std::optional<Error> carry_out(WorldState& s, const AddSource& c) {
    Scene scene = *s.scene;
    Source source = c.source;
    source.name = free_name(scene.sources, source.name, word(source.channel));
    scene.sources.insert(place_in(scene.sources, place_for(scene.sources, c.before)), std::move(source));
    return take_over_if_sound(s, std::move(scene));
}

std::optional<Error> carry_out(WorldState& s, const RemoveSource& c) {
    if (auto error = missing(s.scene->sources, c.source, "source")) return error;
    Scene scene = *s.scene;
    // Starts that face it keep the direction in which it stood.
    for (Start& start : scene.starts) {
        const Source& gone = scene.sources[static_cast<std::size_t>(c.source)];
        if (start.facing != gone.name) continue;
        start.heading = maths::wrap_angle(start.heading + maths::arctangent2(gone.y - start.y, gone.x - start.x));
        start.facing.clear();
    }
    scene.sources.erase(place_in(scene.sources, c.source));
    take_over(s, std::move(scene));
    return std::nullopt;
}

std::optional<Error> carry_out(WorldState& s, const EditSource& c) {
    if (auto error = missing(s.scene->sources, c.source, "source")) return error;
    Scene scene = *s.scene;
    Source& source = *place_in(scene.sources, c.source);
    const std::string name = source.name;  // starts and checks know it by this
    source = c.to;
    source.name = name;
    return take_over_if_sound(s, std::move(scene));
}

std::optional<Error> carry_out(WorldState& s, const MoveSource& c) {
    if (auto error = missing(s.scene->sources, c.source, "source")) return error;
    if (!is_finite({c.x, c.y})) return not_finite();
    Scene scene = *s.scene;
    Source& source = *place_in(scene.sources, c.source);
    source.x = std::clamp(c.x, -1000.0f, 1000.0f);
    source.y = std::clamp(c.y, -1000.0f, 1000.0f);
    if (source.solid)
        take_over(s, std::move(scene));
    else
        s.scene = std::make_shared<const Scene>(std::move(scene));
    return std::nullopt;
}

std::optional<Error> carry_out(WorldState& s, const AddObstacle& c) {
    Scene scene = *s.scene;
    Obstacle obstacle = c.obstacle;
    obstacle.name = free_name(scene.obstacles, obstacle.name, "obstacle");
    const int index = place_for(scene.obstacles, c.before);
    const Motion motion = at_rest({obstacle.x, obstacle.y, obstacle.heading});
    scene.obstacles.insert(place_in(scene.obstacles, index), std::move(obstacle));
    if (auto error = check_scene(scene)) return error;
    s.obstacles.insert(place_in(s.obstacles, index), motion);
    take_over(s, std::move(scene));
    return std::nullopt;
}

std::optional<Error> carry_out(WorldState& s, const RemoveObstacle& c) {
    if (auto error = missing(s.scene->obstacles, c.obstacle, "obstacle")) return error;
    Scene scene = *s.scene;
    scene.obstacles.erase(place_in(scene.obstacles, c.obstacle));
    s.obstacles.erase(place_in(s.obstacles, c.obstacle));
    take_over(s, std::move(scene));
    return std::nullopt;
}

std::optional<Error> carry_out(WorldState& s, const EditObstacle& c) {
    if (auto error = missing(s.scene->obstacles, c.obstacle, "obstacle")) return error;
    Scene scene = *s.scene;
    Obstacle& obstacle = *place_in(scene.obstacles, c.obstacle);
    const std::string name = obstacle.name;
    obstacle = c.to;
    obstacle.name = name;
    const Motion motion = at_rest({obstacle.x, obstacle.y, obstacle.heading});
    if (auto error = check_scene(scene)) return error;
    *place_in(s.obstacles, c.obstacle) = motion;
    take_over(s, std::move(scene));
    return std::nullopt;
}

std::optional<Error> carry_out(WorldState& s, const MoveObstacle& c) {
    if (auto error = missing(s.scene->obstacles, c.obstacle, "obstacle")) return error;
    if (!is_finite({c.x, c.y, c.heading})) return not_finite();
    Obstacle moved = s.scene->obstacles[static_cast<std::size_t>(c.obstacle)];
    moved.x = std::clamp(c.x, -1000.0f, 1000.0f);
    moved.y = std::clamp(c.y, -1000.0f, 1000.0f);
    moved.heading = maths::wrap_angle(c.heading);
    return carry_out(s, EditObstacle{c.obstacle, std::move(moved)});
}

std::optional<Error> carry_out(WorldState& s, const Retitle& c) {
    Scene scene = *s.scene;
    scene.title = c.title;
    if (auto error = check_scene(scene)) return error;
    s.scene = std::make_shared<const Scene>(std::move(scene));
    return std::nullopt;
}

}  // namespace braitenlab

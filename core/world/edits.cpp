#include "core/world/edits.h"

#include "core/maths/angle.h"
#include "core/scene/enums.h"

namespace braitenlab::world {

namespace {

std::vector<maths::vec2> posts_of(const Scene& scene) {
    std::vector<maths::vec2> posts;
    for (const Source& source : scene.sources)
        if (source.solid) posts.push_back({source.x, source.y});
    return posts;
}

// Replaces the scene after an edit of its sources. Only solid sources have a body and an outline; if they do not
// change, the world is not rebuilt, so that an edit of a source's values is cheap and does not change the contacts.
void replace_sources(WorldData& s, Scene scene) {
    if (posts_of(*s.scene) == posts_of(scene))
        s.scene = std::make_shared<const Scene>(std::move(scene));
    else
        replace_scene(s, std::move(scene));
}

std::optional<Error> replace_sources_if_valid(WorldData& s, Scene scene) {
    if (auto error = check_scene(scene)) return error;
    replace_sources(s, std::move(scene));
    return std::nullopt;
}

}  // namespace

std::optional<Error> execute(WorldData& s, const SetSensors& c) {
    if (auto error = missing(s.scene->kinds, c.kind, "kind")) return error;
    Scene scene = *s.scene;
    Kind& kind = scene.kinds[static_cast<std::size_t>(c.kind)];
    kind.sensors = c.sensors;
    kind.brain = s.kind_brains[static_cast<std::size_t>(c.kind)]->graph;
    if (auto error = check_scene(scene)) return error;

    // Brains refer to sensors by name; compile every brain of the kind again for the new sensors.
    std::vector<std::pair<SharedBrain, SharedBrain>> made;
    const auto again = [&](SharedBrain& brain) {
        for (const auto& [before, after] : made)
            if (before == brain) return void(brain = after);
        made.emplace_back(brain, *compile_brain(brain->graph, kind));
        brain = made.back().second;
    };
    again(s.kind_brains[static_cast<std::size_t>(c.kind)]);
    Vehicles& v = s.vehicles;
    for (std::size_t row = 0; row < v.size(); ++row)
        if (v.kind[row] == c.kind) again(v.brain[row]);
    v.sensed.clear();
    v.delayed.clear();
    for (std::size_t row = 0; row < v.size(); ++row) {
        const Kind& of_row = scene.kinds[s.kind(row)];
        v.first_sensed[row] = static_cast<std::uint32_t>(v.sensed.size());
        v.sensed.resize(v.sensed.size() + of_row.sensors.size(), 0.0f);
        v.first_delayed[row] = static_cast<std::uint32_t>(v.delayed.size());
        v.delayed.resize(v.delayed.size() + delayed_readings(of_row), 0.0f);
    }
    replace_scene(s, std::move(scene));
    return std::nullopt;
}

std::optional<Error> execute(WorldData& s, const AddSource& c) {
    Scene scene = *s.scene;
    Source source = c.source;
    source.name = free_name(scene.sources, source.name, word(source.channel));
    scene.sources.insert(iterator_at(scene.sources, insertion_index(scene.sources, c.before)), std::move(source));
    return replace_sources_if_valid(s, std::move(scene));
}

std::optional<Error> execute(WorldData& s, const RemoveSource& c) {
    if (auto error = missing(s.scene->sources, c.source, "source")) return error;
    Scene scene = *s.scene;
    // Starts that face the source get a fixed heading in its direction.
    for (Start& start : scene.starts) {
        const Source& removed = scene.sources[static_cast<std::size_t>(c.source)];
        if (start.facing != removed.name) continue;
        start.heading = maths::wrap_angle(start.heading + maths::arctangent2(removed.y - start.y, removed.x - start.x));
        start.facing.clear();
    }
    scene.sources.erase(iterator_at(scene.sources, c.source));
    replace_sources(s, std::move(scene));
    return std::nullopt;
}

std::optional<Error> execute(WorldData& s, const EditSource& c) {
    if (auto error = missing(s.scene->sources, c.source, "source")) return error;
    Scene scene = *s.scene;
    Source& source = *iterator_at(scene.sources, c.source);
    const std::string name = source.name;  // starts and checks refer to it
    source = c.to;
    source.name = name;
    return replace_sources_if_valid(s, std::move(scene));
}

std::optional<Error> execute(WorldData& s, const MoveSource& c) {
    if (auto error = missing(s.scene->sources, c.source, "source")) return error;
    if (!is_finite({c.x, c.y})) return not_finite();
    Scene scene = *s.scene;
    Source& source = *iterator_at(scene.sources, c.source);
    source.x = std::clamp(c.x, -1000.0f, 1000.0f);
    source.y = std::clamp(c.y, -1000.0f, 1000.0f);
    replace_sources(s, std::move(scene));
    return std::nullopt;
}

std::optional<Error> execute(WorldData& s, const AddObstacle& c) {
    Scene scene = *s.scene;
    Obstacle obstacle = c.obstacle;
    obstacle.name = free_name(scene.obstacles, obstacle.name, "obstacle");
    const int index = insertion_index(scene.obstacles, c.before);
    const mechanics::Motion motion = mechanics::at_rest({obstacle.x, obstacle.y}, obstacle.heading);
    scene.obstacles.insert(iterator_at(scene.obstacles, index), std::move(obstacle));
    if (auto error = check_scene(scene)) return error;
    s.obstacles.insert(iterator_at(s.obstacles, index), motion);
    replace_scene(s, std::move(scene));
    return std::nullopt;
}

std::optional<Error> execute(WorldData& s, const RemoveObstacle& c) {
    if (auto error = missing(s.scene->obstacles, c.obstacle, "obstacle")) return error;
    Scene scene = *s.scene;
    scene.obstacles.erase(iterator_at(scene.obstacles, c.obstacle));
    s.obstacles.erase(iterator_at(s.obstacles, c.obstacle));
    replace_scene(s, std::move(scene));
    return std::nullopt;
}

std::optional<Error> execute(WorldData& s, const EditObstacle& c) {
    if (auto error = missing(s.scene->obstacles, c.obstacle, "obstacle")) return error;
    Scene scene = *s.scene;
    Obstacle& obstacle = *iterator_at(scene.obstacles, c.obstacle);
    const std::string name = obstacle.name;
    obstacle = c.to;
    obstacle.name = name;
    const mechanics::Motion motion = mechanics::at_rest({obstacle.x, obstacle.y}, obstacle.heading);
    if (auto error = check_scene(scene)) return error;
    *iterator_at(s.obstacles, c.obstacle) = motion;
    replace_scene(s, std::move(scene));
    return std::nullopt;
}

std::optional<Error> execute(WorldData& s, const MoveObstacle& c) {
    if (auto error = missing(s.scene->obstacles, c.obstacle, "obstacle")) return error;
    if (!is_finite({c.x, c.y, c.heading})) return not_finite();
    Obstacle moved = s.scene->obstacles[static_cast<std::size_t>(c.obstacle)];
    moved.x = std::clamp(c.x, -1000.0f, 1000.0f);
    moved.y = std::clamp(c.y, -1000.0f, 1000.0f);
    moved.heading = maths::wrap_angle(c.heading);
    return execute(s, EditObstacle{c.obstacle, std::move(moved)});
}

}  // namespace braitenlab::world

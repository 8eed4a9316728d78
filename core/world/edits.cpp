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

// Replaces the scene after an edit of its zones. The world is rebuilt only if physics depends on the edit.
void replace_zones(WorldData& s, Scene scene) {
    if (may_skip_an_impact(*s.scene) != may_skip_an_impact(scene)) return replace_scene(s, std::move(scene));
    s.scene = std::make_shared<const Scene>(std::move(scene));
    s.environment.ground = sensing::Ground(*s.scene);
}

// Replaces the scene by an edited one, or returns why there is none.
template <class Replace>
std::optional<Error> replace_if_valid(WorldData& s, Result<Scene> edited, Replace replace) {
    if (!edited) return edited.error();
    replace(s, std::move(*edited));
    return std::nullopt;
}

// As above, after an edit of one obstacle, which is at rest then at its pose in the scene.
std::optional<Error> replace_obstacle(WorldData& s, int index, Result<Scene> edited) {
    if (!edited) return edited.error();
    const Obstacle& to = *iterator_at(edited->obstacles, index);
    *iterator_at(s.obstacles, index) = mechanics::at_rest({to.x, to.y}, to.heading);
    replace_scene(s, std::move(*edited));
    return std::nullopt;
}

}  // namespace

void compile_again(WorldData& s, int index, const Kind& kind) {
    struct Made {
        SharedBrain before;
        const OwnDesign* design;
        SharedBrain after;
    };
    std::vector<Made> all;
    const auto again = [&](SharedBrain& brain, const OwnDesign* own) {
        for (const Made& made : all)
            if (made.before == brain && made.design == own) return void(brain = made.after);
        Kind design = kind;
        if (own) design.sensors = own->kind.sensors;
        all.push_back({brain, own, *compile_brain(brain->graph, design)});
        brain = all.back().after;
    };
    again(s.kind_brains[static_cast<std::size_t>(index)], nullptr);
    Vehicles& v = s.vehicles;
    for (std::size_t row = 0; row < v.size(); ++row)
        if (v.kind[row] == index) again(v.brain[row], v.design[row].get());
}

std::optional<Error> execute(WorldData& s, const AddSource& c) {
    return replace_if_valid(s, with_added(*s.scene, &Scene::sources, c.source, c.before, word(c.source.channel)),
                            replace_sources);
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
    return replace_if_valid(s, without(std::move(scene), &Scene::sources, c.source, "source"), replace_sources);
}

std::optional<Error> execute(WorldData& s, const EditSource& c) {
    return replace_if_valid(s, with_edited(*s.scene, &Scene::sources, c.source, c.to, "source"), replace_sources);
}

std::optional<Error> execute(WorldData& s, const MoveSource& c) {
    return replace_if_valid(s, with_moved(*s.scene, &Scene::sources, c.source, {c.x, c.y}, "source"), replace_sources);
}

std::optional<Error> execute(WorldData& s, const AddObstacle& c) {
    auto scene = with_added(*s.scene, &Scene::obstacles, c.obstacle, c.before, "obstacle");
    if (!scene) return scene.error();
    s.obstacles.insert(iterator_at(s.obstacles, insertion_index(s.obstacles, c.before)),
                       mechanics::at_rest({c.obstacle.x, c.obstacle.y}, c.obstacle.heading));
    replace_scene(s, std::move(*scene));
    return std::nullopt;
}

std::optional<Error> execute(WorldData& s, const RemoveObstacle& c) {
    auto scene = without(*s.scene, &Scene::obstacles, c.obstacle, "obstacle");
    if (!scene) return scene.error();
    s.obstacles.erase(iterator_at(s.obstacles, c.obstacle));
    replace_scene(s, std::move(*scene));
    return std::nullopt;
}

std::optional<Error> execute(WorldData& s, const EditObstacle& c) {
    return replace_obstacle(s, c.obstacle, with_edited(*s.scene, &Scene::obstacles, c.obstacle, c.to, "obstacle"));
}

std::optional<Error> execute(WorldData& s, const MoveObstacle& c) {
    return replace_obstacle(s, c.obstacle,
                            with_moved(*s.scene, &Scene::obstacles, c.obstacle, {c.x, c.y, c.heading}, "obstacle"));
}

std::optional<Error> execute(WorldData& s, const AddZone& c) {
    return replace_if_valid(s, with_added(*s.scene, &Scene::zones, c.zone, c.before, "zone"), replace_zones);
}

std::optional<Error> execute(WorldData& s, const RemoveZone& c) {
    return replace_if_valid(s, without(*s.scene, &Scene::zones, c.zone, "zone"), replace_zones);
}

std::optional<Error> execute(WorldData& s, const EditZone& c) {
    return replace_if_valid(s, with_edited(*s.scene, &Scene::zones, c.zone, c.to, "zone"), replace_zones);
}

std::optional<Error> execute(WorldData& s, const MoveZone& c) {
    return replace_if_valid(s, with_moved(*s.scene, &Scene::zones, c.zone, {c.x, c.y, c.heading}, "zone"),
                            replace_zones);
}

namespace {

std::optional<Error> refusal(const WorldData& s, const std::vector<MoveVehicle>& moves) {
    for (const MoveVehicle& c : moves) {
        if (!s.row_of(c.vehicle)) return unknown_vehicle(c.vehicle);
        if (!is_finite({c.x, c.y, c.heading})) return not_finite();
    }
    return std::nullopt;
}

std::optional<Error> move_in(Scene& scene, const MoveObjects& c) {
    for (const MoveSource& m : c.of_sources)
        if (auto error = move(scene.sources, m.source, {m.x, m.y}, "source")) return error;
    for (const MoveObstacle& m : c.of_obstacles)
        if (auto error = move(scene.obstacles, m.obstacle, {m.x, m.y, m.heading}, "obstacle")) return error;
    for (const MoveZone& m : c.of_zones)
        if (auto error = move(scene.zones, m.zone, {m.x, m.y, m.heading}, "zone")) return error;
    return std::nullopt;
}

}  // namespace

std::optional<Error> execute(WorldData& s, const MoveObjects& c) {
    if (auto error = refusal(s, c.of_vehicles)) return error;
    if (!c.of_sources.empty() || !c.of_obstacles.empty() || !c.of_zones.empty()) {
        Scene scene = *s.scene;
        if (auto error = move_in(scene, c)) return error;
        for (const MoveObstacle& m : c.of_obstacles) {
            const Obstacle& to = *iterator_at(scene.obstacles, m.obstacle);
            *iterator_at(s.obstacles, m.obstacle) = mechanics::at_rest({to.x, to.y}, to.heading);
        }
        if (!c.of_obstacles.empty() || (!c.of_sources.empty() && !c.of_zones.empty()))
            replace_scene(s, std::move(scene));
        else if (!c.of_zones.empty())
            replace_zones(s, std::move(scene));
        else
            replace_sources(s, std::move(scene));
    }
    for (const MoveVehicle& m : c.of_vehicles)
        if (auto error = execute(s, m)) return error;
    return std::nullopt;
}

}  // namespace braitenlab::world

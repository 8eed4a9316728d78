// Commands that edit the arena, the ecology and the kinds, in the running world and in its scene.
#include <algorithm>
#include <utility>

#include "core/maths/angle.h"
#include "core/scene/arena.h"
#include "core/world/edits.h"

namespace braitenlab::world {

namespace {

template <class Placed>
void bring_inside(const Arena& arena, Placed& placed) {
    const maths::vec2 to = moved_inside(arena, {placed.x, placed.y});
    placed.x = to.x, placed.y = to.y;
}

void bring_vehicles_inside(WorldData& s) {
    const Arena& arena = s.scene->arena;
    for (std::size_t row = 0; row < s.vehicles.size(); ++row) {
        const mechanics::Motion& m = s.vehicles.motion[row];
        if (is_inside(arena, m.position)) continue;
        const maths::vec2 to = moved_inside(arena, m.position, s.kinds[s.kind(row)].reach);
        const Pose wanted{to.x, to.y, maths::wrap_angle(m.heading)};
        s.physics.set_pose(row, nearest_free_pose(s, s.vehicles.kind[row], wanted));
        read_motion(s, row);
    }
}

void rename_kind(Scene& scene, const std::string& from, const std::string& to) {
    for (Start& start : scene.starts)
        if (start.kind == from) start.kind = to;
    for (Member& member : scene.members)
        if (member.kind == from) member.kind = to;
}

}  // namespace

std::optional<Error> execute(WorldData& s, const EditArena& c) {
    Scene scene = *s.scene;
    scene.arena = c.to;
    for (Start& start : scene.starts) bring_inside(c.to, start);
    for (Member& member : scene.members) bring_inside(c.to, member);
    if (auto error = check_edited(s, scene)) return error;
    replace_scene(s, std::move(scene));
    bring_vehicles_inside(s);
    return std::nullopt;
}

std::optional<Error> execute(WorldData& s, const EditEcology& c) {
    Scene scene = *s.scene;
    const int population = scene.ecology.population;
    scene.ecology = c.to;
    scene.ecology.population = population;
    if (auto error = check_scene(scene)) return error;
    s.scene = std::make_shared<const Scene>(std::move(scene));
    return std::nullopt;
}

std::optional<Error> execute(WorldData& s, const AddKind& c) {
    Scene scene = *s.scene;
    Kind kind = c.kind;
    kind.name = free_name(scene.kinds, kind.name, "kind");
    auto brain = compile_brain(kind.brain, kind);
    if (!brain) return brain.error();
    const int index = insertion_index(scene.kinds, c.before);
    scene.kinds.insert(iterator_at(scene.kinds, index), std::move(kind));
    if (auto error = check_scene(scene)) return error;
    s.kind_brains.insert(iterator_at(s.kind_brains, index), *brain);
    for (std::int32_t& of_vehicle : s.vehicles.kind) of_vehicle += of_vehicle >= index;
    replace_scene(s, std::move(scene));
    return std::nullopt;
}

std::optional<Error> execute(WorldData& s, const RemoveKind& c) {
    if (auto error = missing(s.scene->kinds, c.kind, "kind")) return error;
    Scene scene = *s.scene;
    const std::string name = scene.kinds[static_cast<std::size_t>(c.kind)].name;
    const auto is_of_it = [&](const auto& entry) { return entry.kind == name; };
    const auto count = std::count(s.vehicles.kind.begin(), s.vehicles.kind.end(), c.kind);
    if (count > 0) return error_of(message_of("kind_in_use", count, name));
    if (std::any_of(scene.starts.begin(), scene.starts.end(), is_of_it) ||
        std::any_of(scene.members.begin(), scene.members.end(), is_of_it))
        return error_of(message_of("kind_starts", name));
    scene.kinds.erase(iterator_at(scene.kinds, c.kind));
    if (auto error = check_scene(scene)) return error;
    s.kind_brains.erase(iterator_at(s.kind_brains, c.kind));
    for (std::int32_t& of_vehicle : s.vehicles.kind) of_vehicle -= of_vehicle > c.kind;
    replace_scene(s, std::move(scene));
    return std::nullopt;
}

std::optional<Error> execute(WorldData& s, const EditKind& c) {
    if (auto error = missing(s.scene->kinds, c.kind, "kind")) return error;
    Scene scene = *s.scene;
    Kind& kind = scene.kinds[static_cast<std::size_t>(c.kind)];
    const Kind before = std::exchange(kind, c.to);
    kind.sensors = before.sensors;
    kind.brain = s.kind_brains[static_cast<std::size_t>(c.kind)]->graph;
    if (kind.name.empty()) kind.name = before.name;
    if (kind.name != before.name) rename_kind(scene, before.name, kind.name);
    if (auto error = check_edited(s, scene)) return error;

    compile_again(s, c.kind, kind);
    replace_scene(s, scene);
    Vehicles& v = s.vehicles;
    for (std::size_t row = 0; row < v.size(); ++row) {
        if (v.kind[row] != c.kind) continue;
        v.gain[row] = motor_gains(s, c.kind, v.id[row]);
        if (v.driver[row] == before.driver && c.to.driver != before.driver) {
            v.driver[row] = c.to.driver;
            v.steered[row] = {};
        }
        if (static_cast<std::size_t>(v.waypoint[row]) >= c.to.waypoints.size()) v.waypoint[row] = 0;
    }
    return std::nullopt;
}

}  // namespace braitenlab::world

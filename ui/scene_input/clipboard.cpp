#include "ui/scene_input/clipboard.h"

#include <algorithm>

#include "core/scene/arena.h"

namespace braitenlab::ui {

using maths::vec2;

namespace {

constexpr vec2 beside_original{0.8f, -0.8f};  // m

// The kind with its present brain is in the copy; a start refers to it.
void copy_vehicle(Scene& copy, const Snapshot& now, const VehicleView& v) {
    Kind kind = now.scene->kinds[static_cast<std::size_t>(v.kind)];
    const auto index = static_cast<std::size_t>(v.kind);
    if (index < now.kind_brains.size()) kind.brain = *now.kind_brains[index];
    Start start{
        .name = std::to_string(copy.starts.size()), .kind = kind.name, .x = v.x, .y = v.y, .heading = v.heading};
    if (v.driver != kind.driver) start.driver = v.driver;
    if (*brain_of(now, v) != kind.brain) start.brain = *brain_of(now, v);
    if (v.design >= 0) start.sensors = kind_of(now, v).sensors;
    if (v.start >= 0) start.colour = now.scene->starts[static_cast<std::size_t>(v.start)].colour;
    copy.starts.push_back(std::move(start));
    if (find_kind(copy, kind.name) < 0) copy.kinds.push_back(std::move(kind));
}

template <class Element>
void copy_at(std::vector<Element>& copies, const std::vector<Element>& all, int index, const Pose& at) {
    Element copy = all[static_cast<std::size_t>(index)];
    copy.x = at.x, copy.y = at.y;
    if constexpr (requires { copy.heading; }) copy.heading = at.heading;
    copies.push_back(std::move(copy));
}

// Calls f with each object that has a position.
template <class Copy, class F>
void each_object(Copy& copy, F f) {
    for (auto& start : copy.starts) f(start);
    for (auto& source : copy.sources) f(source);
    for (auto& obstacle : copy.obstacles) f(obstacle);
    for (auto& zone : copy.zones) f(zone);
}

// Of the rectangle around all positions.
vec2 middle_of(const Scene& copy) {
    vec2 low{1e9f, 1e9f}, high{-1e9f, -1e9f};
    each_object(copy, [&](const auto& object) {
        low = {std::min(low.x, object.x), std::min(low.y, object.y)};
        high = {std::max(high.x, object.x), std::max(high.y, object.y)};
    });
    return (low + high) / 2;
}

// Name, brain and share may differ.
bool same_design(Kind a, const Kind& b) {
    a.name = b.name;
    a.brain = b.brain;
    a.share = b.share;
    return a == b;
}

// The scene's kind of the same name and design. Where the name belongs to another design, the first kind of this
// design: an earlier paste has added the kind under another name. −1: none.
int kind_in(const Scene& scene, const Kind& kind) {
    const int index = find_kind(scene, kind.name);
    if (index < 0 || same_design(kind, scene.kinds[static_cast<std::size_t>(index)])) return index;
    const auto found =
        std::find_if(scene.kinds.begin(), scene.kinds.end(), [&](const Kind& each) { return same_design(kind, each); });
    return found == scene.kinds.end() ? -1 : static_cast<int>(found - scene.kinds.begin());
}

// Adds the commands for the kinds that the scene lacks. The index in the scene of each kind of the copy.
std::vector<int> paste_kinds(const Scene& scene, const Scene& copy, std::vector<Command>& commands) {
    std::vector<int> indices;
    auto next = static_cast<int>(scene.kinds.size());
    for (Kind kind : copy.kinds) {
        int index = kind_in(scene, kind);
        if (index < 0) {
            index = next++;
            kind.share = 0;  // the random population stays as it is
            commands.emplace_back(AddKind{std::move(kind)});
        }
        indices.push_back(index);
    }
    return indices;
}

AddVehicle added_vehicle(const Snapshot& now, const Kind& copied_kind, int kind, const Start& start) {
    AddVehicle add;
    add.kind = kind;
    add.at = Pose{start.x, start.y, start.heading};
    const auto index = static_cast<std::size_t>(kind);
    const BrainGraph& of_kind = index < now.kind_brains.size() ? *now.kind_brains[index] : copied_kind.brain;
    const BrainGraph& brain = start.brain ? *start.brain : copied_kind.brain;
    if (brain != of_kind) add.brain = brain;
    add.driver = start.driver;
    add.sensors = start.sensors;
    add.colour = start.colour;
    return add;
}

}  // namespace

Scene copied(const Snapshot& now, const std::vector<SceneObject>& objects) {
    Scene copy;
    for (const SceneObject& object : objects) {
        const auto at = place_of(now, object);
        if (!at) continue;
        if (object.kind == SceneObjectKind::vehicle) copy_vehicle(copy, now, *find_vehicle(now, object.index));
        if (object.kind == SceneObjectKind::source) copy_at(copy.sources, now.scene->sources, object.index, *at);
        if (object.kind == SceneObjectKind::obstacle) copy_at(copy.obstacles, now.scene->obstacles, object.index, *at);
        if (object.kind == SceneObjectKind::zone) copy_at(copy.zones, now.scene->zones, object.index, *at);
    }
    return copy;
}

std::size_t object_count(const Scene& copy) {
    return copy.starts.size() + copy.sources.size() + copy.obstacles.size() + copy.zones.size();
}

std::vector<Command> pasted(const Snapshot& now, const Scene& copy, std::optional<vec2> middle) {
    std::vector<Command> commands;
    const std::vector<int> kinds = paste_kinds(*now.scene, copy, commands);
    Scene moved = copy;
    const vec2 by = middle ? *middle - middle_of(copy) : beside_original;
    const Arena& arena = now.scene->arena;
    each_object(moved, [&](auto& object) {
        const vec2 to = moved_inside(arena, vec2{object.x, object.y} + by);
        object.x = to.x, object.y = to.y;
    });
    for (const Zone& zone : moved.zones) commands.emplace_back(AddZone{zone});
    for (const Obstacle& obstacle : moved.obstacles) commands.emplace_back(AddObstacle{obstacle});
    for (const Source& source : moved.sources) commands.emplace_back(AddSource{source});
    for (const Start& start : moved.starts) {
        const auto kind = static_cast<std::size_t>(find_kind(copy, start.kind));
        commands.emplace_back(added_vehicle(now, copy.kinds[kind], kinds[kind], start));
    }
    return commands;
}

}  // namespace braitenlab::ui

#include "core/world/edits.h"

#include "core/scene/enums.h"

namespace braitenlab::world {

namespace {

std::vector<maths::vec2> posts_of(const Scene& scene) {
    std::vector<maths::vec2> posts;
    for (const Source& source : scene.sources)
        if (source.solid) posts.push_back({source.x, source.y});
    return posts;
}

// Replaces the scene after an edit of its sources, obstacles or zones. The world is rebuilt only if physics depends on
// the edit, so that an edit of a lamp's values is cheap and does not change the contacts.
template <class Object>
void replace(WorldData& s, Scene scene) {
    bool rebuilds = true;
    if constexpr (std::is_same_v<Object, Source>) rebuilds = posts_of(*s.scene) != posts_of(scene);
    if constexpr (std::is_same_v<Object, Zone>) rebuilds = may_skip_an_impact(*s.scene) != may_skip_an_impact(scene);
    if (rebuilds) return replace_scene(s, std::move(scene));
    s.scene = std::make_shared<const Scene>(std::move(scene));
    if constexpr (std::is_same_v<Object, Zone>) s.environment.ground = sensing::Ground(*s.scene);
}

// Starts that face a source get a fixed heading in its direction.
void release_starts(Scene& scene, const Source& removed) {
    for (Start& start : scene.starts) {
        if (start.facing != removed.name) continue;
        start.heading = maths::wrap_angle(start.heading + maths::arctangent2(removed.y - start.y, removed.x - start.x));
        start.facing.clear();
    }
}

mechanics::Motion at_rest(const Obstacle& o) { return mechanics::at_rest({o.x, o.y}, o.heading); }

template <class Object>
constexpr bool has_body = std::is_same_v<Object, Obstacle>;

template <class Object>
constexpr auto list = ObjectList<Object>::list;

// Moves an object to a pose, clamped to the range of a position. No rule of check_scene but that of obstacles that push
// each other (check_size) depends on these positions: a drag does not check the whole scene for each object.
template <class Object>
std::optional<Error> move_in(Scene& scene, const MoveObject<Object>& c) {
    if (auto error = missing(scene.*list<Object>, c.index, ObjectList<Object>::word)) return error;
    if (!is_finite({c.x, c.y, c.heading})) return not_finite();
    Object& object = *iterator_at(scene.*list<Object>, c.index);
    object.x = std::clamp(c.x, -1000.0f, 1000.0f);
    object.y = std::clamp(c.y, -1000.0f, 1000.0f);
    if constexpr (requires { object.heading; }) object.heading = maths::wrap_angle(c.heading);
    return std::nullopt;
}

// Puts the body of an obstacle to rest at its pose in the scene.
void rest(WorldData& s, const Scene& scene, int obstacle) {
    *iterator_at(s.obstacles, obstacle) = at_rest(scene.obstacles[static_cast<std::size_t>(obstacle)]);
}

std::optional<Error> refusal(const WorldData& s, const std::vector<MoveVehicle>& moves) {
    for (const MoveVehicle& c : moves) {
        if (!s.row_of(c.vehicle)) return unknown_vehicle(c.vehicle);
        if (!is_finite({c.x, c.y, c.heading})) return not_finite();
    }
    return std::nullopt;
}

template <class Object>
std::optional<Error> move_all_in(Scene& scene, const std::vector<MoveObject<Object>>& moves) {
    for (const MoveObject<Object>& move : moves)
        if (auto error = move_in(scene, move)) return error;
    return std::nullopt;
}

}  // namespace

std::optional<Error> check_size(const Scene& scene, const PresentParts& parts) {
    const auto fault = size_fault(scene, parts);
    if (!fault) return std::nullopt;
    return error_of(fault->path.empty() ? fault->what : Message(fault->path + ": ") + fault->what);
}

std::optional<Error> check_edited(const WorldData& s, const Scene& scene) {
    if (auto error = check_scene(scene)) return error;
    return check_size(scene, present_parts(s));
}

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

template <class Object>
std::optional<Error> execute(WorldData& s, const AddObject<Object>& c) {
    Scene scene = *s.scene;
    auto& all = scene.*list<Object>;
    const int index = insertion_index(all, c.before);
    Object added = c.object;
    std::string_view named = ObjectList<Object>::word;
    if constexpr (std::is_same_v<Object, Source>) named = word(added.channel);
    added.name = free_name(all, added.name, named);
    all.insert(iterator_at(all, index), std::move(added));
    if (auto error = check_edited(s, scene)) return error;
    if constexpr (has_body<Object>) s.obstacles.insert(iterator_at(s.obstacles, index), at_rest(c.object));
    replace<Object>(s, std::move(scene));
    return std::nullopt;
}

template <class Object>
std::optional<Error> execute(WorldData& s, const RemoveObject<Object>& c) {
    Scene scene = *s.scene;
    auto& all = scene.*list<Object>;
    if (auto error = missing(all, c.index, ObjectList<Object>::word)) return error;
    if constexpr (std::is_same_v<Object, Source>) release_starts(scene, *iterator_at(all, c.index));
    all.erase(iterator_at(all, c.index));
    if constexpr (has_body<Object>) s.obstacles.erase(iterator_at(s.obstacles, c.index));
    replace<Object>(s, std::move(scene));
    return std::nullopt;
}

template <class Object>
std::optional<Error> execute(WorldData& s, const EditObject<Object>& c) {
    Scene scene = *s.scene;
    if (auto error = missing(scene.*list<Object>, c.index, ObjectList<Object>::word)) return error;
    Object& object = *iterator_at(scene.*list<Object>, c.index);
    std::string name = std::move(object.name);
    object = c.to;
    object.name = std::move(name);
    if (auto error = check_edited(s, scene)) return error;
    if constexpr (has_body<Object>) rest(s, scene, c.index);
    replace<Object>(s, std::move(scene));
    return std::nullopt;
}

template <class Object>
std::optional<Error> execute(WorldData& s, const MoveObject<Object>& c) {
    Scene scene = *s.scene;
    if (auto error = move_in(scene, c)) return error;
    if constexpr (has_body<Object>) {
        if (auto error = check_size(scene, present_parts(s))) return error;
        rest(s, scene, c.index);
    }
    replace<Object>(s, std::move(scene));
    return std::nullopt;
}

template std::optional<Error> execute(WorldData&, const AddSource&);
template std::optional<Error> execute(WorldData&, const RemoveSource&);
template std::optional<Error> execute(WorldData&, const EditSource&);
template std::optional<Error> execute(WorldData&, const MoveSource&);
template std::optional<Error> execute(WorldData&, const AddObstacle&);
template std::optional<Error> execute(WorldData&, const RemoveObstacle&);
template std::optional<Error> execute(WorldData&, const EditObstacle&);
template std::optional<Error> execute(WorldData&, const MoveObstacle&);
template std::optional<Error> execute(WorldData&, const AddZone&);
template std::optional<Error> execute(WorldData&, const RemoveZone&);
template std::optional<Error> execute(WorldData&, const EditZone&);
template std::optional<Error> execute(WorldData&, const MoveZone&);

std::optional<Error> execute(WorldData& s, const MoveObjects& c) {
    if (auto error = refusal(s, c.of_vehicles)) return error;
    if (!c.of_sources.empty() || !c.of_obstacles.empty() || !c.of_zones.empty()) {
        Scene scene = *s.scene;
        if (auto error = move_all_in(scene, c.of_sources)) return error;
        if (auto error = move_all_in(scene, c.of_obstacles)) return error;
        if (auto error = move_all_in(scene, c.of_zones)) return error;
        if (!c.of_obstacles.empty())
            if (auto error = check_size(scene, present_parts(s))) return error;
        for (const MoveObstacle& m : c.of_obstacles) rest(s, scene, m.index);
        if (!c.of_obstacles.empty() || (!c.of_sources.empty() && !c.of_zones.empty()))
            replace_scene(s, std::move(scene));
        else if (!c.of_zones.empty())
            replace<Zone>(s, std::move(scene));
        else
            replace<Source>(s, std::move(scene));
    }
    for (const MoveVehicle& m : c.of_vehicles)
        if (auto error = execute(s, m)) return error;
    return std::nullopt;
}

}  // namespace braitenlab::world

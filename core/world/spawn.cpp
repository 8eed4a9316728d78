// Spawning: kinds and poses of vehicles that enter the world, and their removal.
#include <algorithm>
#include <numeric>

#include "core/maths/angle.h"
#include "core/maths/random.h"
#include "core/scene/arena.h"
#include "core/scene/population.h"
#include "core/world/world_data.h"

namespace braitenlab::world {

using maths::vec2;

namespace {

// Attempts to find a free position. After the last one overlap is accepted, and contacts separate the bodies.
constexpr int tries = 64;

// Random numbers for the pose of one vehicle in one generation, independent of those of other vehicles. The number of
// falls is part of the seed, so that a vehicle that fell over the edge does not respawn at the same pose and fall
// again.
maths::Random chance_for(const WorldData& s, VehicleId id) {
    const auto stream = (static_cast<std::uint64_t>(s.generation) << 32U) | static_cast<std::uint32_t>(id);
    return {s.seed ^ (static_cast<std::uint64_t>(s.events.falls) * 0x9e3779b97f4a7c15ULL), stream};
}

Pose start_pose(const WorldData& s, const Start& start, VehicleId id) {
    maths::Random chance = chance_for(s, id);
    Pose pose{start.x, start.y, start.heading};
    pose.x += chance.uniform(-start.place_spread, start.place_spread);
    pose.y += chance.uniform(-start.place_spread, start.place_spread);
    if (const int source = find_source(*s.scene, start.facing); source >= 0) {
        const Source& faced = s.scene->sources[static_cast<std::size_t>(source)];
        const vec2 to = vec2{faced.x, faced.y} - vec2{pose.x, pose.y};
        pose.heading += maths::arctangent2(to.y, to.x);
    }
    pose.heading = maths::wrap_angle(pose.heading + chance.uniform(-start.heading_spread, start.heading_spread));
    return pose;
}

std::vector<int> random_counts(const WorldData& s) {
    std::vector<int> counts(s.kinds.size(), 0);
    for (std::size_t row = 0; row < s.vehicles.size(); ++row)
        if (s.vehicles.start[row] < 0) ++counts[static_cast<std::size_t>(s.vehicles.kind[row])];
    return counts;
}

// Removes the elements of these rows from a column. Precondition: the rows ascend.
template <class Column>
void drop_rows(Column& column, const std::vector<std::size_t>& rows) {
    auto gone = rows.begin();
    std::size_t kept = 0;
    for (std::size_t row = 0; row < column.size(); ++row) {
        if (gone != rows.end() && *gone == row)
            ++gone;
        else if (kept++ != row)
            column[kept - 1] = std::move(column[row]);
    }
    column.resize(kept);
}

// Removes the ranges of these rows from a flat array. Updates the values of `first` but keeps its size. Precondition:
// the rows ascend.
void drop_stretches(std::vector<float>& flat, std::vector<std::uint32_t>& first, const std::vector<std::size_t>& rows) {
    auto gone = rows.begin();
    std::size_t kept = 0;
    for (std::size_t row = 0; row < first.size(); ++row) {
        const std::size_t begin = first[row], end = row + 1 < first.size() ? first[row + 1] : flat.size();
        first[row] = static_cast<std::uint32_t>(kept);
        if (gone != rows.end() && *gone == row) {
            ++gone;
        } else {
            for (std::size_t i = begin; i < end; ++i) flat[kept++] = flat[i];
        }
    }
    flat.resize(kept);
}

Pose elsewhere(const WorldData& s, std::size_t row) {
    FreeSpace free_space(s);
    return free_pose(s, free_space, s.vehicles.kind[row], s.vehicles.id[row]);
}

// The kinds of the next generation, one for each row. The shares give the numbers; vehicles with a brain or sensors of
// their own keep their kind first. A vehicle with a start keeps its kind and is not counted.
std::vector<int> next_kinds(const WorldData& s, const Vehicles& before) {
    std::vector<int> counts(s.kinds.size(), 0), kinds = before.kind;
    std::vector<int> wanted;
    for (const int start : before.start) {
        if (start >= 0) continue;
        wanted.push_back(most_wanted(*s.scene, counts));
        ++counts[static_cast<std::size_t>(wanted.back())];
    }
    std::vector<std::size_t> others;
    for (std::size_t row = 0; row < before.size(); ++row) {
        if (before.start[row] >= 0) continue;
        const auto kind = static_cast<std::size_t>(before.kind[row]);
        const SharedBrain &brain = before.brain[row], &of_kind = s.kind_brains[kind];
        const bool has_own = before.design[row] || (brain != of_kind && brain->graph != of_kind->graph);
        const auto kept = has_own ? std::find(wanted.begin(), wanted.end(), before.kind[row]) : wanted.end();
        if (kept != wanted.end())
            wanted.erase(kept);
        else
            others.push_back(row);
    }
    for (std::size_t i = 0; i < others.size(); ++i) kinds[others[i]] = wanted[i];
    return kinds;
}

}  // namespace

// Gains of the left and right motor: 1 ± Body::mismatch, uniformly distributed. They depend on the seed and the id
// only, so that a vehicle has the same gains in every generation.
std::array<float, 2> motor_gains(const WorldData& s, int kind, VehicleId id) {
    const float mismatch = s.scene->kinds[static_cast<std::size_t>(kind)].body.mismatch;
    maths::Random chance{s.seed, (std::uint64_t{0x6d6f746f} << 32U) | static_cast<std::uint32_t>(id)};
    const float left = chance.uniform(-1, 1), right = chance.uniform(-1, 1);
    return {1 + mismatch * left, 1 + mismatch * right};
}

int next_kind(const WorldData& s) { return most_wanted(*s.scene, random_counts(s)); }

Pose free_pose(const WorldData& s, FreeSpace& free_space, int kind, int number) {
    maths::Random chance = chance_for(s, number);
    const float reach = s.kinds[static_cast<std::size_t>(kind)].reach, margin = 1.5f * reach;  // m
    const Arena& arena = s.scene->arena;
    const float half_width = std::max(0.0f, arena.width / 2 - margin);
    const float half_height = std::max(0.0f, arena.height / 2 - margin);
    vec2 at;
    for (int i = 0; i < tries; ++i) {
        at.x = chance.uniform(-half_width, half_width);
        at.y = chance.uniform(-half_height, half_height);
        if (arena.round && !is_inside(arena, at, margin)) continue;
        if (free_space.is_free(at, reach)) break;
    }
    at = moved_inside(arena, at, margin);
    free_space.occupy(at, reach);
    return {at.x, at.y, chance.uniform(-maths::pi, maths::pi)};
}

void read_motion(WorldData& s, std::size_t row) { s.vehicles.motion[row] = s.physics.motion(row); }

void add_vehicle(WorldData& s, int kind, int start, VehicleId id, SharedBrain brain, const Pose& pose,
                 SharedDesign design) {
    const CompiledKind& compiled = design ? design->compiled : s.kinds[static_cast<std::size_t>(kind)];
    Vehicles& v = s.vehicles;
    each_vehicle_value([&v](const auto& value) { (v.*value.column).push_back(value.initial); });
    v.id.back() = id;
    v.kind.back() = kind;
    v.start.back() = start;
    v.driver.back() = s.scene->kinds[static_cast<std::size_t>(kind)].driver;
    v.gain.back() = motor_gains(s, kind, id);
    v.first_sensed.push_back(static_cast<std::uint32_t>(v.sensed.size()));
    v.sensed.resize(v.sensed.size() + compiled.sensors.size(), 0.0f);
    v.first_neuron.push_back(static_cast<std::uint32_t>(v.neurons.size()));
    v.neurons.resize(v.neurons.size() + static_cast<std::size_t>(brain->flat.state_size()), 0.0f);
    v.first_delayed.push_back(static_cast<std::uint32_t>(v.delayed.size()));
    v.delayed.resize(v.delayed.size() + compiled.delayed_readings, 0.0f);
    v.brain.push_back(std::move(brain));
    v.design.push_back(std::move(design));
    s.physics.add(v.id.size() - 1, id, s.scene->kinds[static_cast<std::size_t>(kind)].body,
                  mechanics::at_rest({pose.x, pose.y}, pose.heading));
    v.motion.back() = s.physics.motion(v.id.size() - 1);
    s.readings_are_stale = true;
}

void respawn(WorldData& s, std::size_t row) {
    Vehicles& v = s.vehicles;
    const VehicleId id = v.id[row];
    std::erase_if(s.marks, [id](const Mark& mark) { return mark.owner == id; });
    const int start = v.start[row];
    const Pose pose =
        start >= 0 ? start_pose(s, s.scene->starts[static_cast<std::size_t>(start)], id) : elsewhere(s, row);
    s.physics.set_pose(row, pose);
    read_motion(s, row);
    each_vehicle_value([&](const auto& value) {
        if (value.reset) (v.*value.column)[row] = value.initial;
    });
    const std::size_t first = v.first_neuron[row];
    std::fill_n(v.neurons.begin() + static_cast<std::ptrdiff_t>(first), v.brain[row]->flat.state_size(), 0.0f);
    std::fill_n(v.delayed.begin() + static_cast<std::ptrdiff_t>(v.first_delayed[row]), s.compiled(row).delayed_readings,
                0.0f);
    s.readings_are_stale = true;
}

void remove_vehicles(WorldData& s, const std::vector<std::size_t>& rows) {
    Vehicles& v = s.vehicles;
    std::vector<VehicleId> gone;
    for (const std::size_t row : rows) gone.push_back(v.id[row]);
    std::erase_if(s.marks, [&](const Mark& m) { return std::binary_search(gone.begin(), gone.end(), m.owner); });
    std::erase_if(s.looks,
                  [&](const VehicleLook& l) { return std::binary_search(gone.begin(), gone.end(), l.vehicle); });
    drop_stretches(v.sensed, v.first_sensed, rows);
    drop_stretches(v.neurons, v.first_neuron, rows);
    drop_stretches(v.delayed, v.first_delayed, rows);
    Vehicles::each_column(v, [&](auto& column) { drop_rows(column, rows); });
    s.physics.remove(rows);
}

void spawn_population(WorldData& s) {
    const Scene& scene = *s.scene;
    // `own`: an entry of Scene::starts or Scene::members, or nullptr.
    const auto add = [&s](int kind, int start, VehicleId id, const Pose& pose, const auto* own) {
        const Kind& of_kind = s.scene->kinds[static_cast<std::size_t>(kind)];
        SharedBrain brain = s.kind_brains[static_cast<std::size_t>(kind)];
        SharedDesign design = own && own->sensors ? own_design(of_kind, *own->sensors) : nullptr;
        if (design || (own && own->brain)) {  // check_scene has checked them
            const BrainGraph& graph = own->brain ? *own->brain : brain->graph;
            if (auto made = compile_brain(graph, design ? design->kind : of_kind)) brain = *made;
        }
        add_vehicle(s, kind, start, id, std::move(brain), pose, std::move(design));
        if (own && own->driver) s.vehicles.driver.back() = *own->driver;
    };
    for (std::size_t i = 0; i < scene.starts.size(); ++i) {
        const VehicleId id = s.next_id++;
        add(find_kind(scene, scene.starts[i].kind), static_cast<int>(i), id, start_pose(s, scene.starts[i], id),
            &scene.starts[i]);
    }
    std::vector<const Member*> members(static_cast<std::size_t>(scene.ecology.population));
    for (const Member& member : scene.members) members[static_cast<std::size_t>(number_of(member))] = &member;
    const std::vector<int> kinds = population_kinds(scene);
    FreeSpace free_space(s);
    for (std::size_t number = 0; number < members.size(); ++number) {
        const Member* member = members[number];
        const int kind = kinds[number];
        const VehicleId id = s.next_id++;
        const Pose random = free_pose(s, free_space, kind, static_cast<int>(number));
        add(kind, -1, id, member && member->placed ? Pose{member->x, member->y, member->heading} : random, member);
        if (member) set_look(s.looks, id, {member->label, member->colour});
    }
    s.lay_out_grids();
}

// Replaces all vehicles by the same number of vehicles with the same ids, so that a selection in the window stays
// valid. Vehicles with a start return to it. The kinds of the others are chosen again by the shares, which restores the
// balance of the population. A vehicle whose kind does not change keeps its brain and sensors.
void new_generation(WorldData& s) {
    const Vehicles before = std::move(s.vehicles);
    s.vehicles = {};
    std::vector<std::size_t> all(before.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    s.physics.remove(all);
    ++s.generation;
    s.still_ticks = 0;
    s.bites.clear();
    s.strikes.clear();
    s.marks.clear();
    const std::vector<int> kinds = next_kinds(s, before);
    FreeSpace free_space(s);
    for (std::size_t row = 0; row < before.size(); ++row) {
        const int start = before.start[row];
        const int kind = kinds[row];
        const VehicleId id = before.id[row];
        const bool is_as_before = kind == before.kind[row];
        const SharedBrain& brain = is_as_before ? before.brain[row] : s.kind_brains[static_cast<std::size_t>(kind)];
        const Pose pose = start >= 0 ? start_pose(s, s.scene->starts[static_cast<std::size_t>(start)], id)
                                     : free_pose(s, free_space, kind, id);
        if (start >= 0) free_space.occupy({pose.x, pose.y}, s.kinds[static_cast<std::size_t>(kind)].reach);
        add_vehicle(s, kind, start, id, brain, pose, is_as_before ? before.design[row] : nullptr);
    }
    s.touching.clear();
    s.rebuild();
}

}  // namespace braitenlab::world

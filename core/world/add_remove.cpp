// Commands that add, remove and move vehicles and edit starts, in the running world and in its scene.
#include <cmath>

#include "core/scene/schema.h"
#include "core/world/edits.h"

namespace braitenlab::world {

namespace {

constexpr VehicleId largest_id = 1'000'000'000;

std::optional<Error> refusal(const WorldData& s, const AddVehicle& c) {
    if (s.kinds.empty()) return error_of(message_of("no_kinds"));
    if (c.kind >= static_cast<int>(s.kinds.size()))
        return Error{fmt::format("the scene has no kind number {}", c.kind)};
    if (s.vehicles.size() >= static_cast<std::size_t>(limits::vehicles))
        return error_of(message_of("full_world", limits::vehicles));
    if (c.at && !is_finite(*c.at)) return not_finite();
    if (!(c.energy >= 0 && c.energy <= 1)) return Error{"energy is a number from 0 to 1"};
    if (c.id != no_vehicle && s.row_of(c.id)) return Error{fmt::format("vehicle {} is in the world already", c.id)};
    if (c.id < no_vehicle || c.id > largest_id) return Error{fmt::format("no vehicle can be number {}", c.id)};
    return std::nullopt;
}

// Number in the population that the vehicle with this id has or would have.
int number_in_population(const WorldData& s, VehicleId id) {
    int number = 0;
    for (std::size_t row = 0; row < s.vehicles.size() && s.vehicles.id[row] < id; ++row)
        number += s.vehicles.start[row] < 0;
    return number;
}

void renumber_members(Scene& scene, int from, int by) {
    for (Member& member : scene.members)
        if (const int number = number_of(member); number >= from) member.name = std::to_string(number + by);
}

// Adds the vehicle to the scene. Returns the index of its start; −1 if it counts towards the population.
Result<int> add_to_scene(WorldData& s, const AddVehicle& c, int kind) {
    Scene scene = *s.scene;
    const bool returns_to_population = c.id != no_vehicle && !c.start;
    if (!c.at || returns_to_population) {
        ++scene.ecology.population;
        if (returns_to_population) renumber_members(scene, number_in_population(s, c.id), 1);
        s.scene = std::make_shared<const Scene>(std::move(scene));
        return -1;
    }
    const std::string& of_kind = scene.kinds[static_cast<std::size_t>(kind)].name;
    Start start = c.start ? *c.start : Start{"", of_kind, c.at->x, c.at->y, maths::wrap_angle(c.at->heading)};
    start.name = free_name(scene.starts, start.name, of_kind);
    const int index = insertion_index(scene.starts, c.before);
    scene.starts.insert(iterator_at(scene.starts, index), std::move(start));
    if (auto error = check_scene(scene)) return *error;
    for (std::int32_t& other : s.vehicles.start) other += other >= index;
    s.scene = std::make_shared<const Scene>(std::move(scene));
    return index;
}

// Call before the vehicle is removed from the world.
void remove_from_scene(WorldData& s, std::size_t row) {
    const std::int32_t start = s.vehicles.start[row];
    Scene scene = *s.scene;
    if (start >= 0) {
        scene.starts.erase(iterator_at(scene.starts, start));
        for (std::int32_t& other : s.vehicles.start) other -= other > start;
    } else {
        const int number = number_in_population(s, s.vehicles.id[row]);
        std::erase_if(scene.members, [number](const Member& member) { return number_of(member) == number; });
        renumber_members(scene, number, -1);
        scene.ecology.population = std::max(0, scene.ecology.population - 1);
    }
    s.scene = std::make_shared<const Scene>(std::move(scene));
}

// Moves the last row to its place in the order of ascending ids, for a vehicle that is restored under its old id.
void sort_in_last_row(WorldData& s) {
    State m = std::move(static_cast<State&>(s));
    Vehicles& v = m.vehicles;
    const auto last = static_cast<std::ptrdiff_t>(v.size()) - 1;
    const auto row = std::lower_bound(v.id.begin(), v.id.end() - 1, v.id.back()) - v.id.begin();
    const auto rotate_stretch = [&](std::vector<float>& flat, std::vector<std::uint32_t>& first) {
        const auto begin = first[static_cast<std::size_t>(row)], end = first.back();
        const auto size = static_cast<std::uint32_t>(flat.size()) - end;
        std::rotate(flat.begin() + begin, flat.begin() + end, flat.end());
        for (auto later = row; later < last; ++later) first[static_cast<std::size_t>(later)] += size;
        first.back() = begin;
    };
    rotate_stretch(v.sensed, v.first_sensed);
    rotate_stretch(v.neurons, v.first_neuron);
    rotate_stretch(v.delayed, v.first_delayed);
    Vehicles::each_column(
        v, [&](auto& column) { std::rotate(column.begin() + row, column.begin() + last, column.end()); });
    s = WorldData(std::move(m));
}

}  // namespace

std::optional<Error> execute(WorldData& s, const AddVehicle& c) {
    if (auto error = refusal(s, c)) return error;
    const int kind = c.kind >= 0 ? c.kind : next_kind(s);
    const Kind& of_kind = s.scene->kinds[static_cast<std::size_t>(kind)];
    if (c.sensors)
        if (auto error = check_sensors(s, static_cast<std::size_t>(kind), *c.sensors)) return error;
    SharedDesign design = c.sensors ? own_design(of_kind, *c.sensors) : nullptr;
    SharedBrain brain = s.kind_brains[static_cast<std::size_t>(kind)];
    if (design || (c.brain && *c.brain != brain->graph)) {
        auto own = compile_brain(c.brain ? *c.brain : brain->graph, design ? design->kind : of_kind);
        if (!own) return own.error();
        brain = *own;
    }
    const auto start = add_to_scene(s, c, kind);
    if (!start) return start.error();
    const VehicleId id = c.id != no_vehicle ? c.id : s.next_id;
    s.next_id = std::max(s.next_id, id + 1);
    const bool comes_last = s.vehicles.size() == 0 || s.vehicles.id.back() < id;
    const auto somewhere = [&] {
        FreeSpace free_space(s);
        return free_pose(s, free_space, kind, id);
    };
    const bool has_own_sensors = design != nullptr;
    add_vehicle(s, kind, *start, id, std::move(brain), c.at ? *c.at : somewhere(), std::move(design));
    if (has_own_sensors) s.lay_out_grids();
    s.vehicles.energy.back() = c.energy;
    if (c.driver) s.vehicles.driver.back() = *c.driver;
    if (!comes_last) sort_in_last_row(s);
    return std::nullopt;
}

std::optional<Error> execute(WorldData& s, const RemoveVehicle& c) {
    if (s.vehicles.size() == 0) return error_of(message_of("no_vehicle_left"));
    const auto row = c.vehicle == no_vehicle ? std::optional(s.vehicles.size() - 1) : s.row_of(c.vehicle);
    if (!row) return unknown_vehicle(c.vehicle);
    remove_from_scene(s, *row);
    remove_vehicles(s, {*row});
    return std::nullopt;
}

std::optional<Error> execute(WorldData& s, const MoveVehicle& c) {
    const auto row = s.row_of(c.vehicle);
    if (!row) return unknown_vehicle(c.vehicle);
    if (!is_finite({c.x, c.y, c.heading})) return not_finite();
    s.physics.set_pose(*row, {c.x, c.y, maths::wrap_angle(c.heading)});
    read_motion(s, *row);
    return std::nullopt;
}

std::optional<Error> execute(WorldData& s, const EditStart& c) {
    if (auto error = missing(s.scene->starts, c.start, "start")) return error;
    Scene scene = *s.scene;
    Start& start = *iterator_at(scene.starts, c.start);
    const std::string name = start.name;
    start = c.to;
    start.name = name;
    if (auto error = check_scene(scene)) return error;
    s.scene = std::make_shared<const Scene>(std::move(scene));
    return std::nullopt;
}

std::optional<Error> execute(WorldData& s, const EditMember& c) {
    Scene scene = *s.scene;
    std::erase_if(scene.members, [&](const Member& member) { return number_of(member) == c.member; });
    if (c.to) {
        scene.members.push_back(*c.to);
        scene.members.back().name = std::to_string(c.member);
    }
    if (auto error = check_scene(scene)) return error;
    s.scene = std::make_shared<const Scene>(std::move(scene));
    return std::nullopt;
}

}  // namespace braitenlab::world

// Commands that add, remove and move vehicles and edit starts, in the running world and in its scene.
#include <numeric>

#include "core/scene/population.h"
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
    return check_look(c.look);
}

// The error of check_size() with this vehicle.
std::optional<Error> check_size_with(const WorldData& s, const AddVehicle& c) {
    const auto kind = static_cast<std::size_t>(c.kind >= 0 ? c.kind : next_kind(s));
    PresentParts parts = present_parts(s);
    PresentParts::Own& own = parts.of_vehicles.emplace_back();
    if (c.brain && *c.brain != s.kind_brains[kind]->graph) own.brain = &*c.brain;
    if (c.sensors && *c.sensors != s.scene->kinds[kind].sensors) own.sensors = &*c.sensors;
    Scene counted = *s.scene;
    ++counted.ecology.population;
    return check_size(counted, parts);
}

// Number in the population that the vehicle with this id has or would have.
int number_in_population(const WorldData& s, VehicleId id) {
    int number = 0;
    for (std::size_t row = 0; row < s.vehicles.size(); ++row)  // rows just restored may not be sorted yet
        number += s.vehicles.id[row] < id && s.vehicles.start[row] < 0;
    return number;
}

void renumber_members(Scene& scene, int from, int by) {
    for (Member& member : scene.members)
        if (const int number = number_of(member); number >= from) member.name = std::to_string(number + by);
}

// Adds the vehicle to the scene, a copy of the world's. Returns the index of its start; −1 if it counts towards the
// population.
Result<int> add_to_scene(WorldData& s, Scene& scene, const AddVehicle& c, int kind) {
    const bool returns_to_population = c.id != no_vehicle && !c.start;
    if (!c.at || returns_to_population) {
        ++scene.ecology.population;
        if (returns_to_population) renumber_members(scene, number_in_population(s, c.id), 1);
        return -1;
    }
    const std::string& of_kind = scene.kinds[static_cast<std::size_t>(kind)].name;
    Start start = c.start ? *c.start : Start{"", of_kind, c.at->x, c.at->y, maths::wrap_angle(c.at->heading)};
    if (!c.start) start.colour = c.colour;
    start.name = free_name(scene.starts, start.name, of_kind);
    const int index = insertion_index(scene.starts, c.before);
    scene.starts.insert(iterator_at(scene.starts, index), std::move(start));
    if (auto error = check_edited(s, scene)) return *error;
    for (std::int32_t& other : s.vehicles.start) other += other >= index;
    return index;
}

// Removes the vehicle from the scene, a copy of the world's. Call before it is removed from the world.
void remove_from_scene(WorldData& s, Scene& scene, std::size_t row) {
    const std::int32_t start = s.vehicles.start[row];
    if (start >= 0) {
        scene.starts.erase(iterator_at(scene.starts, start));
        for (std::int32_t& other : s.vehicles.start) other -= other > start;
    } else {
        const int number = number_in_population(s, s.vehicles.id[row]);
        std::erase_if(scene.members, [number](const Member& member) { return number_of(member) == number; });
        renumber_members(scene, number, -1);
        scene.ecology.population = std::max(0, scene.ecology.population - 1);
    }
}

// Sorts the rows by ascending id, after vehicles were restored under their old ids.
void sort_rows(WorldData& s) {
    State m = std::move(static_cast<State&>(s));
    Vehicles& v = m.vehicles;
    std::vector<std::size_t> order(v.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return v.id[a] < v.id[b]; });
    const auto sort_stretches = [&](std::vector<float>& flat, const std::vector<std::uint32_t>& first) {
        std::vector<float> sorted;
        sorted.reserve(flat.size());
        std::vector<std::uint32_t> sorted_first(first.size());
        for (const std::size_t row : order) {
            const auto begin = flat.begin() + first[row];
            const auto end = row + 1 < first.size() ? flat.begin() + first[row + 1] : flat.end();
            sorted_first[row] = static_cast<std::uint32_t>(sorted.size());  // moved with its column below
            sorted.insert(sorted.end(), begin, end);
        }
        flat = std::move(sorted);
        return sorted_first;
    };
    v.first_sensed = sort_stretches(v.sensed, v.first_sensed);
    v.first_neuron = sort_stretches(v.neurons, v.first_neuron);
    v.first_delayed = sort_stretches(v.delayed, v.first_delayed);
    Vehicles::each_column(v, [&](auto& column) {
        auto sorted = column;
        for (std::size_t i = 0; i < order.size(); ++i) sorted[i] = std::move(column[order[i]]);
        column = std::move(sorted);
    });
    s = WorldData(std::move(m));
}

// Adds a vehicle as the last row, and to the scene, a copy of the world's that replaces it afterwards. `free_space`:
// for vehicles without a pose; it is created when it is first needed.
std::optional<Error> add_last(WorldData& s, Scene& scene, const AddVehicle& c, std::optional<FreeSpace>& free_space) {
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
    const auto start = add_to_scene(s, scene, c, kind);
    if (!start) return start.error();
    const VehicleId id = c.id != no_vehicle ? c.id : s.next_id;
    s.next_id = std::max(s.next_id, id + 1);
    const auto somewhere = [&] {
        if (!free_space) free_space.emplace(s);
        return free_pose(s, *free_space, kind, number_in_population(s, id));
    };
    const bool has_own_sensors = design != nullptr;
    add_vehicle(s, kind, *start, id, std::move(brain), c.at ? *c.at : somewhere(), std::move(design));
    if (has_own_sensors) s.lay_out_grids();
    s.vehicles.energy.back() = static_cast<double>(c.energy);
    if (c.driver) s.vehicles.driver.back() = *c.driver;
    set_look(s.looks, id, c.look);
    return std::nullopt;
}

std::optional<Error> refusal(const WorldData& s, const SetPopulation& c) {
    if (auto error = missing(s.scene->kinds, c.kind, "kind")) return error;
    const auto of_kind = std::count(s.vehicles.kind.begin(), s.vehicles.kind.end(), c.kind);
    const auto others = static_cast<std::ptrdiff_t>(s.vehicles.size()) - of_kind;
    if (c.count < 0 || others + c.count > limits::vehicles)
        return error_of(message_of("population_limit", limits::vehicles));
    if (!c.shares.empty() && c.shares.size() != s.scene->kinds.size())
        return Error{"a population has one share for each kind"};
    if (c.population && (*c.population < 0 || *c.population > limits::vehicles))
        return error_of(message_of("population_limit", limits::vehicles));
    VehicleId last = no_vehicle;
    for (const AddVehicle& vehicle : c.vehicles) {
        if (vehicle.kind != c.kind || vehicle.id <= last || !vehicle.at)
            return Error{"vehicles of a population have its kind, a pose and ascending ids"};
        last = vehicle.id;
        if (s.row_of(vehicle.id)) continue;
        if (auto error = refusal(s, vehicle)) return error;
    }
    return std::nullopt;
}

// The rows of the kind in the order in which they are removed.
std::vector<std::size_t> removable_rows(const WorldData& s, const SetPopulation& c) {
    const Vehicles& v = s.vehicles;
    const auto is_listed = [&](std::size_t row) {
        const auto found = std::lower_bound(c.vehicles.begin(), c.vehicles.end(), v.id[row],
                                            [](const AddVehicle& a, VehicleId id) { return a.id < id; });
        return found != c.vehicles.end() && found->id == v.id[row];
    };
    std::vector<std::size_t> rows;
    for (std::size_t row = v.size(); row-- > 0;)
        if (v.kind[row] == c.kind) rows.push_back(row);
    std::stable_sort(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) {
        return std::pair(is_listed(a), v.start[a] >= 0) < std::pair(is_listed(b), v.start[b] >= 0);
    });
    return rows;
}

void remove_surplus(WorldData& s, Scene& scene, const SetPopulation& c) {
    std::vector<std::size_t> rows = removable_rows(s, c);
    if (rows.size() <= static_cast<std::size_t>(c.count)) return;
    rows.resize(rows.size() - static_cast<std::size_t>(c.count));
    std::sort(rows.rbegin(), rows.rend());
    for (const std::size_t row : rows)
        remove_from_scene(s, scene, row);  // the numbers of vehicles with smaller ids stay
    std::reverse(rows.begin(), rows.end());
    remove_vehicles(s, rows);
}

// The numbers of the population that the person has set: those of the world, or once vehicles have starved and others
// have replaced them, those with which a run of the scene begins.
std::vector<int> numbers_set(const State& s) {
    if (s.events.deaths > s.events.falls) return start_numbers(*s.scene).in_population;
    std::vector<int> numbers(s.scene->kinds.size(), 0);
    for (std::size_t row = 0; row < s.vehicles.size(); ++row)
        if (s.vehicles.start[row] < 0) ++numbers[static_cast<std::size_t>(s.vehicles.kind[row])];
    return numbers;
}

// Sets the numbers with which a run begins: that of the kind as wanted, those of the others as before, or all as they
// were earlier.
void set_numbers(Scene& scene, const State& before, const SetPopulation& c) {
    if (!c.shares.empty()) {
        scene.ecology.population = c.population.value_or(scene.ecology.population);
        for (std::size_t k = 0; k < c.shares.size(); ++k) scene.kinds[k].share = c.shares[k];
        return;
    }
    const auto kind = static_cast<std::size_t>(c.kind);
    std::vector<int> numbers = numbers_set(before);
    const std::string& name = scene.kinds[kind].name;
    const auto with_start =
        std::count_if(scene.starts.begin(), scene.starts.end(), [&](const Start& start) { return start.kind == name; });
    numbers[kind] = std::max(0, c.count - static_cast<int>(with_start));
    set_population(scene, numbers);
}

}  // namespace

std::optional<Error> execute(WorldData& s, const AddVehicle& c) {
    if (auto error = refusal(s, c)) return error;
    Scene scene = *s.scene;
    if (c.id == no_vehicle)  // one that is brought back has been counted before
        if (auto error = check_size_with(s, c)) return error;
    std::optional<FreeSpace> free_space;
    if (auto error = add_last(s, scene, c, free_space)) return error;
    s.scene = std::make_shared<const Scene>(std::move(scene));
    const auto& ids = s.vehicles.id;
    if (ids.size() > 1 && ids[ids.size() - 2] > ids.back()) sort_rows(s);
    return std::nullopt;
}

std::optional<Error> execute(WorldData& s, const RemoveVehicle& c) {
    if (s.vehicles.size() == 0) return error_of(message_of("no_vehicle_left"));
    const auto row = c.vehicle == no_vehicle ? std::optional(s.vehicles.size() - 1) : s.row_of(c.vehicle);
    if (!row) return unknown_vehicle(c.vehicle);
    Scene scene = *s.scene;
    remove_from_scene(s, scene, *row);
    s.scene = std::make_shared<const Scene>(std::move(scene));
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

std::optional<Error> execute(WorldData& s, const SetLook& c) {
    if (!s.row_of(c.vehicle)) return unknown_vehicle(c.vehicle);
    if (auto error = check_look(c.look)) return error;
    set_look(s.looks, c.vehicle, c.look);
    return std::nullopt;
}

std::optional<Error> execute(WorldData& s, const EditStart& c) {
    if (auto error = missing(s.scene->starts, c.start, "start")) return error;
    Scene scene = *s.scene;
    Start& start = *iterator_at(scene.starts, c.start);
    const std::string name = start.name;
    start = c.to;
    if (start.name.empty()) start.name = name;
    if (auto error = check_edited(s, scene)) return error;
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
    if (auto error = check_edited(s, scene)) return error;
    s.scene = std::make_shared<const Scene>(std::move(scene));
    return std::nullopt;
}

std::optional<Error> execute(WorldData& s, const SetPopulation& c) {
    if (auto error = refusal(s, c)) return error;
    const State before = s;
    const auto undone = [&](Error error) {
        s = WorldData(before);
        return error;
    };
    std::optional<FreeSpace> free_space;
    Scene scene = *s.scene;
    std::vector<const AddVehicle*> absent;
    for (const AddVehicle& vehicle : c.vehicles)
        if (!s.row_of(vehicle.id)) absent.push_back(&vehicle);
    for (const AddVehicle* vehicle : absent)
        if (auto error = add_last(s, scene, *vehicle, free_space)) return undone(*error);
    if (!std::is_sorted(s.vehicles.id.begin(), s.vehicles.id.end())) sort_rows(s);
    remove_surplus(s, scene, c);
    for (auto count = std::count(s.vehicles.kind.begin(), s.vehicles.kind.end(), c.kind); count < c.count; ++count)
        if (auto error = add_last(s, scene, AddVehicle{.kind = c.kind}, free_space)) return undone(*error);
    set_numbers(scene, before, c);
    if (auto error = check_edited(s, scene)) return undone(*error);
    s.scene = std::make_shared<const Scene>(std::move(scene));
    return std::nullopt;
}

}  // namespace braitenlab::world

#include "core/session/undo.h"

#include <algorithm>
#include <type_traits>

#include "core/match.h"
#include "core/scene/arena.h"
#include "core/world/cosmetic_edits.h"

namespace braitenlab {

namespace {

using Commands = std::vector<Command>;

template <class Thing>
const Thing* at(const std::vector<Thing>& things, int index) {
    return index >= 0 && static_cast<std::size_t>(index) < things.size() ? &things[static_cast<std::size_t>(index)]
                                                                         : nullptr;
}

// The command that restores the present value of an element, or none.
template <class Edit, class Thing>
Commands same(const std::vector<Thing>& things, int index) {
    const Thing* thing = at(things, index);
    if (!thing) return {};
    return {Edit{index, *thing}};
}

template <class Thing>
int place_of_new(const std::vector<Thing>& things, int before) {
    const auto count = static_cast<int>(things.size());
    return before < 0 ? count : std::min(before, count);
}

// The commands that restore the present brains of a target.
Commands same_brains(const Snapshot& now, const Target& target) {
    if (const VehicleView* v = find_vehicle(now, target.vehicle)) return {SetBrain{target, *brain_of(now, *v)}};
    const auto* of_kind = at(now.kind_brains, target.kind);
    if (!of_kind) return {};
    Commands commands{SetBrain{target, **of_kind}};
    for (const VehicleView& v : now.vehicles) {  // vehicles of the kind with an individual brain
        const BrainGraph& brain = *brain_of(now, v);
        if (v.kind == target.kind && brain != **of_kind) commands.push_back(SetBrain{{.vehicle = v.id}, brain});
    }
    return commands;
}

// The commands that restore the present sensors of a target.
Commands same_sensors(const Snapshot& now, const Target& target) {
    if (const VehicleView* v = find_vehicle(now, target.vehicle)) return {SetSensors{target, kind_of(now, *v).sensors}};
    const Kind* of_kind = at(now.scene->kinds, target.kind);
    if (!of_kind) return {};
    Commands commands{SetSensors{target, of_kind->sensors}};
    for (const VehicleView& v : now.vehicles)
        if (v.kind == target.kind && v.design >= 0)
            commands.push_back(SetSensors{{.vehicle = v.id}, kind_of(now, v).sensors});
    return commands;
}

// The commands that restore the node positions of these brains.
Commands same_places(const Snapshot& now, const Target& target) {
    Commands commands;
    for (Command& command : same_brains(now, target)) {
        const auto& brain = std::get<SetBrain>(command);
        commands.push_back(PlaceNodes{brain.target, world::places_of(brain.brain)});
    }
    return commands;
}

AddVehicle bringing_back(const Snapshot& now, const VehicleView& v) {
    AddVehicle add;
    add.kind = v.kind;
    add.at = Pose{v.x, v.y, v.heading};
    add.brain = *brain_of(now, v);
    add.energy = v.energy;
    add.driver = v.driver;
    add.id = v.id;
    if (const Start* start = at(now.scene->starts, v.start)) add.start = *start;
    add.before = v.start;
    if (v.design >= 0) add.sensors = kind_of(now, v).sensors;
    if (const Look* look = find_look(now.looks, v.id)) add.look = *look;
    return add;
}

EditMember same_member(const Scene& scene, int number) {
    for (const Member& member : scene.members)
        if (number_of(member) == number) return {number, member};
    return {number, std::nullopt};
}

Commands bringing_back(const Snapshot& now, const RemoveVehicle& c) {
    const VehicleView* v =
        c.vehicle == no_vehicle && !now.vehicles.empty() ? &now.vehicles.back() : find_vehicle(now, c.vehicle);
    if (!v) return {};
    Commands commands{bringing_back(now, *v)};
    if (v->start >= 0) return commands;
    const EditMember member = same_member(*now.scene, number_in_population(now, v->id));
    if (member.to) commands.push_back(member);
    return commands;
}

template <class Object>
Commands bringing_back(const Snapshot& now, const RemoveObject<Object>& c) {
    const Object* object = at((*now.scene).*ObjectList<Object>::list, c.index);
    if (!object) return {};
    Commands commands{AddObject<Object>{*object, c.index}};
    if constexpr (std::is_same_v<Object, Source>)
        for (std::size_t i = 0; i < now.scene->starts.size(); ++i)  // starts that faced it
            if (now.scene->starts[i].facing == object->name)
                commands.push_back(EditStart{static_cast<int>(i), now.scene->starts[i]});
    return commands;
}

// Sets the pose of a move to the present one; false if there is no such object.
bool set_present(const Snapshot& now, MoveVehicle& m) {
    const VehicleView* v = find_vehicle(now, m.vehicle);
    if (v) m = {v->id, v->x, v->y, v->heading};
    return v;
}
bool set_present(const Snapshot& now, MoveSource& m) {
    const Source* source = at(now.scene->sources, m.index);
    if (source) m = {m.index, source->x, source->y};
    return source;
}
bool set_present(const Snapshot& now, MoveObstacle& m) {
    const Pose* pose = at(now.obstacles, m.index);
    if (pose) m = {m.index, pose->x, pose->y, pose->heading};
    return pose;
}
bool set_present(const Snapshot& now, MoveZone& m) {
    const Zone* zone = at(now.scene->zones, m.index);
    if (zone) m = {m.index, zone->x, zone->y, zone->heading};
    return zone;
}

template <class Move>
Commands same_pose(const Snapshot& now, Move move) {
    return set_present(now, move) ? Commands{move} : Commands{};
}

// The vehicles of a kind, each with the values to restore it.
std::vector<AddVehicle> vehicles_of(const Snapshot& now, int kind) {
    std::vector<AddVehicle> all;
    for (const VehicleView& v : now.vehicles) {
        if (v.kind != kind) continue;
        AddVehicle& vehicle = all.emplace_back(bringing_back(now, v));
        const auto* of_kind = at(now.kind_brains, kind);
        if (of_kind && *vehicle.brain == **of_kind) vehicle.brain.reset();
    }
    return all;
}

Commands same_population(const Snapshot& now, const SetPopulation& c) {
    if (!at(now.scene->kinds, c.kind)) return {};
    SetPopulation back{c.kind, 0, vehicles_of(now, c.kind), {}};
    back.count = static_cast<int>(back.vehicles.size());
    for (const Kind& kind : now.scene->kinds) back.shares.push_back(kind.share);
    back.population = now.scene->ecology.population;
    Commands commands{back};
    for (const Member& member : now.scene->members) commands.push_back(EditMember{number_of(member), member});
    return commands;
}

// The present arena, and the poses that a smaller one would change.
Commands same_arena(const Snapshot& now, const EditArena& c) {
    const auto leaves = [&](const auto& placed) { return !is_inside(c.to, {placed.x, placed.y}); };
    const Scene& scene = *now.scene;
    Commands commands{EditArena{scene.arena}};
    for (std::size_t i = 0; i < scene.starts.size(); ++i)
        if (leaves(scene.starts[i])) commands.push_back(EditStart{static_cast<int>(i), scene.starts[i]});
    for (const Member& member : scene.members)
        if (leaves(member)) commands.push_back(EditMember{number_of(member), member});
    for (const VehicleView& v : now.vehicles)
        if (leaves(v)) commands.push_back(MoveVehicle{v.id, v.x, v.y, v.heading});
    return commands;
}

// The present poses of the objects that a command moves.
Commands same_poses(const Snapshot& now, MoveObjects c) {
    const auto all = [&](auto& moves) {
        return std::all_of(moves.begin(), moves.end(), [&](auto& move) { return set_present(now, move); });
    };
    const bool known = all(c.of_vehicles) && all(c.of_sources) && all(c.of_obstacles) && all(c.of_zones);
    return known ? Commands{c} : Commands{};
}

// The present kind, and the vehicles that have the new driver already and keep it.
Commands same_kind(const Snapshot& now, const EditKind& c) {
    const Kind* kind = at(now.scene->kinds, c.kind);
    if (!kind) return {};
    Commands commands{EditKind{c.kind, *kind}};
    for (const VehicleView& v : now.vehicles)
        if (v.kind == c.kind && v.driver == c.to.driver && v.driver != kind->driver)
            commands.push_back(ChooseDriver{v.id, v.driver});
    return commands;
}

Commands bringing_back(const Snapshot& now, const RemoveKind& c) {
    const Kind* kind = at(now.scene->kinds, c.kind);
    if (!kind) return {};
    AddKind add{*kind, c.kind};
    add.kind.brain = *now.kind_brains[static_cast<std::size_t>(c.kind)];
    return {add};
}

bool moves_same(const MoveObjects& a, const MoveObjects& b) {
    const auto same = [](const auto& one, const auto& other, auto number) {
        return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                          [number](const auto& x, const auto& y) { return x.*number == y.*number; });
    };
    return same(a.of_vehicles, b.of_vehicles, &MoveVehicle::vehicle) &&
           same(a.of_sources, b.of_sources, &MoveSource::index) &&
           same(a.of_obstacles, b.of_obstacles, &MoveObstacle::index) && same(a.of_zones, b.of_zones, &MoveZone::index);
}

}  // namespace

std::vector<Command> undoing(const Snapshot& now, const Command& command) {
    const Scene& scene = *now.scene;
    return std::visit(
        Match{
            [&](const TurnDial& c) { return same_brains(now, c.target); },
            [&](const SetBrain& c) { return same_brains(now, c.target); },
            [&](const PlaceNodes& c) { return same_places(now, c.target); },
            [&](const AddVehicle&) -> Commands { return {RemoveVehicle{}}; },
            [&](const RemoveVehicle& c) { return bringing_back(now, c); },
            [&](const MoveVehicle& c) { return same_pose(now, c); },
            [&](const SetLook& c) -> Commands {
                const Look* look = find_look(now.looks, c.vehicle);
                return {SetLook{c.vehicle, look ? *look : Look{}}};
            },
            [&](const EditStart& c) { return same<EditStart>(scene.starts, c.start); },
            [&](const EditMember& c) -> Commands { return {same_member(scene, c.member)}; },
            [&](const SetSensors& c) { return same_sensors(now, c.target); },
            [&]<class Object>(const AddObject<Object>& c) -> Commands {
                return {RemoveObject<Object>{place_of_new(scene.*ObjectList<Object>::list, c.before)}};
            },
            [&]<class Object>(const RemoveObject<Object>& c) { return bringing_back(now, c); },
            [&]<class Object>(const EditObject<Object>& c) {
                return same<EditObject<Object>>(scene.*ObjectList<Object>::list, c.index);
            },
            [&]<class Object>(const MoveObject<Object>& c) { return same_pose(now, c); },
            [&](const MoveObjects& c) { return same_poses(now, c); },
            [](const ChooseDriver&) -> Commands { return {}; },  // the driver is a mode, not an edit
            [](const Steer&) -> Commands { return {}; },
            [](const NewPopulation&) -> Commands { return {}; },
            [&](const Retitle& c) -> Commands {
                Retitle back;
                if (c.title) back.title = scene.title;
                if (c.story) back.story = scene.story;
                return {back};
            },
            [&](const EditArena& c) { return same_arena(now, c); },
            [&](const EditEcology&) -> Commands { return {EditEcology{scene.ecology}}; },
            [&](const AddKind& c) -> Commands { return {RemoveKind{place_of_new(scene.kinds, c.before)}}; },
            [&](const RemoveKind& c) { return bringing_back(now, c); },
            [&](const EditKind& c) { return same_kind(now, c); },
            [&](const SetPopulation& c) { return same_population(now, c); },
        },
        command);
}

Command repeating(const Snapshot& after, const Command& command) {
    if (const auto* set = std::get_if<SetPopulation>(&command))
        return SetPopulation{set->kind, set->count, vehicles_of(after, set->kind), set->shares, set->population};
    const auto* add = std::get_if<AddVehicle>(&command);
    if (!add || after.vehicles.empty()) return command;
    const VehicleView* v = add->id == no_vehicle ? &after.vehicles.back() : find_vehicle(after, add->id);
    return v ? Command(bringing_back(after, *v)) : command;
}

bool supersedes(const Command& later, const Command& earlier) {
    if (later.index() != earlier.index()) return false;
    return std::visit(Match{[&](const TurnDial& c) {
                                const auto& e = std::get<TurnDial>(earlier);
                                return c.target == e.target && c.dial == e.dial && c.pair == e.pair;
                            },
                            [&](const SetBrain& c) { return c.target == std::get<SetBrain>(earlier).target; },
                            [&](const MoveVehicle& c) { return c.vehicle == std::get<MoveVehicle>(earlier).vehicle; },
                            [&](const SetLook& c) { return c.vehicle == std::get<SetLook>(earlier).vehicle; },
                            [&](const EditStart& c) { return c.start == std::get<EditStart>(earlier).start; },
                            [&](const EditMember& c) { return c.member == std::get<EditMember>(earlier).member; },
                            [&](const SetSensors& c) { return c.target == std::get<SetSensors>(earlier).target; },
                            [&]<class Object>(const EditObject<Object>& c) {
                                return c.index == std::get<EditObject<Object>>(earlier).index;
                            },
                            [&]<class Object>(const MoveObject<Object>& c) {
                                return c.index == std::get<MoveObject<Object>>(earlier).index;
                            },
                            [&](const MoveObjects& c) { return moves_same(c, std::get<MoveObjects>(earlier)); },
                            [&](const Retitle& c) {
                                const auto& e = std::get<Retitle>(earlier);
                                return (c.title || !e.title) && (c.story || !e.story);
                            },
                            [](const EditArena&) { return true; }, [](const EditEcology&) { return true; },
                            [&](const EditKind& c) { return c.kind == std::get<EditKind>(earlier).kind; },
                            [&](const SetPopulation& c) { return c.kind == std::get<SetPopulation>(earlier).kind; },
                            [](const auto&) { return false; }},
                      later);
}

std::vector<Command> beyond(const std::vector<Command>& known, std::vector<Command> back) {
    std::erase_if(back, [&](const Command& command) {
        return std::any_of(known.begin(), known.end(), [&](const Command& k) { return supersedes(command, k); });
    });
    return back;
}

bool is_about_brains(const Command& command) {
    return std::holds_alternative<TurnDial>(command) || std::holds_alternative<SetBrain>(command) ||
           std::holds_alternative<PlaceNodes>(command);
}

Command renumbered(Command command, const std::function<VehicleId(VehicleId)>& number) {
    const auto change = [&](VehicleId& id) {
        if (id != no_vehicle) id = number(id);
    };
    std::visit(
        [&](auto& c) {
            if constexpr (requires { c.target.vehicle; }) change(c.target.vehicle);
            if constexpr (requires { c.vehicle; }) change(c.vehicle);
            if constexpr (requires { c.id; }) change(c.id);
            if constexpr (requires { c.of_vehicles; })
                for (MoveVehicle& move : c.of_vehicles) change(move.vehicle);
            if constexpr (requires { c.vehicles; }) {
                for (AddVehicle& vehicle : c.vehicles) change(vehicle.id);
                std::sort(c.vehicles.begin(), c.vehicles.end(),
                          [](const AddVehicle& a, const AddVehicle& b) { return a.id < b.id; });
            }
        },
        command);
    return command;
}

}  // namespace braitenlab

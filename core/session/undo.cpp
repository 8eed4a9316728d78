#include "core/session/undo.h"

#include <algorithm>
#include <cmath>
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

// The command that adds a removed element again at its index, or none.
template <class Add, class Thing>
Commands added_again(const std::vector<Thing>& things, int index) {
    const Thing* thing = at(things, index);
    if (!thing) return {};
    return {Add{*thing, index}};
}

template <class Thing>
int place_of_new(const std::vector<Thing>& things, int before) {
    const auto count = static_cast<int>(things.size());
    return before < 0 ? count : std::min(before, count);
}

// The commands that restore the present brains of a target.
Commands same_brains(const Snapshot& now, const Target& target) {
    if (const VehicleView* v = find_vehicle(now, target.vehicle))
        return {SetBrain{target, *now.brains[static_cast<std::size_t>(v->brain)]}};
    const auto* of_kind = at(now.kind_brains, target.kind);
    if (!of_kind) return {};
    Commands commands{SetBrain{target, **of_kind}};
    for (const VehicleView& v : now.vehicles) {  // vehicles of the kind with an individual brain
        const BrainGraph& brain = *now.brains[static_cast<std::size_t>(v.brain)];
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
    add.brain = *now.brains[static_cast<std::size_t>(v.brain)];
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

Commands bringing_back(const Snapshot& now, const RemoveSource& c) {
    const Source* source = at(now.scene->sources, c.source);
    if (!source) return {};
    Commands commands{AddSource{*source, c.source}};
    for (std::size_t i = 0; i < now.scene->starts.size(); ++i)  // starts that faced it
        if (now.scene->starts[i].facing == source->name)
            commands.push_back(EditStart{static_cast<int>(i), now.scene->starts[i]});
    return commands;
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
    bool known = true;
    for (MoveVehicle& m : c.of_vehicles) {
        const VehicleView* v = find_vehicle(now, m.vehicle);
        v ? void(m = {v->id, v->x, v->y, v->heading}) : void(known = false);
    }
    for (MoveSource& m : c.of_sources) {
        const Source* source = at(now.scene->sources, m.source);
        source ? void(m = {m.source, source->x, source->y}) : void(known = false);
    }
    for (MoveObstacle& m : c.of_obstacles) {
        const Pose* pose = at(now.obstacles, m.obstacle);
        pose ? void(m = {m.obstacle, pose->x, pose->y, pose->heading}) : void(known = false);
    }
    for (MoveZone& m : c.of_zones) {
        const Zone* zone = at(now.scene->zones, m.zone);
        zone ? void(m = {m.zone, zone->x, zone->y, zone->heading}) : void(known = false);
    }
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
            [&](const MoveVehicle& c) -> Commands {
                const VehicleView* v = find_vehicle(now, c.vehicle);
                if (!v) return {};
                return {MoveVehicle{v->id, v->x, v->y, v->heading}};
            },
            [&](const SetLook& c) -> Commands {
                const Look* look = find_look(now.looks, c.vehicle);
                return {SetLook{c.vehicle, look ? *look : Look{}}};
            },
            [&](const EditStart& c) { return same<EditStart>(scene.starts, c.start); },
            [&](const EditMember& c) -> Commands { return {same_member(scene, c.member)}; },
            [&](const SetSensors& c) { return same_sensors(now, c.target); },
            [&](const AddSource& c) -> Commands { return {RemoveSource{place_of_new(scene.sources, c.before)}}; },
            [&](const RemoveSource& c) { return bringing_back(now, c); },
            [&](const EditSource& c) { return same<EditSource>(scene.sources, c.source); },
            [&](const MoveSource& c) -> Commands {
                const Source* source = at(scene.sources, c.source);
                if (!source) return {};
                return {MoveSource{c.source, source->x, source->y}};
            },
            [&](const AddObstacle& c) -> Commands { return {RemoveObstacle{place_of_new(scene.obstacles, c.before)}}; },
            [&](const RemoveObstacle& c) { return added_again<AddObstacle>(scene.obstacles, c.obstacle); },
            [&](const EditObstacle& c) { return same<EditObstacle>(scene.obstacles, c.obstacle); },
            [&](const MoveObstacle& c) -> Commands {
                const Pose* pose = at(now.obstacles, c.obstacle);
                if (!pose) return {};
                return {MoveObstacle{c.obstacle, pose->x, pose->y, pose->heading}};
            },
            [&](const AddZone& c) -> Commands { return {RemoveZone{place_of_new(scene.zones, c.before)}}; },
            [&](const RemoveZone& c) { return added_again<AddZone>(scene.zones, c.zone); },
            [&](const EditZone& c) { return same<EditZone>(scene.zones, c.zone); },
            [&](const MoveZone& c) -> Commands {
                const Zone* zone = at(scene.zones, c.zone);
                if (!zone) return {};
                return {MoveZone{c.zone, zone->x, zone->y, zone->heading}};
            },
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

namespace {

bool moves_same(const MoveObjects& a, const MoveObjects& b) {
    const auto same = [](const auto& one, const auto& other, auto number) {
        return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                          [number](const auto& x, const auto& y) { return x.*number == y.*number; });
    };
    return same(a.of_vehicles, b.of_vehicles, &MoveVehicle::vehicle) &&
           same(a.of_sources, b.of_sources, &MoveSource::source) &&
           same(a.of_obstacles, b.of_obstacles, &MoveObstacle::obstacle) &&
           same(a.of_zones, b.of_zones, &MoveZone::zone);
}

}  // namespace

bool supersedes(const Command& later, const Command& earlier) {
    if (later.index() != earlier.index()) return false;
    return std::visit(
        Match{[&](const TurnDial& c) {
                  const auto& e = std::get<TurnDial>(earlier);
                  return c.target == e.target && c.dial == e.dial && c.pair == e.pair;
              },
              [&](const SetBrain& c) { return c.target == std::get<SetBrain>(earlier).target; },
              [&](const MoveVehicle& c) { return c.vehicle == std::get<MoveVehicle>(earlier).vehicle; },
              [&](const SetLook& c) { return c.vehicle == std::get<SetLook>(earlier).vehicle; },
              [&](const EditStart& c) { return c.start == std::get<EditStart>(earlier).start; },
              [&](const EditMember& c) { return c.member == std::get<EditMember>(earlier).member; },
              [&](const SetSensors& c) { return c.target == std::get<SetSensors>(earlier).target; },
              [&](const EditSource& c) { return c.source == std::get<EditSource>(earlier).source; },
              [&](const MoveSource& c) { return c.source == std::get<MoveSource>(earlier).source; },
              [&](const EditObstacle& c) { return c.obstacle == std::get<EditObstacle>(earlier).obstacle; },
              [&](const MoveObstacle& c) { return c.obstacle == std::get<MoveObstacle>(earlier).obstacle; },
              [&](const EditZone& c) { return c.zone == std::get<EditZone>(earlier).zone; },
              [&](const MoveZone& c) { return c.zone == std::get<MoveZone>(earlier).zone; },
              [&](const MoveObjects& c) { return moves_same(c, std::get<MoveObjects>(earlier)); },
              [&](const Retitle& c) {
                  const auto& e = std::get<Retitle>(earlier);
                  return (c.title || !e.title) && (c.story || !e.story);
              },
              [](const EditArena&) { return true; },
              [](const EditEcology&) { return true; },
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

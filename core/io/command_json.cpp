// Commands as JSON, for the log of a run file.
#include <array>
#include <string>

#include "core/io/json.h"

namespace braitenlab {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Pose, x, y, heading)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Target, vehicle, kind)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SensorPair, left, right)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SetBrain, target, brain)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(NodePlace, node, at)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PlaceNodes, target, places)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RemoveVehicle, vehicle)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(MoveVehicle, vehicle, x, y, heading)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ChooseDriver, vehicle, driver)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Steer, vehicle, left, right)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SetLook, vehicle, look)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EditStart, start, to)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EditMember, member, to)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SetSensors, target, sensors)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EditArena, to)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EditEcology, to)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(AddKind, kind, before)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RemoveKind, kind)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EditKind, kind, to)

// Commands with members that are left out, or with other keys than the names of their members.
void visit_command(auto members, auto& c, Of<TurnDial>) {
    members.value("target", c.target), members.value("dial", c.dial), members.value("value", c.value);
    members.unusual("pair", c.pair, SensorPair{});
}
void visit_command(auto members, auto& c, Of<AddVehicle>) {
    members.value("kind", c.kind), members.value("at", c.at), members.value("brain", c.brain);
    members.value("energy", c.energy), members.value("driver", c.driver), members.value("id", c.id);
    members.value("start", c.start), members.value("before", c.before);
    members.optional("sensors", c.sensors);
    members.unusual("colour", c.colour, std::string()), members.unusual("look", c.look, Look{});
}
void visit_command(auto members, auto& c, Of<Retitle>) {
    members.optional("title", c.title), members.optional("story", c.story);
}
void visit_command(auto members, auto& c, Of<SetPopulation>) {
    members.value("kind", c.kind), members.value("count", c.count);
    members.value("vehicles", c.vehicles), members.value("shares", c.shares);
    members.optional("population", c.population);
}
void visit_command(auto, auto&, Of<NewPopulation>) {}
template <class Object>
void visit_command(auto members, auto& c, Of<AddObject<Object>>) {
    members.value(ObjectList<Object>::word, c.object), members.value("before", c.before);
}
template <class Object>
void visit_command(auto members, auto& c, Of<RemoveObject<Object>>) {
    members.value(ObjectList<Object>::word, c.index);
}
template <class Object>
void visit_command(auto members, auto& c, Of<EditObject<Object>>) {
    members.value(ObjectList<Object>::word, c.index), members.value("to", c.to);
}
template <class Object>
void visit_command(auto members, auto& c, Of<MoveObject<Object>>) {
    members.value(ObjectList<Object>::word, c.index), members.value("x", c.x), members.value("y", c.y);
    if constexpr (requires(Object object) { object.heading; }) members.value("heading", c.heading);
}

template <class T>
concept Visited = requires(io::JsonReader members, T& command) {
    visit_command(members, command, Of<T>{});
};
template <Visited T>
void to_json(Json& json, const T& command) {
    json = Json::object();
    visit_command(io::JsonWriter{json}, command, Of<T>{});
}
template <Visited T>
void from_json(const Json& json, T& command) {
    visit_command(io::JsonReader{json}, command, Of<T>{});
}
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(MoveObjects, of_vehicles, of_sources, of_obstacles, of_zones)

namespace {

// In the order of Command's alternatives.
constexpr std::array<const char*, std::variant_size_v<Command::variant>> command_names{
    "TurnDial",    "SetBrain",       "PlaceNodes",    "AddVehicle",   "RemoveVehicle", "MoveVehicle", "ChooseDriver",
    "Steer",       "EditStart",      "SetSensors",    "AddSource",    "RemoveSource",  "EditSource",  "MoveSource",
    "AddObstacle", "RemoveObstacle", "EditObstacle",  "MoveObstacle", "NewPopulation", "Retitle",     "EditMember",
    "AddZone",     "RemoveZone",     "EditZone",      "MoveZone",     "EditArena",     "EditEcology", "AddKind",
    "RemoveKind",  "EditKind",       "SetPopulation", "SetLook",      "MoveObjects"};

template <std::size_t... I>
void read_one(const Json& json, const std::string& name, Command& command, std::index_sequence<I...>) {
    const bool known =
        ((name == command_names[I] && (command = json.get<std::variant_alternative_t<I, Command::variant>>(), true)) ||
         ...);
    if (!known) throw Json::other_error::create(501, "unknown command '" + name + "'", &json);
}

}  // namespace

void to_json(Json& json, const Command& command) {
    std::visit([&](const auto& c) { json = {{command_names[command.index()], c}}; }, command);
}

void from_json(const Json& json, Command& command) {
    if (!json.is_object() || json.size() != 1)
        throw Json::other_error::create(501, "a command is an object with one key, its name", &json);
    read_one(json.begin().value(), json.begin().key(), command,
             std::make_index_sequence<std::variant_size_v<Command::variant>>{});
}

}  // namespace braitenlab

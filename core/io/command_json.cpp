// Commands as JSON, for the log of a run file.
#include <array>
#include <string>
#include <type_traits>

#include "core/io/json.h"

namespace braitenlab {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Pose, x, y, heading)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Target, vehicle, kind)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SensorPair, left, right)
inline void to_json(Json& json, const TurnDial& c) {
    json = {{"target", c.target}, {"dial", c.dial}, {"value", c.value}};
    if (c.pair != SensorPair{}) json["pair"] = c.pair;
}
inline void from_json(const Json& json, TurnDial& c) {
    json.at("target").get_to(c.target);
    json.at("dial").get_to(c.dial);
    json.at("value").get_to(c.value);
    if (json.contains("pair")) json.at("pair").get_to(c.pair);
}
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SetBrain, target, brain)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(NodePlace, node, at)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PlaceNodes, target, places)
inline void to_json(Json& json, const AddVehicle& c) {
    json = {{"kind", c.kind},     {"at", c.at}, {"brain", c.brain}, {"energy", c.energy},
            {"driver", c.driver}, {"id", c.id}, {"start", c.start}, {"before", c.before}};
    if (c.sensors) json["sensors"] = *c.sensors;
    if (!c.colour.empty()) json["colour"] = c.colour;
    if (c.look != Look{}) json["look"] = c.look;
}
inline void from_json(const Json& json, AddVehicle& c) {
    json.at("kind").get_to(c.kind);
    json.at("at").get_to(c.at);
    json.at("brain").get_to(c.brain);
    json.at("energy").get_to(c.energy);
    json.at("driver").get_to(c.driver);
    json.at("id").get_to(c.id);
    json.at("start").get_to(c.start);
    json.at("before").get_to(c.before);
    if (json.contains("sensors")) c.sensors = json.at("sensors").get<std::vector<Sensor>>();
    if (json.contains("colour")) json.at("colour").get_to(c.colour);
    if (json.contains("look")) json.at("look").get_to(c.look);
}
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RemoveVehicle, vehicle)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(MoveVehicle, vehicle, x, y, heading)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ChooseDriver, vehicle, driver)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Steer, vehicle, left, right)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SetLook, vehicle, look)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EditStart, start, to)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EditMember, member, to)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SetSensors, target, sensors)
template <class Object>
void to_json(Json& json, const AddObject<Object>& c) {
    json = {{ObjectList<Object>::word, c.object}, {"before", c.before}};
}
template <class Object>
void from_json(const Json& json, AddObject<Object>& c) {
    json.at(ObjectList<Object>::word).get_to(c.object);
    json.at("before").get_to(c.before);
}
template <class Object>
void to_json(Json& json, const RemoveObject<Object>& c) {
    json = {{ObjectList<Object>::word, c.index}};
}
template <class Object>
void from_json(const Json& json, RemoveObject<Object>& c) {
    json.at(ObjectList<Object>::word).get_to(c.index);
}
template <class Object>
void to_json(Json& json, const EditObject<Object>& c) {
    json = {{ObjectList<Object>::word, c.index}, {"to", c.to}};
}
template <class Object>
void from_json(const Json& json, EditObject<Object>& c) {
    json.at(ObjectList<Object>::word).get_to(c.index);
    json.at("to").get_to(c.to);
}
template <class Object>
constexpr bool has_heading = requires(Object object) {
    object.heading;
};
template <class Object>
void to_json(Json& json, const MoveObject<Object>& c) {
    json = {{ObjectList<Object>::word, c.index}, {"x", c.x}, {"y", c.y}};
    if (has_heading<Object>) json["heading"] = c.heading;
}
template <class Object>
void from_json(const Json& json, MoveObject<Object>& c) {
    json.at(ObjectList<Object>::word).get_to(c.index);
    json.at("x").get_to(c.x);
    json.at("y").get_to(c.y);
    if (has_heading<Object>) json.at("heading").get_to(c.heading);
}
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(MoveObjects, of_vehicles, of_sources, of_obstacles, of_zones)
inline void to_json(Json& json, const Retitle& c) {
    json = Json::object();
    if (c.title) json["title"] = *c.title;
    if (c.story) json["story"] = *c.story;
}
inline void from_json(const Json& json, Retitle& c) {
    if (json.contains("title")) c.title = json.at("title").get<std::string>();
    if (json.contains("story")) c.story = json.at("story").get<std::string>();
}
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EditArena, to)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EditEcology, to)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(AddKind, kind, before)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RemoveKind, kind)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EditKind, kind, to)
inline void to_json(Json& json, const SetPopulation& c) {
    json = {{"kind", c.kind}, {"count", c.count}, {"vehicles", c.vehicles}, {"shares", c.shares}};
    if (c.population) json["population"] = *c.population;
}
inline void from_json(const Json& json, SetPopulation& c) {
    json.at("kind").get_to(c.kind);
    json.at("count").get_to(c.count);
    json.at("vehicles").get_to(c.vehicles);
    json.at("shares").get_to(c.shares);
    if (json.contains("population")) c.population = json.at("population").get<int>();
}
inline void to_json(Json& json, const NewPopulation&) { json = Json::object(); }
inline void from_json(const Json&, NewPopulation&) {}

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

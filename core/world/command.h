// Commands: the only way to change a running world from outside. Indices that the world does not have are refused.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/brain/four_neurons.h"
#include "core/brain/graph.h"
#include "core/world/snapshot.h"

namespace braitenlab {

// Whose brain or sensors a command changes: of one vehicle, or of all present and future vehicles of a kind.
struct Target {
    VehicleId vehicle = no_vehicle;
    int kind = -1;  // used when vehicle is no_vehicle
    friend bool operator==(const Target&, const Target&) = default;
};

struct TurnDial {  // sets a dial; the value is clamped to the dial's range
    Target target;
    Dial dial = Dial::LL;
    float value = 0;
    SensorPair pair{};
    friend bool operator==(const TurnDial&, const TurnDial&) = default;
};
struct SetBrain {
    Target target;
    BrainGraph brain;
    friend bool operator==(const SetBrain&, const SetBrain&) = default;
};
// The position of a node on the wiring canvas (Node::place). The run does not depend on it.
struct NodePlace {
    NodeId node = 0;
    std::optional<maths::vec2> at{};  // none: automatic layout
    friend bool operator==(const NodePlace&, const NodePlace&) = default;
};
struct PlaceNodes {  // nodes that a brain does not have are ignored
    Target target;
    std::vector<NodePlace> places;
    friend bool operator==(const PlaceNodes&, const PlaceNodes&) = default;
};
// AddVehicle and RemoveVehicle change the scene, too: a vehicle with a given pose is a start (Scene::starts), any other
// vehicle and a restored one without a start count towards the population (Ecology::population).
struct AddVehicle {
    int kind = -1;                      // −1: the kind that the shares require next
    std::optional<Pose> at{};           // none: a random free pose
    std::optional<BrainGraph> brain{};  // none: the brain of the kind
    float energy = 1;                   // 0..1
    std::optional<Driver> driver{};     // none: the driver of the kind
    // To restore a removed vehicle: its id, its start if it had one, and the index of that start.
    VehicleId id = no_vehicle;
    std::optional<Start> start{};
    int before = -1;
    std::optional<std::vector<Sensor>> sensors{};  // none: the sensors of the kind
    std::string colour{};                          // of a new vehicle with a pose, as Start::colour
    Look look{};                                   // of a vehicle of the population
    friend bool operator==(const AddVehicle&, const AddVehicle&) = default;
};
struct RemoveVehicle {
    VehicleId vehicle = no_vehicle;  // no_vehicle: the vehicle with the largest id
    friend bool operator==(const RemoveVehicle&, const RemoveVehicle&) = default;
};
struct MoveVehicle {  // sets the pose (m, m, rad) and zero velocity
    VehicleId vehicle = no_vehicle;
    float x = 0, y = 0, heading = 0;
    friend bool operator==(const MoveVehicle&, const MoveVehicle&) = default;
};
struct ChooseDriver {
    VehicleId vehicle = no_vehicle;
    Driver driver = Driver::brain;
    friend bool operator==(const ChooseDriver&, const ChooseDriver&) = default;
};
struct Steer {  // wheel commands, clamped to −1..1, of a manually driven vehicle; held until the next Steer
    VehicleId vehicle = no_vehicle;
    float left = 0, right = 0;
    friend bool operator==(const Steer&, const Steer&) = default;
};
// Name and colour of a vehicle of the population; EditStart sets those of one with a start.
struct SetLook {
    VehicleId vehicle = no_vehicle;
    Look look;
    friend bool operator==(const SetLook&, const SetLook&) = default;
};
// Name and colour change at once, the other values when a vehicle next enters at the start; no vehicle moves now. An
// empty name: the present one.
struct EditStart {
    int start = 0;
    Start to;
    friend bool operator==(const EditStart&, const EditStart&) = default;
};
// Replaces or removes the entry of Scene::members for this vehicle of the population, numbered from 0. Takes effect in
// a world that is created from the scene; no vehicle changes now.
struct EditMember {
    int member = 0;
    std::optional<Member> to{};  // nullopt: none
    friend bool operator==(const EditMember&, const EditMember&) = default;
};
// Replaces the sensors of the target. A sensor that keeps its name, or is only renamed, keeps its reading, with the
// same latency also the readings that its brain has not received yet; a new sensor begins with 0.
struct SetSensors {
    Target target;
    std::vector<Sensor> sensors;
    friend bool operator==(const SetSensors&, const SetSensors&) = default;
};

// Sources, obstacles and zones are identified by their current index in Scene::sources, Scene::obstacles and
// Scene::zones. A removal decrements the later indices. An addition is inserted at index `before`, or at the end for
// −1. An edited object keeps its name.
template <class Object>
struct AddObject {
    Object object;
    int before = -1;
    friend bool operator==(const AddObject&, const AddObject&) = default;
};
template <class Object>
struct RemoveObject {
    int index = 0;
    friend bool operator==(const RemoveObject&, const RemoveObject&) = default;
};
template <class Object>
struct EditObject {
    int index = 0;
    Object to;
    friend bool operator==(const EditObject&, const EditObject&) = default;
};
template <class Object>
struct MoveObject {  // sets the pose (m, m, rad)
    int index = 0;
    float x = 0, y = 0, heading = 0;  // a source has no heading
    friend bool operator==(const MoveObject&, const MoveObject&) = default;
};
using AddSource = AddObject<Source>;
using RemoveSource = RemoveObject<Source>;
using EditSource = EditObject<Source>;
using MoveSource = MoveObject<Source>;
using AddObstacle = AddObject<Obstacle>;
using RemoveObstacle = RemoveObject<Obstacle>;
using EditObstacle = EditObject<Obstacle>;
using MoveObstacle = MoveObject<Obstacle>;
using AddZone = AddObject<Zone>;
using RemoveZone = RemoveObject<Zone>;
using EditZone = EditObject<Zone>;
using MoveZone = MoveObject<Zone>;

// The list of a scene with the objects of a type, and the word for one of them.
template <class Object>
struct ObjectList;
template <>
struct ObjectList<Source> {
    static constexpr auto list = &Scene::sources;
    static constexpr const char* word = "source";
};
template <>
struct ObjectList<Obstacle> {
    static constexpr auto list = &Scene::obstacles;
    static constexpr const char* word = "obstacle";
};
template <>
struct ObjectList<Zone> {
    static constexpr auto list = &Scene::zones;
    static constexpr const char* word = "zone";
};
struct Retitle {  // sets the scene's title and story; nullopt: unchanged. The run does not depend on them
    std::optional<std::string> title{}, story{};
    friend bool operator==(const Retitle&, const Retitle&) = default;
};
struct NewPopulation {  // starts the next generation: the same number of vehicles at new random poses
    friend bool operator==(const NewPopulation&, const NewPopulation&) = default;
};

// ── Values of the arena and of kinds ──
// Vehicles and starts outside a smaller arena move to the nearest free position inside. Sources, obstacles and zones
// stay.
struct EditArena {
    Arena to;
    friend bool operator==(const EditArena&, const EditArena&) = default;
};
struct EditEcology {  // all values but the population, which SetPopulation sets
    Ecology to;
    friend bool operator==(const EditEcology&, const EditEcology&) = default;
};
struct AddKind {
    Kind kind;  // a name that is empty or in use is replaced by a free one
    int before = -1;
    friend bool operator==(const AddKind&, const AddKind&) = default;
};
struct RemoveKind {  // refused while a vehicle, a start or a member is of this kind
    int kind = 0;
    friend bool operator==(const RemoveKind&, const RemoveKind&) = default;
};
// Replaces a kind but for its brain and its sensors, which have commands of their own. Starts and members of the kind
// follow a new name; vehicles with the kind's driver get its new driver. An empty name: the present one.
struct EditKind {
    int kind = 0;
    Kind to;
    friend bool operator==(const EditKind&, const EditKind&) = default;
};
// Sets the number of vehicles of a kind. New vehicles start at random free poses and count towards the population;
// those with the largest ids are removed first, vehicles with a start last. A reset gives this number of the kind; of
// the other kinds, it gives their present numbers or, once vehicles have starved, the numbers that it gave before.
struct SetPopulation {
    int kind = 0;
    int count = 0;  // 0 .. limits::vehicles
    // To restore an earlier population: vehicles of this kind with their ids, ascending, each added unless it is in the
    // world, and removed after all others; the shares of all kinds, and Ecology::population.
    std::vector<AddVehicle> vehicles{};
    std::vector<float> shares{};      // empty: population and shares follow from `count`
    std::optional<int> population{};  // with shares; none: it does not change
    friend bool operator==(const SetPopulation&, const SetPopulation&) = default;
};

// Moves several objects, each at most once, at the cost of one command for them all.
struct MoveObjects {
    std::vector<MoveVehicle> of_vehicles{};
    std::vector<MoveSource> of_sources{};
    std::vector<MoveObstacle> of_obstacles{};
    std::vector<MoveZone> of_zones{};
    friend bool operator==(const MoveObjects&, const MoveObjects&) = default;
};

// A variant whose special members are defined once, in commands.cpp: a compiler spends seconds on them in each source.
struct Command : std::variant<TurnDial, SetBrain, PlaceNodes, AddVehicle, RemoveVehicle, MoveVehicle, ChooseDriver,
                              Steer, EditStart, SetSensors, AddSource, RemoveSource, EditSource, MoveSource,
                              AddObstacle, RemoveObstacle, EditObstacle, MoveObstacle, NewPopulation, Retitle,
                              EditMember, AddZone, RemoveZone, EditZone, MoveZone, EditArena, EditEcology, AddKind,
                              RemoveKind, EditKind, SetPopulation, SetLook, MoveObjects> {
    using variant::variant;
    Command() = default;
    Command(const Command&);
    Command(Command&&) noexcept;
    Command& operator=(const Command&);
    Command& operator=(Command&&) noexcept;
    ~Command();
};

}  // namespace braitenlab

// Everything that can be done to a running world from outside: the only way in.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/brain/four_neurons.h"
#include "core/brain/graph.h"
#include "core/world/snapshot.h"

namespace braitenlab {

// Whose brain is meant: one vehicle's, or that of every vehicle of a kind, those born later included.
struct Target {
    VehicleId vehicle = no_vehicle;
    int kind = -1;  // used when vehicle is no_vehicle
    friend bool operator==(const Target&, const Target&) = default;
};

struct TurnDial {  // values are clamped to the dial's range
    Target target;
    Dial dial = Dial::LL;
    float value = 0;
    friend bool operator==(const TurnDial&, const TurnDial&) = default;
};
struct SetBrain {
    Target target;
    BrainGraph brain;
    friend bool operator==(const SetBrain&, const SetBrain&) = default;
};
// Where nodes stand on the wiring canvas (Node::place); nothing that the run does is touched by it.
struct NodePlace {
    NodeId node = 0;
    std::optional<maths::vec2> at{};  // none: where it is tidied to
    friend bool operator==(const NodePlace&, const NodePlace&) = default;
};
struct PlaceNodes {  // a node that a brain lacks is passed over
    Target target;
    std::vector<NodePlace> places;
    friend bool operator==(const PlaceNodes&, const PlaceNodes&) = default;
};
// Vehicles that people add and remove are added to and removed from the scene as well: one with a place of its own is a
// start (Scene::starts), any other is one more of the population (Ecology::population).
struct AddVehicle {
    int kind = -1;                      // −1: the kind that the shares ask for next
    std::optional<Pose> at{};           // else somewhere free, at random
    std::optional<BrainGraph> brain{};  // else what newcomers of the kind get
    float energy = 1;                   // 0..1
    std::optional<Driver> driver{};     // else its kind's
    // For one that comes back: who it was, and its start if it had one, with its index.
    VehicleId id = no_vehicle;
    std::optional<Start> start{};
    int before = -1;
    friend bool operator==(const AddVehicle&, const AddVehicle&) = default;
};
struct RemoveVehicle {
    VehicleId vehicle = no_vehicle;  // no_vehicle: the one added last
    friend bool operator==(const RemoveVehicle&, const RemoveVehicle&) = default;
};
struct MoveVehicle {  // it stands still there
    VehicleId vehicle = no_vehicle;
    float x = 0, y = 0, heading = 0;
    friend bool operator==(const MoveVehicle&, const MoveVehicle&) = default;
};
struct ChooseDriver {
    VehicleId vehicle = no_vehicle;
    Driver driver = Driver::brain;
    friend bool operator==(const ChooseDriver&, const ChooseDriver&) = default;
};
struct Steer {  // a vehicle driven by hand: its wheels' commands, −1..1, until the next
    VehicleId vehicle = no_vehicle;
    float left = 0, right = 0;
    friend bool operator==(const Steer&, const Steer&) = default;
};
struct EditStart {  // for the next run; nobody moves now
    int start = 0;
    Start to;
    friend bool operator==(const EditStart&, const EditStart&) = default;
};
struct SetSensors {  // of a kind; readings begin anew
    int kind = 0;
    std::vector<Sensor> sensors;
    friend bool operator==(const SetSensors&, const SetSensors&) = default;
};

// Sources and obstacles are known by their place in Scene::sources and Scene::obstacles as they are at the moment: one
// removed closes the gap, one added goes to the end or before the one at `before`.
struct AddSource {
    Source source;
    int before = -1;
    friend bool operator==(const AddSource&, const AddSource&) = default;
};
struct RemoveSource {
    int source = 0;
    friend bool operator==(const RemoveSource&, const RemoveSource&) = default;
};
struct EditSource {
    int source = 0;
    Source to;
    friend bool operator==(const EditSource&, const EditSource&) = default;
};
struct MoveSource {
    int source = 0;
    float x = 0, y = 0;
    friend bool operator==(const MoveSource&, const MoveSource&) = default;
};
struct AddObstacle {
    Obstacle obstacle;
    int before = -1;
    friend bool operator==(const AddObstacle&, const AddObstacle&) = default;
};
struct RemoveObstacle {
    int obstacle = 0;
    friend bool operator==(const RemoveObstacle&, const RemoveObstacle&) = default;
};
struct EditObstacle {
    int obstacle = 0;
    Obstacle to;
    friend bool operator==(const EditObstacle&, const EditObstacle&) = default;
};
struct MoveObstacle {
    int obstacle = 0;
    float x = 0, y = 0, heading = 0;
    friend bool operator==(const MoveObstacle&, const MoveObstacle&) = default;
};
struct Retitle {  // the scene, for people
    std::string title;
    friend bool operator==(const Retitle&, const Retitle&) = default;
};
struct NewPopulation {  // the next generation: the same numbers at new random places
    friend bool operator==(const NewPopulation&, const NewPopulation&) = default;
};

using Command = std::variant<TurnDial, SetBrain, PlaceNodes, AddVehicle, RemoveVehicle, MoveVehicle, ChooseDriver,
                             Steer, EditStart, SetSensors, AddSource, RemoveSource, EditSource, MoveSource, AddObstacle,
                             RemoveObstacle, EditObstacle, MoveObstacle, NewPopulation, Retitle>;

}  // namespace braitenlab

// Everything that can be done to a running world from outside: the only way in.
#pragma once

#include <string>
#include <variant>

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
struct AddVehicle {
    int kind = -1;  // −1: the kind that the shares ask for next
    friend bool operator==(const AddVehicle&, const AddVehicle&) = default;
};
struct RemoveVehicle {
    VehicleId vehicle = no_vehicle;  // no_vehicle: the one added last
    friend bool operator==(const RemoveVehicle&, const RemoveVehicle&) = default;
};
struct MoveVehicle {
    VehicleId vehicle = no_vehicle;
    float x = 0, y = 0, heading = 0;
    friend bool operator==(const MoveVehicle&, const MoveVehicle&) = default;
};
struct MoveSource {
    int source = 0;  // in Scene::sources
    float x = 0, y = 0;
    friend bool operator==(const MoveSource&, const MoveSource&) = default;
};
struct NewPopulation {  // the next generation: the same numbers at new random places
    friend bool operator==(const NewPopulation&, const NewPopulation&) = default;
};

using Command = std::variant<TurnDial, SetBrain, AddVehicle, RemoveVehicle, MoveVehicle, MoveSource, NewPopulation>;

}  // namespace braitenlab

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
};

struct TurnDial {  // values are clamped to the dial's range
    Target target;
    Dial dial = Dial::LL;
    float value = 0;
};
struct SetBrain {
    Target target;
    BrainGraph brain;
};
struct AddVehicle {
    int kind = -1;  // −1: the kind that the shares ask for next
};
struct RemoveVehicle {
    VehicleId vehicle = no_vehicle;  // no_vehicle: the one added last
};
struct MoveVehicle {
    VehicleId vehicle = no_vehicle;
    float x = 0, y = 0, heading = 0;
};
struct MoveSource {
    int source = 0;  // in Scene::sources
    float x = 0, y = 0;
};
struct NewPopulation {};  // the next generation: the same numbers at new random places

using Command = std::variant<TurnDial, SetBrain, AddVehicle, RemoveVehicle, MoveVehicle, MoveSource, NewPopulation>;

}  // namespace braitenlab

// What all goals of an exercise have in common. A goal is what a vehicle must do, and how far it is from having done
// it.
//
// A goal is one struct: its parameters, `traits`, `needed()`, its `State` (what it remembers from tick to tick; finite
// numbers only), the description of its file keys, the list of its state's values and an overload of `measure`. To add
// a goal, write the struct and its `measure` in core/lesson/goals/ and list it in `Goal` (core/lesson/goals.h).
// Reading, error messages, documentation and saved state derive from these.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/scene/schema.h"
#include "core/world/snapshot.h"

namespace braitenlab {

// The vehicles that checks are about: ids[i] is the vehicle of starts[i]. A scene without starts has one id, that of
// its first vehicle.
struct Subjects {
    std::span<const Start> starts;
    std::span<const VehicleId> ids;
    VehicleId id(std::string_view start_name) const;  // of the first vehicle when the name is empty; or no_vehicle
};

// Poses of the first vehicle in a run with the exercise's solution from the same seed: one per tick, from tick 0.
using ReferencePath = std::vector<Pose>;

namespace goals {

struct Traits {
    std::string_view word;           // in files
    std::string_view unit;           // of the measured and the needed value
    bool at_most = false;            // met when the measured value is at most the needed one; otherwise at least
    float unmeasured = 0;            // value shown before the first measurement
    std::string_view meaning;        // for the documentation: when the goal is met
    bool is_total = false;           // the measured value is one of the run so far, not of the present tick
    bool is_of_scene = false;        // about the scene, not about one vehicle: it is judged without the vehicle, too
    std::string_view quantity = {};  // see Measure::quantity
};

// One tick of a run and the vehicle that the goal is about.
struct Observation {
    const Snapshot& now;
    const VehicleView& vehicle;  // without meaning for a goal about the scene (Traits::is_of_scene)
    const Subjects& subjects;
    const ReferencePath* reference = nullptr;  // null when no goal of the exercise needs it; else up to this tick
};

struct Reading {
    float value = 0;    // in the goal's unit
    bool met = false;   // true while the goal is met
    bool lost = false;  // true when the goal cannot be met any more in this run
};

// Each state with values has such a function, which passes them to a JsonWriter or a JsonReader (core/io/json.h).
template <class State>
requires std::is_empty_v<State>
void visit_values(auto, auto&, Of<State>) {}

// A second value of a goal, measured together with the first one; at most `needed`. A goal with one has a function
// second(State).
struct SecondValue {
    float value = 0, needed = 0;
    std::string_view unit;
};

// From the vehicle to a source, in a torus across the seam if that is shorter; nullopt when the source is missing. The
// nearest source for an empty name.
std::optional<maths::vec2> offset_to_source(const std::string& source, const Observation&);

// Angle in degrees, 0..180, between the vehicle's heading and the direction to a point.
float degrees_off(const VehicleView&, maths::vec2 offset);

}  // namespace goals
}  // namespace braitenlab

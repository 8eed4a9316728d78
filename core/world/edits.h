// Commands that edit the scene of a running world, and their helpers. Inside core/world only.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/messages.h"
#include "core/scene/scene_file.h"
#include "core/world/present_parts.h"
#include "core/world/world_data.h"

namespace braitenlab::world {

// Each returns an error and changes nothing when the scene would become invalid (see check_scene). A name that is empty
// or in use is replaced by a free one.
std::optional<Error> execute(WorldData&, const AddVehicle&);  // add_remove.cpp
std::optional<Error> execute(WorldData&, const RemoveVehicle&);
std::optional<Error> execute(WorldData&, const MoveVehicle&);
std::optional<Error> execute(WorldData&, const SetLook&);
std::optional<Error> execute(WorldData&, const EditStart&);
std::optional<Error> execute(WorldData&, const EditMember&);
std::optional<Error> execute(WorldData&, const SetSensors&);         // sensor_edits.cpp
template <class Object>                                              // Source, Obstacle, Zone
std::optional<Error> execute(WorldData&, const AddObject<Object>&);  // edits.cpp
template <class Object>
std::optional<Error> execute(WorldData&, const RemoveObject<Object>&);
template <class Object>
std::optional<Error> execute(WorldData&, const EditObject<Object>&);
template <class Object>
std::optional<Error> execute(WorldData&, const MoveObject<Object>&);
std::optional<Error> execute(WorldData&, const MoveObjects&);
std::optional<Error> execute(WorldData&, const EditArena&);  // edit_values.cpp
std::optional<Error> execute(WorldData&, const EditEcology&);
std::optional<Error> execute(WorldData&, const AddKind&);
std::optional<Error> execute(WorldData&, const RemoveKind&);
std::optional<Error> execute(WorldData&, const EditKind&);
std::optional<Error> execute(WorldData&, const SetPopulation&);  // add_remove.cpp

inline bool is_finite(const Pose& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.heading); }
inline Error unknown_vehicle(VehicleId id) { return error_of(message_of("vehicle_is_gone", id)); }
inline Error not_finite() { return {"a position takes finite numbers only"}; }

// Derives the designs of vehicles with sensors of their own again from the kinds of the scene.
inline void renew_designs(State& s) {
    std::map<const OwnDesign*, SharedDesign> made;  // by the earlier one
    for (std::size_t row = 0; row < s.vehicles.size(); ++row) {
        SharedDesign& design = s.vehicles.design[row];
        if (!design) continue;
        const Kind& kind = s.scene->kinds[static_cast<std::size_t>(s.vehicles.kind[row])];
        const auto [known, is_new] = made.try_emplace(design.get());
        if (is_new) known->second = own_design(kind, design->kind.sensors);
        design = known->second;
    }
}

// The error of size_fault() for a scene that is valid but for its size. Precondition: its kinds are those of the parts.
std::optional<Error> check_size(const Scene&, const PresentParts&);  // edits.cpp
// The error of check_scene(), or of check_size() with the present brains and sensors.
std::optional<Error> check_edited(const WorldData&, const Scene&);

// The error that the scene would have if these were the sensors of the kind.
std::optional<Error> check_sensors(const WorldData&, std::size_t kind, const std::vector<Sensor>&);  // sensor_edits.cpp

// Replaces the scene by an edited one and rebuilds the world from it.
inline void replace_scene(WorldData& s, Scene scene) {
    State state = std::move(static_cast<State&>(s));
    state.scene = std::make_shared<const Scene>(std::move(scene));
    renew_designs(state);
    s = WorldData(std::move(state));
}

// Compiles every brain of a kind again, for the sensors and the role of `kind`. Precondition: check_scene accepts it.
void compile_again(WorldData&, int index, const Kind& kind);  // edits.cpp

template <class Element>
std::optional<Error> missing(const std::vector<Element>& elements, int index, const char* what) {
    if (index >= 0 && static_cast<std::size_t>(index) < elements.size()) return std::nullopt;
    return Error{fmt::format("the scene has no {} number {}", what, index)};
}

template <class Element>
auto iterator_at(std::vector<Element>& elements, int index) {
    return elements.begin() + static_cast<std::ptrdiff_t>(index);
}

// Index at which to insert a new element: `before`, or the end for −1.
template <class Element>
int insertion_index(const std::vector<Element>& elements, int before) {
    const auto count = static_cast<int>(elements.size());
    return before < 0 ? count : std::min(before, count);
}

// The requested name if it is not empty and not in use, else the word, with the lowest free number from 2 if needed.
template <class Element>
std::string free_name(const std::vector<Element>& elements, const std::string& requested, std::string_view word) {
    const auto is_used = [&](const std::string& name) {
        return std::any_of(elements.begin(), elements.end(), [&](const Element& e) { return e.name == name; });
    };
    if (!requested.empty() && !is_used(requested)) return requested;
    std::string name(word);
    for (int number = 2; is_used(name); ++number) name = fmt::format("{}-{}", word, number);
    return name;
}

}  // namespace braitenlab::world

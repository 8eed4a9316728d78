// Commands that edit the scene of a running world, and their helpers. Inside core/world only.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/scene/scene_file.h"
#include "core/world/world_data.h"

namespace braitenlab::world {

// Each returns an error and changes nothing when the scene would become invalid (see check_scene). A name that is empty
// or in use is replaced by a free one.
std::optional<Error> execute(WorldData&, const AddVehicle&);  // add_remove.cpp
std::optional<Error> execute(WorldData&, const RemoveVehicle&);
std::optional<Error> execute(WorldData&, const MoveVehicle&);
std::optional<Error> execute(WorldData&, const EditStart&);
std::optional<Error> execute(WorldData&, const EditMember&);
std::optional<Error> execute(WorldData&, const SetSensors&);  // edits.cpp
std::optional<Error> execute(WorldData&, const AddSource&);
std::optional<Error> execute(WorldData&, const RemoveSource&);
std::optional<Error> execute(WorldData&, const EditSource&);
std::optional<Error> execute(WorldData&, const MoveSource&);
std::optional<Error> execute(WorldData&, const AddObstacle&);
std::optional<Error> execute(WorldData&, const RemoveObstacle&);
std::optional<Error> execute(WorldData&, const EditObstacle&);
std::optional<Error> execute(WorldData&, const MoveObstacle&);

inline bool is_finite(const Pose& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.heading); }
inline Error unknown_vehicle(VehicleId id) {
    return {fmt::format("vehicle {} is no longer in the world; select another one", id)};
}
inline Error not_finite() { return {"a position takes finite numbers only"}; }

// Replaces the scene by an edited one and rebuilds the world from it.
inline void replace_scene(WorldData& s, Scene scene) {
    State state = std::move(static_cast<State&>(s));
    state.scene = std::make_shared<const Scene>(std::move(scene));
    s = WorldData(std::move(state));
}

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

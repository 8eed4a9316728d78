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

#include "core/maths/angle.h"
#include "core/messages.h"
#include "core/scene/scene_file.h"
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
std::optional<Error> execute(WorldData&, const SetSensors&);  // sensor_edits.cpp
std::optional<Error> execute(WorldData&, const AddSource&);   // edits.cpp
std::optional<Error> execute(WorldData&, const RemoveSource&);
std::optional<Error> execute(WorldData&, const EditSource&);
std::optional<Error> execute(WorldData&, const MoveSource&);
std::optional<Error> execute(WorldData&, const AddObstacle&);
std::optional<Error> execute(WorldData&, const RemoveObstacle&);
std::optional<Error> execute(WorldData&, const EditObstacle&);
std::optional<Error> execute(WorldData&, const MoveObstacle&);
std::optional<Error> execute(WorldData&, const AddZone&);
std::optional<Error> execute(WorldData&, const RemoveZone&);
std::optional<Error> execute(WorldData&, const EditZone&);
std::optional<Error> execute(WorldData&, const MoveZone&);
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

// The scene with one more, one edited or one removed source, obstacle or zone (`of`: the list of the scene). An error
// if it has no element with this index or would become invalid. An edited element keeps its name, because starts and
// checks refer to it.
template <class Element>
Result<Scene> with_added(Scene scene, std::vector<Element> Scene::*of, Element element, int before,
                         std::string_view word) {
    std::vector<Element>& all = scene.*of;
    element.name = free_name(all, element.name, word);
    all.insert(iterator_at(all, insertion_index(all, before)), std::move(element));
    if (auto error = check_scene(scene)) return *error;
    return scene;
}

template <class Element>
Result<Scene> with_edited(Scene scene, std::vector<Element> Scene::*of, int index, Element to, const char* what) {
    if (auto error = missing(scene.*of, index, what)) return *error;
    Element& element = *iterator_at(scene.*of, index);
    to.name = element.name;
    element = std::move(to);
    if (auto error = check_scene(scene)) return *error;
    return scene;
}

template <class Element>
Result<Scene> without(Scene scene, std::vector<Element> Scene::*of, int index, const char* what) {
    if (auto error = missing(scene.*of, index, what)) return *error;
    (scene.*of).erase(iterator_at(scene.*of, index));
    return scene;
}

// Moves an element to this pose, clamped to the range of a position. A valid scene stays valid, because no rule of
// check_scene depends on these positions: a drag of many objects does not check the whole scene for each of them.
template <class Element>
std::optional<Error> move(std::vector<Element>& elements, int index, const Pose& to, const char* what) {
    if (auto error = missing(elements, index, what)) return error;
    if (!is_finite(to)) return not_finite();
    Element& element = *iterator_at(elements, index);
    element.x = std::clamp(to.x, -1000.0f, 1000.0f);
    element.y = std::clamp(to.y, -1000.0f, 1000.0f);
    if constexpr (requires { element.heading; }) element.heading = maths::wrap_angle(to.heading);
    return std::nullopt;
}

// The scene with an element at this pose, see move().
template <class Element>
Result<Scene> with_moved(Scene scene, std::vector<Element> Scene::*of, int index, const Pose& to, const char* what) {
    if (auto error = move(scene.*of, index, to, what)) return *error;
    return scene;
}

}  // namespace braitenlab::world

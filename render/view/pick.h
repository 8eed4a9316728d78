// Picking: the vehicle, source, obstacle or zone under a pixel, and the pose and extent of such an object.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/enum_table.h"
#include "core/world/snapshot.h"
#include "render/view/camera.h"

namespace braitenlab {

enum class SceneObjectKind { none, vehicle, source, obstacle, zone };
inline constexpr std::array<std::string_view, 5> scene_object_words{"none", "vehicle", "source", "obstacle", "zone"};
static_assert(has_enumerators<SceneObjectKind, scene_object_words.size()>());
constexpr std::string_view word(SceneObjectKind kind) { return scene_object_words[static_cast<std::size_t>(kind)]; }

// Identifies an object of the scene that the user can select and move.
struct SceneObject {
    SceneObjectKind kind = SceneObjectKind::none;
    int index = -1;  // VehicleId of a vehicle; else the index in Scene::sources, Scene::obstacles or Scene::zones
    explicit operator bool() const { return kind != SceneObjectKind::none; }
    friend bool operator==(const SceneObject&, const SceneObject&) = default;
};

inline SceneObject vehicle_object(VehicleId id) {
    return id == no_vehicle ? SceneObject{} : SceneObject{SceneObjectKind::vehicle, id};
}

// The vehicle under a pixel, with a margin of a few pixels around the body. Of several vehicles, the one whose centre
// is nearest to the pixel. no_vehicle if there is none.
VehicleId pick(const Snapshot&, const CameraView&, maths::vec2 pixel);

// The object under a pixel: a vehicle; if there is none, a source (near its foot or its bulb); else an obstacle; else
// the topmost zone, if `zones`. SceneObject{} if there is none.
SceneObject pick_object(const Snapshot&, const CameraView&, maths::vec2 pixel, bool zones = true);

// The current pose of an object. The heading of a source is 0. nullopt if the object does not exist.
std::optional<Pose> place_of(const Snapshot&, const SceneObject&);

// The radius of a circle around the object's position that contains the object, m; 0 if the object does not exist.
float reach_of(const Snapshot&, const SceneObject&);

// The corners of an obstacle or a zone in its current pose, world coordinates, m, counter-clockwise; points on the
// boundary of an ellipse. Empty for other objects and if it does not exist.
std::vector<maths::vec2> outline_of(const Snapshot&, const SceneObject&);

// All sources, then all obstacles, then all zones.
std::vector<SceneObject> objects_beside_vehicles(const Scene&);

// The name of a source, obstacle or zone in the scene; empty for other objects and if it does not exist.
std::string name_of(const Scene&, const SceneObject&);

// The source, obstacle or zone with this name; SceneObject{} if there is none.
SceneObject object_named(const Scene&, SceneObjectKind, const std::string& name);

inline constexpr float bulb_height = 0.4f;  // m, of a source's light above the floor, times scale_of() the arena

}  // namespace braitenlab

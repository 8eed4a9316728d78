// What in the scene lies under a pixel, and where it stands: vehicles, sources and obstacles as one kind of value.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "core/world/snapshot.h"
#include "render/view/camera.h"

namespace braitenlab {

enum class SceneObjectKind { none, vehicle, source, obstacle };
inline constexpr std::array<std::string_view, 4> scene_object_words{"none", "vehicle", "source", "obstacle"};
constexpr std::string_view word(SceneObjectKind kind) { return scene_object_words[static_cast<std::size_t>(kind)]; }

// Something in the scene that a hand can take.
struct SceneObject {
    SceneObjectKind kind = SceneObjectKind::none;
    int index = -1;  // a vehicle's id; else the place in Scene::sources or Scene::obstacles
    explicit operator bool() const { return kind != SceneObjectKind::none; }
    friend bool operator==(const SceneObject&, const SceneObject&) = default;
};

inline SceneObject vehicle_object(VehicleId id) {
    return id == no_vehicle ? SceneObject{} : SceneObject{SceneObjectKind::vehicle, id};
}

// The vehicle under a pixel, or no_vehicle; generous by a few pixels, the nearest to the pixel wins.
VehicleId pick(const Snapshot&, const CameraView&, maths::vec2 pixel);

// The same for everything: vehicles before sources, sources (by foot or bulb) before obstacles.
SceneObject pick_object(const Snapshot&, const CameraView&, maths::vec2 pixel);

// Where it stands now; a source has no heading. Nothing when it is gone.
std::optional<Pose> place_of(const Snapshot&, const SceneObject&);

// The radius of the circle round its place that it lies within, m; 0 when it is gone.
float reach_of(const Snapshot&, const SceneObject&);

// The corners of an obstacle where it stands now, counter-clockwise, m; none when it is gone.
std::vector<maths::vec2> outline_of(const Snapshot&, int obstacle);

inline constexpr float obstacle_height = 0.42f;  // m, as drawn
inline constexpr float bulb_height = 0.4f;       // m, of a source's light

}  // namespace braitenlab

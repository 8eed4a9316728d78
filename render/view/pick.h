// What in the scene lies under a pixel, and where it stands: vehicles, sources and obstacles as one kind of value.
#pragma once

#include <optional>
#include <vector>

#include "core/world/snapshot.h"
#include "render/view/camera.h"

namespace braitenlab {

enum class ThingKind { none, vehicle, source, obstacle };

// Something in the scene that a hand can take.
struct Thing {
    ThingKind kind = ThingKind::none;
    int index = -1;  // a vehicle's id; else the place in Scene::sources or Scene::obstacles
    explicit operator bool() const { return kind != ThingKind::none; }
    friend bool operator==(const Thing&, const Thing&) = default;
};

inline Thing vehicle_thing(VehicleId id) { return id == no_vehicle ? Thing{} : Thing{ThingKind::vehicle, id}; }

// The vehicle under a pixel, or no_vehicle; generous by a few pixels, the nearest to the pixel wins.
VehicleId pick(const Snapshot&, const Sight&, maths::vec2 pixel);

// The same for everything: vehicles before sources, sources (by foot or bulb) before obstacles.
Thing pick_thing(const Snapshot&, const Sight&, maths::vec2 pixel);

// Where it stands now; a source has no heading. Nothing when it is gone.
std::optional<Pose> place_of(const Snapshot&, const Thing&);

// The radius of the circle round its place that it lies within, m; 0 when it is gone.
float reach_of(const Snapshot&, const Thing&);

// The corners of an obstacle where it stands now, counter-clockwise, m; none when it is gone.
std::vector<maths::vec2> outline_of(const Snapshot&, int obstacle);

inline constexpr float obstacle_height = 0.42f;  // m, as drawn
inline constexpr float bulb_height = 0.4f;       // m, of a source's light

}  // namespace braitenlab

// Where the scene is seen from. No graphics library: a camera is a few numbers and two matrices.
//
// The world's plane (x, y) is drawn at GL's (x, 0, −y) with Y up, so that left stays left.
#pragma once

#include <optional>

#include "core/maths/mat4.h"
#include "core/maths/vec.h"
#include "core/world/snapshot.h"

namespace braitenlab {

enum class CameraMode { overview, follow };

// A point of the world, metres, in GL's coordinates.
constexpr maths::vec3 to_gl(maths::vec2 place, float height = 0) { return {place.x, height, -place.y}; }

// A rectangle in window pixels, y down from the top.
struct Rect {
    float x = 0, y = 0, w = 0, h = 0;
    bool contains(float px, float py) const { return px >= x && px < x + w && py >= y && py < y + h; }
    friend bool operator==(const Rect&, const Rect&) = default;
};

// What a person moves: the overview rides on a ring round the arena.
struct Camera {
    CameraMode mode = CameraMode::overview;
    float azimuth = -1.5707963f;  // rad, where on the ring the eye stands; −pi/2: behind −y, so +x is to the right
    float elevation = 1.1f;       // rad above the floor, 0.15..1.5
    float zoom = 1;               // 0.25..8; 1 fits the arena into the free part of the window
    maths::vec2 pan{};            // m, shifts what the overview looks at
};

// What the renderer and the mouse need: both matrices and the eye.
struct Sight {
    maths::mat4 view, projection;  // GL conventions
    maths::vec3 eye;               // GL coordinates
    Rect window;                   // the whole framebuffer, px
};

// The camera's sight of this moment. `free_area` is the part of the window that no card covers: the arena is centred
// and fitted there. `follow` is the vehicle to ride behind (ignored in overview).
Sight look(const Camera&, const Arena&, const VehicleView* follow, Rect window, Rect free_area);

// Moves `from` towards `to` as time passes, so that a change of camera is a short glide; seconds of wall time.
Sight glide(const Sight& from, const Sight& to, float seconds);

// Where a point of the world (metres; height above the floor) falls in the window, or nothing when behind the eye.
std::optional<maths::vec2> project(const Sight&, maths::vec2 place, float height = 0);

// The point of the floor under a pixel, or nothing above the horizon.
std::optional<maths::vec2> unproject(const Sight&, maths::vec2 pixel);

// The vehicle under a pixel, or no_vehicle; generous by a few pixels, the nearest to the pixel wins.
VehicleId pick(const Snapshot&, const Sight&, maths::vec2 pixel);

}  // namespace braitenlab

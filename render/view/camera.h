// Where the scene is seen from. No graphics library: a camera is a few numbers and two matrices.
//
// The world's plane (x, y) is drawn at GL's (x, 0, −y) with Y up, so that left stays left.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/maths/mat4.h"
#include "core/maths/vec.h"
#include "core/world/snapshot.h"

namespace braitenlab {

// overview: on a ring round the arena, turned, raised, panned and zoomed freely; follow: behind and above a vehicle;
// birds_eye: straight down without perspective; driver: through the eyes of a vehicle.
enum class CameraMode { overview, follow, birds_eye, driver };
inline constexpr std::array<std::string_view, 4> camera_mode_words{"overview", "follow", "birds_eye", "driver"};
constexpr std::string_view word(CameraMode mode) { return camera_mode_words[static_cast<std::size_t>(mode)]; }

// Whether the camera rides with a vehicle.
constexpr bool rides(CameraMode mode) { return mode == CameraMode::follow || mode == CameraMode::driver; }

// A point of the world, metres, in GL's coordinates.
constexpr maths::vec3 to_gl(maths::vec2 place, float height = 0) { return {place.x, height, -place.y}; }

// A rectangle in window pixels, y down from the top.
struct Rect {
    float x = 0, y = 0, w = 0, h = 0;
    bool contains(float px, float py) const { return px >= x && px < x + w && py >= y && py < y + h; }
    friend bool operator==(const Rect&, const Rect&) = default;
};

// What a person moves. A fresh one is the way home: everything in sight.
struct Camera {
    CameraMode mode = CameraMode::overview;
    float azimuth = -1.5707963f;  // rad, where on the ring the eye stands; −pi/2: behind −y, so +x is to the right
    float elevation = 1.1f;       // rad above the floor, 0.15..1.5
    float zoom = 1;               // 0.25..8; 1 fits the arena into the free part of the window
    maths::vec2 pan{};            // m, shifts what overview and bird's eye look at
    friend bool operator==(const Camera&, const Camera&) = default;
};

// What the renderer and the mouse need: both matrices and the eye.
struct Sight {
    maths::mat4 view, projection;  // GL conventions
    maths::vec3 eye;               // GL coordinates
    Rect window;                   // the whole framebuffer, px
};

// The camera's sight of this moment. `free_area` is the part of the window that no card covers: the arena is centred
// and fitted there. `follow` is the vehicle to ride with; without one, the modes that ride show the overview.
Sight look(const Camera&, const Arena&, const VehicleView* follow, Rect window, Rect free_area);

// Turns and raises the camera on its ring, rad.
void orbit(Camera&, float azimuth, float elevation);

// Moves the camera so that the floor under pixel `from` comes to lie under pixel `to`.
void pan(Camera&, const Sight&, maths::vec2 from, maths::vec2 to);

// Zooms by a factor; what is on the floor under the pixel stays there (but not while riding). Arguments as look()'s.
void zoom_about(Camera&, const Arena&, Rect window, Rect free_area, maths::vec2 pixel, float factor);

// Moves `from` towards `to` as time passes, so that a change of camera is a short glide; seconds of wall time.
Sight glide(const Sight& from, const Sight& to, float seconds);

// Where a point of the world (metres; height above the floor) falls in the window, or nothing when behind the eye.
std::optional<maths::vec2> project(const Sight&, maths::vec2 place, float height = 0);

// How many pixels a metre across the line of sight is long there; 0 behind the eye.
float pixels_per_metre(const Sight&, maths::vec2 place, float height = 0);

// The point of the floor, or of the plane at this height above it, under a pixel; nothing above the horizon.
std::optional<maths::vec2> unproject(const Sight&, maths::vec2 pixel, float height = 0);

}  // namespace braitenlab

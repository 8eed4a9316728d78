// The camera: its settings, its matrices, and conversion between world and pixels.
//
// The world's (x, y, height) is GL's (x, height, −y).
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/enum_table.h"
#include "core/maths/mat4.h"
#include "core/maths/vec.h"
#include "core/world/snapshot.h"

namespace braitenlab {

// overview: the camera is on a ring around the arena; follow: behind and above a vehicle; birds_eye: straight down,
// orthographic; driver: at the front of a vehicle.
enum class CameraMode { overview, follow, birds_eye, driver };
inline constexpr std::array<std::string_view, 4> camera_mode_words{"overview", "follow", "birds_eye", "driver"};
static_assert(has_enumerators<CameraMode, camera_mode_words.size()>());
constexpr std::string_view word(CameraMode mode) { return camera_mode_words[static_cast<std::size_t>(mode)]; }

// True if the camera moves with a vehicle.
constexpr bool rides(CameraMode mode) { return mode == CameraMode::follow || mode == CameraMode::driver; }

// World coordinates, m, to GL coordinates.
constexpr maths::vec3 to_gl(maths::vec2 place, float height = 0) { return {place.x, height, -place.y}; }

// Distance of the fine lines of the grid on the floor, m: 1, in a small arena 0.1. Every fifth line is bright.
inline float grid_share(const Arena& arena) { return scale_of(arena) < 1 ? 0.1f : 1.0f; }

// Walls and obstacles as drawn, m. In an arena of less than five metres they are lower in proportion, so that they do
// not hide a small robot.
struct WallSize {
    float thickness = 0, height = 0;
};
inline WallSize wall_of(const Arena& arena) { return {0.22f * scale_of(arena), 0.35f * scale_of(arena)}; }
inline float obstacle_height(const Arena& arena) { return 0.42f * scale_of(arena); }

// A rectangle in window pixels, y down.
struct Rect {
    float x = 0, y = 0, w = 0, h = 0;
    maths::vec2 middle() const { return {x + w / 2, y + h / 2}; }
    bool contains(float px, float py) const { return px >= x && px < x + w && py >= y && py < y + h; }
    bool contains(maths::vec2 at) const { return contains(at.x, at.y); }
    // Rectangles that only touch do not overlap.
    bool overlaps(const Rect& r) const { return r.x < x + w && x < r.x + r.w && r.y < y + h && y < r.y + r.h; }
    friend bool operator==(const Rect&, const Rect&) = default;
};

inline Rect square_around(maths::vec2 middle, float side) {
    return {middle.x - side / 2, middle.y - side / 2, side, side};
}

// The camera settings that a user changes. Default: the action (framing.h).
struct Camera {
    CameraMode mode = CameraMode::overview;
    float azimuth = -1.5707963f;  // rad, direction from the arena's centre to the camera; −pi/2: +x is to the right
    float elevation = 1.0f;       // rad above the floor, 0.15..1.5
    float zoom = 1;               // 0.25..8; 1 fits the framed part of the floor into the free part of the window
    maths::vec2
        pan{};  // m, shift of the point that overview and bird's eye look at, from the middle of the framed part
    bool turned = false;  // by the user: the framing then leaves the elevation as it is
    friend bool operator==(const Camera&, const Camera&) = default;
};

// A camera in a window: matrices and position, for drawing and picking.
struct CameraView {
    maths::mat4 view, projection;  // GL conventions
    maths::vec3 eye;               // position, GL coordinates
    Rect window;                   // the whole framebuffer, px
};

// A box on the floor, m.
struct FloorBox {
    maths::vec2 low, high;
    friend bool operator==(const FloorBox&, const FloorBox&) = default;
};

// Computes the view of a camera. `free_area`: the part of the window that no card covers; the framed box (null: the
// whole arena) is centred and fitted there. `follow`: the vehicle for the modes follow and driver; if it is null, these
// modes give the overview. `ride_scale`: of the distances of these modes.
CameraView look(const Camera&, const Arena&, const VehicleView* follow, Rect window, Rect free_area,
                const FloorBox* framed = nullptr, float ride_scale = 1);

// Scale of the distances of the modes follow and driver: 1, in a small arena the length of the vehicle in metres.
float ride_scale(const Snapshot&, const VehicleView* followed);

// Adds to azimuth and elevation, rad. With another value than 0 the camera is turned.
void orbit(Camera&, float azimuth, float elevation);

// Moves the camera so that the floor point under pixel `from` is under pixel `to`.
void pan(Camera&, const CameraView&, maths::vec2 from, maths::vec2 to);

// Multiplies the zoom. The floor point under the pixel stays under it, except in the modes follow and driver. The
// arena, `window`, `free_area` and `framed` are those of look().
void zoom_about(Camera&, const Arena&, Rect window, Rect free_area, maths::vec2 pixel, float factor,
                const FloorBox* framed = nullptr);

// Interpolates between two views for a transition of about 0.2 s. `seconds`: wall time since `from`.
CameraView glide(const CameraView& from, const CameraView& to, float seconds);

// The pixel of a world point, `height` metres above the floor. nullopt if the point is behind the camera.
std::optional<maths::vec2> project(const CameraView&, maths::vec2 place, float height = 0);

// Pixels per metre across the viewing direction at a point; 0 behind the camera.
float pixels_per_metre(const CameraView&, maths::vec2 place, float height = 0);

// The point under a pixel on the plane `height` metres above the floor, m. nullopt if the pixel is above the horizon.
std::optional<maths::vec2> unproject(const CameraView&, maths::vec2 pixel, float height = 0);

}  // namespace braitenlab

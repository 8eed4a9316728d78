// The camera of a frame, and its control by mouse and arrow keys. Mouse input for objects in the scene is in
// ui/scene_input.
#pragma once

#include <cstdint>
#include <span>

#include "app/lab.h"
#include "render/view/camera.h"
#include "render/view/framing.h"
#include "ui/scene_input/scene_input.h"

namespace braitenlab {

struct ViewportState {
    CameraView camera_view;  // of this frame
    bool has_sight = false;
    Framing framing;
    FloorBox framed;        // the part of the floor that zoom 1 shows
    float below_cards = 0;  // height of the free area that is left out at its top, because a card hides something there
    std::uint64_t tick = 0;  // of the last frame
    float age = 1e9f;        // s since the last change that is shown as a glide
    Camera last;             // camera of the last frame, and the vehicle that it followed
    VehicleId last_followed = no_vehicle;
    Rect last_area;  // free area of the last frame, and the document
    std::uint64_t last_run = 0;
};

// Keys of the camera that are held: −1, 0 or 1 each.
struct CameraKeys {
    float turn = 0, raise = 0, zoom = 0;
    maths::vec2 pan;  // to the right, up
    explicit operator bool() const { return turn != 0 || raise != 0 || zoom != 0 || pan.x != 0 || pan.y != 0; }
};

// Computes the camera view of this frame. A change of mode or vehicle, Home, and in a lecture a change of the free
// area, as by a step of a page, are shown as short glides, unless motion is reduced. Other changes apply at once. While
// both slots run, the vehicle of B stays in the picture, too, and so do rings that an exercise is about. `cards`: over
// the scene, as folded cards of a lecture are. Once one hides a vehicle or a bulb, the scene is framed below it, until
// the run is back at its start.
void aim(ViewportState&, const Lab&, Rect window, Rect free_area, float seconds, const SlotsView& = {},
         std::span<const Rect> cards = {});

// Turns the camera by the slow orbit, if ViewSettings::orbits; motion must not be reduced.
void orbit_slowly(Camera&, float seconds);

// Moves the camera by mouse and arrow keys: left drag on the floor orbits (pans in bird's eye), right or middle drag
// pans, the wheel zooms about the pointer, keys turn, raise, zoom and pan; any of them ends the slow orbit. Reads the
// mouse from Dear ImGui.
void drive_camera(Lab&, const ViewportState&, const ui::SceneInputState&, CameraKeys, Rect window, Rect free_area,
                  float seconds);

}  // namespace braitenlab

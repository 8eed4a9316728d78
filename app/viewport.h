// The camera: where it stands in this frame, and what mouse and arrow keys do to it. What they do to things in the
// scene is ui/stage's.
#pragma once

#include "app/lab.h"
#include "render/view/camera.h"
#include "ui/stage/stage.h"

namespace braitenlab {

struct ViewportState {
    Sight sight;  // of this frame
    bool has_sight = false;
    float age = 1e9f;  // s since the camera changed by a jump, which becomes a short glide
    Camera last;       // last frame's camera and whom it rode with
    VehicleId last_followed = no_vehicle;
};

// Which arrows are held: −1, 0 or 1 each way.
struct Arrows {
    float turn = 0, raise = 0;
};

// Stands the camera up for this frame. Changes of mode or vehicle and the way home are short glides, everything else
// follows at once; so does all where motion is reduced.
void aim(ViewportState&, const Lab&, Rect window, Rect free_area, float seconds);

// The mouse over the free floor: left drag orbits (pans the bird's eye), right or middle drag pans, the wheel zooms
// about the pointer; arrows turn and raise the overview. Reads the mouse from Dear ImGui.
void drive_camera(Lab&, const ViewportState&, const StageState&, Arrows, Rect window, Rect free_area, float seconds);

}  // namespace braitenlab

// The mouse and the arrow keys over the 3D view: orbit, zoom, select, and drag vehicles and lamps.
#pragma once

#include <cstdint>
#include <optional>

#include "app/lab.h"
#include "render/view/camera.h"

namespace braitenlab {

// What is under the pointer or in the hand. At most one of the two is set.
struct Grip {
    VehicleId vehicle = no_vehicle;
    int source = -1;
    bool any() const { return vehicle != no_vehicle || source >= 0; }
};

struct ViewportState {
    Grip hovered;
    std::optional<maths::vec2> pressed_at;  // window pixels; while the left button is down over the view
    Grip held;                              // what lay under the press
    maths::vec2 offset;                     // m, from the pointer's place on the floor to what is held
    bool dragging = false;                  // moved more than a few pixels since
    bool orbiting = false;                  // with the right button
    std::uint64_t gesture = 0;
};

// Which arrows are held: −1, 0 or 1 each way.
struct Arrows {
    float turn = 0, raise = 0;
};

// One frame of it. Reads the mouse from Dear ImGui, which says whether a card is under it.
void drive_viewport(Lab&, ViewportState&, const Sight&, Arrows, float seconds);

}  // namespace braitenlab

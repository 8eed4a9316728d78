// What a picture shows beyond the world itself.
#pragma once

#include "core/world/snapshot.h"
#include "render/view/camera.h"
#include "render/view/palette.h"
#include "render/view/view_settings.h"

namespace braitenlab {

struct Picture {
    CameraView camera_view;
    Theme theme = Theme::dark;
    ViewSettings settings;  // its camera is not used: `camera_view` has been made from it
    VehicleId hovered = no_vehicle;
    VehicleId driver = no_vehicle;    // the vehicle that carries the camera: its sensor fields are always drawn
    std::vector<bool> hidden_brains;  // by kind: no wires on the deck, no arrows at the wheels; empty: none
    bool reduce_motion = false;       // no mark grows or fades
    float pixel_scale = 1;            // display pixels per layout pixel, for line widths
    char decimal_mark = '.';          // of the language, for the numbers at contour lines
};

}  // namespace braitenlab

// What a picture shows beyond the world itself.
#pragma once

#include "core/world/snapshot.h"
#include "render/view/camera.h"
#include "render/view/overlays.h"
#include "render/view/palette.h"

namespace braitenlab {

struct Picture {
    Sight sight;
    Theme theme = Theme::dark;
    VehicleId selected = no_vehicle, hovered = no_vehicle;
    bool thing_selected = false;    // a lamp or an obstacle is, above all: the vehicle's ring stands back
    VehicleId driver = no_vehicle;  // through whose eyes one looks: its fields show whatever else is off
    bool sensors = true;            // fill the sensor fields
    bool outlines = false;          // draw their edges
    Overlays overlays;
    float pixel_scale = 1;  // display pixels per layout pixel, for line widths
};

}  // namespace braitenlab

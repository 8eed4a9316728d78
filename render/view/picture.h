// What a picture shows beyond the world itself.
#pragma once

#include <optional>

#include "core/world/snapshot.h"
#include "render/view/camera.h"
#include "render/view/palette.h"

namespace braitenlab {

// What may be shown beyond the things themselves.
struct Overlays {
    bool trails = true;            // where vehicles came from
    bool surfaces = true;          // zones: ice, carpet, wind, …
    bool memory = true;            // the places that vehicles remember
    bool labels = true;            // names of things
    std::optional<Channel> field;  // how strongly this channel is felt everywhere, as contours
    friend bool operator==(const Overlays&, const Overlays&) = default;
};

struct Picture {
    Sight sight;
    Theme theme = Theme::dark;
    VehicleId selected = no_vehicle, hovered = no_vehicle;
    VehicleId driver = no_vehicle;  // through whose eyes one looks: its fields show whatever else is off
    bool sensors = true;            // fill the sensor fields
    bool outlines = false;          // draw their edges
    Overlays overlays;
    float pixel_scale = 1;  // display pixels per layout pixel, for line widths
};

}  // namespace braitenlab

// What a picture shows beyond the world itself.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/world/snapshot.h"
#include "render/view/camera.h"
#include "render/view/palette.h"
#include "render/view/view_settings.h"

namespace braitenlab {

// Words in the language for names of sources and zones.
using NameMap = std::map<std::string, std::string, std::less<>>;

struct Picture {
    CameraView camera_view;
    Theme theme = Theme::dark;
    Quality quality = Quality::low;
    float resolution = 1;        // pixels drawn per pixel of the window, in width and in height, 0..1; labels have all
    bool coarse_ground = false;  // while the ground moves in the picture, it has half the pixels in width and in height
    // While nothing moves, the scene is drawn once with all pixels and then copied, where a window has one sample per
    // pixel, as those of software renderers have.
    bool copied_at_rest = false;
    // The window shows the last picture, and everything over the scene is as in it: if the scene rests, too, nothing is
    // drawn.
    bool may_stay = false;
    ViewSettings settings;  // its camera is not used: `camera_view` has been made from it
    VehicleId hovered = no_vehicle;
    VehicleId driver = no_vehicle;    // the vehicle that carries the camera: its sensor fields are always drawn
    std::vector<bool> hidden_brains;  // by kind: no wires on the deck, no arrows at the wheels; empty: none
    bool reduce_motion = false;       // no mark grows or fades
    float pixel_scale = 1;            // display pixels per layout pixel, for line widths
    const NameMap* names = nullptr;   // null: sources and zones have the names of the file
    char decimal_mark = '.';          // of the language, for the numbers at contour lines
    std::vector<Rect> covered;        // cards and words over the scene, display pixels: no label is under them
    std::vector<Rect> opaque;         // display pixels over which something opaque is drawn later: nothing is below
};

}  // namespace braitenlab

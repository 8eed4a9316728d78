// A still picture of a scene from above: floor, zones, obstacles, lamps and start poses. It is drawn from the scene
// alone, so it shows nothing of what the vehicles will do.
#pragma once

#include <vector>

#include <imgui.h>

#include "core/maths/vec.h"
#include "core/scene/scene.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

// A part of the floor, metres.
struct FloorArea {
    maths::vec2 low, high;
};

// The part with every object and start of the scene and a margin, inside the arena.
FloorArea occupied_area(const Scene&);

// Enlarges the area to these points.
void include(FloorArea&, const std::vector<maths::vec2>&);

// Maps a part of the floor into a rectangle of the window, as large as fits.
struct FloorMap {
    Rect place;
    maths::vec2 middle;
    float scale = 1;  // window pixels per metre

    FloorMap(const FloorArea&, Rect to);
    ImVec2 operator()(maths::vec2 at) const {
        return {place.x + place.w / 2 + (at.x - middle.x) * scale, place.y + place.h / 2 - (at.y - middle.y) * scale};
    }
};

// Draws on the draw list of the present window; clip it to FloorMap::place.
void draw_floor(const Ui&, const Scene&, const FloorMap&);     // all but the vehicles
void draw_vehicles(const Ui&, const Scene&, const FloorMap&);  // at the poses of the starts, without their spread

}  // namespace braitenlab::ui

// Lines and vehicles of other runs, drawn over the 3D view at places on the floor.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "ui/scene_input/state.h"

namespace braitenlab::ui {

// Lengths in metres but for widths, in layout pixels. Dashes lie on the floor, so that they stay where they are when
// the camera moves.
struct DashedLine {
    float width = 2.5f;
    float dash = 0.22f, gap = 0.14f;
    float height = 0;  // above the floor
    bool over_vehicles = false;
};
void draw_dashes(const SceneInputFrame&, const Ui&, const std::vector<maths::vec2>& points, Colour,
                 const DashedLine& = {});

// A solid line. Points more than 2 m apart are not joined, here and in draw_dashes(): the seam of a torus is between.
// Nothing of a path hides a vehicle's body: lines and dots are left out there.
void draw_floor_line(const SceneInputFrame&, const Ui&, const std::vector<maths::vec2>& points, Colour, float width);

// Labels do not cover this line.
void keep_line_free(const SceneInputFrame&, const Ui&, const std::vector<maths::vec2>& points);

// The body of the vehicle that is at this pixel, or nullopt.
std::optional<Rect> body_at(const SceneInputFrame&, maths::vec2 pixel);

// The body of a vehicle at a place, from above a disc; window pixels, width 0 behind the camera. `length`: m.
Rect picture_of_body(const SceneInputFrame&, maths::vec2 place, float length);

// The driven part of a ghost's path as dots at fixed times, so that their distances show the speed; they fade within a
// minute. They are small where vehicles are small on the screen.
void draw_path_dots(const SceneInputFrame&, const Ui&, const GhostView&, Colour);

// The part of a path after the tick `now` as a dot each half second, so that their distances show the speed; where the
// vehicle is slow, as many as have a gap between them. `first`: the tick of the first pose.
struct ComingPath {
    const std::vector<Pose>* path;  // never null
    std::uint64_t first, now;
};
void draw_coming_dots(const SceneInputFrame&, const Ui&, const ComingPath&, Colour);

// A vehicle of another run as a dashed outline, four dots a second along its path, and its name: it has no colour of
// its own and nothing that a click takes. Records the anchor at its position.
struct GhostLook {
    Colour colour, edge;  // of the outline and of the name's frame
    std::string_view words, anchor;
    std::optional<Rect> other{};  // something that has another name
};
void draw_ghost(const SceneInputFrame&, const Ui&, const GhostView&, const GhostLook&);

}  // namespace braitenlab::ui

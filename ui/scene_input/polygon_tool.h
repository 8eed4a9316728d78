// Drawing of an obstacle or a zone: a polygon corner by corner, or a rectangle. A click on the first corner or a double
// click closes the polygon. Does not use Dear ImGui.
#pragma once

#include <string_view>
#include <vector>

#include "core/maths/vec.h"
#include "core/scene/scene.h"
#include "ui/scene_input/state.h"

namespace braitenlab::ui {

// Why corners do not define a valid obstacle.
enum class OutlineFault {
    none,
    too_near,    // a corner is within 0.1 m of another one
    crosses,     // two edges cross
    dents,       // not convex
    too_many,    // more corners than an obstacle can have
    too_few,     // fewer than three corners
    too_narrow,  // less than 0.1 m wide, or all corners on a line
};

// Checks `next` as the next corner. Corners are in metres, clockwise or counter-clockwise.
OutlineFault fault_of_next(const std::vector<maths::vec2>& corners, maths::vec2 next);

// Checks a closed outline.
OutlineFault fault_of(const std::vector<maths::vec2>& corners);

// Checks a closed outline after this corner was moved.
OutlineFault fault_of_moved(const std::vector<maths::vec2>& corners, std::size_t moved);

// String key of the reason; empty for none.
std::string_view refusal_of(OutlineFault);

// The obstacle with these corners; its position is their centroid. Precondition: fault_of() is none.
Obstacle obstacle_from(const std::vector<maths::vec2>& corners);

// The zone or obstacle with this outline, which has heading 0, instead of its own. Its heading does not change.
Zone with_outline(Zone, const Obstacle& outline);
Obstacle with_outline(Obstacle, const Obstacle& outline);

// The box between two opposite corners; each side at least 0.2 m long.
Obstacle box_between(maths::vec2 a, maths::vec2 b);

// A zone of ice between two opposite corners; of 2 by 2 m around them if they are the same point.
Zone zone_between(maths::vec2 a, maths::vec2 b);

// Adds a corner, or shows why it is refused. A corner at the position of the first or the last one closes the polygon.
void set_polygon_corner(SceneInputState&, const LabView&, maths::vec2 at, bool keep_tool, Outbox&);

// A press of the left button at this position on the floor, m.
void click_corner(SceneInputState&, const SceneInputFrame&, maths::vec2 at, Outbox&);

// Removes the last corner of what a tool draws. Without corners, selects the hand.
void take_back_corner(SceneInputState&);

// Adds the obstacle, or gives the outline to the zone SceneInputState::redrawn, or shows why the outline is refused.
// `keep_tool`: the tool stays selected.
void close_outline(SceneInputState&, const LabView&, bool keep_tool, Outbox&);

}  // namespace braitenlab::ui

// The tools that draw on the floor: lamp, box, zone, tape, ruler. A corner is set by a press of the left button or,
// with the keyboard's crosshair, by Enter; so a press and Enter have the same effect. Polygon: polygon_tool.h. Does not
// use Dear ImGui.
#pragma once

#include <optional>
#include <vector>

#include "core/maths/vec.h"
#include "core/scene/scene.h"
#include "ui/scene_input/state.h"

namespace braitenlab::ui {

// The tool draws from one corner to the opposite one, or from one end to the other: box, zone and ruler.
constexpr bool spans(SceneInputTool tool) {
    return tool == SceneInputTool::box || tool == SceneInputTool::zone || tool == SceneInputTool::ruler;
}

// The position of the next corner: that of the crosshair, else of the pointer on the floor, within the arena. Near the
// position of an object the ruler takes that position. nullopt above the horizon.
std::optional<maths::vec2> aim(const SceneInputState&, const LabView&, maths::vec2 pointer);

// Sets the next corner with the tool in use: adds a lamp, begins or completes a box, a zone or a measurement, adds a
// point to a line of tape or a corner to a polygon. A second corner at the same position ends a line or closes a
// polygon. `keep_tool`: the tool stays selected after an object is complete.
void set_corner(SceneInputState&, const LabView&, maths::vec2 at, bool keep_tool, Outbox&);

// Completes a box, a zone or a measurement that begins at SceneInputState::corners[0].
void complete_span(SceneInputState&, const LabView&, maths::vec2 to, bool keep_tool, Outbox&);

// Ends the line of tape: adds its segments as one undo step. With fewer than two points it discards the line.
void end_line(SceneInputState&, const LabView&, bool keep_tool, Outbox&);

// The width of tape in this scene, m: 0.1 m beside a vehicle of the standard width, in proportion beside others.
float tape_width(const Scene&);

// The zones of a line of tape along these points. Segments overlap at the points between them, so that no gap is left.
std::vector<Zone> tape_along(const std::vector<maths::vec2>& points, float width);

// Moves the crosshair by a vector (m) within the arena. Without a crosshair it starts at the last corner or at the
// middle of the view.
void move_crosshair(SceneInputState&, const LabView&, maths::vec2 by);

}  // namespace braitenlab::ui

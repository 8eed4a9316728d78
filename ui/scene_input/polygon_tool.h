// An obstacle drawn corner by corner: clicks set corners, a click on the first one or a double click closes the
// outline.
#pragma once

#include <string_view>

#include "ui/scene_input/interaction.h"
#include "ui/scene_input/outline.h"

namespace braitenlab {

// A press of the left button at this place on the floor, m.
void click_corner(SceneInputState&, const SceneInputFrame&, maths::vec2 at, Outbox&);

// Takes back the corner drawn last; without any, back to the hand.
void take_back_corner(SceneInputState&);

// Makes the outline an obstacle, or says why not. `keep_tool`: another one follows.
void close_outline(SceneInputState&, double wall_seconds, bool keep_tool, Outbox&);

// The string key that says why an outline is refused; empty for none.
std::string_view reason(OutlineFault);

}  // namespace braitenlab

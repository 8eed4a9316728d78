// The scene behind the title page of the first start.
#pragma once

#include <functional>
#include <optional>

#include "app/lab.h"

namespace braitenlab {

// A shipped scene that plays, some seconds after its start, with a camera that orbits slowly; without labels, sensor
// fields and selection. `seen` gets the snapshots of these seconds, for the trails. nullopt if the scene cannot be
// opened.
std::optional<Lab> title_lab(const std::function<void(const Snapshot&)>& seen);

// Lets the scene and its camera move for so many seconds of wall time; does nothing if motion is reduced.
void advance_title(Lab& title, float seconds);

// The part of the window that the scene is fitted into: right of the words, in an upright one below them.
Rect title_area(Rect window);

}  // namespace braitenlab

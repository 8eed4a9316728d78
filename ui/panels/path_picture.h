// A small picture of a run: the floor as in scene_picture.h, and the vehicle's path.
#pragma once

#include "core/lesson/grade.h"
#include "ui/panels/scene_picture.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

// Draws into the rectangle of the map and not beside it. A path that ends at a fall (has_fallen) ends with a cross.
void draw_run(const Ui&, const Exercise&, const StartResult&, const FloorMap&, Colour of_path);

}  // namespace braitenlab::ui

// A small picture of a run: the arena with its edge, its objects and zones of tape, and the vehicle's path.
#pragma once

#include "core/lesson/grade.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

// Draws into the rectangle and not beside it. A path that ends at a fall (has_fallen) ends with a cross.
void draw_run(const Ui&, const Exercise&, const StartResult&, Rect, Colour of_path);

}  // namespace braitenlab::ui

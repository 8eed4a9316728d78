// Marks at the edge of the scene for what acts on a vehicle from outside the picture.
#pragma once

#include "ui/scene_input/state.h"

namespace braitenlab::ui {

// For each source that is on and outside the area free of cards: a disc in the colour of its channel at the edge, with
// a point towards the source. Not for a camera that rides with a vehicle. Anchors: stage.outside.0 …, by source.
void draw_sources_outside(const SceneInputFrame&, const Ui&);

}  // namespace braitenlab::ui

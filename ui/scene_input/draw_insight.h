// What the lab knows about other runs, over the 3D view: the predicted path and the last run.
#pragma once

#include "ui/scene_input/state.h"

namespace braitenlab::ui {

// FeatureViews::prediction: the coming path as a dot each half second with the seconds at its end, a thin line for each
// path with other noise, and a thin solid line for the path without the change. What is driven already is not drawn.
// Anchor: stage.prediction, at the end of the path.
// FeatureViews::last_run: the vehicle of the run before the reset, while no run with a solution is shown and
// the two vehicles are not at one place. Anchor: stage.last_run.
// FeatureViews::slots: the path of A as a solid line, that of B as a dashed line with its vehicle, each with its
// letter. Anchors: stage.slot_a, stage.slot_b.
void draw_insight(const SceneInputFrame&, const Ui&);

}  // namespace braitenlab::ui

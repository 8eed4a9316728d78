// What an exercise shows over the 3D view: the vehicle of the run with the solution, and the predicted path.
#pragma once

#include "ui/scene_input/state.h"

namespace braitenlab::ui {

// The vehicle of FeatureViews::ghost as a dashed outline, four dots a second along its path, and the word "Solution":
// it has no colour of its own and nothing that a click takes. Anchor: stage.ghost.
// The predicted path as a dashed line and, once the outcome is known, the real path as a solid one, each with its name.
// They are hidden while the run with the solution is shown, and once the exercise is passed. Anchor: stage.path, at the
// vehicle whose path can be drawn.
void draw_lesson(const SceneInputState&, const SceneInputFrame&, const Ui&);

}  // namespace braitenlab::ui

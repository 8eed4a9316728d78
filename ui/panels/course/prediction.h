// Parts of the exercise card: the prediction, and the run with the solution beside the student's.
#pragma once

#include <imgui.h>

#include "ui/lab_view.h"
#include "ui/panels/panel_state.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

// The question with its options and the button that begins a drawing, or both once made; then the outcome, whether the
// chosen option came true, and how much a drawn path differs. Only a run of the scene as given shows the outcome.
// Anchors: exercise.predict, exercise.predict.N, exercise.draw, exercise.came_true, exercise.outcome,
// exercise.as_given. Precondition: view.lesson.
void prediction(const LabView&, PanelState&, Ui&);

// True where the first run does not answer the question: a selection or a breeding does.
bool is_about_end(const Exercise&);

// The button that shows the run with the solution, at the right end of the heading that begins at `heading`, and what
// is seen then, at the cursor; where its words are wider than `room` the button is its icon. Nothing while
// can_compare() is false. Anchor: exercise.compare. Precondition: view.lesson.
void comparison(const LabView&, Ui&, ImVec2 heading, float room);

// A check mark in a filled circle when done, an empty circle before: the shape differs, not only the colour. `c` and
// `radius` in window pixels; `arrived`: 0..1, how far the circle has grown.
void check_mark(const Ui&, ImVec2 c, float radius, bool done, float arrived);

}  // namespace braitenlab::ui

// Parts of the sheet of the breeding. Each is drawn into a rectangle of the window. Precondition: BreedingView::base.
#pragma once

#include <string>

#include "ui/lab_view.h"
#include "ui/panels/panel_state.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

// Best scores by generation: against the opponents of the generation, and against the panel. breeding_curves.cpp
void breeding_curves(const BreedingView&, Ui&, Rect);

// A cell for each pair of champions in the colour of the predator's score. A click, or an arrow key with the focus,
// watches a match. Anchors: breeding.matrix, and breeding.cell.PREDATOR.PREY with both generations.
// breeding_matrix.cpp
void breeding_matrix(const BreedingView&, Ui&, Rect);
float breeding_matrix_width(const Ui&, float height);  // with a field as large as this height allows; window pixels

// The watched matches, which are repeated. Anchors: breeding.duel.1, breeding.duel.2. breeding_duels.cpp
void breeding_duels(const LabView&, BreedingSheetState&, Ui&, Rect);

// What the matrix shows, for each side that evolves. breeding_words.cpp
void breeding_words(const BreedingView&, Ui&);

}  // namespace braitenlab::ui

// Parts of the sheet of the breeding. Those with a rectangle are drawn into it. Precondition: BreedingView::base.
#pragma once

#include <string>
#include <string_view>

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

// How far it is, and what the matrix shows, for each side that evolves, as items at the cursor. breeding_words.cpp
void breeding_progress(const BreedingView&, Ui&);
bool breeds_panel(const BreedingView&);                        // opponents to measure with are bred first
std::string breeding_percent(const BreedingView&, const Ui&);  // "43 %, about 40 s left"; empty without a base
void breeding_words(const BreedingView&, Ui&);
// Of the words, whatever they will be: nothing moves while they change. With the space above them, window pixels.
float breeding_words_height(const BreedingView&, const Ui&);

// A paragraph of small second text that takes the room of so many lines. breeding_words.cpp
void paragraph_of_lines(Ui&, std::string_view words, std::size_t lines);

}  // namespace braitenlab::ui

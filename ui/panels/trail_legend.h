// The colours of trails: the choices of the View menu, and the legend in the scene.
#pragma once

#include <string>

#include "ui/lab_view.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

// The choice after the present one: plain, wheels, speed, each recorded sensor of the selected vehicle, plain.
TrailColour next_trail_colour(const LabView&);

// "Faster wheel", "Reading: left light sensor".
std::string trail_colour_words(const LabView&, const Ui&);

// Value and unit, scale and its numbers, in the lower left corner of `area`; nothing while trails are plain or hidden.
// Anchor: trail_legend.
void trail_legend(const LabView&, const Ui&, Rect area);

}  // namespace braitenlab::ui

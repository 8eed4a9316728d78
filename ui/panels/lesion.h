// What L hurts or heals where the little picture of the brain is not under the pointer: by a slider its wire, by an eye
// or a driven wheel of the selected vehicle in the scene that eye or motor.
#pragma once

#include <string>

#include "ui/panels/panel_state.h"
#include "ui/widgets/ui.h"

namespace braitenlab {

// "lesion.SL", "lesion.LR" … of what lies under the pointer outside the picture, or empty. Asks the anchors of the
// sliders and, where no card covers the pointer, the scene.
std::string lesion_under_pointer(const LabView&, const Anchors&, bool over_card);

// Completes state.lesion_under_pointer, and carries out state.lesion_wanted where the picture has not.
void lesions_elsewhere(const LabView&, PanelState&, Ui&);

}  // namespace braitenlab

// What the hand needs to see over the 3D view: rings, handles, previews, and words at the pointer.
#pragma once

#include "ui/stage/interaction.h"

namespace braitenlab {

// On Dear ImGui's background list: over the scene, below every card.
void draw_stage(const StageState&, const StageFrame&, const Ui&);

}  // namespace braitenlab

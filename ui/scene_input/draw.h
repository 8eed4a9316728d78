// What the hand needs to see over the 3D view: rings, handles, previews, and words at the pointer.
#pragma once

#include "ui/scene_input/interaction.h"

namespace braitenlab {

// On Dear ImGui's background list: over the scene, below every card.
void draw_scene_input(const SceneInputState&, const SceneInputFrame&, const Ui&);

}  // namespace braitenlab

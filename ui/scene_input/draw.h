// Drawing over the 3D view: rings, handles, previews, and notes at the pointer.
#pragma once

#include "ui/scene_input/interaction.h"

namespace braitenlab::ui {

// On Dear ImGui's background draw list: over the scene, below the cards.
void draw_scene_input(const SceneInputState&, const SceneInputFrame&, const Ui&);

}  // namespace braitenlab::ui

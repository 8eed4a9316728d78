// The paths of single values of a scene: "kind.prey.brain.LL", "source.lamp.x".
#pragma once

#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace braitenlab {

// All values outside lists; of a brain the dials only.
std::vector<std::string> setting_paths(const Scene&);

}  // namespace braitenlab

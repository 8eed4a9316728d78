// The paths by which single values of a scene can be set: "kind.prey.brain.LL", "source.lamp.x".
#pragma once

#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace braitenlab {

// All values that are not in a list; of brains the dials, whatever else the brain holds.
std::vector<std::string> setting_paths(const Scene&);

}  // namespace braitenlab

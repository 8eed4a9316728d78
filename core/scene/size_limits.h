// What a scene may ask of a computer. A file of a few lines, also a link, can describe a world of any size.
#pragma once

#include <optional>

#include "core/scene/brain_text.h"

namespace braitenlab {

struct Scene;

// The first of these faults, or nullopt:
// - more than 32 vehicles are placed on the floor of one;
// - more than 100 vehicles cover more than the floor;
// - all brains and all latencies of sensors have more than 16 million numbers;
// - in a tick, sensors and wheels may compare more than 40 million stimuli and zones one after the other.
// Precondition: all values are in their ranges, and each start has a kind of the scene.
std::optional<Fault> size_fault(const Scene&);

}  // namespace braitenlab

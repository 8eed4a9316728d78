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
// - work_of_a_tick() is more than most_work.
// Precondition: all values are in their ranges, and each start has a kind of the scene.
std::optional<Fault> size_fault(const Scene&);

// How long a tick may take at most, in comparisons of a sensor with a stimulus, each about 2.5 ns on a core of 2.1 GHz.
// An estimate from the values of the scene: of what its sensors may compare, brains compute and bodies touch, wherever
// the vehicles gather and push obstacles.
double work_of_a_tick(const Scene&);
inline constexpr double most_work = 40e6;  // 0.1 s

}  // namespace braitenlab

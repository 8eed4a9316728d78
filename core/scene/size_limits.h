// What a scene may ask of a computer. A file of a few lines, also a link, can describe a world of any size.
#pragma once

#include <optional>
#include <vector>

#include "core/scene/brain_text.h"

namespace braitenlab {

struct Scene;
struct Sensor;

// Brains and sensors of a running world, which edits may have changed since the scene was opened. Valid as long as what
// it points to.
struct PresentParts {
    struct Own {  // of one vehicle; null: those of its kind
        const BrainGraph* brain = nullptr;
        const std::vector<Sensor>* sensors = nullptr;
    };
    std::vector<const BrainGraph*> of_kinds;  // as Scene::kinds
    std::vector<Own> of_vehicles;             // those that have nothing of their own may be left out
};

// The first of these faults, or nullopt:
// - more than 32 vehicles are placed on the floor of one;
// - more than 100 vehicles cover more than the floor;
// - all brains and all latencies of sensors have more than 16 million numbers;
// - work_of_a_tick() is more than most_work.
// Precondition: all values are in their ranges, and each start has a kind of the scene.
std::optional<Fault> size_fault(const Scene&);
std::optional<Fault> size_fault(const Scene&, const PresentParts&);  // in place of those of the scene

// How long a tick may take at most, in comparisons of a sensor with a stimulus, each about 2.5 ns on a core of 2.1 GHz.
// An estimate from the values of the scene: of what its sensors may compare, brains compute and bodies touch, wherever
// the vehicles gather and push obstacles.
double work_of_a_tick(const Scene&);
double work_of_a_tick(const Scene&, const PresentParts&);
inline constexpr double most_work = 40e6;  // 0.1 s

// That a tick of so many vehicles needs this work, which is more than `most`.
Message too_much_work(long long vehicles, double work, double most);

}  // namespace braitenlab

// The breeding of a scene: its predator and its prey evolve from what they are.
#pragma once

#include "core/evolve/breeding_file.h"
#include "core/scene/scene.h"

namespace braitenlab::evolve {

// What may change in both kinds.
struct MayChange {
    bool weights = true, biases = true, thresholds = false;
    bool eyes = true;  // angles of the sensors for predators and prey, and of other sensors for lights
    friend bool operator==(const MayChange&, const MayChange&) = default;
};

struct SceneBreeding {
    Breeding breeding;
    Scene scene;  // in which vehicles of both roles have brain and sensors of their kinds
};

// A gene for each such value of the first kind with either role; those of further wires and nodes have paths as
// put() in core/scene/toml_tree.h describes. A kind without such values, or whose brain is hidden, does not evolve. The
// result is checked by BreedingBase::create, also whether the scene has one vehicle of each role.
SceneBreeding breeding_of_scene(Scene, const MayChange&, std::string title);

}  // namespace braitenlab::evolve

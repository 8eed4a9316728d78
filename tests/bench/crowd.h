// The crowd of the benchmarks of the world, its parts and its lower limit: N vehicles at constant density, half
// attracted, half repelled, with many contacts.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "core/mechanics/motion.h"
#include "core/sensing/stimulus_grid.h"
#include "core/world/world.h"
#include "tests/core/scenes.h"

namespace braitenlab::bench {

using namespace sensing;
using namespace world;

inline constexpr float eye_range = 6;
inline constexpr FourNeurons hunter{.LR = 1.5f, .RL = 1.5f, .LM = 0.3f, .RM = 0.25f};
inline constexpr FourNeurons hunted{.LL = 1.0f, .RR = 1.0f, .LM = 0.2f, .RM = 0.25f};

inline Scene dense(int n) {
    Scene scene = tests::crowd(n);
    scene.arena.width = scene.arena.height = 2 * std::sqrt(static_cast<float>(n));
    scene.ecology.inactivity = 0;
    scene.ecology.bite = 0;  // no vehicle dies: the same load in every tick
    scene.kinds[0].brain = make_graph(hunter);
    scene.kinds[1].brain = make_graph(hunted);
    for (Kind& kind : scene.kinds)
        for (Sensor& eye : kind.sensors) eye.range = eye_range, eye.fov = maths::radians(60);
    return scene;
}

// Poses, motions and roles of all vehicles.
struct CrowdState {
    std::vector<mechanics::Motion> motion;
    std::vector<char> hunts;
};

// Readings of the eyes of the crowd from two fields. `farthest` sets the size of their cells.
class CrowdEyes {
public:
    CrowdEyes(const Scene& scene, float farthest) {
        for (const Sensor& sensor : scene.kinds[0].sensors) sensors_.emplace_back(sensor);
        for (StimulusGrid& grid : grids_) grid.lay_out(scene.arena, farthest);
    }

    void look(const std::vector<mechanics::Motion>& motion, const std::vector<char>& hunts,
              std::vector<std::array<float, 2>>& sensed) {
        for (int side = 0; side < 2; ++side) {
            stimuli_.clear();
            for (std::size_t row = 0; row < motion.size(); ++row)
                if (hunts[row] == side) stimuli_.push_back({motion[row].position, 1, static_cast<std::int32_t>(row)});
            grids_[static_cast<std::size_t>(side)].fill(stimuli_);
        }
        sensed.resize(motion.size());
        for (std::size_t row = 0; row < motion.size(); ++row)
            for (std::size_t k = 0; k < 2; ++k) {
                const StimulusGrid& others = grids_[hunts[row] ? 0 : 1];
                const SensorPose pose = sensor_pose(sensors_[k], motion[row].position, motion[row].ahead);
                sensed[row][k] = std::min(1.0f, others.total(sensors_[k], pose, static_cast<std::int32_t>(row)));
            }
    }

private:
    std::vector<CompiledSensor> sensors_;
    std::array<StimulusGrid, 2> grids_;
    std::vector<Stimulus> stimuli_;
};

// Motor commands of a four-neuron brain with two eyes.
inline std::array<float, 2> motors(const FourNeurons& b, const std::array<float, 2>& sensed) {
    return {std::clamp(b.LM + b.LL * sensed[0] + b.LR * sensed[1], -1.0f, 1.0f),
            std::clamp(b.RM + b.RL * sensed[0] + b.RR * sensed[1], -1.0f, 1.0f)};
}

}  // namespace braitenlab::bench

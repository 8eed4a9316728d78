// Helpers that start a world in a given state and run it.
#pragma once

#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "core/scene/scene_file.h"
#include "core/world/state.h"
#include "core/world/world.h"

namespace braitenlab::tests {

// The shipped scene of this name.
inline Scene shipped_scene(const std::string& name) {
    auto scene = load_scene(std::filesystem::path(BRAITENLAB_SOURCE) / "exercises/scenes" / (name + ".toml"));
    EXPECT_TRUE(scene) << scene.error().text();
    return scene ? *scene : Scene{};
}

inline World make(const Scene& scene, std::uint64_t seed = 1) {
    auto world = World::create(scene, seed);
    EXPECT_TRUE(world) << world.error().text();
    return std::move(*world);
}

inline Snapshot look(const World& world) {
    Snapshot now;
    world.capture(now);
    return now;
}

inline Snapshot after(World& world, double seconds) {
    const auto until = world.tick() + static_cast<std::uint64_t>(std::llround(seconds * 60));
    while (world.tick() < until) world.step();
    return look(world);
}

// Runs a scene for a number of seconds and calls see(snapshot) before each tick.
template <class See>
void watch_run(const Scene& scene, std::uint64_t seed, int seconds, See see) {
    World world = make(scene, seed);
    Snapshot now;
    for (int tick = 0; tick < seconds * 60; ++tick, world.step()) {
        world.capture(now);
        see(now);
    }
}

inline maths::vec2 position(const VehicleView& vehicle) { return {vehicle.x, vehicle.y}; }

// A world with an edited start state, for values that commands cannot set, such as velocity and energy.
template <class Edit>
World begin_with(const Scene& scene, Edit edit, std::uint64_t seed = 1) {
    Checkpoint checkpoint = make(scene, seed).checkpoint();
    auto state = std::make_shared<world::State>(*checkpoint.keyframe);
    edit(*state);
    checkpoint.keyframe = std::move(state);
    return World::restore(checkpoint);
}

}  // namespace braitenlab::tests

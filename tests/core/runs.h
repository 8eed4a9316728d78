// Helpers that start a world in a given state and run it.
#pragma once

#include <cmath>
#include <memory>
#include <utility>

#include <gtest/gtest.h>

#include "core/world/state.h"
#include "core/world/world.h"

namespace braitenlab::tests {

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

// A world with an edited start state, for values that commands cannot set, such as velocity and energy.
template <class Edit>
World begin_with(const Scene& scene, Edit edit) {
    Checkpoint checkpoint = make(scene).checkpoint();
    auto state = std::make_shared<world::State>(*checkpoint.keyframe);
    edit(*state);
    checkpoint.keyframe = std::move(state);
    return World::restore(checkpoint);
}

}  // namespace braitenlab::tests

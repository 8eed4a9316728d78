// One tick of a running world, for World::step and for benchmarks of its parts. Inside core/world and benchmarks only.
#pragma once

#include <memory>
#include <utility>

#include "core/world/world_data.h"

namespace braitenlab::world {

enum class TickPart { sense, think, drive, physics, other };

// Computes one tick. Calls done(TickPart) after each part.
template <class Done>
void tick(WorldData& s, Done done) {
    sense(s);
    done(TickPart::sense);
    think(s);
    done(TickPart::think);
    drive(s);
    done(TickPart::drive);
    s.physics.step(s.touching, s.begun);
    for (std::size_t row = 0; row < s.vehicles.size(); ++row) read_motion(s, row);
    for (std::size_t i = 0; i < s.obstacles.size(); ++i) s.obstacles[i] = s.physics.obstacle(i);
    done(TickPart::physics);
    keep_inside(s);
    s.environment.outlines.move(*s.scene, s.obstacles);
    remember(s);
    touch_and_live(s);
    ++s.tick;
    done(TickPart::other);
}

// Rebuilds the world from a copy of its own state, as a world restored from that copy is built. Returns the copy.
inline std::shared_ptr<const State> begin_keyframe(WorldData& s) {
    const bool stale = s.readings_are_stale;
    auto keyframe = std::make_shared<const State>(s);
    s.rebuild();
    s.readings_are_stale = stale;
    return keyframe;
}

}  // namespace braitenlab::world

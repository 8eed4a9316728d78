// One tick of a running world, for World::step and for whoever measures its parts. Inside core/world and benchmarks
// only.
#pragma once

#include <memory>
#include <utility>

#include "core/world/state.h"

namespace braitenlab {

enum class TickPart { sense, think, drive, physics, other };

// The whole tick. Calls done(TickPart) after each part of it.
template <class Done>
void tick(WorldState& s, Done done) {
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
    s.outlines.move(*s.scene, s.obstacles);
    remember(s);
    touch_and_live(s);
    ++s.tick;
    done(TickPart::other);
}

// Goes on from a copy of its own moment, as a world restored from that copy will. Gives the copy.
inline std::shared_ptr<const Moment> begin_keyframe(WorldState& s) {
    const bool stale = s.eyes_are_stale;
    auto keyframe = std::make_shared<const Moment>(s);
    s = WorldState(Moment(*keyframe));
    s.eyes_are_stale = stale;
    return keyframe;
}

}  // namespace braitenlab

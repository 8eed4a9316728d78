// Semi-implicit Euler integration: updates the velocity first, then the position with the new velocity. Unlike explicit
// Euler, it does not add energy to oscillations; rigid-body engines use it.
#pragma once

namespace braitenlab::mechanics {

// Advances place (m) and speed (m/s), numbers or vectors, by dt seconds under an acceleration (m/s^2).
template <class Vector>
constexpr void integrate(Vector& place, Vector& speed, Vector acceleration, float dt) {
    speed += acceleration * dt;
    place += speed * dt;
}

}  // namespace braitenlab::mechanics

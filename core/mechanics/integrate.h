// One step of motion: semi-implicit Euler, which steps the speed first and the place with the new speed. Unlike
// explicit Euler it does not pump energy into what swings; rigid-body engines use it.
#pragma once

namespace braitenlab::mechanics {

// Moves place (m, or any vector of them) and speed (m/s) on by dt seconds under an acceleration (m/s^2).
template <class Vector>
constexpr void integrate(Vector& place, Vector& speed, Vector acceleration, float dt) {
    speed += acceleration * dt;
    place += speed * dt;
}

}  // namespace braitenlab::mechanics

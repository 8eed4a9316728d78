#include "core/maths/angle.h"
#include "core/mechanics/wheel.h"

// A robot with a track of 0.2 m is to drive at 0.3 m/s on a circle of 1 m: which wheel speeds, and do they give it
// back?
int main() {
    using namespace braitenlab;
    const mechanics::Drive wanted{0.3f, 0.3f};
    const auto wheels = mechanics::wheels_of_drive(wanted, 0.2f);
    const auto back = mechanics::drive_of_wheels(wheels.left, wheels.right, 0.2f);
    const bool same = maths::almost_equal(back.forward, wanted.forward, 1e-6f) &&
                      maths::almost_equal(back.turning, wanted.turning, 1e-6f);
    return same && wheels.right > wheels.left ? 0 : 1;
}

// Random sensors, places and poses for tests that compare with brute force.
#pragma once

#include "core/maths/portable.h"
#include "core/maths/random.h"
#include "core/mechanics/motion.h"
#include "core/scene/scene.h"
#include "core/world/snapshot.h"

namespace braitenlab::tests {

class Chance {
public:
    explicit Chance(std::uint64_t seed) : random_(seed, 77) {}

    float number(float low, float high) { return random_.uniform(low, high); }
    int below(int count) { return static_cast<int>(random_.next() % static_cast<unsigned>(count)); }
    maths::vec2 place(float most) { return {number(-most, most), number(-most, most)}; }
    Pose pose() { return {number(-3, 3), number(-3, 3), number(-7, 7)}; }
    mechanics::Motion motion() {
        const Pose at = pose();
        return mechanics::at_rest({at.x, at.y}, at.heading);
    }

    // Of any shape and response. Triangles open by less than 180 degrees.
    Sensor sensor() {
        Sensor s;
        s.shape = static_cast<SensorShape>(below(3));
        s.response = static_cast<SensorResponse>(below(2));
        s.x = number(-1, 1), s.y = number(-1, 1);
        s.angle = number(-3, 3);
        s.fov = number(0.05f, s.shape == SensorShape::triangle ? 3.1f : 2 * maths::pi);
        s.range = number(1, 10);
        s.half_distance = number(0.5f, 6);
        return s;
    }

private:
    maths::Random random_;
};

}  // namespace braitenlab::tests

#include "render/view/between.h"

#include <cmath>

#include "core/maths/angle.h"

namespace braitenlab::render {

namespace {

constexpr float farthest = 1;  // m in a tick: 60 m/s

float mix(float a, float b, float t) { return a + (b - a) * t; }

float mix_angle(float a, float b, float t) { return maths::wrap_angle(a + maths::wrap_angle(b - a) * t); }

}  // namespace

void stand_between(Snapshot& now, const std::vector<VehicleView>& before, float t) {
    auto old = before.begin();
    for (VehicleView& v : now.vehicles) {
        while (old != before.end() && old->id < v.id) ++old;
        if (old == before.end()) return;
        if (old->id != v.id || std::hypot(v.x - old->x, v.y - old->y) > farthest) continue;
        v.x = mix(old->x, v.x, t);
        v.y = mix(old->y, v.y, t);
        v.heading = mix_angle(old->heading, v.heading, t);
        for (std::size_t side = 0; side < 2; ++side)
            v.wheel_angle[side] = mix_angle(old->wheel_angle[side], v.wheel_angle[side], t);
    }
}

}  // namespace braitenlab::render

#include "core/world/bumper.h"

#include <utility>

#include "core/maths/angle.h"

namespace braitenlab {

using maths::vec2;

namespace {

// Bodies that touched when a step began have moved apart a little by its end.
constexpr float touching_distance = 0.05f;  // m

// Cuts the stretch from..to of a segment (shares of its length) down to where it lies between −half and half.
void clip_to_slab(float start, float way, float half, float& from, float& to) {
    if (way == 0) {
        if (start < -half || start > half) to = -1;
        return;
    }
    float enter = (-half - start) / way, leave = (half - start) / way;
    if (enter > leave) std::swap(enter, leave);
    from = std::max(from, enter);
    to = std::min(to, leave);
}

// In the vehicle's frame.
bool reaches_box(const Segment& s, vec2 half) {
    float from = 0, to = 1;
    clip_to_slab(s.a.x, s.b.x - s.a.x, half.x, from, to);
    clip_to_slab(s.a.y, s.b.y - s.a.y, half.y, from, to);
    return from <= to;
}

}  // namespace

bool feels(const Eye& bumper, const Body& body, const Motion& motion, const Outline& outline) {
    const Gaze gaze = carry(bumper, motion.place, motion.ahead);
    const vec2 half = vec2{body.length, body.width} / 2 + vec2{touching_distance, touching_distance};
    const vec2 back{motion.ahead.x, -motion.ahead.y};
    for (std::size_t i = 0; i < side_count(outline); ++i) {
        const Clipped clipped = clip_to_field(bumper, gaze, side(outline, i));
        for (int k = 0; k < clipped.count; ++k) {
            const Segment& part = clipped.part[static_cast<std::size_t>(k)];
            if (reaches_box({maths::rotate(part.a - motion.place, back), maths::rotate(part.b - motion.place, back)},
                            half))
                return true;
        }
    }
    return false;
}

}  // namespace braitenlab

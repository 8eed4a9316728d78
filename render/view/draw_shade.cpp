// Bodies and eyes in the shadow of obstacles.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "render/view/drawing.h"

namespace braitenlab::render {

using maths::vec2;
using maths::vec4;

namespace {

constexpr float levels = 7;  // of darkness per lamp; see HullInstance

float smooth_step(float from, float to, float x) {
    const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

// Part of the lamp's light that the box takes from a place, 0..1: as shaders/cast.frag on the floor, but `height` m
// above it. A box takes nothing from what is in it.
float taken_at(vec2 place, float height, const CastInstance& cast) {
    const vec2 half{cast.shape.x, cast.shape.y};
    const float below = std::min((cast.shape.z - height) / (cast.lamp.z - height), 0.85f);
    const vec2 ray = vec2{cast.lamp.x, cast.lamp.y} - place;
    const float whole = maths::length(ray);
    if (below <= 0 || whole < 1e-4f) return 0;
    const vec2 back{cast.place.z, -cast.place.w};  // turns into the frame of the box
    const vec2 ahead = maths::rotate(ray / whole, back);
    const vec2 middle = maths::rotate(vec2{cast.place.x, cast.place.y} - place, back);
    if (std::fabs(middle.x) <= half.x && std::fabs(middle.y) <= half.y) return 0;
    // Across the ray, and the lengths of the ray at which it enters and leaves the box.
    const float across = std::fabs(middle.x * ahead.y - middle.y * ahead.x);
    const float half_across = std::fabs(ahead.y) * half.x + std::fabs(ahead.x) * half.y;
    const auto slab = [](float centre, float direction, float half_width) {
        const float slope = 1 / (std::fabs(direction) + 1e-3f), along = direction < 0 ? -centre : centre;
        return vec2{(along - half_width) * slope, (along + half_width) * slope};
    };
    const vec2 x = slab(middle.x, ahead.x, half.x), y = slab(middle.y, ahead.y, half.y);
    const float enters = std::max(x.x, y.x), leaves = std::min(x.y, y.y);
    const float before = std::clamp(enters, 0.0f, whole), soft = 0.04f + 0.16f * before,
                end_soft = 0.08f + 0.25f * before;
    const float side = 1 - smooth_step(-soft, soft, across - half_across);
    const float end = 1 - smooth_step(-end_soft, end_soft, enters - whole * below);
    return side * end * smooth_step(-0.06f, 0.06f, leaves);
}

// The darkness of all lamps at a place: three bits a lamp.
float darkness_at(vec2 place, float height, std::span<const CastInstance> casts) {
    std::array<float, most_lamps> passes;
    passes.fill(1);
    for (const CastInstance& cast : casts)
        passes[static_cast<std::size_t>(cast.shape.w)] *= 1 - taken_at(place, height, cast);
    float packed = 0;
    for (std::size_t i = most_lamps; i-- > 0;) packed = packed * (levels + 1) + std::round(levels * (1 - passes[i]));
    return packed;
}

}  // namespace

void add_darkness(Drawing& drawing) {
    DrawList& list = drawing.list;
    const std::span<const CastInstance> casts(list.casts.data(), drawing.obstacle_casts);
    if (casts.empty()) return;
    for (auto& of_role : list.bodies)
        for (HullInstance& body : of_role)
            body.look.z = darkness_at({body.place.x, body.place.y}, deck_height / 2 * body.size.z, casts);
    for (EyeballInstance& ball : list.eyeballs)
        ball.size.w = darkness_at({ball.place.x, ball.place.y}, ball.size.y, casts);
}

}  // namespace braitenlab::render

// What a camera sees, once it stands: from places to pixels and back, and from one sight to the next.
#include <cmath>

#include "render/view/camera.h"

namespace braitenlab {

using maths::vec2;
using maths::vec3;
using maths::vec4;

namespace {

vec3 row(const maths::mat4& m, int i) { return {m[0][i], m[1][i], m[2][i]}; }

vec4 clip_place(const Sight& sight, vec2 place, float height) {
    const vec3 p = to_gl(place, height);
    return sight.projection * (sight.view * vec4{p.x, p.y, p.z, 1});
}

}  // namespace

Sight glide(const Sight& from, const Sight& to, float seconds) {
    constexpr float time_constant = 0.06f;  // s; 96 % of the way after 0.2 s
    const float t = 1 - std::exp(-std::max(seconds, 0.0f) / time_constant);
    const vec3 back = row(from.view, 2) * (1 - t) + row(to.view, 2) * t;
    const vec3 up = row(from.view, 1) * (1 - t) + row(to.view, 1) * t;
    const float turned = maths::dot(row(from.view, 2), row(to.view, 2));
    const bool arrived = maths::distance(from.eye, to.eye) < 1e-3f && turned > 1 - 1e-6f &&
                         maths::length(from.projection[2] - to.projection[2]) < 1e-4f &&
                         maths::length(from.projection[0] - to.projection[0]) < 1e-4f &&
                         maths::length(from.projection[3] - to.projection[3]) < 1e-4f;
    // Between opposite directions there is no shortest way, and a window that changed its size shows a new picture
    // anyway.
    if (arrived || turned < -0.9f || !(from.window == to.window)) return to;

    Sight sight = to;
    sight.eye = from.eye * (1 - t) + to.eye * t;
    sight.view = maths::look_at(sight.eye, sight.eye - back, up);
    for (int i = 0; i < 4; ++i) sight.projection[i] = from.projection[i] * (1 - t) + to.projection[i] * t;
    return sight;
}

std::optional<vec2> project(const Sight& sight, vec2 place, float height) {
    const vec4 clip = clip_place(sight, place, height);
    if (clip.w < 1e-4f) return std::nullopt;
    return vec2{sight.window.x + (clip.x / clip.w + 1) / 2 * sight.window.w,
                sight.window.y + (1 - clip.y / clip.w) / 2 * sight.window.h};
}

float pixels_per_metre(const Sight& sight, vec2 place, float height) {
    const float depth = clip_place(sight, place, height).w;
    return depth < 1e-4f ? 0 : sight.projection[1].y * sight.window.h / (2 * depth);
}

std::optional<vec2> unproject(const Sight& sight, vec2 pixel, float height) {
    const float x = 2 * (pixel.x - sight.window.x) / sight.window.w - 1;
    const float y = 1 - 2 * (pixel.y - sight.window.y) / sight.window.h;
    // At depth d before the eye, w is spread·d + level (1·d with perspective, 1 without, both amid a glide), so what
    // the pixel shows there lies on a line in d.
    const auto& p = sight.projection;
    const float spread = -p[2].w, level = p[3].w;
    const vec3 right = row(sight.view, 0), up = row(sight.view, 1), back = row(sight.view, 2);
    const vec3 start = sight.eye + right * ((x * level - p[3].x) / p[0].x) + up * ((y * level - p[3].y) / p[1].y);
    const vec3 ray = right * ((x * spread + p[2].x) / p[0].x) + up * ((y * spread + p[2].y) / p[1].y) - back;
    if (ray.y > -1e-5f) return std::nullopt;
    const float reach = (height - start.y) / ray.y;
    return vec2{start.x + reach * ray.x, -(start.z + reach * ray.z)};
}

}  // namespace braitenlab

#include "render/view/fine_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/maths/angle.h"

namespace braitenlab::render {

using maths::vec2;
using maths::vec3;

namespace {

constexpr float standard_width = 0.7f;  // m; a hull's mesh has width 1

// A point of an outline with its unit normal.
struct Turning {
    vec2 at, out;
};

struct Rounded {
    vec2 corner;
    float radius;
};

// A convex polygon, counter-clockwise, with an arc of this radius in place of each corner.
std::vector<Turning> rounded(const std::vector<Rounded>& corners) {
    std::vector<Turning> outline;
    const std::size_t count = corners.size();
    for (std::size_t i = 0; i < count; ++i) {
        const vec2 here = corners[i].corner;
        const vec2 before = maths::normalise(here - corners[(i + count - 1) % count].corner),
                   after = maths::normalise(corners[(i + 1) % count].corner - here);
        const vec2 out_before{before.y, -before.x}, out_after{after.y, -after.x};
        const vec2 both = out_before + out_after;
        const vec2 middle = here - both * (corners[i].radius / std::max(0.05f, 1 + maths::dot(out_before, out_after)));
        const int pieces = corners[i].radius > 0.15f ? 7 : corners[i].radius > 0.06f ? 4 : 2;
        for (int k = 0; k <= pieces; ++k) {
            const float t = static_cast<float>(k) / static_cast<float>(pieces);
            const vec2 out = maths::normalise(out_before * (1 - t) + out_after * t);
            outline.push_back({middle + out * corners[i].radius, out});
        }
    }
    return outline;
}

std::uint16_t add_corner(Shape& shape, vec3 place, vec3 normal, Paint paint) {
    shape.corners.push_back({place, maths::normalise(normal), static_cast<float>(paint)});
    return static_cast<std::uint16_t>(shape.corners.size() - 1);
}

// Triangles between two rings of `count` corners each; counter-clockwise if the second is above the first and both run
// counter-clockwise.
void join_rings(Shape& shape, std::size_t lower, std::size_t upper, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t j = (i + 1) % count;
        for (const std::size_t k : {lower + i, lower + j, upper + j, lower + i, upper + j, upper + i})
            shape.indices.push_back(static_cast<std::uint16_t>(k));
    }
}

// A ring of a plate's profile: the outline moved inwards by `inset`, at the height z; the normal's tilt upwards, rad.
struct Ring {
    float inset, z, tilt;
};

std::size_t add_ring(Shape& shape, const std::vector<Turning>& outline, Ring ring, Paint paint) {
    const std::size_t first = shape.corners.size();
    for (const Turning& t : outline) {
        const vec2 at = t.at - t.out * ring.inset, out = t.out * maths::cosine(ring.tilt);
        add_corner(shape, {at.x, at.y, ring.z}, {out.x, out.y, maths::sine(ring.tilt)}, paint);
    }
    return first;
}

// The top of a plate: a fan around its middle.
void add_cap(Shape& shape, const std::vector<Turning>& outline, float inset, float z, Paint paint) {
    const std::size_t first = add_ring(shape, outline, {inset, z, maths::pi / 2}, paint);
    vec2 middle{};
    for (const Turning& t : outline) middle += (t.at - t.out * inset) / static_cast<float>(outline.size());
    const std::uint16_t centre = add_corner(shape, {middle.x, middle.y, z}, {0, 0, 1}, paint);
    for (std::size_t i = 0; i < outline.size(); ++i)
        for (const std::size_t k : {std::size_t{centre}, first + i, first + (i + 1) % outline.size()})
            shape.indices.push_back(static_cast<std::uint16_t>(k));
}

// A plate from z0 to z1 with rounded upper and lower edges.
void add_rounded_plate(Shape& shape, const std::vector<Turning>& outline, float z0, float z1, float below, float above,
                       int steps, Paint paint) {
    std::vector<Ring> rings;
    if (below > 0)
        for (const float tilt : {-1.2f, -0.6f})
            rings.push_back({below * (1 - maths::cosine(tilt)), z0 + below * (1 + maths::sine(tilt)), tilt});
    rings.push_back({0, z0 + below, 0});
    for (int i = 0; i <= steps; ++i) {
        const float tilt = maths::pi / 2 * static_cast<float>(i) / static_cast<float>(steps);
        rings.push_back({above * (1 - maths::cosine(tilt)), z1 - above * (1 - maths::sine(tilt)), tilt});
    }
    std::size_t lower = add_ring(shape, outline, rings[0], paint);
    for (std::size_t i = 1; i < rings.size(); ++i) {
        const std::size_t upper = add_ring(shape, outline, rings[i], paint);
        join_rings(shape, lower, upper, outline.size());
        lower = upper;
    }
    add_cap(shape, outline, above, z1, paint);
}

std::vector<Turning> rounded_box(float x0, float x1, float y0, float y1, float radius) {
    return rounded({{{x0, y0}, radius}, {{x1, y0}, radius}, {{x1, y1}, radius}, {{x0, y1}, radius}});
}

std::vector<Turning> body_outline(Role role) {
    constexpr float half = 0.26f, tail = -0.49f, nose = 0.49f;
    if (role == Role::predator)
        return rounded({{{tail, -half}, 0.13f},
                        {{0.10f, -half}, 0.22f},
                        {{0.50f, -0.085f}, 0.081f},
                        {{0.50f, 0.085f}, 0.081f},
                        {{0.10f, half}, 0.22f},
                        {{tail, half}, 0.13f}});
    if (role == Role::prey)
        return rounded(
            {{{tail, -0.235f}, 0.2f}, {{nose, -0.275f}, 0.26f}, {{nose, 0.275f}, 0.26f}, {{tail, 0.235f}, 0.2f}});
    return rounded_box(tail, nose, -half, half, 0.14f);
}

// Metres across to shares of the width. Normals are divided again by the size in the shader.
void narrow(Shape& shape) {
    for (Corner& c : shape.corners) {
        c.place.y /= standard_width;
        c.normal = maths::normalise(vec3{c.normal.x, c.normal.y * standard_width, c.normal.z});
    }
}

void add_flat(Shape& shape, std::array<vec3, 4> corners, Paint paint) {
    const vec3 normal = maths::cross(corners[2] - corners[0], corners[3] - corners[1]);
    const auto first = static_cast<std::uint16_t>(shape.corners.size());
    for (const vec3& p : corners) add_corner(shape, p, normal, paint);
    for (const int i : {0, 1, 2, 0, 2, 3}) shape.indices.push_back(static_cast<std::uint16_t>(first + i));
}

// A point of a wheel: `turn` from the top forwards.
vec3 on_wheel(float turn, float radius, float y) {
    const vec2 p = maths::direction(turn) * radius;
    return {p.y, y, p.x};
}

// Around the axis between two circles; the normals at both lean to +y by `tilt` rad.
void add_band(Shape& shape, int facets, float r0, float y0, float tilt0, float r1, float y1, float tilt1, Paint paint) {
    const std::size_t first = shape.corners.size();
    for (const auto& [r, y, tilt] : {Ring{r0, y0, tilt0}, Ring{r1, y1, tilt1}})
        for (int i = 0; i < facets; ++i) {
            const float turn = 2 * maths::pi * static_cast<float>(i) / static_cast<float>(facets);
            const vec3 out = on_wheel(turn, maths::cosine(tilt), maths::sine(tilt));
            add_corner(shape, on_wheel(turn, r, y), out, paint);
        }
    join_rings(shape, first, first + static_cast<std::size_t>(facets), static_cast<std::size_t>(facets));
}

void add_tread_block(Shape& shape, int i) {
    constexpr float half = 0.085f, foot = 0.90f, top = 1.0f;  // rad, radius
    const float middle = 2 * maths::pi * static_cast<float>(i) / tread_blocks;
    const float a = middle - half, b = middle + half;
    // Alternately to the left and to the right.
    const float y0 = i % 2 == 0 ? -0.50f : -0.16f, y1 = i % 2 == 0 ? 0.16f : 0.50f;
    add_flat(shape, {on_wheel(a, top, y0), on_wheel(b, top, y0), on_wheel(b, top, y1), on_wheel(a, top, y1)},
             Paint::deck);
    add_flat(shape, {on_wheel(a, foot, y0), on_wheel(a, top, y0), on_wheel(a, top, y1), on_wheel(a, foot, y1)},
             Paint::dark);
    add_flat(shape, {on_wheel(b, foot, y1), on_wheel(b, top, y1), on_wheel(b, top, y0), on_wheel(b, foot, y0)},
             Paint::dark);
    add_flat(shape, {on_wheel(a, foot, y1), on_wheel(a, top, y1), on_wheel(b, top, y1), on_wheel(b, foot, y1)},
             Paint::dark);
}

// A disc around a point of the hub's face.
void add_hole(Shape& shape, int i, int holes) {
    constexpr int sides = 6;
    const vec3 middle = on_wheel(2 * maths::pi * static_cast<float>(i) / static_cast<float>(holes), 0.36f, 0.462f);
    const std::uint16_t centre = add_corner(shape, middle, {0, 1, 0}, Paint::dark);
    for (int k = 0; k < sides; ++k)
        add_corner(shape, middle + on_wheel(2 * maths::pi * static_cast<float>(k) / sides, 0.085f, 0), {0, 1, 0},
                   Paint::dark);
    for (int k = 0; k < sides; ++k)
        for (const int corner : {0, 1 + k, 1 + (k + 1) % sides})
            shape.indices.push_back(static_cast<std::uint16_t>(centre + corner));
}

// A surface of revolution about the z axis through these rings (radius as `inset`), from below to above, with smooth
// normals; closed at the top.
void add_turned(Shape& shape, vec2 middle, const std::vector<Ring>& profile, int sides, Paint paint) {
    std::size_t lower = 0;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const std::size_t first = shape.corners.size();
        for (int k = 0; k < sides; ++k) {
            const vec2 out = maths::direction(2 * maths::pi * static_cast<float>(k) / static_cast<float>(sides));
            const vec2 at = middle + out * profile[i].inset, flat = out * maths::cosine(profile[i].tilt);
            add_corner(shape, {at.x, at.y, profile[i].z}, {flat.x, flat.y, maths::sine(profile[i].tilt)}, paint);
        }
        if (i > 0) join_rings(shape, lower, first, static_cast<std::size_t>(sides));
        lower = first;
    }
}

// An ellipsoid of revolution.
void add_round(Shape& shape, vec3 middle, float radius, float height, int sides, int stacks, Paint paint) {
    std::vector<Ring> profile;
    for (int i = 0; i <= stacks; ++i) {
        const float latitude = maths::pi * (static_cast<float>(i) / static_cast<float>(stacks) - 0.5f);
        const float flat = std::max(maths::cosine(latitude), 0.002f);
        profile.push_back({radius * flat, middle.z + height * maths::sine(latitude),
                           std::atan2(maths::sine(latitude) * radius, flat * height)});
    }
    add_turned(shape, {middle.x, middle.y}, profile, sides, paint);
}

void add_bulb(Shape& shape) {
    add_turned(shape, {}, {{0.22f, 0, 0}, {0.22f, 0.03f, 0.3f}, {0.20f, 0.05f, 1.0f}, {0.09f, 0.055f, 1.57f}}, 30,
               Paint::dark);
    for (const float z : {0.055f, 0.105f, 0.155f})
        add_turned(shape, {}, {{0.095f, z, -0.7f}, {0.112f, z + 0.025f, 0}, {0.095f, z + 0.05f, 0.7f}}, 16,
                   Paint::deck);
    add_round(shape, {0, 0, 0.41f}, 0.21f, 0.21f, 28, 11, Paint::light);
}

void add_flame(Shape& shape) {
    add_turned(shape, {},
               {{0.12f, 0, 0},
                {0.16f, 0.03f, -0.9f},
                {0.24f, 0.12f, -0.7f},
                {0.28f, 0.22f, -0.1f},
                {0.25f, 0.23f, 1.2f},
                {0.20f, 0.19f, 1.5f},
                {0.01f, 0.18f, 1.57f}},
               24, Paint::dark);
    add_turned(shape, {},
               {{0.13f, 0.18f, -0.4f},
                {0.18f, 0.27f, 0},
                {0.16f, 0.38f, 0.4f},
                {0.09f, 0.52f, 0.5f},
                {0.04f, 0.62f, 0.4f},
                {0.002f, 0.72f, 0.6f}},
               18, Paint::light);
    for (const vec2 beside : {vec2{0.12f, 0.05f}, vec2{-0.09f, 0.10f}, vec2{-0.02f, -0.13f}})
        add_turned(shape, beside,
                   {{0.05f, 0.17f, -0.3f}, {0.07f, 0.24f, 0.1f}, {0.04f, 0.34f, 0.5f}, {0.002f, 0.42f, 0.6f}}, 10,
                   Paint::light);
}

void add_blossom(Shape& shape) {
    add_turned(shape, {}, {{0.10f, 0, 0.6f}, {0.05f, 0.03f, 0.8f}, {0.03f, 0.08f, 0}, {0.03f, 0.32f, 0}}, 10,
               Paint::dark);
    for (int i = 0; i < 6; ++i) {
        const vec2 petal = maths::direction(2 * maths::pi * static_cast<float>(i) / 6) * 0.17f;
        add_round(shape, {petal.x, petal.y, 0.35f}, 0.115f, 0.055f, 10, 5, Paint::light);
    }
    add_round(shape, {0, 0, 0.38f}, 0.095f, 0.07f, 14, 8, Paint::mark);
}

}  // namespace

Shape fine_hull_shape(Role role) {
    Shape shape;
    const std::vector<Turning> outline = body_outline(role);
    add_rounded_plate(shape, outline, 0.07f, 0.262f, 0.05f, 0.08f, 4, Paint::body);
    const float front = role == Role::predator ? 0.20f : 0.24f;
    add_rounded_plate(shape, rounded_box(-0.30f, front, -0.165f, 0.165f, 0.05f), 0.25f, 0.272f, 0, 0.012f, 1,
                      Paint::inlay);
    add_rounded_plate(shape, rounded_box(-0.45f, -0.365f, -0.21f, 0.21f, 0.03f), 0.24f, 0.268f, 0, 0.010f, 1,
                      Paint::inlay);
    add_rounded_plate(shape, rounded_box(-0.428f, -0.387f, -0.185f, 0.185f, 0.018f), 0.25f, 0.276f, 0, 0.008f, 1,
                      Paint::gauge);
    for (const float side : {-0.156f, 0.156f})
        add_rounded_plate(shape, rounded_box(-0.21f, -0.11f, side - 0.036f, side + 0.036f, 0.02f), 0.265f, 0.315f, 0,
                          0.018f, 2, Paint::light);
    narrow(shape);
    return shape;
}

Shape tyre_shape() {
    constexpr int facets = 24, holes = 5;
    Shape shape;
    add_band(shape, facets, 0.02f, -0.44f, -1.57f, 0.78f, -0.5f, -1.4f, Paint::dark);  // the side at the body
    add_band(shape, facets, 0.78f, -0.5f, -0.9f, 0.92f, -0.40f, -0.3f, Paint::dark);
    add_band(shape, facets, 0.92f, -0.40f, -0.2f, 0.92f, 0.40f, 0.2f, Paint::dark);
    add_band(shape, facets, 0.92f, 0.40f, 0.3f, 0.78f, 0.5f, 1.2f, Paint::dark);
    add_band(shape, facets, 0.78f, 0.5f, 1.4f, 0.58f, 0.47f, 1.57f, Paint::dark);
    add_band(shape, facets, 0.58f, 0.47f, 1.3f, 0.52f, 0.45f, 1.57f, Paint::mark);
    add_band(shape, facets, 0.52f, 0.45f, 1.57f, 0.17f, 0.45f, 1.57f, Paint::mark);
    add_band(shape, facets / 2, 0.17f, 0.45f, 0.5f, 0.10f, 0.60f, 1.3f, Paint::body);
    add_band(shape, facets / 2, 0.10f, 0.60f, 1.3f, 0.001f, 0.61f, 1.57f, Paint::body);
    for (int i = 0; i < tread_blocks; ++i) add_tread_block(shape, i);
    for (int i = 0; i < holes; ++i) add_hole(shape, i, holes);
    return shape;
}

Shape eyeball_shape() {
    constexpr int slices = 18, stacks = 12;
    Shape shape;
    for (int s = 0; s <= stacks; ++s) {
        const float latitude = maths::pi * (static_cast<float>(s) / stacks - 0.5f);
        for (int i = 0; i < slices; ++i) {
            const vec2 round =
                maths::direction(2 * maths::pi * static_cast<float>(i) / slices) * maths::cosine(latitude);
            const vec3 unit{maths::sine(latitude), round.x, round.y};
            add_corner(shape, unit, unit, Paint::light);
        }
    }
    for (int s = 0; s < stacks; ++s)
        join_rings(shape, static_cast<std::size_t>(s * slices), static_cast<std::size_t>((s + 1) * slices), slices);
    const std::vector<Turning> collar = rounded_box(-0.46f, 0.46f, -0.46f, 0.46f, 0.45f);
    const std::size_t foot = add_ring(shape, collar, {0, -1.7f, 0}, Paint::dark),
                      top = add_ring(shape, collar, {0, -0.8f, 0}, Paint::dark);
    join_rings(shape, foot, top, collar.size());
    // Triangles at the poles have no area.
    std::vector<std::uint16_t> kept;
    for (std::size_t i = 0; i < shape.indices.size(); i += 3) {
        const vec3 a = shape.corners[shape.indices[i]].place, b = shape.corners[shape.indices[i + 1]].place,
                   c = shape.corners[shape.indices[i + 2]].place;
        if (maths::length(maths::cross(b - a, c - a)) > 1e-6f)
            kept.insert(kept.end(), &shape.indices[i], &shape.indices[i] + 3);
    }
    shape.indices = kept;
    return shape;
}

Shape fine_source_shape(Channel channel) {
    Shape shape;
    switch (channel) {
        case Channel::heat:
            add_flame(shape);
            break;
        case Channel::smell:
            add_blossom(shape);
            break;
        case Channel::oxygen:
            add_round(shape, {0.10f, 0.02f, 0.17f}, 0.17f, 0.17f, 18, 10, Paint::light);
            add_round(shape, {-0.12f, 0.10f, 0.34f}, 0.12f, 0.12f, 14, 8, Paint::light);
            add_round(shape, {-0.02f, -0.10f, 0.52f}, 0.09f, 0.09f, 12, 8, Paint::light);
            add_round(shape, {0.08f, 0.10f, 0.64f}, 0.05f, 0.05f, 10, 6, Paint::light);
            break;
        default:
            add_bulb(shape);
    }
    return shape;
}

}  // namespace braitenlab::render

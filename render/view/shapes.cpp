#include "render/view/shapes.h"

#include <algorithm>
#include <array>
#include <span>

#include "core/maths/angle.h"

namespace braitenlab::render {

using maths::vec2;
using maths::vec3;

namespace {

void add_triangle(Shape& shape, vec3 a, vec3 b, vec3 c, Paint paint) {
    const vec3 normal = maths::cross(b - a, c - a);
    if (maths::length(normal) < 1e-9f) return;  // two outline points above each other
    const auto first = static_cast<std::uint16_t>(shape.corners.size());
    for (const vec3& p : {a, b, c}) shape.corners.push_back({p, maths::normalise(normal), static_cast<float>(paint)});
    for (int i = 0; i < 3; ++i) shape.indices.push_back(static_cast<std::uint16_t>(first + i));
}

void add_quad(Shape& shape, vec3 a, vec3 b, vec3 c, vec3 d, Paint paint) {
    const vec3 normal = maths::normalise(maths::cross(c - a, d - b));
    if (maths::length(normal) < 0.5f) return;
    const auto first = static_cast<std::uint16_t>(shape.corners.size());
    for (const vec3& p : {a, b, c, d}) shape.corners.push_back({p, normal, static_cast<float>(paint)});
    for (const int i : {0, 1, 2, 0, 2, 3}) shape.indices.push_back(static_cast<std::uint16_t>(first + i));
}

vec3 at(vec2 p, float z) { return {p.x, p.y, z}; }

// The counter-clockwise outline; `left`: its left half from the rear to the front.
std::vector<vec2> mirrored(std::span<const vec2> left) {
    std::vector<vec2> outline;
    for (const vec2& p : left) outline.push_back({p.x, -p.y});
    outline.insert(outline.end(), left.rbegin(), left.rend());
    return outline;
}

// The outline offset inwards by `by`, with mitred corners.
std::vector<vec2> inset(const std::vector<vec2>& outline, float by) {
    const std::size_t count = outline.size();
    std::vector<vec2> inner(count);
    for (std::size_t i = 0; i < count; ++i) {
        const vec2 before = maths::normalise(outline[i] - outline[(i + count - 1) % count]);
        const vec2 after = maths::normalise(outline[(i + 1) % count] - outline[i]);
        const vec2 n1{-before.y, before.x}, n2{-after.y, after.x};
        inner[i] = outline[i] + (n1 + n2) * (by / std::max(0.5f, 1 + maths::dot(n1, n2)));
    }
    return inner;
}

// The area of a mirrored outline at one height: strips between right point i and left point count−1−i.
void add_top(Shape& shape, const std::vector<vec2>& outline, float z, Paint paint) {
    const std::size_t count = outline.size();
    for (std::size_t i = 0; i + 1 < count / 2; ++i)
        add_quad(shape, at(outline[i], z), at(outline[i + 1], z), at(outline[count - 2 - i], z),
                 at(outline[count - 1 - i], z), paint);
}

// A plate with this left half from z0 to z1, its upper edge chamfered. Coarse: with sloping sides instead.
void add_plate(Shape& shape, std::span<const vec2> left, float z0, float z1, float chamfer, Paint paint,
               Mesh mesh = Mesh::full) {
    const auto outer = mirrored(left), inner = inset(outer, chamfer);
    const std::size_t count = outer.size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t j = (i + 1) % count;
        if (mesh == Mesh::coarse) {
            add_quad(shape, at(outer[i], z0), at(outer[j], z0), at(inner[j], z1), at(inner[i], z1), paint);
            continue;
        }
        add_quad(shape, at(outer[i], z0), at(outer[j], z0), at(outer[j], z1 - chamfer), at(outer[i], z1 - chamfer),
                 paint);
        add_quad(shape, at(outer[i], z1 - chamfer), at(outer[j], z1 - chamfer), at(inner[j], z1), at(inner[i], z1),
                 paint);
    }
    add_top(shape, inner, z1, paint);
}

// The top of such a plate, without its sides where it is coarse: they are low.
void add_low_plate(Shape& shape, std::span<const vec2> left, float z0, float z1, float chamfer, Paint paint,
                   Mesh mesh) {
    if (mesh == Mesh::full)
        add_plate(shape, left, z0, z1, chamfer, paint);
    else
        add_top(shape, inset(mirrored(left), chamfer), z1, paint);
}

// An ellipsoid about `middle` with its poles on the z axis; `paint`: as a function of height −1..1.
template <class PaintAt>
void add_ball(Shape& shape, vec3 middle, vec3 radius, int slices, int stacks, PaintAt paint_at) {
    const auto first = shape.corners.size();
    for (int s = 0; s <= stacks; ++s) {
        const float latitude = maths::pi * (static_cast<float>(s) / static_cast<float>(stacks) - 0.5f);
        for (int i = 0; i <= slices; ++i) {
            const vec2 round = maths::direction(2 * maths::pi * static_cast<float>(i) / static_cast<float>(slices)) *
                               maths::cosine(latitude);
            const vec3 unit{round.x, round.y, maths::sine(latitude)};
            const vec3 normal = maths::normalise(vec3{unit.x / radius.x, unit.y / radius.y, unit.z / radius.z});
            shape.corners.push_back({middle + vec3{unit.x * radius.x, unit.y * radius.y, unit.z * radius.z}, normal,
                                     static_cast<float>(paint_at(unit.z))});
        }
    }
    const auto index = [&](int s, int i) {
        return static_cast<std::uint16_t>(first + static_cast<std::size_t>(s * (slices + 1) + i));
    };
    for (int s = 0; s < stacks; ++s)
        for (int i = 0; i < slices; ++i) {
            if (s > 0)
                for (const auto k : {index(s, i), index(s, i + 1), index(s + 1, i + 1)}) shape.indices.push_back(k);
            if (s + 1 < stacks || s == 0)
                for (const auto k : {index(s, i), index(s + 1, i + 1), index(s + 1, i)}) shape.indices.push_back(k);
        }
}

void add_ball(Shape& shape, vec3 middle, float radius, int slices, int stacks, Paint paint) {
    add_ball(shape, middle, {radius, radius, radius}, slices, stacks, [paint](float) { return paint; });
}

// A round post from z0 to z1 about the z axis, closed at the top.
void add_post(Shape& shape, float r0, float r1, float z0, float z1, int sides, Paint paint) {
    for (int i = 0; i < sides; ++i) {
        const vec2 a = maths::direction(2 * maths::pi * static_cast<float>(i) / static_cast<float>(sides));
        const vec2 b = maths::direction(2 * maths::pi * static_cast<float>(i + 1) / static_cast<float>(sides));
        add_quad(shape, at(a * r0, z0), at(b * r0, z0), at(b * r1, z1), at(a * r1, z1), paint);
        add_triangle(shape, {0, 0, z1}, at(a * r1, z1), at(b * r1, z1), paint);
    }
}

// The left half of a hull behind the wheel and before it.
std::vector<vec2> tail_of(Role role) {
    if (role == Role::prey) return {{-0.5f, 0.14f}, {-0.475f, 0.30f}, {-0.41f, 0.42f}, {-0.32f, 0.47f}};
    return {{-0.5f, 0.40f}, {-0.46f, 0.47f}};
}
std::vector<vec2> nose_of(Role role) {
    if (role == Role::predator) return {{0.195f, 0.50f}, {0.50f, 0.015f}};
    if (role == Role::prey)
        return {{0.20f, 0.48f}, {0.29f, 0.465f}, {0.37f, 0.41f}, {0.44f, 0.31f}, {0.485f, 0.18f}, {0.50f, 0.05f}};
    return {{0.195f, 0.48f}, {0.47f, 0.48f}, {0.50f, 0.44f}};
}

}  // namespace

Shape hull_shape(Role role, Mesh mesh) {
    const std::vector<vec2> arch{{-0.215f, 0.47f}, {-0.195f, 0.325f}, {0.175f, 0.325f}};
    std::vector<vec2> hull = tail_of(role), deck{{-0.24f, 0.40f}, {-0.20f, 0.265f}, {0.17f, 0.265f}};
    const auto nose = nose_of(role);
    hull.insert(hull.end(), arch.begin(), arch.end());
    hull.insert(hull.end(), nose.begin(), nose.end());
    if (role == Role::predator)
        deck.insert(deck.end(), {{0.205f, 0.43f}, {0.355f, 0.16f}});
    else if (role == Role::prey)
        deck.insert(deck.end(), {{0.20f, 0.41f}, {0.28f, 0.39f}, {0.33f, 0.34f}});
    else
        deck.insert(deck.end(), {{0.20f, 0.40f}, {0.33f, 0.40f}});
    Shape shape;
    add_plate(shape, hull, 0.07f, 0.25f, 0.028f, Paint::body, mesh);
    add_low_plate(shape, deck, 0.25f, 0.268f, 0.018f, Paint::deck, mesh);
    add_top(shape, inset(mirrored(deck), 0.035f), 0.271f, Paint::inlay);
    const std::array<vec2, 2> gauge{{{-0.42f, 0.32f}, {-0.33f, 0.32f}}};
    add_low_plate(shape, gauge, 0.25f, 0.262f, 0.012f, Paint::gauge, mesh);
    // The arrowhead shows the front.
    add_triangle(shape, {0, -1, 0.254f}, {1, 0, 0.254f}, {0, 1, 0.254f}, Paint::mark);
    return shape;
}

Shape sign_shape(Role role) {
    const std::vector<vec2> left =
        role == Role::predator ? std::vector<vec2>{{-0.5f, 0.44f}, {0.2f, 0.5f}, {0.5f, 0.02f}}
        : role == Role::prey   ? std::vector<vec2>{{-0.5f, 0.2f}, {-0.33f, 0.5f}, {0.25f, 0.5f}, {0.5f, 0.15f}}
                               : std::vector<vec2>{{-0.5f, 0.48f}, {0.5f, 0.48f}};
    constexpr float rim = 0.07f, height = 0.2f;
    const auto outline = inset(mirrored(left), -rim);
    Shape shape;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const vec2 a = outline[i], b = outline[(i + 1) % outline.size()], along = maths::normalise(b - a);
        add_triangle(shape, at({0, 0}, height), at(a, height), at(b, height), Paint::body);
        shape.corners[shape.corners.size() - 3].paint = a.x * along.y - a.y * along.x;  // how far inside the middle is
    }
    return shape;
}

Shape rim_shape(Role role) {
    std::vector<vec2> left = tail_of(role);
    const auto nose = nose_of(role);
    left.insert(left.end(), {{-0.18f, 0.5f}, {0.18f, 0.5f}});
    left.insert(left.end(), nose.begin(), nose.end());
    const auto outline = mirrored(left);
    const std::size_t count = outline.size();
    Shape shape;
    for (std::size_t i = 0; i < count; ++i) {
        const vec2 before = maths::normalise(outline[i] - outline[(i + count - 1) % count]);
        const vec2 after = maths::normalise(outline[(i + 1) % count] - outline[i]);
        const vec2 out = maths::normalise(vec2{before.y + after.y, -before.x - after.x});
        const float mitre = 1 / std::max(0.6f, out.x * after.y - out.y * after.x);
        for (const float edge : {0.0f, 1.0f, 2.0f})
            shape.corners.push_back({at(outline[i], mitre), {out.x, out.y, 0}, edge});
        const auto here = static_cast<int>(3 * i), next = static_cast<int>(3 * ((i + 1) % count));
        for (const int edge : {0, 1})
            for (const int corner : {here, here + 1, next + 1, here, next + 1, next})
                shape.indices.push_back(static_cast<std::uint16_t>(corner + edge));
    }
    const auto first = shape.corners.size();
    for (std::size_t i = 0; i < count; ++i) {
        Corner inside = shape.corners[3 * i];
        inside.paint = 3;
        shape.corners.push_back(inside);
    }
    for (std::size_t i = 0; i + 1 < count / 2; ++i)
        for (const std::size_t k : {i, i + 1, count - 2 - i, i, count - 2 - i, count - 1 - i})
            shape.indices.push_back(static_cast<std::uint16_t>(first + k));
    return shape;
}

Shape wheel_shape(Mesh mesh) {
    const int facets = mesh == Mesh::full ? 12 : 9;
    // A circle in the x-z plane; index 0 at the top, then forwards.
    const auto rim = [facets](int i, float radius, float y) {
        const vec2 p = maths::direction(2 * maths::pi * static_cast<float>(i) / static_cast<float>(facets)) * radius;
        return vec3{p.y, y, p.x};
    };
    Shape shape;
    for (int i = 0; i < facets; ++i) {
        const bool lug = i % 3 == 0;
        add_quad(shape, rim(i, 1, -0.5f), rim(i + 1, 1, -0.5f), rim(i + 1, 1, 0.5f), rim(i, 1, 0.5f),
                 lug ? Paint::mark : Paint::dark);
        if (mesh == Mesh::full)
            add_quad(shape, rim(i, 0.72f, 0.5f), rim(i, 1, 0.5f), rim(i + 1, 1, 0.5f), rim(i + 1, 0.72f, 0.5f),
                     Paint::dark);
        const float hub = mesh == Mesh::full ? 0.72f : 1.0f;
        add_triangle(shape, {0, 0.5f, 0}, rim(i, hub, 0.5f), rim(i + 1, hub, 0.5f), lug ? Paint::mark : Paint::deck);
    }
    return shape;
}

Shape source_shape(Channel channel) {
    Shape shape;
    switch (channel) {
        case Channel::heat:
            add_post(shape, 0.14f, 0.26f, 0, 0.22f, 8, Paint::dark);
            add_post(shape, 0.20f, 0.02f, 0.2f, 0.62f, 6, Paint::light);
            break;
        case Channel::smell:
            add_post(shape, 0.03f, 0.03f, 0, 0.3f, 6, Paint::dark);
            for (int i = 0; i < 5; ++i) {
                const vec2 petal = maths::direction(2 * maths::pi * static_cast<float>(i) / 5) * 0.17f;
                add_ball(shape, {petal.x, petal.y, 0.34f}, {0.12f, 0.12f, 0.06f}, 6, 4,
                         [](float) { return Paint::light; });
            }
            add_ball(shape, {0, 0, 0.38f}, 0.08f, 6, 4, Paint::mark);
            break;
        case Channel::oxygen:
            add_ball(shape, {0.10f, 0.02f, 0.16f}, 0.16f, 8, 6, Paint::light);
            add_ball(shape, {-0.12f, 0.10f, 0.34f}, 0.12f, 8, 6, Paint::light);
            add_ball(shape, {-0.02f, -0.10f, 0.52f}, 0.09f, 8, 6, Paint::light);
            break;
        default:  // a bulb on a ribbed socket
            add_post(shape, 0.22f, 0.19f, 0, 0.06f, 14, Paint::dark);
            for (const float z : {0.06f, 0.11f, 0.16f}) add_post(shape, 0.115f, 0.095f, z, z + 0.05f, 10, Paint::deck);
            add_ball(shape, {0, 0, 0.40f}, 0.21f, 13, 7, Paint::light);
    }
    return shape;
}

}  // namespace braitenlab::render

// The way from one place to another in an arena whose opposite edges may be joined (Edge::torus).
#pragma once

#include <cmath>

#include "core/scene/scene.h"

namespace braitenlab {

struct Seam {
    bool joined = false;
    maths::vec2 size;  // m, of the arena

    Seam() = default;
    explicit Seam(const Arena& arena) : joined(arena.edge == Edge::torus), size{arena.width, arena.height} {}

    // The same place, in the arena if its edges are joined; anywhere else as it is.
    maths::vec2 inside(maths::vec2 place) const {
        if (!joined) return place;
        return {inside(place.x, size.x), inside(place.y, size.y)};
    }

    // The shortest of the ways that lead to the same place: `way` itself, or across the seam.
    maths::vec2 shortest(maths::vec2 way) const { return inside(way); }

private:
    static float inside(float x, float side) { return x - side * std::floor(x / side + 0.5f); }
};

}  // namespace braitenlab

// Shortest paths in an arena whose opposite edges may be joined (Boundary::torus).
#pragma once

#include <cmath>
#include <vector>

#include "core/scene/scene.h"

namespace braitenlab::sensing {

struct Seam {
    bool joined = false;
    maths::vec2 size;  // m, of the arena

    Seam() = default;
    explicit Seam(const Arena& arena) : joined(arena.edge == Boundary::torus), size{arena.width, arena.height} {}

    // The same position inside the arena when its edges are joined; otherwise the position itself.
    maths::vec2 inside(maths::vec2 position) const {
        if (!joined) return position;
        return {inside(position.x, size.x), inside(position.y, size.y)};
    }

    // The shortest displacement (m) with the same end point: `displacement` itself, or the one across the seam.
    maths::vec2 shortest(maths::vec2 displacement) const { return inside(displacement); }

    // The displacements (m) of what is in the arena to where it is seen: {0, 0} first; with joined edges also those
    // to the eight neighbours of the arena.
    std::vector<maths::vec2> images() const {
        std::vector<maths::vec2> all{{0, 0}};
        if (!joined) return all;
        for (const float x : {-size.x, 0.0f, size.x})
            for (const float y : {-size.y, 0.0f, size.y})
                if (x != 0 || y != 0) all.push_back({x, y});
        return all;
    }

    // The images() of `middle` from which something of the size 2 · `reach` (m) around it reaches into the arena:
    // itself first.
    std::vector<maths::vec2> images_of(maths::vec2 middle, maths::vec2 reach) const {
        std::vector<maths::vec2> all;
        for (const maths::vec2 image : images()) {
            const maths::vec2 at = middle + image;
            const bool is_beyond = std::fabs(at.x) - reach.x > size.x / 2 || std::fabs(at.y) - reach.y > size.y / 2;
            if (all.empty() || !is_beyond) all.push_back(at);
        }
        return all;
    }

private:
    static float inside(float x, float side) { return x - side * std::floor(x / side + 0.5f); }
};

}  // namespace braitenlab::sensing

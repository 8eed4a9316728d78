// The floor of a scene from above, as parts of an SVG picture: what pictures of paths share.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/maths/vec.h"
#include "core/scene/scene.h"

namespace braitenlab {

// Metres to pixels of the picture: y up becomes y down.
struct FloorMap {
    float scale, width, height;
    explicit FloorMap(const Arena& arena, float across)
        : scale(across / arena.width), width(across), height(arena.height * across / arena.width) {}
    float x(float metres) const { return width / 2 + metres * scale; }
    float y(float metres) const { return height / 2 - metres * scale; }
};

// Zones and obstacles.
std::string floor_svg(const Scene&, const FloorMap&);

// Sources, with their names.
std::string sources_svg(const Scene&, const FloorMap&, bool names);

// The path as SVG path data of about `most` points, interrupted where the vehicle went over an edge of a torus.
std::string path_data(const std::vector<maths::vec2>& path, const Arena&, const FloorMap&, std::size_t most);

}  // namespace braitenlab

// The draw list of a snapshot, without a graphics library.
#pragma once

#include <vector>

#include "render/view/draw_list.h"

namespace braitenlab::render {

inline DrawList drawn(const Snapshot& now, const Picture& picture = {}) {
    DrawList list;
    fill(list, now, picture, Trails{});
    return list;
}

// The wires of a list, without the shadows of cables and the strokes of signs.
inline std::vector<WireInstance> wires_of(const DrawList& list) {
    std::vector<WireInstance> wires;
    for (const WireInstance& wire : list.wires)
        if (wire.colour.w != 0) wires.push_back(wire);
    return wires;
}

}  // namespace braitenlab::render

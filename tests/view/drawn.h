// The draw list of a snapshot, without a graphics library.
#pragma once

#include "render/view/draw_list.h"

namespace braitenlab::render {

inline DrawList drawn(const Snapshot& now, const Picture& picture = {}) {
    DrawList list;
    fill(list, now, picture, Trails{});
    return list;
}

}  // namespace braitenlab::render

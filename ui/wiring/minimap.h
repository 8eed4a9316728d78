// A small picture of the whole brain in the canvas's corner, for brains too large to be seen at once.
#pragma once

#include <optional>

#include "render/view/camera.h"
#include "ui/wiring/layout.h"

namespace braitenlab {

inline constexpr std::size_t minimap_from = 21;  // nodes: smaller brains need none

struct Minimap {
    Rect rect;  // window pixels
    View view;  // how the canvas lies in it
};

// In the lower right corner of the area; nothing for a brain of fewer nodes, where there is no room, and while the view
// shows every card whole: the picture would only hide some of them.
std::optional<Minimap> minimap_of(const Layout&, const View&, Rect area, float ui_scale);

}  // namespace braitenlab

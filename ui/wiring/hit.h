// What lies under a pixel of the canvas.
#pragma once

#include <optional>
#include <set>

#include "render/view/camera.h"
#include "ui/wiring/layout.h"

namespace braitenlab {

enum class Part { nothing, in_pin, out_pin, node, label, wire };

struct Hit {
    Part part = Part::nothing;
    NodeId node = 0;  // of a pin or node
    WireEnds wire;    // of a label or wire
    friend bool operator==(const Hit&, const Hit&) = default;
};

// Layout pixels on the screen, whatever the zoom; but a pin never takes more than its card.
inline constexpr float pin_reach = 14, wire_reach = 8;
inline constexpr float map_zoom = 0.4f;  // layout pixels per unit; below, labels are neither seen nor hit

// Pins first (the nearest within reach), then nodes (the topmost), labels, wires (the
// nearest within reach). `ui_scale`: window pixels per layout pixel.
Hit hit(const Layout&, const View&, maths::vec2 pixel, float ui_scale);

// The wire that runs through a box of half this height around a point (canvas units), the nearest one; ghosts are none.
std::optional<WireEnds> wire_through(const Layout&, maths::vec2 centre, float reach);

// What a box from corner to corner (window pixels) takes in: nodes that it touches, wires whose label's middle it
// holds. Ghosts are no wires.
struct Caught {
    std::set<NodeId> nodes;
    std::set<WireEnds> wires;
};
Caught inside(const Layout&, const View&, maths::vec2 corner, maths::vec2 opposite);

// Window pixels.
Rect node_rect(const View&, const NodeShape&);
Rect label_rect(const View&, const WireShape&);
Rect pin_rect(const View&, maths::vec2 pin);

}  // namespace braitenlab

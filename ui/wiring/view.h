// The canvas in the window: camera and minimap, and the parts under a pixel, in a box or beside a node.
//
// No Dear ImGui. `area` is the canvas in window pixels, `ui_scale` is window pixels per layout pixel.
#pragma once

#include <optional>
#include <set>

#include "render/view/camera.h"
#include "ui/wiring/layout.h"

namespace braitenlab::wiring {

// From canvas units to window pixels: pixel = origin + scale · unit.
struct View {
    maths::vec2 origin;
    float scale = 1;  // window pixels per canvas unit
    maths::vec2 to_window(maths::vec2 unit) const { return origin + unit * scale; }
    maths::vec2 to_canvas(maths::vec2 pixel) const { return (pixel - origin) / scale; }
};

inline constexpr float least_zoom = 0.02f, most_zoom = 3;  // 1,000 nodes fit into a window

// True where the diagram is a map: labels are neither drawn nor hit. So it is at a small zoom, and where letters of
// `least_type` window pixels (0: of any size) are too large for the cards.
bool is_map(const View&, float ui_scale, float least_type);

struct CanvasCamera {
    maths::vec2 middle;    // canvas point in the middle of the area
    float zoom = 1;        // least_zoom..most_zoom, layout pixels per canvas unit
    bool by_user = false;  // panned or zoomed by the user: no automatic fit
};

View view_of(const CanvasCamera&, Rect area, float ui_scale);

// Multiplies the zoom within its range; the canvas point under the pixel stays there.
void zoom_at(CanvasCamera&, Rect area, float ui_scale, maths::vec2 pixel, float factor);

// Shows all nodes at a zoom of at most 1.4; with `has_buttons` below the area's buttons or beside them.
void fit(CanvasCamera&, const Layout&, Rect area, float ui_scale, bool has_buttons = true);

// Moves the camera by the least distance that shows the canvas point away from the area's rim.
void reveal(CanvasCamera&, Rect area, float ui_scale, maths::vec2 point);

// A small picture of the whole brain in the lower right corner of the area.
struct Minimap {
    Rect rect;  // window pixels
    View view;  // of the canvas in it
};
inline constexpr std::size_t minimap_from = 21;  // nodes

// nullopt for fewer than minimap_from nodes, in a small area, and while the view shows every node.
std::optional<Minimap> minimap_of(const Layout&, const View&, Rect area, float ui_scale);

enum class Part { nothing, in_pin, out_pin, node, label, wire };

// A part of the picture.
struct Hit {
    Part part = Part::nothing;
    NodeId node = 0;  // of a pin or node
    WireEnds wire;    // of a label or wire
    bool is_wire() const { return part == Part::label || part == Part::wire; }
    bool is_of_node() const { return part == Part::node || is_pin(); }
    bool is_pin() const { return part == Part::in_pin || part == Part::out_pin; }
    friend bool operator==(const Hit&, const Hit&) = default;
};

// Layout pixels at any zoom; a pin's reach is never larger than its card.
inline constexpr float pin_reach = 14, wire_reach = 8;
inline constexpr float pin_size = 18;  // units, as drawn

// The part under a pixel: the nearest pin within reach, else the topmost node, else a label, else the nearest wire
// within reach. On a label beside a card a pin reaches no further than it is drawn. A map has no labels.
Hit hit(const Layout&, const View&, maths::vec2 pixel, float ui_scale, bool map);

// The wire nearest to a point (canvas units) within `reach` units, wires of weight 0 excluded.
std::optional<WireEnds> wire_through(const Layout&, maths::vec2 centre, float reach);

struct CanvasSelection {
    std::set<NodeId> nodes;
    std::set<WireEnds> wires;
    bool empty() const { return nodes.empty() && wires.empty(); }
    bool contains(const Hit&) const;
};

// The nodes that a box between two corners (window pixels) touches and the wires with the centre of their label in it,
// wires of weight 0 excluded.
CanvasSelection in_box(const Layout&, const View&, maths::vec2 corner, maths::vec2 opposite);

// Window pixels.
Rect node_rect(const View&, const NodeShape&);
Rect label_rect(const View&, const WireShape&);
Rect pin_rect(const View&, maths::vec2 pin);

enum class Direction { left, right, up, down };

// The nearest node or label in a direction; distance across it has the weight 2.2. `from` if there is none. From
// Part::nothing: the node nearest to the upper left corner.
Hit next_in(Direction, const Layout&, const Hit& from, bool nodes_only = false);

// The centre of a node, pin's node or label, canvas units; nullopt for a part that the layout does not have.
std::optional<maths::vec2> centre_of(const Layout&, const Hit&);

}  // namespace braitenlab::wiring

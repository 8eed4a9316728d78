#include "ui/wiring/hit.h"

#include <algorithm>

namespace braitenlab {
namespace {

using maths::vec2;

Rect rect_round(const View& view, vec2 centre, vec2 size) {
    const vec2 low = view.to_window(centre - size / 2);
    return {low.x, low.y, size.x * view.scale, size.y * view.scale};
}

float distance_to_segment(vec2 p, vec2 a, vec2 b) {
    const vec2 along = b - a;
    const float square = maths::dot(along, along);
    const float t = square > 0 ? std::clamp(maths::dot(p - a, along) / square, 0.0f, 1.0f) : 0;
    return maths::distance(p, a + along * t);
}

float distance_to_wire(const View& view, const WireShape& wire, vec2 pixel) {
    float nearest = 1e9f;
    vec2 before = view.to_window(wire.bezier[0]);
    for (int i = 1; i <= wire_segments; ++i) {
        const vec2 next = view.to_window(bezier_point(wire.bezier, static_cast<float>(i) / wire_segments));
        nearest = std::min(nearest, distance_to_segment(pixel, before, next));
        before = next;
    }
    return nearest;
}

Hit nearest_pin(const Layout& layout, const View& view, vec2 pixel, float reach) {
    Hit best;
    const auto offer = [&](float distance, Part part, NodeId node) {
        if (distance > reach) return;
        reach = distance;
        best = {part, node, {}};
    };
    for (const NodeShape& node : layout.nodes) {
        // The in-pin is as tall as the wires' arrivals.
        const vec2 half{0, node.in_spread / 2};
        const vec2 top = view.to_window(node.in_pin() - half), bottom = view.to_window(node.in_pin() + half);
        if (node.has_in) offer(distance_to_segment(pixel, top, bottom), Part::in_pin, node.id);
        if (node.has_out) offer(maths::distance(pixel, view.to_window(node.out_pin())), Part::out_pin, node.id);
    }
    return best;
}

}  // namespace

Hit hit(const Layout& layout, const View& view, vec2 pixel, float ui_scale) {
    const bool map = view.scale < map_zoom * ui_scale;
    const float reach_of_pins = std::min(pin_reach * ui_scale, 48 * view.scale);
    if (const Hit pin = nearest_pin(layout, view, pixel, reach_of_pins); pin.part != Part::nothing) return pin;
    for (auto node = layout.nodes.rbegin(); node != layout.nodes.rend(); ++node)
        if (node_rect(view, *node).contains(pixel.x, pixel.y)) return {Part::node, node->id, {}};
    for (auto wire = layout.wires.rbegin(); !map && wire != layout.wires.rend(); ++wire)
        if (label_rect(view, *wire).contains(pixel.x, pixel.y)) return {Part::label, 0, wire->ends};
    Hit best;
    float reach = wire_reach * ui_scale;
    const vec2 at = view.to_canvas(pixel), room = vec2{reach, reach} / view.scale;
    for (const WireShape& wire : layout.wires) {
        const bool near = at.x > wire.low.x - room.x && at.x < wire.high.x + room.x && at.y > wire.low.y - room.y &&
                          at.y < wire.high.y + room.y;
        if (!near) continue;
        const float distance = distance_to_wire(view, wire, pixel);
        if (distance > reach) continue;
        reach = distance;
        best = {Part::wire, 0, wire.ends};
    }
    return best;
}

std::optional<WireEnds> wire_through(const Layout& layout, vec2 centre, float reach) {
    std::optional<WireEnds> best;
    for (const WireShape& wire : layout.wires) {
        if (wire.ghost) continue;
        const float distance = distance_to_wire(View{}, wire, centre);
        if (distance > reach) continue;
        reach = distance;
        best = wire.ends;
    }
    return best;
}

Caught inside(const Layout& layout, const View& view, vec2 corner, vec2 opposite) {
    const float left = std::min(corner.x, opposite.x), right = std::max(corner.x, opposite.x);
    const float top = std::min(corner.y, opposite.y), bottom = std::max(corner.y, opposite.y);
    Caught caught;
    for (const NodeShape& node : layout.nodes) {
        const Rect r = node_rect(view, node);
        if (r.x < right && r.x + r.w > left && r.y < bottom && r.y + r.h > top) caught.nodes.insert(node.id);
    }
    for (const WireShape& wire : layout.wires) {
        const vec2 middle = view.to_window(wire.label);
        const bool held = middle.x > left && middle.x < right && middle.y > top && middle.y < bottom;
        if (held && !wire.ghost) caught.wires.insert(wire.ends);
    }
    return caught;
}

Rect node_rect(const View& view, const NodeShape& node) { return rect_round(view, node.centre, node.size); }
Rect label_rect(const View& view, const WireShape& wire) { return rect_round(view, wire.label, wire.label_size); }
Rect pin_rect(const View& view, vec2 pin) { return rect_round(view, pin, {18, 18}); }

}  // namespace braitenlab

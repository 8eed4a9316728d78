#include "ui/wiring/view.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/enum_table.h"
#include "ui/widgets/theme.h"

namespace braitenlab::wiring {

using namespace ui;
using maths::vec2;

namespace {

// Margins of a fitted brain, layout pixels. The buttons in the upper right corner take top_margin in height and
// button_margin in width.
constexpr float side_margin = spacing::wide, bottom_margin = spacing::wide, top_margin = 56, button_margin = 212;
constexpr float bare_margin = spacing::small;  // on all sides, without buttons
constexpr float small_zoom = 0.6f;             // below: letters are enlarged, and labels with them
constexpr float map_zoom = 0.36f;              // below: no labels

float zoom_to_show(vec2 room, vec2 size, float ui_scale) {
    const float zoom = std::min(std::max(room.x, 1.0f) / size.x, std::max(room.y, 1.0f) / size.y) / ui_scale;
    return std::clamp(zoom, least_zoom, 1.4f);
}

struct Box {
    vec2 low, high;
};

// Around all nodes and labels: the label of a loop is above its nodes.
Box box_to_fit(const Layout& layout) {
    Box box{layout.low, layout.high};
    for (const WireShape& wire : layout.wires) {
        const vec2 low = wire.label - wire.label_size / 2, high = wire.label + wire.label_size / 2;
        box.low = {std::min(box.low.x, low.x), std::min(box.low.y, low.y)};
        box.high = {std::max(box.high.x, high.x), std::max(box.high.y, high.y)};
    }
    return box;
}

Rect rect_around(const View& view, vec2 centre, vec2 size) {
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
        // An in-pin is as tall as the ends of its wires.
        const vec2 half{0, node.in_spread / 2};
        const vec2 top = view.to_window(node.in_pin() - half), bottom = view.to_window(node.in_pin() + half);
        if (node.has_in) offer(distance_to_segment(pixel, top, bottom), Part::in_pin, node.id);
        if (node.has_out) offer(maths::distance(pixel, view.to_window(node.out_pin())), Part::out_pin, node.id);
    }
    return best;
}

Hit node_at(const Layout& layout, const View& view, vec2 pixel) {
    for (auto node = layout.nodes.rbegin(); node != layout.nodes.rend(); ++node)
        if (node_rect(view, *node).contains(pixel)) return {Part::node, node->id, {}};
    return {};
}

Hit label_at(const Layout& layout, const View& view, vec2 pixel) {
    for (auto wire = layout.wires.rbegin(); wire != layout.wires.rend(); ++wire)
        if (label_rect(view, *wire).contains(pixel)) return {Part::label, 0, wire->ends};
    return {};
}

template <class Visitor>
void each_stop(const Layout& layout, bool nodes_only, Visitor visit) {
    for (const NodeShape& node : layout.nodes) visit(Hit{Part::node, node.id, {}}, node.centre);
    if (nodes_only) return;
    for (const WireShape& wire : layout.wires) visit(Hit{Part::label, 0, wire.ends}, wire.label);
}

// In the order of Direction.
constexpr std::array<vec2, 4> directions{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
static_assert(has_enumerators<Direction, directions.size()>());

}  // namespace

View view_of(const CanvasCamera& camera, Rect area, float ui_scale) {
    const float scale = camera.zoom * ui_scale;
    return {area.middle() - camera.middle * scale, scale};
}

void zoom_at(CanvasCamera& camera, Rect area, float ui_scale, vec2 pixel, float factor) {
    const vec2 fixed = view_of(camera, area, ui_scale).to_canvas(pixel);
    camera.zoom = std::clamp(camera.zoom * factor, least_zoom, most_zoom);
    camera.middle += fixed - view_of(camera, area, ui_scale).to_canvas(pixel);
    camera.by_user = true;
}

namespace {

bool is_clear_of_buttons(const Layout& layout, const View& view, Rect area, float ui_scale) {
    const float width = button_margin * ui_scale;
    const Rect buttons{area.x + area.w - width, area.y, width, top_margin * ui_scale};
    const auto is_clear = [&](const auto& shapes, auto rect) {
        return std::none_of(shapes.begin(), shapes.end(),
                            [&](const auto& shape) { return rect(view, shape).overlaps(buttons); });
    };
    return is_clear(layout.nodes, node_rect) && is_clear(layout.wires, label_rect);
}

// Shows all nodes in the whole area, in its middle or at its left side, where none is below the buttons.
std::optional<CanvasCamera> beneath_buttons(const Layout& layout, const Box& box, Rect area, float ui_scale) {
    const vec2 size = box.high - box.low, room = vec2{area.w, area.h} - vec2{2, 2} * (bare_margin * ui_scale);
    CanvasCamera camera{(box.low + box.high) / 2, zoom_to_show(room, size, ui_scale)};
    const float to_left = std::max(0.0f, (room.x / (camera.zoom * ui_scale) - size.x) / 2), middle = camera.middle.x;
    for (const float shift : {0.0f, to_left}) {
        camera.middle.x = middle + shift;
        if (is_clear_of_buttons(layout, view_of(camera, area, ui_scale), area, ui_scale)) return camera;
    }
    return {};
}

}  // namespace

void fit(CanvasCamera& camera, const Layout& layout, Rect area, float ui_scale, bool has_buttons) {
    const auto [low, high] = box_to_fit(layout);
    const vec2 size = high - low;
    if (!has_buttons) {
        const float around = 2 * bare_margin * ui_scale;
        camera = {(low + high) / 2, zoom_to_show({area.w - around, area.h - around}, size, ui_scale)};
        return;
    }
    const float below = zoom_to_show(
        {area.w - 2 * side_margin * ui_scale, area.h - (top_margin + bottom_margin) * ui_scale}, size, ui_scale);
    const float beside = zoom_to_show(
        {area.w - (side_margin + button_margin) * ui_scale, area.h - 2 * bottom_margin * ui_scale}, size, ui_scale);
    // In a small area the room below or beside the buttons is too small for letters.
    const float most = std::max(beside, below);
    const auto whole = beneath_buttons(layout, {low, high}, area, ui_scale);
    if (whole && most < small_zoom && whole->zoom > 1.05f * most) return void(camera = *whole);
    const bool is_beside = beside > 1.1f * below;  // in a low area the room below the buttons is too small
    camera.zoom = is_beside ? beside : below;
    camera.middle = (low + high) / 2;
    camera.by_user = false;
    const float scale = view_of(camera, area, ui_scale).scale;
    const float above = (area.h - size.y * scale) / 2, right = (area.w - size.x * scale) / 2;
    if (is_beside && right < button_margin * ui_scale) camera.middle.x += (button_margin * ui_scale - right) / scale;
    if (!is_beside && above < top_margin * ui_scale) camera.middle.y -= (top_margin * ui_scale - above) / scale;
}

void reveal(CanvasCamera& camera, Rect area, float ui_scale, vec2 point) {
    const View view = view_of(camera, area, ui_scale);
    const vec2 at = view.to_window(point);
    const vec2 rim{std::min(96 * ui_scale, area.w / 3), std::min(72 * ui_scale, area.h / 3)};
    const vec2 wanted{std::clamp(at.x, area.x + rim.x, area.x + area.w - rim.x),
                      std::clamp(at.y, area.y + rim.y, area.y + area.h - rim.y)};
    if (wanted == at) return;
    camera.middle += (at - wanted) / view.scale;
    camera.by_user = true;
}

std::optional<Minimap> minimap_of(const Layout& layout, const View& view, Rect area, float ui_scale) {
    constexpr float width = 176, height = 112, away = spacing::medium, margin = spacing::small;  // layout pixels
    if (layout.nodes.size() < minimap_from) return {};
    if (area.w < 2.5f * width * ui_scale || area.h < 2.5f * height * ui_scale) return {};
    const vec2 low = view.to_window(layout.low), high = view.to_window(layout.high);
    if (area.contains(low) && area.contains(high)) return {};
    Minimap map;
    map.rect = {area.x + area.w - (width + away) * ui_scale, area.y + area.h - (height + away) * ui_scale,
                width * ui_scale, height * ui_scale};
    const vec2 size = layout.high - layout.low, room = vec2{width - 2 * margin, height - 2 * margin} * ui_scale;
    map.view.scale = std::min(room.x / size.x, room.y / size.y);
    const vec2 middle = map.rect.middle();
    map.view.origin = middle - (layout.low + layout.high) / 2 * map.view.scale;
    return map;
}

bool is_map(const View& view, float ui_scale, float least_type) {
    constexpr float letters = 26, most_growth = 1.7f;  // units; the cards of a sketch hold letters enlarged by so much
    return view.scale < map_zoom * ui_scale || least_type > most_growth * letters * view.scale;
}

Hit hit(const Layout& layout, const View& view, vec2 pixel, float ui_scale, bool map) {
    const Hit node = node_at(layout, view, pixel), label = map ? Hit{} : label_at(layout, view, pixel);
    // On a short wire the number is beside a pin: the pin reaches no further than it is drawn.
    const bool is_on_number = label.part != Part::nothing && node.part == Part::nothing;
    const float drawn = pin_size / 2 * view.scale, reach_of_pins = std::min(pin_reach * ui_scale, 48 * view.scale);
    const Hit pin = nearest_pin(layout, view, pixel, is_on_number ? std::min(drawn, reach_of_pins) : reach_of_pins);
    for (const Hit& part : {pin, node, label})
        if (part.part != Part::nothing) return part;
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

CanvasSelection in_box(const Layout& layout, const View& view, vec2 corner, vec2 opposite) {
    const float left = std::min(corner.x, opposite.x), right = std::max(corner.x, opposite.x);
    const float top = std::min(corner.y, opposite.y), bottom = std::max(corner.y, opposite.y);
    CanvasSelection selection;
    for (const NodeShape& node : layout.nodes) {
        const Rect r = node_rect(view, node);
        if (r.x < right && r.x + r.w > left && r.y < bottom && r.y + r.h > top) selection.nodes.insert(node.id);
    }
    for (const WireShape& wire : layout.wires) {
        const vec2 middle = view.to_window(wire.label);
        const bool held = middle.x > left && middle.x < right && middle.y > top && middle.y < bottom;
        if (held && !wire.ghost) selection.wires.insert(wire.ends);
    }
    return selection;
}

Rect node_rect(const View& view, const NodeShape& node) { return rect_around(view, node.centre, node.size); }
Rect label_rect(const View& view, const WireShape& wire) { return rect_around(view, wire.label, wire.label_size); }
Rect pin_rect(const View& view, vec2 pin) { return rect_around(view, pin, {pin_size, pin_size}); }

bool CanvasSelection::contains(const Hit& part) const {
    if (part.part == Part::nothing) return false;
    return part.is_wire() ? wires.count(part.wire) > 0 : nodes.count(part.node) > 0;
}

std::optional<vec2> centre_of(const Layout& layout, const Hit& part) {
    if (part.is_wire()) {
        const WireShape* wire = find_shape(layout, part.wire);
        return wire == nullptr ? std::nullopt : std::optional(wire->label);
    }
    const NodeShape* node = part.part == Part::nothing ? nullptr : find_shape(layout, part.node);
    return node == nullptr ? std::nullopt : std::optional(node->centre);
}

Hit next_in(Direction towards, const Layout& layout, const Hit& from, bool nodes_only) {
    const auto start = centre_of(layout, from);
    Hit best = start ? from : Hit{};
    float least = 1e30f;
    const vec2 ahead = directions[static_cast<std::size_t>(towards)];
    each_stop(layout, nodes_only || !start, [&](const Hit& stop, vec2 at) {
        float cost = at.x + at.y;
        if (start) {
            const float along = maths::dot(at - *start, ahead), aside = std::abs(at.x - start->x) * std::abs(ahead.y) +
                                                                        std::abs(at.y - start->y) * std::abs(ahead.x);
            if (along < 4) return;
            cost = along + 2.2f * aside;
        }
        if (cost >= least) return;
        least = cost;
        best = stop;
    });
    return best;
}

}  // namespace braitenlab::wiring

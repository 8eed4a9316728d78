#include <algorithm>
#include <cmath>

#include "ui/strings.h"
#include "ui/theme.h"
#include "ui/widgets/number.h"
#include "ui/wiring/draw.h"
#include "ui/wiring/node_words.h"

namespace braitenlab {
namespace {

using maths::vec2;

constexpr float card_rounding = 16;

float wheel_angle(const CanvasPicture& picture, const Node& node) {
    const auto& angle = picture.vehicle.wheel_angle;
    return node.name == "ML" ? angle[0] : node.name == "MR" ? angle[1] : 0;
}

// From far away only what can still be read: icon, name and number, as large as the card allows.
void draw_words(const Pen& pen, const CanvasPicture& picture, const Node& node, float value, vec2 low, vec2 high) {
    const Palette& p = pen.palette();
    const bool neuron = node.kind == NodeKind::neuron, far = detail_of(pen) != Detail::full;
    const std::string number = node.kind == NodeKind::sensor ? fixed(value, 2) : with_sign(value, 2);
    const float room = high.x - low.x;
    const std::string_view caption = pen.ui.strings(node_words(*picture.view.now, picture.vehicle, node));
    if (far && !neuron) {
        pen.text({low.x, low.y + 24}, 27, 0, node.name, p.text, Face::strong, room);
        pen.text({low.x, low.y + 52}, 26, 0, number, p.text, Face::text, room);
        pen.text({low.x - 62, low.y + 81}, 20, 0, caption, p.second_text, Face::small, room + 66);
    } else if (far || neuron) {
        const float height = far ? 29 : 21, above = far ? 25 : 22;
        pen.text({low.x, low.y + above}, height, 0, node.name, p.text, Face::strong, room);
        pen.text({low.x, low.y + above + height + 2}, height, 0, number, p.text, Face::text, room);
    } else {
        pen.text({low.x, low.y + 27}, 24, 0, node.name, p.text, Face::strong, room - 62);
        pen.text({high.x, low.y + 27}, 20, 1, number, p.text);
        pen.text({low.x, low.y + 52}, 16, 0, caption, p.second_text, Face::small, room);
    }
    const float bar = neuron ? low.x : low.x - 58;
    if (!far)
        draw_bar(pen, {bar, high.y - (neuron ? 14.0f : 18.0f)}, high.x - 2 - bar, value, node.kind != NodeKind::sensor);
}

void draw_contents(const Pen& pen, const CanvasPicture& picture, const NodeShape& shape, const Node& node,
                   float value) {
    const bool neuron = node.kind == NodeKind::neuron;
    const bool far = detail_of(pen) != Detail::full;
    const vec2 half = shape.size / 2;
    const vec2 icon = shape.centre + vec2{-half.x + (neuron ? 38.0f : 44.0f), neuron ? 0.0f : far ? -13.0f : -9.0f};
    if (node.kind == NodeKind::sensor) draw_eye(pen, icon, value, node.silenced);
    if (node.kind == NodeKind::motor) draw_wheel(pen, icon, wheel_angle(picture, node), value, node.silenced);
    if (neuron) draw_response(pen, icon, node.curve, value);
    const float left = icon.x + (neuron ? 28.0f : 34.0f);
    draw_words(pen, picture, node, value, {left, shape.centre.y - half.y},
               shape.centre + half - vec2{neuron ? 14.0f : 18.0f, 0});
}

// A lesion: stripes across the card, which its name and number stay readable on.
void draw_silence(const Pen& pen, const NodeShape& shape) {
    const Palette& p = pen.palette();
    const vec2 half = shape.size / 2;
    const ImVec2 low = pen.at(shape.centre - half), high = pen.at(shape.centre + half);
    pen.list.PushClipRect(low, high, true);
    const float gap = pen.size(15), height = high.y - low.y;
    for (float x = low.x - height; x < high.x; x += gap)
        pen.list.AddLine({x, high.y}, {x + height, low.y}, paint(p.warning.with_alpha(0.20f)), pen.stroke(3));
    pen.list.PopClipRect();
    pen.frame(shape.centre, shape.size, card_rounding, 2.2f, p.warning);
}

void draw_card(const Pen& pen, const CanvasPicture& picture, std::size_t index) {
    const Palette& p = pen.palette();
    const NodeShape& shape = picture.layout.nodes[index];
    const Node& node = picture.graph.nodes[shape.node];
    const float value = picture.moment.nodes[index], strength = std::min(std::abs(value), 1.0f);
    const bool selected = picture.state.selection.nodes.count(shape.id) > 0;
    const bool hovered = picture.state.hovered.part == Part::node && picture.state.hovered.node == shape.id;
    const bool plain = detail_of(pen) == Detail::map;
    if (!plain)
        pen.halo(shape.centre + vec2{0, 4}, shape.size, card_rounding, 14, p.shadow.with_alpha(p.shadow.a * 0.28f));
    if (strength > 0.01f && !plain)
        pen.halo(shape.centre, shape.size, card_rounding, 8 + 10 * strength,
                 colour_of_weight(p, value).with_alpha(0.34f * strength));
    pen.box(shape.centre, shape.size, card_rounding, mix(p.panel, p.raised, hovered ? 1.0f : 0.45f));
    const Colour edge = strength > 0.01f ? mix(p.line, colour_of_weight(p, value), 0.25f + 0.6f * strength) : p.line;
    if (selected) {
        pen.frame(shape.centre, shape.size + vec2{7, 7}, card_rounding + 4, 5, p.text.with_alpha(0.45f));
        pen.frame(shape.centre, shape.size + vec2{7, 7}, card_rounding + 4, 3, p.selected);
    }
    if (node.silenced)
        draw_silence(pen, shape);
    else
        pen.frame(shape.centre, shape.size, card_rounding, 1.6f, hovered ? p.second_text : edge);
    if (!plain) return draw_contents(pen, picture, shape, node, value);
    pen.box(shape.centre, shape.size - vec2{24, 24}, 6, colour_of_weight(p, value).with_alpha(0.15f + 0.6f * strength));
    pen.text(shape.centre, 34, 0.5f, node.name, p.text, Face::strong, shape.size.x);
}

// While a wire is dragged, the pins that could take it light up.
bool invites(const CanvasPicture& picture, const NodeShape& shape, bool out) {
    const CanvasDrag& drag = picture.state.drag;
    if (drag.phase != CanvasPhase::drag_wire) return false;
    const bool outwards = drag.pressed.part == Part::out_pin;
    if (outwards == out) return false;
    const WireEnds ends = outwards ? WireEnds{drag.pressed.node, shape.id} : WireEnds{shape.id, drag.pressed.node};
    return weight_of(picture.graph, ends) == 0;
}

}  // namespace

void draw_nodes(const Pen& pen, const CanvasPicture& picture) {
    const Hit& over = picture.state.hovered;
    for (std::size_t i = 0; i < picture.layout.nodes.size(); ++i) {
        const NodeShape& shape = picture.layout.nodes[i];
        if (!picture.sees(shape.centre - shape.size / 2, shape.centre + shape.size / 2)) continue;
        draw_card(pen, picture, i);
        const bool in = over.part == Part::in_pin && over.node == shape.id;
        const bool out = over.part == Part::out_pin && over.node == shape.id;
        if (shape.has_in) draw_pin(pen, shape.in_pin(), shape.in_spread, in, invites(picture, shape, false), false);
        if (shape.has_out) draw_pin(pen, shape.out_pin(), 0, out, invites(picture, shape, true), true);
    }
}

}  // namespace braitenlab

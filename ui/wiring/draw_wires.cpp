#include <algorithm>
#include <cmath>

#include "ui/theme.h"
#include "ui/widgets/number.h"
#include "ui/wiring/draw.h"

namespace braitenlab {
namespace {

using maths::vec2;

constexpr float dot_gap = 44;    // units between signal dots
constexpr float dot_step = 5;    // units they move in a tick
constexpr float sign_size = 13;  // of the end sign
constexpr float end_gap = 2;     // between the end sign's tip and the pin

struct Look {
    Wire wire;          // weight 0 for a place without a wire
    float carried = 0;  // what arrives at its end
    bool selected = false, hovered = false;
};

Look look_of(const CanvasPicture& picture, const WireShape& shape) {
    Look look;
    if (const Wire* wire = find_wire(picture.graph, shape.ends.from, shape.ends.to))
        look.wire = *wire;
    else
        look.wire.weight = 0;
    if (!shape.ghost) look.carried = signal(look.wire, picture.value(shape.ends.from));
    look.selected = picture.state.selection.wires.count(shape.ends) > 0;
    const Hit& over = picture.state.hovered;
    look.hovered = (over.part == Part::wire || over.part == Part::label) && over.wire == shape.ends;
    return look;
}

float width_of(float weight) { return 1.5f + 2.6f * std::min(std::abs(weight), 2.0f); }

// The curve without its last few units, where the end sign stands.
std::array<vec2, 4> shortened(std::array<vec2, 4> curve) {
    curve[3].x -= sign_size * 0.6f + end_gap;
    return curve;
}

void stroke_curve(const Pen& pen, const std::array<vec2, 4>& b, float width, Colour colour) {
    pen.list.AddBezierCubic(pen.at(b[0]), pen.at(b[1]), pen.at(b[2]), pen.at(b[3]), paint(colour), pen.stroke(width),
                            wire_segments * 2);
}

// The curve as points a few units apart: for dashes and dots, which must not bunch where the parameter runs slowly.
std::vector<vec2> along(const std::array<vec2, 4>& b, float gap, float first) {
    constexpr int fine = 160;
    std::vector<vec2> points;
    float run = 0, next = first;
    vec2 before = b[0];
    for (int i = 1; i <= fine; ++i) {
        const vec2 now = bezier_point(b, static_cast<float>(i) / fine);
        const float piece = maths::distance(before, now);
        while (piece > 0 && next <= run + piece) {
            points.push_back(before + (now - before) * ((next - run) / piece));
            next += gap;
        }
        run += piece;
        before = now;
    }
    return points;
}

void draw_ghost(const Pen& pen, const CanvasPicture& picture, const WireShape& shape, const Look& look) {
    const Palette& p = pen.palette();
    const bool quiet = std::any_of(picture.graph.nodes.begin(), picture.graph.nodes.end(),
                                   [](const Node& node) { return node.kind == NodeKind::neuron; });
    const Colour colour = look.hovered || look.selected ? p.text : p.second_text.with_alpha(quiet ? 0.30f : 0.55f);
    const auto points = along(shape.bezier, 7, 4);
    for (std::size_t i = 0; i + 1 < points.size(); i += 2)
        pen.list.AddLine(pen.at(points[i]), pen.at(points[i + 1]), paint(colour), pen.stroke(1.5f));
}

// Dots stand where the signal stands; a tick moves them on.
void draw_dots(const Pen& pen, const CanvasPicture& picture, const WireShape& shape, const Look& look, Colour colour) {
    const float strength = std::min(std::abs(look.carried), 1.0f);
    if (strength < 0.01f) return;
    const float moved = std::fmod(static_cast<float>(picture.view.now->tick % 44) * dot_step, dot_gap);
    const float radius = pen.stroke(2.2f + 3.4f * std::sqrt(strength));
    const Colour core =
        mix(colour, Colour{1, 1, 1, 1}, picture.view.theme == Theme::dark ? 0.25f + 0.6f * strength : 0);
    for (const vec2 point : along(shortened(shape.bezier), dot_gap, 12 + moved)) {
        const ImVec2 at = pen.at(point);
        pen.list.AddCircleFilled(at, radius * 2.1f, paint(colour.with_alpha(0.28f * strength)));
        pen.list.AddCircleFilled(at, radius, paint(core.with_alpha(0.55f + 0.45f * strength)));
        if (picture.view.theme == Theme::light)  // a lit dot has a rim on white ground
            pen.list.AddCircle(at, radius, paint(pen.palette().text.with_alpha(0.5f)), 0, pen.stroke(1));
    }
}

void draw_wire(const Pen& pen, const CanvasPicture& picture, const WireShape& shape) {
    const Palette& p = pen.palette();
    const Look look = look_of(picture, shape);
    if (shape.ghost) return draw_ghost(pen, picture, shape, look);
    const Colour colour = colour_of_weight(p, look.wire.weight);
    const float strength = std::min(std::abs(look.carried), 1.0f), width = width_of(look.wire.weight);
    const auto curve = shortened(shape.bezier);
    if (look.selected) {
        stroke_curve(pen, curve, width + 8, p.text.with_alpha(0.35f));
        stroke_curve(pen, curve, width + 5, p.selected);
    } else if (look.hovered) {
        stroke_curve(pen, curve, width + 6, p.text.with_alpha(0.22f));
    }
    stroke_curve(pen, curve, width + 1.5f, p.ground);  // keeps crossing wires apart
    if (strength > 0.01f) stroke_curve(pen, curve, width + 7 * strength, colour.with_alpha(0.18f * strength));
    const float resting = picture.view.theme == Theme::dark ? 0.55f : 0.85f;  // a pale line drowns in white
    stroke_curve(pen, curve, width, mix(p.ground, colour, resting + (1 - resting) * strength));
    draw_dots(pen, picture, shape, look, colour);
    draw_end_sign(pen, shape.bezier[3] - vec2{end_gap, 0}, sign_size + width * 0.6f, look.wire.weight > 0, colour);
}

void draw_label(const Pen& pen, const CanvasPicture& picture, const WireShape& shape) {
    const Palette& p = pen.palette();
    const Look look = look_of(picture, shape);
    const vec2 extent = shape.label_size, at = shape.label;
    const Colour rim = shape.ghost ? p.line : colour_of_weight(p, look.wire.weight);
    const Colour fill = shape.ghost ? p.panel : p.raised;
    if (!shape.ghost) pen.halo(at + vec2{0, 1}, extent, extent.y / 2, 4, p.shadow.with_alpha(p.shadow.a * 0.3f));
    pen.box(at, extent, extent.y / 2, fill);
    if (look.selected) pen.frame(at, extent + vec2{6, 6}, extent.y / 2 + 3, 3, p.selected);
    const Colour edge = look.hovered ? p.text : rim;
    pen.frame(at, extent, extent.y / 2, look.hovered || !shape.ghost ? 2 : 1.2f, edge);
    const std::string weight = shape.ghost ? fixed(0, 2) : with_sign(look.wire.weight, 2);
    const Colour ink = shape.ghost ? p.second_text : p.text;
    const bool far = pen.view.scale < 0.62f * pen.ui.scale;  // larger there, or it cannot be read
    if (!shape.direct) return pen.text(at, far ? 23 : 18, 0.5f, weight, ink);
    const float pad = far ? 9 : 13;
    pen.text(at - vec2{extent.x / 2 - pad, 0}, far ? 20 : 17, 0, wire_name(picture.graph, shape.ends), p.second_text,
             Face::strong);
    pen.text(at + vec2{extent.x / 2 - pad, 0}, far ? 22 : 19, 1, weight, ink);
}

}  // namespace

void draw_end_sign(const Pen& pen, vec2 tip, float size, bool excites, Colour colour) {
    const float half = size / 2;
    if (excites)
        pen.list.AddTriangleFilled(pen.at(tip), pen.at(tip + vec2{-size, half}), pen.at(tip - vec2{size, half}),
                                   paint(colour));
    else
        pen.list.AddCircleFilled(pen.at(tip - vec2{half * 0.9f, 0}), pen.stroke(half * 0.9f), paint(colour));
}

void draw_wires(const Pen& pen, const CanvasPicture& picture) {
    for (const WireShape& wire : picture.layout.wires)
        if (wire.ghost) draw_wire(pen, picture, wire);
    for (const WireShape& wire : picture.layout.wires)
        if (!wire.ghost) draw_wire(pen, picture, wire);
    for (const WireShape& wire : picture.layout.wires) draw_label(pen, picture, wire);
}

}  // namespace braitenlab

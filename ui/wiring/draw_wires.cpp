#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "ui/imgui_compat.h"
#include "ui/widgets/number.h"
#include "ui/widgets/theme.h"
#include "ui/wiring/draw.h"

namespace braitenlab::wiring {

using namespace ui;

using maths::vec2;

namespace {

constexpr float dot_step = 5;    // units the dots move in a tick
constexpr float sign_size = 13;  // of the end sign
constexpr float pin_gap = 2;     // between the end sign's tip and the pin

vec2 corner_low(vec2 a, vec2 b) { return {std::min(a.x, b.x), std::min(a.y, b.y)}; }
vec2 corner_high(vec2 a, vec2 b) { return {std::max(a.x, b.x), std::max(a.y, b.y)}; }

// A wire as straight pieces; those outside the visible canvas are not drawn.
class Stroke {
public:
    Stroke(const Pen& with, const Picture& picture, const std::array<vec2, 4>& curve) : pen(with), picture_(picture) {
        // The number of pieces follows the size of the bend on the screen.
        const float across = std::abs(curve[3].y - curve[0].y);
        const float bend = curve[3].x > curve[0].x
                               ? across
                               : maths::distance(curve[0], curve[1]) + maths::distance(curve[1], curve[2]) +
                                     maths::distance(curve[2], curve[3]);
        pieces_ = std::clamp(static_cast<int>(2 + std::sqrt(pen.size(bend)) * 1.3f), 2, 2 * wire_segments);
        // The curve as a polynomial in t, which is faster than bezier_point() for hundreds of wires.
        const vec2 first = (curve[1] - curve[0]) * 3, second = (curve[2] - curve[1]) * 3 - first;
        const vec2 third = curve[3] - curve[0] - first - second;
        const float step = 1 / static_cast<float>(pieces_);
        for (int i = 0; i <= pieces_; ++i) {
            const float t = static_cast<float>(i) * step;
            points_[static_cast<std::size_t>(i)] = curve[0] + (first + (second + third * t) * t) * t;
        }
    }

    void line(float width, Colour colour) const {
        const bool plain = detail_of(pen) == Detail::map;
        // Whole pixels on a map: Dear ImGui draws such lines with half the vertices.
        const float thickness = plain ? std::max(1.0f, std::round(pen.stroke(width))) : pen.stroke(width);
        std::array<ImVec2, 2 * wire_segments + 1> run;
        int count = 0;
        const auto finish = [&] {
            if (count > 1) compat::polyline(pen.list, run.data(), count, paint(colour), false, thickness);
            count = 0;
        };
        for (std::size_t i = 0; i < static_cast<std::size_t>(pieces_); ++i) {
            if (!picture_.is_visible(corner_low(points_[i], points_[i + 1]), corner_high(points_[i], points_[i + 1]))) {
                finish();
                continue;
            }
            if (count == 0) run[static_cast<std::size_t>(count++)] = pen.at(points_[i]);
            run[static_cast<std::size_t>(count++)] = pen.at(points_[i + 1]);
        }
        finish();
    }

    // Calls the visitor with points `gap` units of arc length apart and their index. Points on pieces that are not
    // visible are counted only.
    template <class Visitor>
    void along(float gap, float first, Visitor visitor) const {
        float next = first;  // from the start of the piece
        int count = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(pieces_); ++i) {
            const vec2 from = points_[i], way = points_[i + 1] - from;
            const float piece = maths::length(way);
            if (next <= piece &&
                !picture_.is_visible(corner_low(from, points_[i + 1]), corner_high(from, points_[i + 1]))) {
                const int unseen = static_cast<int>((piece - next) / gap) + 1;
                count += unseen;
                next += static_cast<float>(unseen) * gap;
            }
            for (; next <= piece; next += gap) visitor(from + way * (next / piece), count++);
            next -= piece;
        }
    }

    const Pen& pen;

private:
    const Picture& picture_;
    int pieces_;
    std::array<vec2, 2 * wire_segments + 1> points_;
};

float stroke_of(float weight) { return 1.5f + 2.6f * std::min(std::abs(weight), 2.0f); }

// The curve without its last units, which the end sign covers.
std::array<vec2, 4> shortened(std::array<vec2, 4> curve) {
    curve[3].x -= sign_size * 0.6f + pin_gap;
    return curve;
}

void dash(const Stroke& stroke, float width, Colour colour) {
    vec2 before;
    int last = -1;
    stroke.along(7, 4, [&](vec2 point, int count) {
        if (count % 2 == 1 && last == count - 1)
            stroke.pen.list.AddLine(stroke.pen.at(before), stroke.pen.at(point), paint(colour),
                                    stroke.pen.stroke(width));
        before = point;
        last = count;
    });
}

struct WireLook {
    bool selected = false, hovered = false, cut = false;
    float weight = 0;   // with the learned part
    float carried = 0;  // what the wire delivers
};

WireLook look_of(const Picture& picture, std::size_t index) {
    const WireShape& shape = picture.layout.wires[index];
    WireLook look;
    look.selected = picture.state.selection.wires.count(shape.ends) > 0;
    look.hovered = picture.state.hovered.is_wire() && picture.state.hovered.wire == shape.ends;
    if (shape.wire < 0) return look;
    const Wire& wire = picture.graph.wires[static_cast<std::size_t>(shape.wire)];
    look.cut = wire.cut;
    look.weight = wire.weight + picture.readings.learned[index];
    look.carried = picture.readings.carried[index];
    return look;
}

void draw_ghost(const Pen& pen, const Picture& picture, const WireShape& shape, const WireLook& look) {
    const Palette& p = pen.palette();
    const float alpha = picture.layout.has_neurons ? 0.30f : 0.55f;
    if (look.selected) Stroke(pen, picture, shape.bezier).line(7, p.selected.with_alpha(0.55f));
    dash(Stroke(pen, picture, shape.bezier), 1.5f,
         look.hovered || look.selected ? p.text : p.second_text.with_alpha(alpha));
}

// The signal as dots, which are brighter and larger for a stronger signal. In brains with many wires they have no rims
// and glows, because these take most of a frame's time.
void draw_dots(const Stroke& stroke, const Picture& picture, float carried, Colour colour) {
    constexpr std::size_t many_wires = 60;
    const float strength = std::min(std::abs(carried), 1.0f);
    if (strength < 0.01f) return;
    const Pen& pen = stroke.pen;
    const bool dark = picture.view.program.theme == Theme::dark, map = detail_of(pen) == Detail::map;
    const bool plain = picture.layout.wires.size() > many_wires;
    const float radius = pen.stroke(2.2f + 3.4f * std::sqrt(strength));
    const ImU32 core =
        paint(mix(colour, Colour{1, 1, 1, 1}, dark ? 0.25f + 0.6f * strength : 0).with_alpha(0.55f + 0.45f * strength));
    const ImU32 glow = paint(colour.with_alpha(0.28f * strength)), rim = paint(pen.palette().text.with_alpha(0.5f));
    stroke.along(map ? 2 * dot_gap : dot_gap, first_dot(picture.view.now->tick), [&](vec2 point, int) {
        if (!picture.is_visible(point, point)) return;
        const ImVec2 at = pen.at(point);
        if (map) return pen.list.AddRectFilled({at.x - radius, at.y - radius}, {at.x + radius, at.y + radius}, core);
        if (plain) return pen.dot(at, radius, core);
        pen.list.AddCircleFilled(at, radius * 2.1f, glow);
        pen.list.AddCircleFilled(at, radius, core);
        if (!dark) pen.list.AddCircle(at, radius, rim, 0, pen.stroke(1));  // for white ground
    });
}

void draw_wire(const Pen& pen, const Picture& picture, std::size_t index) {
    const WireShape& shape = picture.layout.wires[index];
    const WireLook look = look_of(picture, index);
    if (shape.ghost) return draw_ghost(pen, picture, shape, look);
    const Palette& p = pen.palette();
    const Colour colour = colour_of_weight(p, look.weight);
    const float strength = std::min(std::abs(look.carried), 1.0f), width = stroke_of(look.weight);
    const Stroke stroke(pen, picture, shortened(shape.bezier));
    if (look.selected) {
        stroke.line(width + 8, p.text.with_alpha(0.35f));
        stroke.line(width + 5, p.selected);
    } else if (look.hovered) {
        stroke.line(width + 6, p.text.with_alpha(0.22f));
    }
    if (look.cut) return dash(stroke, std::min(width, 2.5f), mix(p.ground, colour, 0.6f));
    if (shape.aside && !look.selected && !look.hovered) {
        const Colour pale = mix(p.ground, colour, 0.35f);
        stroke.line(1.5f, pale);
        return draw_end_sign(pen, shape.bezier[3] - vec2{pin_gap, 0}, sign_size, look.weight > 0, pale);
    }
    const bool plain = detail_of(pen) == Detail::map;
    if (!plain) stroke.line(width + 1.5f, p.ground);  // separates crossing wires
    if (!plain && strength > 0.01f) stroke.line(width + 7 * strength, colour.with_alpha(0.18f * strength));
    const float resting =
        picture.view.program.theme == Theme::dark ? 0.55f : 0.85f;  // pale lines are hard to see on white
    stroke.line(width, mix(p.ground, colour, resting + (1 - resting) * strength));
    draw_dots(stroke, picture, look.carried, colour);
    draw_end_sign(pen, shape.bezier[3] - vec2{pin_gap, 0}, sign_size + width * 0.6f, look.weight > 0, colour);
}

// The sign of a cut wire: two strokes across the label's right end.
void draw_cut(const Pen& pen, vec2 at, float size) {
    const Palette& p = pen.palette();
    for (const float side : {-1.0f, 1.0f})
        pen.list.AddLine(pen.at(at + vec2{side * size * 0.45f - size * 0.25f, size}),
                         pen.at(at + vec2{side * size * 0.45f + size * 0.25f, -size}), paint(p.warning),
                         pen.stroke(2.4f));
}

void draw_label(const Pen& pen, const Picture& picture, std::size_t index) {
    const Palette& p = pen.palette();
    const WireShape& shape = picture.layout.wires[index];
    const Wire* wire = shape.wire < 0 ? nullptr : &picture.graph.wires[static_cast<std::size_t>(shape.wire)];
    const bool cut = wire != nullptr && wire->cut, selected = picture.state.selection.wires.count(shape.ends) > 0;
    const bool hovered = picture.state.hovered.is_wire() && picture.state.hovered.wire == shape.ends;
    const Detail detail = detail_of(pen);
    const float letters = label_letters(detail);
    const vec2 extent = shape.label_size, at = shape.label;
    const float value = wire == nullptr ? 0 : wire->weight;
    if (!shape.ghost) pen.halo(at + vec2{0, 1}, extent, extent.y / 2, 4, p.shadow.with_alpha(p.shadow.a * 0.3f));
    pen.box(at, extent, extent.y / 2, shape.ghost || cut ? p.panel : p.raised);
    if (selected) pen.frame(at, extent + vec2{6, 6}, extent.y / 2 + 3, 3, p.selected);
    const float gained = wire != nullptr && learns(*wire) ? picture.readings.learned[index] : 0;
    const Colour rim = cut ? p.warning : shape.ghost ? p.line : colour_of_weight(p, value + gained);
    pen.frame(at, extent, extent.y / 2, hovered || !shape.ghost ? 2 : 1.2f, hovered ? p.text : rim);
    if (cut) draw_cut(pen, at + vec2{extent.x / 2, 0}, extent.y * 0.42f);
    std::string weight = shape.ghost ? fixed(pen.ui, 0, 2) : with_sign(pen.ui, value, 2);
    if (wire != nullptr && learns(*wire))
        weight = fixed(pen.ui, value, 2) + (gained < 0 ? " − " : " + ") + fixed(pen.ui, std::fabs(gained), 2);
    const Colour pale = picture.view.lecture ? p.text : p.second_text;
    const Colour ink = shape.ghost || cut ? pale : p.text;
    const auto name = [&] { return name_of(picture.graph, picture.layout, shape); };
    const auto put_weight = [&](vec2 place, float anchor) {
        const Rect rect = pen.text(place, letters + 2, anchor, weight, ink);
        if (picture.view.mode != Mode::wiring) pen.ui.anchors.record("weight." + name(), rect);
    };
    if (!shape.direct) return put_weight(at, 0.5f);
    const float pad = (detail == Detail::full ? 13.0f : 9.0f) * picture.layout.room.label_growth;
    pen.text(at - vec2{extent.x / 2 - pad, 0}, letters, 0, name(), pale, Face::strong);
    put_weight(at + vec2{extent.x / 2 - pad, 0}, 1);
}

bool is_marked(const Picture& picture, const WireShape& shape) {
    return picture.state.hovered.wire == shape.ends || picture.state.selection.wires.count(shape.ends) > 0;
}

}  // namespace

float first_dot(std::uint64_t tick) {
    constexpr std::uint64_t period = 44;  // ticks after which every dot is where another one was
    return 12 + std::fmod(static_cast<float>(tick % period) * dot_step, dot_gap);
}

void draw_end_sign(const Pen& pen, vec2 tip, float size, bool excites, Colour colour) {
    const float half = size / 2;
    if (excites)
        pen.list.AddTriangleFilled(pen.at(tip), pen.at(tip + vec2{-size, half}), pen.at(tip - vec2{size, half}),
                                   paint(colour));
    else
        pen.list.AddCircleFilled(pen.at(tip - vec2{half * 0.9f, 0}), pen.stroke(half * 0.9f), paint(colour));
}

void draw_wires(const Pen& pen, const Picture& picture) {
    const auto& wires = picture.layout.wires;
    enum class Layer { ghosts, aside, others };
    for (const Layer layer : {Layer::ghosts, Layer::aside, Layer::others})
        for (std::size_t i = 0; i < wires.size(); ++i) {
            const Layer own = wires[i].ghost ? Layer::ghosts : wires[i].aside ? Layer::aside : Layer::others;
            if (own == layer && picture.is_visible(wires[i].low, wires[i].high)) draw_wire(pen, picture, i);
        }
}

void draw_labels(const Pen& pen, const Picture& picture) {
    const bool all = detail_of(pen) != Detail::map;
    for (std::size_t i = 0; i < picture.layout.wires.size(); ++i) {
        const WireShape& shape = picture.layout.wires[i];
        const vec2 half = shape.label_size / 2;
        if (shape.label_size.x <= 0) continue;
        if ((all || is_marked(picture, shape)) && picture.is_visible(shape.label - half, shape.label + half))
            draw_label(pen, picture, i);
    }
}

}  // namespace braitenlab::wiring

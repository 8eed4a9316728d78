// What stands on the cards.
#include <algorithm>
#include <cmath>

#include "core/maths/portable.h"
#include "ui/imgui_compat.h"
#include "ui/theme.h"
#include "ui/wiring/draw.h"

namespace braitenlab {

using maths::vec2;

void draw_eye(const Pen& pen, vec2 c, float value, bool covered) {
    const Palette& p = pen.palette();
    const auto almond = [&] {
        pen.list.PathLineTo(pen.at(c - vec2{21, 0}));
        pen.list.PathBezierQuadraticCurveTo(pen.at(c - vec2{0, 25}), pen.at(c + vec2{21, 0}), 20);
        pen.list.PathBezierQuadraticCurveTo(pen.at(c + vec2{0, 25}), pen.at(c - vec2{21, 0}), 20);
    };
    almond();
    pen.list.PathFillConvex(paint(mix(p.wheel, p.raised, 0.15f)));
    const float seen = std::clamp(value, 0.0f, 1.0f);
    pen.list.AddCircleFilled(pen.at(c), pen.size(11), paint(p.chassis.with_alpha(0.35f)));
    if (seen > 0.005f) pen.list.AddCircleFilled(pen.at(c), pen.size(3 + 8 * seen), paint(mix(p.excites, p.lamp, seen)));
    pen.list.AddCircleFilled(pen.at(c), pen.size(2.5f), paint(p.wheel));
    if (covered) {  // a closed lid
        almond();
        pen.list.PathFillConvex(paint(mix(p.wheel, p.raised, 0.6f)));
        pen.list.AddLine(pen.at(c - vec2{21, 0}), pen.at(c + vec2{21, 0}), paint(p.warning), pen.stroke(2.4f));
    }
    almond();
    pen.list.PathStroke(paint(p.second_text), 0, pen.stroke(1.8f));
}

void draw_wheel(const Pen& pen, vec2 c, float angle, float value, bool stopped) {
    const Palette& p = pen.palette();
    constexpr float radius = 20;
    pen.list.AddCircleFilled(pen.at(c), pen.size(radius), paint(p.wheel), 40);
    pen.list.AddCircleFilled(pen.at(c), pen.size(radius - 5), paint(mix(p.panel, p.chassis, 0.35f)), 40);
    for (int spoke = 0; spoke < 3; ++spoke) {
        const float turn = -angle + static_cast<float>(spoke) * maths::pi / 3;
        const vec2 out{maths::cosine(turn) * (radius - 5), maths::sine(turn) * (radius - 5)};
        pen.list.AddLine(pen.at(c - out), pen.at(c + out), paint(p.wheel), pen.stroke(2.2f));
    }
    pen.list.AddCircleFilled(pen.at(c), pen.size(5), paint(value == 0 ? p.second_text : colour_of_weight(p, value)));
    pen.list.AddCircle(pen.at(c), pen.size(radius), paint(p.second_text), 40, pen.stroke(1.5f));
    if (stopped)  // a brake block across it
        pen.list.AddLine(pen.at(c + vec2{-14, 14}), pen.at(c + vec2{14, -14}), paint(p.warning), pen.stroke(4));
}

void draw_response(const Pen& pen, vec2 c, const Curve& curve, float value) {
    const Palette& p = pen.palette();
    constexpr float half = 17;
    pen.box(c, {2 * half + 6, 2 * half + 6}, 8, mix(p.panel, p.ground, 0.6f));
    pen.list.AddLine(pen.at(c - vec2{half, 0}), pen.at(c + vec2{half, 0}), paint(p.line), pen.stroke(1));
    pen.list.AddLine(pen.at(c - vec2{0, half}), pen.at(c + vec2{0, half}), paint(p.line), pen.stroke(1));
    constexpr int pieces = 24;
    ImVec2 points[pieces + 1];
    for (int i = 0; i <= pieces; ++i) {
        const float x = 2 * static_cast<float>(i) / pieces - 1;
        points[i] = pen.at(c + vec2{x, -std::clamp(respond(curve, x), -1.0f, 1.0f)} * half);
    }
    compat::polyline(pen.list, points, pieces + 1, paint(p.text), false, pen.stroke(2));
    const float height = std::clamp(value, -1.0f, 1.0f);
    pen.list.AddCircleFilled(pen.at(c + vec2{half, -height * half}), pen.size(3.5f), paint(colour_of_weight(p, value)));
}

// Rightwards what drives, leftwards what holds back. A sensor has no negative side.
void draw_bar(const Pen& pen, vec2 left, float width, float value, bool both_sides) {
    const Palette& p = pen.palette();
    const vec2 middle = left + vec2{width / 2, 0};
    pen.box(middle, {width, 7}, 3.5f, mix(p.ground, p.line, 0.7f));
    const float room = both_sides ? width / 2 : width;
    const float length = std::clamp(value, both_sides ? -1.0f : 0.0f, 1.0f) * room;
    const vec2 zero = both_sides ? middle : left;
    if (std::abs(length) > 0.5f)
        pen.box(zero + vec2{length / 2, 0}, {std::abs(length), 7}, 3.5f, colour_of_weight(p, value));
    if (both_sides)
        pen.list.AddLine(pen.at(middle - vec2{0, 6}), pen.at(middle + vec2{0, 6}), paint(p.second_text),
                         pen.stroke(1.5f));
}

void draw_pin(const Pen& pen, vec2 at, float spread, bool hovered, bool inviting, bool out) {
    const Palette& p = pen.palette();
    const float radius = hovered ? 9.5f : 7.5f;
    const vec2 extent{2 * radius, 2 * radius + spread};
    if (hovered || inviting)
        pen.halo(at, extent, radius, hovered ? 8 : 5, p.accent.with_alpha(hovered ? 0.45f : 0.28f));
    pen.box(at, extent, radius, out ? p.text : p.panel);
    pen.frame(at, extent, radius, 2.2f, hovered || inviting ? p.accent : p.text);
    if (out) pen.box(at, {5, 5}, 2.5f, p.panel);
}

}  // namespace braitenlab

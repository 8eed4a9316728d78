#include "ui/panels/brain/brain_sketch.h"

#include <algorithm>
#include <cmath>

#include "ui/imgui_compat.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"

namespace braitenlab::ui::sketch {

namespace {

constexpr int wire_pieces = 24;

ImVec2 bezier(const WirePath& p, float t) {
    const float u = 1 - t, a = u * u * u, b = 3 * u * u * t, c = 3 * u * t * t, d = t * t * t;
    return {a * p[0].x + b * p[1].x + c * p[2].x + d * p[3].x, a * p[0].y + b * p[1].y + c * p[2].y + d * p[3].y};
}

void stretch(const WirePath& p, float from, float to, ImU32 colour, float width) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const int count = std::max(1, static_cast<int>(std::lround((to - from) * wire_pieces)));
    draw.PathClear();
    for (int i = 0; i <= count; ++i)
        draw.PathLineTo(bezier(p, from + (to - from) * static_cast<float>(i) / static_cast<float>(count)));
    draw.PathStroke(colour, 0, width);
}

void dashes(const WirePath& p, ImU32 colour, float width) {
    for (int i = 0; i < wire_pieces; i += 2)
        stretch(p, static_cast<float>(i) / wire_pieces, static_cast<float>(i + 1) / wire_pieces, colour, width);
}

// ✕: the sign of a lesion.
void lesion_cross(const Ui& ui, ImVec2 c, float reach, Colour colour) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    for (const float s : {-1.0f, 1.0f}) {
        draw.AddLine({c.x - reach, c.y - s * reach}, {c.x + reach, c.y + s * reach}, paint(ui.palette.panel), ui.px(5));
        draw.AddLine({c.x - reach, c.y - s * reach}, {c.x + reach, c.y + s * reach}, paint(colour), ui.px(2));
    }
}

// At the end of the path, in its direction.
void end_sign(const Ui& ui, const WirePath& p, const WireLook& look, float width, Colour colour) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 to = p[3];
    const maths::vec2 along = maths::normalise(maths::vec2{to.x - p[2].x, to.y - p[2].y});
    const float size = look.thin ? 0.6f : 1.0f;
    if (look.weight > 0) {
        const float r = size * ui.px(5) + width / 3;
        const ImVec2 back{to.x - along.x * r, to.y - along.y * r}, across{along.y * r, -along.x * r};
        draw.AddTriangleFilled({back.x + across.x, back.y + across.y}, {back.x - across.x, back.y - across.y},
                               {to.x + along.x * r * 0.7f, to.y + along.y * r * 0.7f}, paint(colour));
    } else {
        draw.AddCircleFilled({to.x - along.x * ui.px(1), to.y - along.y * ui.px(1)}, size * ui.px(4) + width / 3,
                             paint(colour));
    }
}

}  // namespace

WirePath path(ImVec2 from, ImVec2 to) {
    const float bend = (to.y - from.y) * 0.45f;
    return {from, {from.x, from.y + bend}, {to.x, to.y - bend}, to};
}

float distance(const WirePath& p, ImVec2 point) {
    float nearest = 1e9f;
    for (int i = 0; i <= wire_pieces; ++i) {
        const ImVec2 on = bezier(p, static_cast<float>(i) / wire_pieces);
        nearest = std::min(nearest, std::hypot(on.x - point.x, on.y - point.y));
    }
    return nearest;
}

void wire(const Ui& ui, const WirePath& p, const WireLook& look) {
    if (std::fabs(look.weight) < 0.005f) return dashes(p, paint(ui.palette.second_text.with_alpha(0.55f)), ui.px(1));
    const Colour colour = colour_of_weight(ui.palette, look.weight);
    const float strength = std::min(1.0f, std::fabs(look.carried));
    const float slope = look.thin ? 0.8f : 1.6f;
    const float width = ui.px(1.5f + slope * std::min(2.0f, std::fabs(look.weight)) + (look.warm ? 1.0f : 0.0f));
    if (look.cut) {
        const Colour dead = mix(colour, ui.palette.second_text, 0.6f);
        stretch(p, 0, 0.36f, paint(dead), width);
        stretch(p, 0.64f, 1, paint(dead.with_alpha(0.5f)), width);
        end_sign(ui, p, look, width, dead);
        return lesion_cross(ui, bezier(p, 0.5f), ui.px(5), ui.palette.text);
    }
    if (strength > 0.01f) stretch(p, 0, 1, paint(colour.with_alpha(0.28f * strength)), width + ui.px(7) * strength);
    stretch(p, 0, 1, paint(colour.with_alpha(0.40f + 0.60f * (look.warm ? 1 : strength))), width);
    end_sign(ui, p, look, width, colour);
}

void eye(const Ui& ui, ImVec2 c, float radius, float reading, bool silenced, float warmth) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const Palette& p = ui.palette;
    const float r = ui.px(radius + warmth);
    if (silenced) {
        draw.AddCircleFilled(c, r, paint(p.wheel));
        draw.AddCircle(c, r, paint(p.text), 0, ui.px(1.5f));
        return lesion_cross(ui, c, 0.6f * r, p.text);
    }
    if (reading > 0.01f) draw.AddCircleFilled(c, r + ui.px(6) * reading, paint(p.lamp.with_alpha(0.30f * reading)));
    draw.AddCircleFilled(c, r, paint(mix(p.wheel, p.lamp, std::sqrt(std::clamp(reading, 0.0f, 1.0f)))));
    draw.AddCircle(c, r, paint(mix(p.second_text, p.text, warmth)), 0, ui.px(1.5f));
}

void neuron(const Ui& ui, ImVec2 c, float radius, float value, bool silenced, float warmth) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const Palette& p = ui.palette;
    const float r = radius + ui.px(warmth), strength = std::min(1.0f, std::fabs(value));
    const Colour colour = colour_of_weight(p, value);
    if (!silenced && strength > 0.01f)
        draw.AddCircleFilled(c, r + ui.px(5) * strength, paint(colour.with_alpha(0.30f * strength)));
    draw.AddCircleFilled(c, r, paint(silenced ? p.wheel : mix(p.panel, colour, strength)));
    draw.AddCircle(c, r, paint(mix(p.second_text, p.text, warmth)), 0, ui.px(1.5f));
    if (silenced) lesion_cross(ui, c, 0.6f * r, p.text);
}

void wheel(const Ui& ui, ImVec2 c, float outward, float motor, float angle, bool stopped, float warmth) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float w = ui.px(8), h = ui.px(22);
    const ImVec2 low{c.x - w, c.y - h}, high{c.x + w, c.y + h};
    draw.AddRectFilled(low, high, paint(ui.palette.wheel), ui.px(radius::box));
    draw.PushClipRect(low, high, true);
    const float spacing = ui.px(9), phase = std::fmod(std::fmod(angle * 0.20f * ui.px(60), spacing) + spacing, spacing);
    for (float y = low.y - phase + spacing; y < high.y + spacing; y += spacing)
        draw.AddLine({low.x + ui.px(3), y}, {high.x - ui.px(3), y}, paint(ui.palette.second_text.with_alpha(0.7f)),
                     ui.px(1.5f));
    draw.PopClipRect();
    compat::outline(draw, low, high, paint(mix(ui.palette.second_text, ui.palette.text, warmth)), ui.px(radius::box),
                    ui.px(1));
    if (stopped) return lesion_cross(ui, c, ui.px(6), ui.palette.text);
    const float reach = ui.px(15) * std::clamp(motor, -1.0f, 1.0f), x = c.x + outward * ui.px(18);
    if (std::fabs(reach) < 1) return;
    const ImU32 colour = paint(ui.palette.text);
    const float tip = c.y - reach, back = reach > 0 ? 1.0f : -1.0f;
    draw.AddLine({x, c.y}, {x, tip + back * ui.px(4)}, colour, ui.px(2.5f));
    draw.AddTriangleFilled({x, tip - back * ui.px(2)}, {x - ui.px(5), tip + back * ui.px(5)},
                           {x + ui.px(5), tip + back * ui.px(5)}, colour);
}

void number(const Ui& ui, ImVec2 at, bool left, std::string_view letters, const std::string& value) {
    const float h = line_height(ui, Face::small);
    const auto line = [&](float y, std::string_view words, Colour colour) {
        if (left)
            put_right(ui, {at.x, y}, words, colour, Face::small);
        else
            put(ui, {at.x, y}, words, colour, Face::small);
    };
    line(at.y - h, letters, ui.palette.second_text);
    line(at.y, value, ui.palette.text);
}

}  // namespace braitenlab::ui::sketch

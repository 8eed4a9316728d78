// The two-eyed brain seen from above, nose up, with this moment's signals on its wires.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <imgui.h>

#include "core/brain/four_neurons.h"
#include "ui/imgui_compat.h"
#include "ui/panels/panels.h"
#include "ui/strings.h"
#include "ui/theme.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"

namespace braitenlab {

namespace {

struct Place {
    ImVec2 eye[2], wheel[2];  // left, right
    Rect chassis;
};

Place place(const Ui& ui, ImVec2 at, float width, float picture_height) {
    Place p;
    const float middle = at.x + width / 2, half = ui.px(50);
    p.chassis = {middle - half, at.y + ui.px(12), 2 * half, ui.px(picture_height - 24)};
    for (int side = 0; side < 2; ++side) {
        const float s = side == 0 ? -1.0f : 1.0f;
        p.eye[side] = {middle + s * ui.px(30), at.y + ui.px(16)};
        p.wheel[side] = {middle + s * ui.px(54), at.y + ui.px(picture_height - 32)};
    }
    return p;
}

ImVec2 bezier(const std::array<ImVec2, 4>& p, float t) {
    const float u = 1 - t, a = u * u * u, b = 3 * u * u * t, c = 3 * u * t * t, d = t * t * t;
    return {a * p[0].x + b * p[1].x + c * p[2].x + d * p[3].x, a * p[0].y + b * p[1].y + c * p[2].y + d * p[3].y};
}

// A wire: as wide as its weight, dashed where it has none, glowing with what it carries; ▶ excites, ● inhibits.
void wire(const Ui& ui, ImVec2 from, ImVec2 to, float weight, float carried) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float bend = (to.y - from.y) * 0.45f;
    const std::array<ImVec2, 4> p{{from, {from.x, from.y + bend}, {to.x, to.y - bend}, to}};
    constexpr int pieces = 24;
    if (std::fabs(weight) < 0.005f) {
        for (int i = 0; i < pieces; i += 2)
            draw.AddLine(bezier(p, static_cast<float>(i) / pieces), bezier(p, static_cast<float>(i + 1) / pieces),
                         paint(ui.palette.second_text.with_alpha(0.55f)), ui.px(1));
        return;
    }
    const Colour colour = colour_of_weight(ui.palette, weight);
    const float strength = std::min(1.0f, std::fabs(carried)),
                width = ui.px(1.5f + 1.6f * std::min(2.0f, std::fabs(weight)));
    if (strength > 0.01f)
        draw.AddBezierCubic(p[0], p[1], p[2], p[3], paint(colour.with_alpha(0.28f * strength)),
                            width + ui.px(7) * strength, pieces);
    draw.AddBezierCubic(p[0], p[1], p[2], p[3], paint(colour.with_alpha(0.40f + 0.60f * strength)), width, pieces);
    const ImU32 solid = paint(colour);
    if (weight > 0) {
        const float r = ui.px(5) + width / 3;
        draw.AddTriangleFilled({to.x - r, to.y - r}, {to.x + r, to.y - r}, {to.x, to.y + r * 0.7f}, solid);
    } else {
        draw.AddCircleFilled({to.x, to.y - ui.px(1)}, ui.px(4) + width / 3, solid);
    }
}

void eye(const Ui& ui, ImVec2 c, float reading) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float r = ui.px(9);
    if (reading > 0.01f)
        draw.AddCircleFilled(c, r + ui.px(6) * reading, paint(ui.palette.lamp.with_alpha(0.30f * reading)));
    draw.AddCircleFilled(c, r,
                         paint(mix(ui.palette.wheel, ui.palette.lamp, std::sqrt(std::clamp(reading, 0.0f, 1.0f)))));
    draw.AddCircle(c, r, paint(ui.palette.second_text), 0, ui.px(1.5f));
}

// The tread runs as the wheel turns; an arrow beside it says how hard and which way.
void wheel(const Ui& ui, ImVec2 c, float motor, float angle) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float w = ui.px(8), h = ui.px(22);
    const ImVec2 low{c.x - w, c.y - h}, high{c.x + w, c.y + h};
    draw.AddRectFilled(low, high, paint(ui.palette.wheel), ui.px(4));
    draw.PushClipRect(low, high, true);
    const float spacing = ui.px(9), phase = std::fmod(std::fmod(angle * 0.16f * ui.px(60), spacing) + spacing, spacing);
    for (float y = low.y - phase + spacing; y < high.y + spacing; y += spacing)
        draw.AddLine({low.x + ui.px(3), y}, {high.x - ui.px(3), y}, paint(ui.palette.second_text.with_alpha(0.7f)),
                     ui.px(1.5f));
    draw.PopClipRect();
    compat::outline(draw, low, high, paint(ui.palette.second_text), ui.px(4), ui.px(1));
    const float reach = h * std::clamp(motor, -1.0f, 1.0f);
    const float x = c.x + (c.x < ImGui::GetWindowPos().x + ImGui::GetWindowWidth() / 2 ? -1.0f : 1.0f) * ui.px(18);
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

float reading(const LabView& view, const VehicleView& vehicle, const BrainGraph& brain, const char* node) {
    const Node* found = find_node(brain, std::string(node));
    return found ? node_value(*view.now, vehicle, found->id) : 0;
}

}  // namespace

void brain_picture(const LabView& view, Ui& ui, const VehicleView& vehicle, float picture_height) {
    const BrainGraph& brain = *view.now->brains[static_cast<std::size_t>(vehicle.brain)];
    const FourNeurons dials = read_dials(brain);
    const float width = card_width(ui);
    const Item area = item(ui, "brain.picture", {width, ui.px(picture_height)}, false);
    const Place p = place(ui, {area.rect.x, area.rect.y}, width, picture_height);
    fill_box(ui, area.rect, ui.palette.ground.with_alpha(0.45f));
    fill_box(ui, p.chassis, mix(ui.palette.panel, ui.palette.chassis, 0.22f), 12);
    line_box(ui, p.chassis, colour_of(ui.palette, vehicle.role), 12, 1.5f);

    const std::array<float, 2>& motors = vehicle.motor;
    const float seen[2]{reading(view, vehicle, brain, "SL"), reading(view, vehicle, brain, "SR")};
    const auto carried = [&](const char* eye_name, const char* motor, float value) {
        const Node* from = find_node(brain, std::string(eye_name));
        const Node* to = find_node(brain, std::string(motor));
        const Wire* found = from && to ? find_wire(brain, from->id, to->id) : nullptr;
        return found ? signal(*found, value) : 0.0f;
    };
    // Wires end above the wheels, the straight ones further out, so that their end signs stand side by side.
    const auto end = [&](int side, bool straight) {
        const float inward = side == 0 ? 1.0f : -1.0f;
        return ImVec2{p.wheel[side].x + inward * ui.px(straight ? 17 : 31), p.wheel[side].y - ui.px(2)};
    };
    const auto begin = [&](int side) { return ImVec2{p.eye[side].x, p.eye[side].y + ui.px(9)}; };
    wire(ui, begin(1), end(0, false), dials.LR, carried("SR", "ML", seen[1]));
    wire(ui, begin(0), end(1, false), dials.RL, carried("SL", "MR", seen[0]));
    wire(ui, begin(0), end(0, true), dials.LL, carried("SL", "ML", seen[0]));
    wire(ui, begin(1), end(1, true), dials.RR, carried("SR", "MR", seen[1]));
    for (int side = 0; side < 2; ++side) {
        const auto s = static_cast<std::size_t>(side);
        eye(ui, p.eye[side], seen[side]);
        wheel(ui, p.wheel[side], motors[s], vehicle.wheel_angle[s]);
        const float out = side == 0 ? -1.0f : 1.0f;
        number(ui, {p.eye[side].x + out * ui.px(44), p.eye[side].y + ui.px(6)}, side == 0, side == 0 ? "SL" : "SR",
               fixed(seen[side], 2));
        number(ui, {p.wheel[side].x + out * ui.px(32), p.wheel[side].y + ui.px(4)}, side == 0, side == 0 ? "ML" : "MR",
               with_sign(motors[s], 2));
    }
    tooltip(ui, area, ui.strings("brain.picture"));
}

}  // namespace braitenlab

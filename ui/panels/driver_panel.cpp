// Who drives the selected vehicle where it is not its brain; a stick to drive it by hand.
#include <algorithm>
#include <cmath>
#include <string>

#include <imgui.h>

#include "core/scene/names.h"
#include "ui/panels/panels.h"
#include "ui/steering.h"
#include "ui/strings.h"
#include "ui/theme.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"

namespace braitenlab {

namespace {

constexpr float stick_size = 88;  // layout pixels

struct Push {
    float right = 0, ahead = 0;  // −1..1
};

// How the wheels are told to turn, as a stick that would tell them so.
Push push_of(const VehicleView& vehicle) {
    return {std::clamp(vehicle.motor[0] - vehicle.motor[1], -1.0f, 1.0f),
            std::clamp((vehicle.motor[0] + vehicle.motor[1]) / 2, -1.0f, 1.0f)};
}

Push under_pointer(const Item& at) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const float reach = at.rect.w / 2;
    return {std::clamp((mouse.x - at.middle_x()) / reach, -1.0f, 1.0f),
            std::clamp((at.middle_y() - mouse.y) / reach, -1.0f, 1.0f)};
}

void draw_stick(const Ui& ui, const Item& at, Push push) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const Palette& p = ui.palette;
    fill_box(ui, at.rect, p.ground.with_alpha(0.45f), 10);
    line_box(ui, at.rect, p.line, 10);
    const ImVec2 middle{at.middle_x(), at.middle_y()};
    const float reach = at.rect.w / 2 - ui.px(16), edge = at.rect.w / 2 - ui.px(8), half = ui.px(4);
    for (const ImVec2 to : {ImVec2{0, -1}, ImVec2{0, 1}, ImVec2{-1, 0}, ImVec2{1, 0}}) {
        const ImVec2 tip{middle.x + to.x * edge, middle.y + to.y * edge}, across{to.y * half, to.x * half};
        const ImVec2 foot{tip.x - to.x * half, tip.y - to.y * half};
        draw.AddTriangleFilled(tip, {foot.x + across.x, foot.y + across.y}, {foot.x - across.x, foot.y - across.y},
                               paint(p.second_text));
    }
    const ImVec2 knob{middle.x + push.right * reach, middle.y - push.ahead * reach};
    draw.AddLine(middle, knob, paint(p.second_text), ui.px(3));
    draw.AddCircleFilled(knob, ui.px(11), paint(mix(p.raised, p.accent, 0.25f + 0.5f * at.warmth)));
    draw.AddCircle(knob, ui.px(11), paint(p.accent), 0, ui.px(1.5f));
}

// Held, it steers; let go, it springs back.
void stick(PanelState& state, Ui& ui, const VehicleView& vehicle) {
    const Item at = item(ui, "drive.stick", {ui.px(stick_size), ui.px(stick_size)});
    Push push = push_of(vehicle);
    if (at.held) {
        push = under_pointer(at);
        const Steer wanted = steer(vehicle.id, push.right, push.ahead);
        if (wanted != state.steered) ui.outbox.push_back(EditRequest{wanted});
        state.steered = wanted;
    } else if (state.stick_held) {
        state.steered = steer(vehicle.id, 0, 0);
        ui.outbox.push_back(EditRequest{state.steered});
    }
    state.stick_held = at.held;
    draw_stick(ui, at, push);
    tooltip(ui, at, ui.strings("drive.stick"));
}

// To the right of the stick: who drives, and the way back to the brain.
void words_and_button(PanelState& state, Ui& ui, const VehicleView& vehicle, float width) {
    ImGui::BeginGroup();
    const std::string key = "drive." + std::string(word(vehicle.driver));
    paragraph(ui, ui.strings(key), ui.palette.text, Face::small, width);
    const SmallButton back{"drive.back", icon::wiring, ui.strings("drive.back")};
    const Item at = small_button(ui, back);
    tooltip(ui, at, ui.strings("tooltip.drive_back"));
    if (at.pressed)
        ui.outbox.push_back(
            EditRequest{ChooseDriver{vehicle.id, Driver::brain}, gestures::panels + ++state.sliders.gesture});
    ImGui::EndGroup();
}

}  // namespace

void driver_panel(PanelState& state, Ui& ui, const VehicleView& vehicle) {
    float width = card_width(ui);
    if (vehicle.driver == Driver::manual) {
        stick(state, ui, vehicle);
        ImGui::SameLine(0, ui.px(12));
        width -= ui.px(stick_size + 12);
    }
    words_and_button(state, ui, vehicle, width);
}

}  // namespace braitenlab

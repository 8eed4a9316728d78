#include "ui/wiring/number_sheet.h"

#include <algorithm>
#include <string>

#include <imgui.h>

#include "ui/strings.h"
#include "ui/theme.h"
#include "ui/widgets/button.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"
#include "ui/wiring/curve_plot.h"
#include "ui/wiring/menu.h"

namespace braitenlab {
namespace {

constexpr float plot_side = 104, kind_width = 44, kind_height = 30, space = 16;  // layout pixels
constexpr std::size_t curve_columns = 3;
constexpr float curves_width = static_cast<float>(curve_columns) * kind_width + 8, room_for_plot = 680;

bool curve_button(Ui& ui, std::size_t index, const Curve& curve) {
    const Item at = item(ui, "inspector.kind." + std::to_string(index + 1), {ui.px(kind_width), ui.px(kind_height)});
    const Palette& p = ui.palette;
    const Response response = responses[index].value;
    const bool on = curve.response == response;
    fill_box(ui, at.rect, on ? mix(p.panel, p.accent, 0.20f) : mix(p.raised, p.line, at.warmth * 0.6f));
    line_box(ui, at.rect, on ? p.accent : p.line);
    const float inset = ui.px(6);
    draw_curve_sign(*ImGui::GetWindowDrawList(), ui,
                    {at.rect.x + inset, at.rect.y + inset, at.rect.w - 2 * inset, at.rect.h - 2 * inset}, {response},
                    on ? p.text : p.second_text);
    tooltip(ui, at, ui.strings(kind_key(index)));
    return at.pressed && !on;
}

// As wide as the longest word that may stand before a slider here; layout pixels.
float widest_words(const Ui& ui) {
    float widest = 0;
    for (const char* key :
         {"inspector.weight", "inspector.threshold", "inspector.bias", "inspector.memory", "inspector.peak",
          "inspector.middle", "inspector.step_at", "inspector.width", "inspector.learning", "inspector.decay"})
        widest = std::max(widest, text_width(ui, Face::text, ui.strings(key)) / ui.scale + 8);
    return widest;
}

}  // namespace

NumberSheet::NumberSheet(Inspected& in, Curve& curve, const SheetHead& head)
    : in_(in),
      plots_(ImGui::GetContentRegionAvail().x > in.ui.px(room_for_plot)),
      start_(ImGui::GetCursorPosX()),
      words_width_(widest_words(in.ui)) {
    slider_width_ = (room_for_sliders() - in.ui.px(space)) / 2;
    if (plots_) plot(curve, head.input);
    choose_curve(curve, head);
    ImGui::BeginGroup();
}

NumberSheet::~NumberSheet() {
    if (sliders_ == 0) ImGui::Dummy({1, 1});
    ImGui::EndGroup();
}

float NumberSheet::room_for_sliders() const {
    const float taken = (plots_ ? plot_side + space : 0) + curves_width + space;
    return ImGui::GetContentRegionAvail().x + ImGui::GetCursorPosX() - start_ - in_.ui.px(taken + 12);
}

void NumberSheet::plot(const Curve& curve, float input) {
    Ui& ui = in_.ui;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Item area = item(ui, "inspector.plot", {ui.px(plot_side), ui.px(plot_side)}, false);
    draw_plot(*ImGui::GetWindowDrawList(), ui, plot_of(curve, {at.x, at.y, area.rect.w, area.rect.h}), curve,
              maths::vec2{input, respond(curve, input)});
    tooltip(ui, area, in_.words("inspector.plot_how"));
    ImGui::SameLine(0, ui.px(space));
}

void NumberSheet::choose_curve(Curve& curve, const SheetHead& head) {
    Ui& ui = in_.ui;
    ImGui::BeginGroup();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(4), ui.px(4)});
    for (std::size_t i = 0; i < responses.size(); ++i) {
        if (i % curve_columns != 0) ImGui::SameLine();
        if (!curve_button(ui, i, curve)) continue;
        curve.response = responses[i].value;
        gesture_ = in_.state.next_gesture++;
    }
    lesion_button(in_, head.hurt, head.hurt_words);
    ImGui::PopStyleVar();
    ImGui::EndGroup();
    ImGui::SameLine(0, ui.px(space));
}

void NumberSheet::number(const Number& n, float& value) {
    if (sliders_++ % 2 == 1) ImGui::SameLine(0, in_.ui.px(space));
    const std::string id(n.id);
    SliderLook look;
    look.words = in_.words(n.words);
    look.tooltip = in_.words(n.tooltip);
    look.low = n.low;
    look.high = in_.sliders.typed == id ? n.typed_high : n.high;
    look.signed_number = look.meaning = n.is_signed;
    look.words_width = words_width_;
    const auto edit = slider(in_.ui, in_.sliders, id, value, slider_width_, in_.view.wall_seconds, look);
    if (edit) value = edit->value, gesture_ = edit->gesture;
}

void NumberSheet::curve_numbers(Curve& curve, bool masks) {
    const PeakWords words = peak_words(curve.response, masks);
    if (traits(curve.response).has_peak)
        number({"inspector.peak", words.words, words.tooltip, -2, 2, 2, true}, curve.peak);
    if (traits(curve.response).has_width)
        number({"inspector.width", "inspector.width", "inspector.width_how", 0.01f, 2, 10}, curve.width);
}

float sheet_height() {
    constexpr auto rows = static_cast<float>((responses.size() + curve_columns - 1) / curve_columns);
    return 92 + rows * (kind_height + 4);
}

PeakWords peak_words(Response response, bool masks) {
    if (response == Response::step) return {masks ? "inspector.step_at" : "inspector.threshold", "inspector.step_how"};
    if (response == Response::sigmoid) return {"inspector.middle", "inspector.middle_how"};
    return {"inspector.peak", "inspector.peak_how"};
}

void lesion_button(Inspected& in, bool hurt, std::string_view hurt_words) {
    ButtonLook look{{}, in.words(hurt ? "wiring.do.heal" : hurt_words)};
    look.on = hurt;
    look.min_width = curves_width;
    const Item at = button(in.ui, "inspector.lesion", look);
    tooltip(in.ui, at, in.words("inspector.lesion_how"));
    if (!at.pressed) return;
    in.state.hovered = {};  // it is for what is selected, wherever the pointer rests meanwhile
    in.state.keys.push_back(Action::lesion);
}

}  // namespace braitenlab

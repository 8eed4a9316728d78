#include "ui/widgets/slider.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "ui/imgui_compat.h"
#include "ui/widgets/item.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr float knob_radius = 7;
constexpr float zero_reach = 3;      // layout pixels; a drag without Shift snaps to 0 within this distance
constexpr int most_decimals = 4;     // shown
constexpr double gesture_pause = 1;  // seconds without a key end a gesture

struct SliderTrack {
    float x0, x1, y, low, high;
    float knee = 0;  // of a wide track; 0: linear
    float bent(float value) const { return knee > 0 ? std::asinh(value / knee) : value; }
    float at(float value) const {
        return x0 + (x1 - x0) * (bent(std::clamp(value, low, high)) - bent(low)) / (bent(high) - bent(low));
    }
    float value_at(float x) const {
        const float along = bent(low) + (x - x0) / (x1 - x0) * (bent(high) - bent(low));
        return knee > 0 ? knee * std::sinh(along) : along;
    }
};

float rounded_to(float value, float step) {
    if (step >= 1) return std::round(value / step) * step;
    const float per_unit = std::round(1 / step);  // exact, so that 0.3 is the float nearest to 0.3
    return std::round(value * per_unit) / per_unit;
}

// The step of mouse and arrow keys at this value: on a wide track a hundredth to a thousandth of it.
float step_at(float value, const SliderLook& look) {
    if (!look.wide || value == 0) return look.step;
    return std::max(look.step, std::pow(10.0f, std::floor(std::log10(std::fabs(value))) - 2));
}

std::string without_trailing_zeros(std::string number, char decimal_mark) {
    if (number.find(decimal_mark) == std::string::npos) return number;
    number.erase(number.find_last_not_of('0') + 1);
    if (number.back() == decimal_mark) number.pop_back();
    return number;
}

bool rounds_to_zero(float value, int decimals) {
    return std::fabs(value) * std::pow(10.0f, static_cast<float>(decimals)) < 0.5f;
}

int shown_decimals(float value, const SliderLook& look) {
    return look.whole ? 0 : decimals_of(value, look.decimals, most_decimals);
}

std::string slider_text(const Ui& ui, float value, const SliderLook& look) {
    const int decimals = shown_decimals(value, look);
    std::string number = look.signed_number ? with_sign(ui, value, decimals) : fixed(ui, value, decimals);
    return look.trimmed ? without_trailing_zeros(std::move(number), ui.decimal_mark) : number;
}

// Clamped, with −0 made 0. Precondition: finite.
float valid_value(float value, const SliderLook& look) {
    return std::clamp(look.whole ? std::round(value) : value, look.low, look.high) + 0.0f;
}

std::optional<float> drag_knob(const Ui& ui, SliderState& state, const Item& at, const SliderTrack& track,
                               std::string_view id, float value, const SliderLook& look) {
    if (!at.held) {
        if (state.dragged == id) state.dragged.clear();
        return std::nullopt;
    }
    const ImGuiIO& io = ImGui::GetIO();
    const float reach = at.rect.h / 2;
    if (state.dragged != id) {
        const bool on_track = io.MousePos.x > track.x0 - reach && io.MousePos.x < track.x1 + reach;
        if (!ImGui::IsMouseClicked(0) || !on_track) return std::nullopt;
        state.dragged = id;
        ++state.gesture;
        state.asked = state.pressed_at = value;
        state.pressed = id;
        const bool on_knob = std::fabs(io.MousePos.x - track.at(value)) <= ui.px(knob_radius + 3);
        state.grip = on_knob ? track.at(value) - io.MousePos.x : 0;
        if (on_knob) return std::nullopt;
    } else if (io.MouseDelta.x == 0) {
        return std::nullopt;
    }
    if (io.KeyShift) {  // ten times finer: the knob lags behind the pointer
        state.grip -= 0.9f * io.MouseDelta.x;
        const float fine = track.value_at(io.MousePos.x + state.grip);
        return rounded_to(fine, step_at(fine, look));
    }
    const float wanted = track.value_at(io.MousePos.x + state.grip);
    const bool meets_zero = track.low < 0 && std::fabs(track.at(wanted) - track.at(0)) <= ui.px(zero_reach);
    return meets_zero ? 0 : rounded_to(wanted, look.wide ? step_at(wanted, look) : look.mouse * look.step);
}

std::optional<float> nudge_knob(Ui& ui, SliderState& state, const Item& at, std::string_view id, float value,
                                double now, const SliderLook& look) {
    if (!at.focused) return std::nullopt;
    float change = 0;
    for (const int direction : {-1, 1})
        while (const auto press = take(*ui.keyboard, direction < 0 ? key::left : key::right))
            change += static_cast<float>(direction) * step_at(value, look) * (press->shift ? 1 : look.nudge);
    if (change == 0) return std::nullopt;
    if (state.nudged != id || now - state.nudged_at > gesture_pause) ++state.gesture;
    state.nudged = id;
    state.nudged_at = now;
    return rounded_to(value + change, look.step);
}

void open_text(SliderState& state, std::string_view id, const std::string& number) {
    state.typed = id;
    state.text_opened = state.commit = state.give_up = false;
    state.text_drawn = true;
    std::string plain = number;  // with the minus of the keyboard
    if (const auto minus = plain.find("−"); minus != std::string::npos) plain.replace(minus, 3, "-");
    state.opened_text = plain[0] == '+' ? plain.substr(1) : plain;
    std::snprintf(state.text, sizeof state.text, "%s", state.opened_text.c_str());
}

// The text being edited. Leaving it other than by Esc returns it.
std::optional<std::string> edit_text(Ui& ui, SliderState& state, std::string_view id, Rect box) {
    ImGui::SetCursorScreenPos({box.x, box.y});
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.px(spacing::tight), (box.h - line_height(ui, Face::text)) / 2});
    compat::push_font(font(ui, Face::text));
    ImGui::SetNextItemWidth(box.w);
    if (!state.text_opened) compat::focus_next_field();
    const bool entered = ImGui::InputText("##number", state.text, sizeof state.text,
                                          ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_EnterReturnsTrue);
    const bool active = ImGui::IsItemActive();
    state.text_drawn = true;
    if (ui.keyboard) ui.keyboard->field = box;
    ImGui::PopFont();
    ImGui::PopStyleVar();
    line_box(ui, box, ui.palette.accent, Corner::box, 1.5f);
    const bool left = state.text_opened && !active;  // after Esc, Dear ImGui has restored the old number
    if (active) state.text_opened = true;
    takes_text(ui.keyboard, id, active);
    if (!entered && !state.commit && !state.give_up && !left) return std::nullopt;
    state.typed.clear();
    ImGui::ClearActiveID();
    return state.give_up ? std::nullopt : std::optional<std::string>(state.text);
}

// The number typed, with notices of what is wrong with it.
std::optional<float> accept_text(Ui& ui, const std::string& text, const SliderLook& look) {
    const std::string_view unit = look.typed_unit.empty() ? look.unit : look.typed_unit;
    const std::optional<float> number = typed_number(text, unit);
    if (!number && text.find_first_not_of(' ') != text.npos)
        ui.outbox.push_back(unit.empty() ? NoticeRequest{"notice.no_number", text, {}}
                                         : NoticeRequest{"notice.no_number_in", text,
                                                         std::string(unit.substr(unit.find_first_not_of(' ')))});
    if (number && (*number < look.low || *number > look.high))
        ui.outbox.push_back(NoticeRequest{"notice.limited", slider_text(ui, look.low, look) + std::string(look.unit),
                                          slider_text(ui, look.high, look) + std::string(look.unit)});
    return number;
}

void draw_slider(const Ui& ui, const Item& at, const SliderTrack& t, float value, const SliderLook& look) {
    const Palette& p = ui.palette;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float half = ui.px(2), origin = t.at(std::max(0.0f, t.low)), knob = t.at(value);
    list.AddRectFilled({t.x0, t.y - half}, {t.x1, t.y + half}, paint(p.line), half);
    const Colour fill = look.meaning ? colour_of_weight(p, value) : p.second_text;
    if (std::fabs(knob - origin) > 1)
        list.AddRectFilled({std::min(origin, knob), t.y - half}, {std::max(origin, knob), t.y + half}, paint(fill),
                           half);
    if (t.low < 0)
        list.AddRectFilled({origin - ui.px(0.75f), t.y - ui.px(6)}, {origin + ui.px(0.75f), t.y + ui.px(6)},
                           paint(p.second_text));
    const float radius = ui.px(knob_radius - (look.meaning ? 0.0f : 1.0f)) + ui.px(1) * at.warmth;
    const ImVec2 middle{knob, t.y};
    list.AddCircleFilled(middle, radius + ui.px(1.5f), paint(p.panel));
    list.AddCircleFilled(middle, radius, paint(fill));
    list.AddCircleFilled(middle, radius - ui.px(2), paint(mix(p.raised, fill, at.held ? 1.0f : 0.25f * at.warmth)));
}

}  // namespace

void keep_drawn(SliderState& state) {
    if (!std::exchange(state.text_drawn, false)) state.typed.clear();
    if (!ImGui::IsMouseDown(0)) state.dragged.clear();
}

std::uint64_t gesture_by_keys(const SliderState& state, double wall_seconds) {
    const bool is_recent = state.set_at >= 0 && wall_seconds - state.set_at <= gesture_pause;
    return is_recent && state.dragged.empty() ? gestures::panels + state.gesture : 0;
}

std::optional<SliderEdit> slider(Ui& ui, SliderState& state, std::string_view id, float value, float width,
                                 double wall_seconds, const SliderLook& look) {
    const bool typing = state.typed == id;
    const float text_width_open = ui.px(look.number_width + 12);
    Item at = item(ui, id, {typing ? width - text_width_open : width, ui.px(ui.tall(look.height))}, true, around_row);
    at.rect.w = width;
    if (typing) mark(ui, id, at.rect, around_row);
    const float inset = ui.px(knob_radius + 1);
    const SliderTrack track{at.rect.x + ui.px(look.words_width) + inset,
                            at.right() - ui.px(look.number_width) - inset,
                            at.middle_y(),
                            look.low,
                            look.high,
                            look.wide ? look.knee : 0};
    const auto shown = [&](float any) { return slider_text(ui, any, look) + std::string(look.unit); };
    const std::string number = shown(value);
    const ImGuiIO& io = ImGui::GetIO();

    std::optional<float> wanted;
    float least_change = look.step / 20;
    const bool on_number = io.MousePos.x > track.x1 + inset;
    const bool clicked = at.hovered && ImGui::IsMouseClicked(0), twice = at.hovered && ImGui::IsMouseDoubleClicked(0);
    const bool to_typing = at.entered || twice || (clicked && (io.KeyCtrl || on_number));
    if (clicked && ui.keyboard) ui.keyboard->focus = id;
    if (typing) {
        ImGui::SameLine(0, 0);
        if (const auto text =
                edit_text(ui, state, id, {at.right() - text_width_open, at.rect.y, text_width_open, at.rect.h})) {
            ++state.gesture;
            if (*text != state.opened_text) wanted = accept_text(ui, *text, look);
            least_change = 0;
        }
    } else if (to_typing) {
        // Undo a move of the knob by the first click of a double click, with the same gesture.
        const bool moved = twice && state.pressed == id && state.pressed_at != value;
        if (moved) wanted = state.pressed_at;
        open_text(state, id, slider_text(ui, wanted.value_or(value), look));
        takes_text(ui.keyboard, id, false);
        state.dragged.clear();
    } else if (const bool by_key = at.focused && take(*ui.keyboard, key::del);
               by_key || (at.hovered && ImGui::IsMouseClicked(1))) {
        if (by_key) ui.outbox.push_back(NoticeRequest{"notice.restored", {}, {}});
        ++state.gesture;
        wanted = look.home;
        least_change = 0;
    } else {
        wanted = drag_knob(ui, state, at, track, id, value, look);
        if (!wanted) wanted = nudge_knob(ui, state, at, id, value, wall_seconds, look);
    }

    const Palette& p = ui.palette;
    put(ui, {at.rect.x, at.middle_y() - line_height(ui, Face::strong) / 2}, look.words, p.text,
        look.meaning ? Face::strong : Face::text);
    draw_slider(ui, at, track, value, look);
    if (!typing)
        put_right(ui, {at.right(), at.middle_y() - line_height(ui, Face::text) / 2}, number,
                  rounds_to_zero(value, shown_decimals(value, look)) ? p.second_text : p.text);
    const bool is_moved = state.pressed == id;  // its effect is watched until the pointer leaves the slider
    if (is_moved && !at.hovered && !at.held) state.pressed.clear();
    if (!typing && at.hovered && !is_moved)
        tooltip(ui, at, look.tooltip,
                fill(ui.strings("slider.how"),
                     {shown(valid_value(look.home, look)), slider_text(ui, look.low, look), shown(look.high)}));

    if (!wanted || !std::isfinite(*wanted)) return std::nullopt;
    const float edited = valid_value(*wanted, look);
    const bool changed = std::fabs(edited - (state.dragged == id ? state.asked : value)) > least_change;
    if (!changed) return std::nullopt;
    state.asked = edited;
    if (state.dragged != id) state.set_at = wall_seconds;
    return SliderEdit{edited, gestures::panels + state.gesture};
}

}  // namespace braitenlab::ui

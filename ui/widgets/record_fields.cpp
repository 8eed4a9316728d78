#include "ui/widgets/record_fields.h"

#include <iterator>
#include <utility>

#include <imgui.h>

#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/paint.h"
#include "ui/words/number_text.h"

namespace braitenlab::ui {

namespace {

constexpr std::size_t longest_unit = 4;      // characters beside the number; a longer unit is in the tooltip only
constexpr float field_gap = spacing::tight;  // layout pixels
constexpr float above_choice = 2, below_choice = 6;

// Rows follow each other without the gap of the card while this exists.
struct CloseRows {
    CloseRows() { ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0}); }
    ~CloseRows() { ImGui::PopStyleVar(); }
    CloseRows(const CloseRows&) = delete;
    CloseRows& operator=(const CloseRows&) = delete;
};

void space(const Ui& ui, float layout_pixels) { ImGui::Dummy({1, ui.px(layout_pixels)}); }

// Draws a label, `width` window pixels wide, left of a widget of this height.
void field_label(const Ui& ui, std::string_view words, float width, float height) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    put(ui, {at.x, at.y + (height - line_height(ui, Face::text)) / 2}, words, ui.palette.text);
    ImGui::SetCursorScreenPos({at.x + width, at.y});
}

// True if each choice fits its share of the width.
bool fit_side_by_side(const Ui& ui, std::span<const std::string_view> choices, float width) {
    const float each = width / static_cast<float>(choices.size());
    return std::all_of(choices.begin(), choices.end(),
                       [&](std::string_view choice) { return text_width(ui, Face::small, choice) < each - ui.px(8); });
}

// The choices as buttons, as many in a row as fit. The one clicked, or −1.
int wrapped_choices(Ui& ui, const std::string& anchor, std::span<const std::string_view> choices, int chosen,
                    std::string_view how) {
    const float right = ImGui::GetCursorScreenPos().x + card_width(ui);
    int clicked = -1;
    for (int i = 0; i < static_cast<int>(choices.size()); ++i) {
        const std::string id = anchor + "." + std::to_string(i + 1);
        const SmallButton look{id, {}, choices[static_cast<std::size_t>(i)], i == chosen};
        if (i > 0 && ImGui::GetItemRectMax().x + ui.px(field_gap) + small_button_width(ui, look, true) <= right)
            ImGui::SameLine(0, ui.px(field_gap));
        if (small_push_button(ui, look, how) && i != chosen) clicked = i;
    }
    return clicked;
}

}  // namespace

void keep_drawn(FieldsState& state) {
    for (auto text = state.texts.begin(); text != state.texts.end();) {
        const bool drawn = keep_drawn(text->second);
        if (!drawn) state.cancelled = false;
        text = drawn ? std::next(text) : state.texts.erase(text);
    }
}

bool for_record_text(FieldsState& state, KeyPress press) {
    for (auto& [anchor, field] : state.texts) {
        if (field.active && press.key == key::escape) state.cancelled = true;
        if (for_text_field(field, press)) return true;
    }
    return false;
}

SliderLook look_of(const NumberField& field) {
    SliderLook look;
    look.low = static_cast<float>(field.range.low), look.high = static_cast<float>(field.range.high);
    look.home = field.home;
    look.whole = field.whole;
    look.typed_unit = field.unit;
    look.nudge = 10;
    const float span = look.high - look.low;
    const bool is_angle = field.unit == "°", is_rate = field.unit == "1/s";
    look.wide = !is_angle && (span > 60 || is_rate || (look.low > 0 && look.high >= 100 * look.low));
    look.step = field.whole ? 1.0f : is_rate || (look.low > 0 && look.low < 0.01f) ? 0.001f : is_angle ? 0.1f : 0.01f;
    look.knee = is_rate ? 0.01f : look.low > 0 ? look.low : 1;
    look.decimals = field.whole ? 0 : is_angle ? 1 : look.step < 0.01f ? 3 : 2;
    look.trimmed = look.wide || is_angle;
    look.signed_number = look.low < 0;
    look.meaning = false;
    look.number_width = 62;
    return look;
}

std::optional<SliderEdit> FieldRows::number(const NumberField& field) const {
    SliderLook look = look_of(field);
    const std::string key = words + field.key;
    const std::string unit = unit_after(field.unit);
    std::string how(ui.strings(key + "_how"));
    look.words = ui.strings(key);
    look.words_width = words_width;
    if (!field.unit.empty() && field.unit.size() <= longest_unit + 1)
        look.unit = unit;
    else if (!field.unit.empty())
        how += " (" + std::string(field.unit) + ")";
    look.tooltip = how;
    const CloseRows close;
    return slider(ui, sliders, anchor + "." + field.key, field.value, card_width(ui), wall_seconds, look);
}

int FieldRows::choice(const char* key, std::span<const std::string_view> choices, int chosen) const {
    const std::string id = anchor + "." + key, how(ui.strings(words + key + "_how"));
    const std::string_view label = ui.strings(words + key);
    const float left = ui.px(words_width), width = card_width(ui) - left;
    const CloseRows close;
    space(ui, above_choice);
    if (fit_side_by_side(ui, choices, width)) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        field_label(ui, label, left, ui.px(30));
        const int clicked = segments(ui, id, choices, chosen, width, how);
        ImGui::SetCursorScreenPos({at.x, at.y + ui.px(30)});
        space(ui, below_choice);
        return clicked;
    }
    paragraph(ui, label, ui.palette.text);
    space(ui, 3);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(field_gap), ui.px(field_gap)});
    const int clicked = wrapped_choices(ui, id, choices, chosen, how);
    ImGui::PopStyleVar();
    space(ui, 2);  // the buttons end with a gap of their own
    return clicked;
}

std::optional<std::string> FieldRows::text(const char* key, const std::string& now, std::size_t longest) const {
    const std::string id = anchor + "." + key;
    TextField& field = state.texts[id];
    const bool was_active = field.active;
    if (!was_active) field.text = now;
    const CloseRows close;
    space(ui, above_choice);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float left = ui.px(words_width), height = ui.px(ui.tall(button_height));
    field_label(ui, ui.strings(words + key), left, height);
    text_field(ui, field, id, card_width(ui) - left, {}, ui.strings(words + key + "_how"));
    ImGui::SetCursorScreenPos({at.x, at.y + height});
    space(ui, below_choice);
    if (field.entered && ui.keyboard) ui.keyboard->focus.clear(), field.active = false;
    if (!field.entered && (field.active || !was_active)) return std::nullopt;
    const bool cancelled = std::exchange(state.cancelled, false);
    if (cancelled || field.text == now || field.text.size() > longest) return std::nullopt;
    return field.text;
}

}  // namespace braitenlab::ui

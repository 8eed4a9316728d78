#include "ui/panels/value_choice.h"

#include <algorithm>
#include <array>

#include <imgui.h>

#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/record_fields.h"
#include "ui/words/measure_text.h"

namespace braitenlab::ui {

using insight::AxisValue;
using insight::ValueGroup;

std::string axis_words(const Ui& ui, const AxisValue& value) { return axis_name(ui.strings, value); }

SliderLook end_look(const Ui& ui, const AxisValue& value, bool is_from, float now) {
    SliderLook look = look_of(NumberField{"", value.unit, value.allowed, now, is_from ? value.from : value.to});
    const std::string_view from = ui.strings("map.from"), to = ui.strings("map.to");
    look.words = is_from ? from : to;
    const float room = std::max(text_width(ui, Face::text, from), text_width(ui, Face::text, to));
    look.words_width = room / ui.px(1) + 12;
    return look;
}

bool choice_in_row(Ui& ui, const std::string& id, const std::string& words, bool on, bool is_first, float right) {
    const SmallButton which{id, {}, words, on};
    if (!is_first) beside_or_below(ui, small_button_width(ui, which, true), right);
    return small_button(ui, which).pressed;
}

const AxisValue* value_choice(Ui& ui, const std::vector<AxisValue>& values, const std::string& begin,
                              std::string_view now, ValueGroup& shown, float width) {
    constexpr std::array groups{"brain", "body", "scene"};  // by ValueGroup
    const float right = ImGui::GetCursorScreenPos().x + width;
    std::array<std::string_view, insight::value_group_count> words;
    for (std::size_t i = 0; i < words.size(); ++i) words[i] = ui.strings(std::string("map.group.") + groups[i]);
    gap(ui, 2);
    const int group = segments(ui, begin + ".group", words, static_cast<int>(shown), width);
    if (group >= 0) shown = static_cast<ValueGroup>(group);
    const AxisValue* chosen = nullptr;
    bool is_first = true;
    for (const AxisValue& value : values) {
        if (group_of(value.owner) != shown) continue;
        if (choice_in_row(ui, begin + "." + value.id, axis_words(ui, value), value.id == now, is_first, right))
            chosen = &value;
        is_first = false;
    }
    return chosen;
}

}  // namespace braitenlab::ui

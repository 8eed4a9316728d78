#include "ui/panels/course/prediction_keys.h"

#include <string>
#include <string_view>

namespace braitenlab::ui {

namespace {

constexpr std::string_view answer_stem = "exercise.predict.";

// The index of the focused answer, or −1.
int focused_answer(const PanelState& state, int count) {
    for (int i = 0; i < count; ++i)
        if (state.keyboard.focus == std::string(answer_stem) + std::to_string(i + 1)) return i;
    return -1;
}

bool is_asked(const LabView& view, const PanelState& state) {
    if (!view.lesson || state.sheet != Sheet::none || !state.menu_bar.open.empty()) return false;
    if (state.keyboard.text != TextInput::none || !state.sliders.typed.empty() || view.lesson->together) return false;
    return !view.lesson->exercise->prediction.options.empty() && is_prediction_open(*view.lesson);
}

}  // namespace

bool key_for_prediction(const LabView& view, PanelState& state, KeyPress press, Outbox& outbox) {
    if (press.ctrl || press.shift || !is_asked(view, state)) return false;
    const int count = static_cast<int>(view.lesson->exercise->prediction.options.size());
    const bool is_unmade = view.lesson->prediction < 0 && !view.lecture;
    int wanted = -1;
    if (press.key >= '1' && press.key <= '9' && is_unmade) wanted = press.key - '1';
    if (press.key == ' ' && state.keyboard.shown) wanted = focused_answer(state, count);
    if (wanted < 0 || wanted >= count || (press.key == ' ' && wanted == view.lesson->prediction)) return false;
    outbox.emplace_back(PredictRequest{wanted});
    state.keyboard.focus = std::string(answer_stem) + std::to_string(wanted + 1);
    state.keyboard.shown = state.keyboard.revealed = true;
    return true;
}

}  // namespace braitenlab::ui

#include "ui/panels/course/exercise_keys.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "ui/panels/panels.h"

namespace braitenlab::ui {

namespace {

constexpr std::string_view answer_stem = "exercise.predict.";

// The index of the focused answer, or −1.
int focused_answer(const PanelState& state, int count) {
    for (int i = 0; i < count; ++i)
        if (state.keyboard.focus == std::string(answer_stem) + std::to_string(i + 1)) return i;
    return -1;
}

// Moves the focus from an answer to the one above or below it. False if no answer has the focus.
bool move_between_answers(PanelState& state, int count, int pressed) {
    const int focused = focused_answer(state, count);
    if (focused < 0 || !state.keyboard.shown) return false;
    const int wanted = std::clamp(focused + (pressed == key::up ? -1 : 1), 0, count - 1);
    state.keyboard.focus = std::string(answer_stem) + std::to_string(wanted + 1);
    state.keyboard.revealed = true;
    return true;
}

// True if keys may be for the exercise: no sheet, menu or text field has them.
bool reaches_exercise(const LabView& view, const PanelState& state) {
    if (!view.lesson || state.sheet != Sheet::none || !state.menu_bar.open.empty()) return false;
    return state.keyboard.text == TextInput::none && state.sliders.typed.empty();
}

bool is_asked(const LabView& view, const PanelState& state) {
    if (!reaches_exercise(view, state) || view.lesson->together) return false;
    return !view.lesson->exercise->prediction.options.empty() && view.may.open_prediction;
}

// True if Play waits for the prediction, unless it is skipped.
bool asks_before_play(const LabView& view) {
    if (view.lecture || !view.lesson || view.lesson->attempt.work.free_play || view.mode == Mode::playing) return false;
    return awaits_prediction(*view.lesson) && hides_outcome(view);
}

}  // namespace

bool digits_choose_answer(const LabView& view) {
    const Attempt& attempt = view.lesson->attempt;
    return !view.lecture && !(attempt.work.has_run && has_predicted(attempt.answers));
}

bool key_for_prediction(const LabView& view, PanelState& state, KeyPress press, Outbox& outbox) {
    if (press.ctrl || press.shift || !is_asked(view, state)) return false;
    const int count = static_cast<int>(view.lesson->exercise->prediction.options.size());
    const bool has_focus = !view.lecture && state.keyboard.shown && focused_answer(state, count) >= 0;
    if (press.key == key::up || press.key == key::down) return move_between_answers(state, count, press.key);
    int wanted = -1;
    if (press.key >= '1' && press.key <= '9' && (digits_choose_answer(view) || has_focus)) wanted = press.key - '1';
    if (press.key == ' ' && state.keyboard.shown) wanted = focused_answer(state, count);
    if (wanted < 0 || wanted >= count || (press.key == ' ' && wanted == view.lesson->attempt.answers.prediction))
        return false;
    outbox.emplace_back(PredictRequest{wanted});
    state.keyboard.focus = std::string(answer_stem) + std::to_string(wanted + 1);
    state.keyboard.shown = state.keyboard.revealed = true;
    return true;
}

bool key_for_next_exercise(const LabView& view, PanelState& state, KeyPress press) {
    if (press != KeyPress{key::enter} || view.lecture || view.mode == Mode::wiring) return false;
    if (!reaches_exercise(view, state) || !view.lesson->grade || !view.lesson->grade->good) return false;
    // A slider has the arrow keys, but the bar names Enter for the next exercise.
    if (state.keyboard.shown && !state.keyboard.focus.empty() && !has_slider_focus(state.keyboard)) return false;
    if (state.scene_input.tool != SceneInputTool::hand || state.scene_input.menu.open) return false;
    state.card(Card::exercise).folded = false;  // the button is in it
    state.keyboard.focus = "exercise.next";
    state.keyboard.revealed = true;  // it was not drawn while the card was folded
    state.keyboard.presses.push_back(press);
    return true;
}

bool holds_play(const LabView& view, PanelState& state, Action action, Outbox& outbox) {
    if ((action != Action::play_pause && action != Action::step) || !asks_before_play(view)) return false;
    if (state.exercise.play_held == view.run_id) return false;
    state.exercise.play_held = view.run_id;
    state.exercise.shows_question = true;
    state.card(Card::exercise).folded = false;
    if (view.mode == Mode::wiring) outbox.emplace_back(Action::wiring);  // Play would leave the diagram, too
    if (view.lesson->exercise->prediction.options.empty()) {
        state.keyboard.focus = "exercise.draw";
        state.keyboard.shown = state.keyboard.revealed = true;
    }
    return true;
}

bool is_play_held(const LabView& view, const PanelState& state) {
    return asks_before_play(view) && state.exercise.play_held == view.run_id;
}

void follow_held_play(const LabView& view, PanelState& state) {
    if (!is_play_held(view, state)) state.exercise.play_held.reset();
}

}  // namespace braitenlab::ui

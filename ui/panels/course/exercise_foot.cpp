// The foot of the exercise card: the buttons, which never change place.
#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>

#include <imgui.h>

#include "ui/panels/course/exercise_parts.h"
#include "ui/panels/exercise_names.h"
#include "ui/panels/panels.h"
#include "ui/shortcuts.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr float more_width = 26;  // layout pixels, of the button that unfolds the others

// The places of the foot, window pixels from its left end. `hint` and `next` are beside each other and have the width
// of the longest words that may be there.
struct FootPlaces {
    float hint = 0, next = 0, reset = 0;  // widths
    bool folds = false;                   // all but hint and next are folded
};

ButtonLook compact_look(const Ui& ui, std::string_view key, std::string_view icon = {}) {
    ButtonLook look{icon, ui.strings(key)};
    look.compact = true;
    return look;
}

// The button that unfolds the others.
ButtonLook more_look() {
    ButtonLook look{{}, "…"};
    look.min_width = more_width, look.compact = true;
    return look;
}

SmallButton small_look(const Ui& ui, std::string_view id) { return {id, {}, ui.strings(id)}; }

// False on a page of a lecture: its exercise is not handed in.
bool is_handed_in(const LabView& view) { return !view.pages; }

FootPlaces foot_places(const LabView& view, const Ui& ui, float width) {
    FootPlaces places;
    for (const std::string_view key : {"exercise.hint", "exercise.show_me"})
        places.hint = std::max(places.hint, button_width(ui, compact_look(ui, key, icon::hint)));
    places.next = button_width(ui, compact_look(ui, "exercise.next_short"));
    places.reset = button_width(ui, compact_look(ui, "exercise.reset"));
    const float space = ui.px(spacing::small);
    float others = note_button_width(view, ui);
    for (const std::string_view id : {"exercise.hand_in", "exercise.lab_record"})
        others += space + small_button_width(ui, small_look(ui, id), true);
    const float row = places.hint + space + places.next + space + places.reset;
    // In the lowest windows the steps need the height; to a finger rows are high, and the answers need the room.
    const bool has_no_room = std::max(row, is_handed_in(view) ? others : 0) > width + 0.5f;
    places.folds = has_no_room || has_close_rows(view, ui) || view.program.touch;
    places.next = width - places.hint - 2 * space - (places.folds ? button_width(ui, more_look()) : places.reset);
    return places;
}

// After the last hint: gives the vehicle the solution.
void show_me_button(const LessonView& lesson, float width, Ui& ui) {
    ButtonLook look = compact_look(ui, "exercise.show_me", icon::hint);
    look.min_width = width / ui.px(1);
    look.enabled = lesson.attempt.answers.hint_ready;
    const Item at = button(ui, "exercise.show_me", look);
    if (at.pressed) ui.outbox.emplace_back(ShowMeRequest{});
    tooltip(ui, at, ui.strings(look.enabled ? "exercise.show_me_how" : "exercise.hint_wait"));
}

void hint_button(const LessonView& lesson, float width, Ui& ui) {
    const std::size_t count = lesson.exercise->hints.size();
    const bool left = static_cast<std::size_t>(lesson.attempt.answers.hints_shown) < count;
    if (!left) return show_me_button(lesson, width, ui);
    ButtonLook look = compact_look(ui, "exercise.hint", icon::hint);
    look.min_width = width / ui.px(1);
    look.enabled = lesson.attempt.answers.hint_ready;
    const Item at = button(ui, "exercise.hint", look);
    if (at.pressed) ui.outbox.push_back(Action::hint);
    tooltip(ui, at, ui.strings(look.enabled ? "exercise.hint_how" : "exercise.hint_wait"),
            key_name(Action::hint, ui.strings));
}

// Opens the next exercise, or the list of files after the last one.
void next_button(const LabView& view, PanelState& state, float width, Ui& ui) {
    const CatalogueEntry* next = next_exercise(view);
    const bool passed = has_passed(*view.lesson);
    ButtonLook look = compact_look(ui, passed ? next_exercise_key(view) : "exercise.next_short");
    if (passed) look.emphasis = Emphasis::primary;
    look.min_width = width / ui.px(1);
    const Item at = button(ui, "exercise.next", look);
    tooltip(ui, at, next ? entry_words(view, ui, *next) : std::string(ui.strings("exercise.more_how")),
            key_name({key::enter}, ui.strings));
    if (!at.pressed) return;
    if (next) return ui.outbox.push_back(OpenRequest{.path = next->path, .next_exercise = true});
    begin_files(state.sheets.files, false);
    state.sheet = Sheet::files;
}

// True if Start over would take something back.
bool has_changes(const LabView& view) {
    return view.undo_depth > 0 || (view.lesson->selection && view.lesson->selection->generation > 0);
}

void reset_pressed(const LabView& view, PanelState& state, Ui& ui) {
    if (has_changes(view))
        state.exercise.reset_asked = true;
    else
        ui.outbox.push_back(Action::exercise_reset);
}

// Whether to take all changes back, before Start over does.
void ask_before_reset(const LabView& view, PanelState& state, Ui& ui, float width) {
    if (!state.exercise.reset_asked) return;
    if (!has_changes(view)) {
        state.exercise.reset_asked = false;
        return;
    }
    const float right = ImGui::GetCursorScreenPos().x + width;
    paragraph(ui, ui.strings("exercise.reset_ask"), ui.palette.text, Face::small, width);
    const SmallButton yes = small_look(ui, "exercise.reset_yes"), no = small_look(ui, "exercise.reset_no");
    const bool keeps = small_button(ui, no).pressed;
    beside_or_below(ui, small_button_width(ui, yes, true), right);
    const bool resets = small_button(ui, yes).pressed;
    if (resets) ui.outbox.push_back(Action::exercise_reset);
    if (keeps || resets) state.exercise.reset_asked = false;
}

// A small button beside the others; before the first run its room stays empty.
bool small_in_row(Ui& ui, std::string_view id, std::string_view how, bool shown, float right) {
    const SmallButton look = small_look(ui, id);
    const float width = small_button_width(ui, look, true);
    beside_or_below(ui, width, right);
    if (!shown) return ImGui::Dummy({width, ui.px(ui.tall(small_button_height))}), false;
    return small_push_button(ui, look, ui.strings(how));
}

// Notes, hand in and the lab record, unless only Start over is wanted; this where the row below has no room for it.
void other_buttons(const LabView& view, PanelState& state, Ui& ui, float width, bool has_reset, bool only_reset) {
    const float right = ImGui::GetCursorScreenPos().x + width;
    if (is_handed_in(view) && !only_reset) {
        const bool has_run = view.lesson->attempt.work.has_run;
        note_button(view, state, ui);
        if (small_in_row(ui, "exercise.hand_in", "exercise.hand_in_how", has_run, right))
            hand_in_pressed(view, state, ui);
        if (small_in_row(ui, "exercise.lab_record", "exercise.lab_record_how", has_run, right))
            lab_record_pressed(view, state, ui);
    }
    if (has_reset && small_in_row(ui, "exercise.reset", "exercise.reset_how", true, right))
        reset_pressed(view, state, ui);
}

// True if a hint points at a button that may be folded: it is shown then.
bool points_at_other(std::string_view anchor) {
    constexpr std::string_view others[]{"exercise.note", "exercise.hand_in", "exercise.lab_record", "exercise.reset"};
    return std::find(std::begin(others), std::end(others), anchor) != std::end(others);
}

}  // namespace

void exercise_foot(const LabView& view, PanelState& state, Ui& ui, float width) {
    const FootPlaces places = foot_places(view, ui, width);
    ask_before_reset(view, state, ui, width);
    if (is_handed_in(view)) hand_in_answer(view, state, ui, width);
    const bool hands_in_next = view.program.touch && has_passed(*view.lesson);
    const bool starts_over = needs_start_over(*view.lesson);
    const bool points = points_at_other(ui.highlight) && !(starts_over && ui.highlight == "exercise.reset");
    const bool shows_all = !places.folds || state.exercise.more_open || hands_in_next || points;
    if (shows_all || starts_over) other_buttons(view, state, ui, width, places.folds, !shows_all);
    const ImVec2 row = ImGui::GetCursorScreenPos();
    const float space = ui.px(spacing::small), next = row.x + places.hint + space;
    const bool passed = has_passed(*view.lesson);
    if (!passed) hint_button(*view.lesson, places.hint, ui);
    if (passed || view.lesson->standing.passed_before) {
        ImGui::SetCursorScreenPos({passed ? row.x : next, row.y});
        next_button(view, state, passed ? places.hint + space + places.next : places.next, ui);
    }
    ImGui::SetCursorScreenPos({next + places.next + space, row.y});
    if (places.folds) {
        ButtonLook more = more_look();
        more.on = state.exercise.more_open;
        if (push_button(ui, "exercise.others", more, ui.strings("exercise.others_how")))
            state.exercise.more_open = !state.exercise.more_open;
    } else if (push_button(ui, "exercise.reset", compact_look(ui, "exercise.reset"),
                           ui.strings("exercise.reset_how"))) {
        reset_pressed(view, state, ui);
    }
}

}  // namespace braitenlab::ui

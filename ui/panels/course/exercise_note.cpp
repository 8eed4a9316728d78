// The student's notes: a button at the foot of the exercise card, and a field of several lines at the end of its text.
#include <string>
#include <utility>

#include "ui/panels/panels.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/text_field.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

void note_field(const LabView& view, PanelState& state, Ui& ui) {
    constexpr int rows = 5;
    if (!state.exercise.note_open) return;
    const std::string& notes = view.lesson->attempt.notes;
    TextField& field = state.exercise.note;
    // They may change below the active field: another window has stored its own.
    const bool have_changed = state.exercise.noted != notes;
    if ((have_changed || !field.active) && field.text != notes) field.text = notes, field.is_new = true;
    state.exercise.noted = notes;
    if (std::exchange(state.exercise.note_begins, false) && ui.keyboard) ui.keyboard->focus = "exercise.note.text";
    text_area(ui, field, "exercise.note.text", card_width(ui), rows, ui.strings("exercise.note_empty"),
              ui.strings("exercise.note_how"));
    if (field.text != notes) ui.outbox.emplace_back(NotesRequest{field.text});
    gap(ui, 12);
}

namespace {

SmallButton look_of_notes(const LabView& view, const Ui& ui, bool open) {
    const bool empty = view.lesson->attempt.notes.empty();
    return {"exercise.note", empty ? std::string_view{} : icon::check,
            ui.strings(empty || has_icons(ui) ? "exercise.note" : "exercise.note_written"), open};
}

}  // namespace

float note_button_width(const LabView& view, const Ui& ui) {
    return small_button_width(ui, look_of_notes(view, ui, false), true);
}

void note_button(const LabView& view, PanelState& state, Ui& ui) {
    const Item at = small_button(ui, look_of_notes(view, ui, state.exercise.note_open));
    tooltip(ui, at, ui.strings("exercise.note_how"));
    if (at.pressed) state.exercise.note_open = state.exercise.note_begins = !state.exercise.note_open;
}

}  // namespace braitenlab::ui

// The student's notes on the exercise card: a folded row, and a field of several lines below it.
#include <string>

#include "ui/panels/panels.h"
#include "ui/strings.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/text_field.h"

namespace braitenlab::ui {

void exercise_note(const LabView& view, PanelState& state, Ui& ui) {
    constexpr int rows = 5;
    const std::string& notes = view.lesson->notes;
    const bool was_open = state.note_open;
    fold_row(ui, "exercise.note", ui.strings(notes.empty() ? "exercise.note" : "exercise.note_written"),
             state.note_open, ui.strings("exercise.note_how"));
    if (state.note_open) {
        if (!state.note.active) state.note.text = notes;
        if (!was_open && ui.keyboard) ui.keyboard->focus = "exercise.note.text", ui.keyboard->revealed = true;
        text_area(ui, state.note, "exercise.note.text", card_width(ui), rows, ui.strings("exercise.note_empty"),
                  ui.strings("exercise.note_how"));
        if (state.note.text != notes) ui.outbox.emplace_back(NotesRequest{state.note.text});
    }
    gap(ui, 12);
}

}  // namespace braitenlab::ui

// The student's notes: a button at the foot of the exercise card, and a field of several lines at the end of its text.
#include <string>
#include <utility>

#include "ui/panels/panels.h"
#include "ui/strings.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/text_field.h"
#include "ui/widgets/theme.h"

namespace braitenlab::ui {

void note_field(const LabView& view, PanelState& state, Ui& ui) {
    constexpr int rows = 5;
    if (!state.note_open) return;
    const std::string& notes = view.lesson->notes;
    if (!state.note.active) state.note.text = notes;
    if (std::exchange(state.note_begins, false) && ui.keyboard) ui.keyboard->focus = "exercise.note.text";
    text_area(ui, state.note, "exercise.note.text", card_width(ui), rows, ui.strings("exercise.note_empty"),
              ui.strings("exercise.note_how"));
    if (state.note.text != notes) ui.outbox.emplace_back(NotesRequest{state.note.text});
    gap(ui, 12);
}

void note_button(const LabView& view, PanelState& state, Ui& ui) {
    const bool empty = view.lesson->notes.empty();
    const Item at = small_button(
        ui, {"exercise.note", empty ? std::string_view{} : icon::check,
             ui.strings(empty || has_icons(ui) ? "exercise.note" : "exercise.note_written"), state.note_open});
    tooltip(ui, at, ui.strings("exercise.note_how"));
    if (at.pressed) state.note_open = state.note_begins = !state.note_open;
}

}  // namespace braitenlab::ui

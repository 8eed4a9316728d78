// The end of the exercise card, once there was a run: hand in, which asks for the student's name, and the lab record.
#include <string>
#include <utility>

#include <imgui.h>

#include "ui/panels/panels.h"
#include "ui/strings.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/text_field.h"

namespace braitenlab::ui {

namespace {

// The name in the view, else the typed one without spaces at its ends.
std::string student_of(const LabView& view, const HandInState& state) {
    const std::string& typed = view.student.empty() ? state.name.text : view.student;
    const std::size_t first = typed.find_first_not_of(' '), last = typed.find_last_not_of(' ');
    return first == std::string::npos ? std::string() : typed.substr(first, last - first + 1);
}

}  // namespace

void exercise_files(const LabView& view, PanelState& state, Ui& ui) {
    if (!view.lesson->has_run) return;
    HandInState& asked = state.hand_in;
    gap(ui, 4);
    if (asked.asks && view.student.empty()) {
        if (std::exchange(asked.begins, false) && ui.keyboard) ui.keyboard->focus = "exercise.student";
        text_field(ui, asked.name, "exercise.student", card_width(ui), ui.strings("exercise.student"),
                   ui.strings("exercise.student_how"));
    }
    const Item hand_in = button(ui, "exercise.hand_in", {{}, ui.strings("exercise.hand_in")});
    tooltip(ui, hand_in, ui.strings("exercise.hand_in_how"));
    ImGui::SameLine();
    const Item record = button(ui, "exercise.lab_record", {{}, ui.strings("exercise.lab_record"), Emphasis::quiet});
    tooltip(ui, record, ui.strings("exercise.lab_record_how"));
    if (record.pressed) ui.outbox.emplace_back(LabRecordRequest{student_of(view, asked)});
    const bool is_entered = std::exchange(asked.name.entered, false);  // stays set once the field is gone
    if (!hand_in.pressed && !is_entered) return;
    const std::string student = student_of(view, asked);
    asked.asks = asked.begins = student.empty();
    if (!student.empty()) ui.outbox.emplace_back(HandInRequest{student});
}

}  // namespace braitenlab::ui

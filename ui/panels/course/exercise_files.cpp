// Handing in from the exercise card: it asks a student without a name for it and says what was written, or why nothing
// was.
#include <string>
#include <utility>

#include <imgui.h>

#include "ui/panels/course/exercise_parts.h"
#include "ui/panels/panels.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/text_field.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

// The name in the view, else the typed one without spaces at its ends.
std::string student_of(const LabView& view, const HandInState& state) {
    const std::string& typed = view.documents.student.empty() ? state.name.text : view.documents.student;
    const std::size_t first = typed.find_first_not_of(' '), last = typed.find_last_not_of(' ');
    return first == std::string::npos ? std::string() : typed.substr(first, last - first + 1);
}

// A name given at hand-in is that of the present student from then on. A name that another student has stays with that
// student, and only the file has it.
void name_student(const LabView& view, Ui& ui, const std::string& name) {
    if (view.documents.student.empty() && view.documents.students && is_free_name(*view.documents.students, name))
        ui.outbox.emplace_back(StudentRequest{StudentEdit::rename, 0, name});
}

// The name of the last written file, and a button that opens it, if it is a page, or copies its path. A download has no
// path.
void written_file(const LabView& view, Ui& ui, float width) {
    const std::string& written = view.lesson->attempt.work.written;
    if (written.empty()) return;
    const bool is_page = written.ends_with(".html");
    const std::string name = written.substr(written.find_last_of('/') + 1);
    if (view.program.uploads && !is_page) return paragraph(ui, name, ui.palette.second_text, Face::small, width);
    const SmallButton copy{is_page ? "exercise.open_record" : "exercise.copy_path",
                           {},
                           ui.strings(is_page ? "exercise.open_record" : "exercise.copy_path")};
    const float beside = width - small_button_width(ui, copy, true) - ui.px(8);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    put(ui, {at.x, at.y + (ui.px(ui.tall(small_button_height)) - line_height(ui, Face::small)) / 2},
        shortened(ui, name, Face::small, beside), ui.palette.second_text, Face::small);
    ImGui::SetCursorScreenPos({at.x + beside + ui.px(8), at.y});
    const Item button = small_button(ui, copy);
    tooltip(ui, button, fill(ui.strings(is_page ? "exercise.open_record_how" : "exercise.copy_path_how"), {written}));
    if (button.pressed && is_page) ui.outbox.emplace_back(OpenWrittenRequest{});
    if (button.pressed && !is_page) ImGui::SetClipboardText(written.c_str());
}

// That the last hand-in was not written, and why. Where an earlier one is better: the buttons that decide.
void refused_hand_in(const LabView& view, const HandInState& state, Ui& ui, float width) {
    const Attempt::Work& work = view.lesson->attempt.work;
    if (work.refused.reason == HandInRefusal::none) return;
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const auto say = [&](const std::string& words) {
        paragraph(ui, words, colour_of(NoticeKind::notice, ui.palette), Face::small, width);
    };
    if (work.refused.reason == HandInRefusal::earlier_is_better) {
        say(fill(ui.strings("exercise.earlier_is_better"),
                 {std::to_string(work.refused.passed), std::to_string(work.refused.starts)}));
        const SmallButton replace{"exercise.replace", {}, ui.strings("exercise.replace")},
            keep{"exercise.keep", {}, ui.strings("exercise.keep")};
        const bool keeps = small_button(ui, keep).pressed;
        beside_or_below(ui, small_button_width(ui, replace, true), start.x + width);
        const bool replaces = small_button(ui, replace).pressed;
        if (keeps || replaces)
            ui.outbox.emplace_back(
                HandInRequest{student_of(view, state), replaces ? EarlierHandIn::replace : EarlierHandIn::keep});
    } else if (work.refused.reason == HandInRefusal::outside_offers) {
        say(std::string(ui.strings("exercise.refused_outside")));
    } else {
        say(fill(ui.strings("exercise.refused_too_many"), {std::to_string(view.lesson->exercise->changes)}));
    }
    mark(ui, "exercise.refused", {start.x, start.y, width, ImGui::GetCursorScreenPos().y - start.y});
}

}  // namespace

void hand_in_answer(const LabView& view, PanelState& state, Ui& ui, float width) {
    HandInState& asked = state.exercise.hand_in;
    if (!view.lesson->attempt.work.has_run) return;
    if (asked.asks && view.documents.student.empty()) {
        paragraph(ui, ui.strings("exercise.student_why"), ui.palette.text, Face::small, width);
        const bool begins = std::exchange(asked.begins, false), was_active = asked.name.active;
        if (begins && ui.keyboard) ui.keyboard->focus = "exercise.student";
        text_field(ui, asked.name, "exercise.student", width, ui.strings("exercise.student"),
                   ui.strings("exercise.student_how"));
        const bool is_entered = std::exchange(asked.name.entered, false);  // stays set once the field is gone
        // Esc, and a click on something else, end the question.
        if (was_active && !asked.name.active && !begins) asked.asks = false;
        if (is_entered) hand_in_pressed(view, state, ui);
    }
    written_file(view, ui, width);
    refused_hand_in(view, asked, ui, width);
}

void hand_in_pressed(const LabView& view, PanelState& state, Ui& ui) {
    HandInState& asked = state.exercise.hand_in;
    const std::string student = student_of(view, asked);
    asked.asks = asked.begins = student.empty();
    if (student.empty()) return;
    name_student(view, ui, student);
    ui.outbox.emplace_back(HandInRequest{student});
}

void lab_record_pressed(const LabView& view, const PanelState& state, Ui& ui) {
    ui.outbox.emplace_back(LabRecordRequest{student_of(view, state.exercise.hand_in)});
}

}  // namespace braitenlab::ui

// The sheet of the students of this computer: who works now, a new name, and what happens to the progress.
#include <algorithm>
#include <string>

#include <imgui.h>

#include "ui/panels/panels.h"
#include "ui/panels/sheets.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/text_field.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

std::string_view name_of(const LabView& view, const Ui& ui, const StudentProgress& student) {
    if (!student.name.empty()) return student.name;
    return ui.strings(view.program.uploads ? "students.nameless_page" : "students.nameless");
}

int course_length(const LabView& view) {
    if (!view.documents.catalogue) return 0;
    return static_cast<int>(std::count_if(view.documents.catalogue->begin(), view.documents.catalogue->end(),
                                          [](const CatalogueEntry& entry) { return entry.number > 0; }));
}

void student_rows(const LabView& view, Ui& ui) {
    const StudentBook& book = *view.documents.students;
    const std::string all = std::to_string(course_length(view));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, ui.px(spacing::tight)});
    for (std::size_t i = 0; i < book.all.size(); ++i) {
        const std::string passed = std::to_string(passed_count(book.all[i]));
        const float aside = text_width(ui, Face::text, "  " + fill(ui.strings("students.passed"), {all, all}));
        const std::string name =
            shortened(ui, name_of(view, ui, book.all[i]), Face::text, card_width(ui) - aside - ui.px(60));
        if (radio_row(ui, "students." + std::to_string(i + 1),
                      name + "  –  " + fill(ui.strings("students.passed"), {passed, all}), i == book.current, true,
                      ui.strings("students.choose_how")) &&
            i != book.current)
            ui.outbox.emplace_back(StudentRequest{StudentEdit::choose, i});
    }
    ImGui::PopStyleVar();
}

void request_students(PanelState& state, Ui& ui, StudentEdit edit) {
    ui.outbox.emplace_back(StudentRequest{edit, 0, state.sheets.student_name.text});
    state.sheets.student_name.text.clear();
}

// A name, and what it is for: a new student, or the present one.
void naming(const LabView& view, PanelState& state, Ui& ui) {
    const bool is_free = is_free_name(*view.documents.students, state.sheets.student_name.text);
    text_field(ui, state.sheets.student_name, "students.name", card_width(ui), ui.strings("students.name"),
               ui.strings("students.name_how"));
    const bool is_taken = !is_free && !tidy_student_name(state.sheets.student_name.text).empty();
    ButtonLook add{icon::add, ui.strings("students.add")}, rename{{}, ui.strings("students.rename")};
    add.enabled = rename.enabled = is_free;
    const bool one = push_button(ui, "students.add", add, ui.strings(is_taken ? "students.taken" : "students.add_how"));
    ImGui::SameLine();
    const bool other =
        push_button(ui, "students.rename", rename, ui.strings(is_taken ? "students.taken" : "students.rename_how"));
    if (one || (state.sheets.student_name.entered && is_free)) return request_students(state, ui, StudentEdit::add);
    if (other) request_students(state, ui, StudentEdit::rename);
}

// Forgetting the progress can be taken back as long as nothing new is added to it.
void keeping(const LabView& view, Ui& ui) {
    ImGui::SameLine(0, ui.px(spacing::small));
    const bool restores = view.documents.students->before_reset.has_value();
    const bool has_progress = !view.documents.students->student().exercises.empty();
    ButtonLook look{{}, ui.strings(restores ? "students.restore" : "students.reset")};
    look.enabled = restores || has_progress;
    const Item reset = button(ui, "students.reset", look);
    tooltip(ui, reset, ui.strings(restores ? "students.restore_how" : "students.reset_how"));
    if (reset.pressed) ui.outbox.emplace_back(StudentRequest{restores ? StudentEdit::restore : StudentEdit::reset});
    ImGui::SameLine(0, ui.px(spacing::small));
    const Item save = button(ui, "students.export", {{}, ui.strings("students.export")});
    tooltip(ui, save, ui.strings("students.export_how"));
    if (save.pressed) ui.outbox.emplace_back(StudentRequest{StudentEdit::save});
}

}  // namespace

void student_sheet(const LabView& view, PanelState& state, Ui& ui, Rect window) {
    if (!view.documents.students) return void(state.sheet = Sheet::none);
    SheetState& sheet = open_sheet(state, ui, Sheet::students, window);
    paragraph(ui, ui.strings(view.program.uploads ? "students.what_page" : "students.what"), ui.palette.second_text);
    naming(view, state, ui);
    if (push_button(ui, "students.save_progress", {{}, ui.strings("students.save_progress")},
                    ui.strings("students.save_progress_how")))
        ui.outbox.emplace_back(StudentRequest{StudentEdit::save_progress});
    gap(ui, 4);
    student_rows(view, ui);
    sheet_buttons(ui, sheet);
    const bool closed = close_button(ui, "students.close");
    keeping(view, ui);
    if (end_sheet(sheet) || closed) state.sheet = Sheet::none;
}

}  // namespace braitenlab::ui

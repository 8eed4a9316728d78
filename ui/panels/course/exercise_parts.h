// Parts of the exercise card that have a source of their own. Precondition of each: view.lesson.
#pragma once

#include "ui/lab_view.h"
#include "ui/panels/panel_state.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

inline bool has_passed(const LessonView& lesson) { return lesson.grade && lesson.grade->good; }

// full: each with its text and values; they can be folded once the exercise is passed. compact: those that are done are
// ticks in one row, one open step is in full, the others are a line each. lines: all open ones are a line each,
// but for one that was clicked.
enum class StepsLook { full, compact, lines };

// The steps. Anchors: exercise.step.N.
void exercise_steps(const LabView&, PanelState&, Ui&, StepsLook);

// The foot of the card, `width` window pixels wide. Its last row has the hint and the next exercise, above it is a row
// with the notes, hand in and the lab record. The place of each button depends on language and width alone, so that no
// button comes where another one was. Where one row above has no room for all of them, `…` unfolds them. Questions and
// answers are above all buttons.
void exercise_foot(const LabView&, PanelState&, Ui&, float width);

// What a hand-in asks and answers: the name of a student without one, the file that was written, why none was.
void hand_in_answer(const LabView&, PanelState&, Ui&, float width);

// Hands in, or asks for the name; the lab record.
void hand_in_pressed(const LabView&, PanelState&, Ui&);
void lab_record_pressed(const LabView&, const PanelState&, Ui&);

}  // namespace braitenlab::ui

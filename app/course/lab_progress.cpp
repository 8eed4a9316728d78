#include "app/course/lab_progress.h"

#include <algorithm>
#include <utility>

#include "app/course/authored_scene.h"
#include "app/lab_reset.h"
#include "core/lesson/hand_in.h"
#include "core/lesson/submission.h"

namespace braitenlab {

namespace {

// What is known after this attempt, from what was known before it.
ExerciseProgress progressed(ExerciseProgress progress, const Lesson& lesson) {
    const Attempt::Answers& answers = lesson.attempt.answers;
    const bool was_shown = lesson.attempt.work.solution_shown;
    const Prediction& asked = lesson.exercise->prediction;
    if (answers.prediction >= 0 && static_cast<std::size_t>(answers.prediction) < asked.options.size()) {
        progress.prediction = asked.options[static_cast<std::size_t>(answers.prediction)];
        progress.predicted_right = answers.prediction == asked.answer;
    }
    progress.drew_path |= !answers.drawn_path.empty();
    progress.hints = std::max(progress.hints, answers.hints_shown);
    progress.notes = lesson.attempt.notes;
    const bool passed_alone = progress.passed && !progress.shown;
    if (was_shown && !passed_alone) progress.shown = true;
    if (!grade_of(lesson)) return progress;
    const Grade& grade = *grade_of(lesson);
    if (grade.count > progress.best || progress.starts == 0)
        progress.best = grade.count, progress.starts = static_cast<int>(grade.starts.size());
    if (grade.good && !was_shown) progress.shown = false;
    if (grade.good || !progress.passed) progress.submission = lesson.graded->submission;
    progress.passed = progress.passed || grade.good;
    return progress;
}

const ExerciseProgress* stored_progress(const Lab& lab) {
    if (!lab.document.lesson) return nullptr;
    return find_progress(lab.students.student(), lab.document.lesson->key);
}

// True once after another exercise was opened or another student was chosen.
bool is_new_attempt(Lab& lab) {
    const std::pair now{lab.document.run_id, lab.students.current};
    return std::exchange(lab.progress_of, now) != now;
}

void choose_student(Lab& lab, std::size_t index) {
    StudentBook& book = lab.students;
    if (index >= book.all.size() || index == book.current) return;
    book.current = index;
    book.before_reset.reset();
    if (lab.document.lesson) restart_exercise(lab);
}

void add_student(Lab& lab, const std::string& name) {
    StudentBook& book = lab.students;
    if (!is_free_name(book, name) || book.all.size() >= most_students) return;
    book.all.push_back({tidy_student_name(name), {}});
    choose_student(lab, book.all.size() - 1);
}

// The student without a name stays the first one; the present work gets the name.
void rename_student(StudentBook& book, const std::string& name) {
    if (!is_free_name(book, name)) return;
    book.before_reset.reset();
    if (book.current > 0) return void(book.student().name = tidy_student_name(name));
    if (book.all.size() >= most_students) return;
    StudentProgress named = std::exchange(book.all.front(), StudentProgress{});
    named.name = tidy_student_name(name);
    book.all.push_back(std::move(named));
    book.current = book.all.size() - 1;
}

void reset_student(Lab& lab) {
    StudentBook& book = lab.students;
    if (book.student().exercises.empty()) return;
    StudentProgress before = book.student();
    book.student().exercises.clear();
    if (lab.document.lesson) restart_exercise(lab), lab.document.lesson->attempt.notes.clear();
    book.before_reset = std::move(before);
}

void restore_student(Lab& lab) {
    StudentBook& book = lab.students;
    if (!book.before_reset) return;
    book.student() = *std::exchange(book.before_reset, std::nullopt);
    lab.progress_of.reset();  // the notes are read again
}

}  // namespace

void follow_progress(Lab& lab) {
    if (!lab.document.lesson || lab.pages) return;            // a page of a lecture is no attempt of a student
    if (has_draft(lab.authored.get(), lab.document)) return;  // nor is the author's trial
    Lesson& lesson = *lab.document.lesson;
    const ExerciseProgress* known = stored_progress(lab);
    if (is_new_attempt(lab)) lesson.attempt.notes = known ? known->notes : std::string();
    const ExerciseProgress before = known ? *known : ExerciseProgress{};
    ExerciseProgress now = progressed(before, lesson);
    lesson.standing.has_kept =
        now.submission && *now.submission != submission_of(*lesson.exercise, lab.document.session.snapshot());
    lesson.standing.passed_before = now.passed;
    if (now == before) return;
    lab.students.before_reset.reset();
    lab.students.student().exercises[lesson.key] = std::move(now);
}

bool is_kept(const Lab& lab, const Submission& submission) {
    const ExerciseProgress* known = stored_progress(lab);
    return known && known->submission == submission;
}

void take_kept_submission(Lab& lab) {
    const ExerciseProgress* known = stored_progress(lab);
    if (!known || !known->submission) return;
    const bool shown = known->shown;
    give_submission(lab, Submission(*known->submission));
    if (shown) lab.document.lesson->attempt.work.solution_shown = true;
}

bool take_progress(Lab& lab, const StudentProgress& given) {
    StudentBook& book = lab.students;
    auto student = book.all.begin();
    if (!given.name.empty())
        student = std::find_if(book.all.begin() + 1, book.all.end(),
                               [&](const StudentProgress& each) { return is_same_student(each.name, given.name); });
    if (student == book.all.end()) {
        if (book.all.size() >= most_students) return false;
        student = book.all.insert(book.all.end(), {tidy_student_name(given.name), {}});
    }
    *student = merged_progress({student->name, {}}, *student, {student->name, given.exercises});
    book.before_reset.reset();
    choose_student(lab, static_cast<std::size_t>(student - book.all.begin()));
    lab.progress_of.reset();  // the notes are read again
    return true;
}

void edit_students(Lab& lab, const StudentRequest& request) {
    if (request.edit == StudentEdit::choose) choose_student(lab, request.index);
    if (request.edit == StudentEdit::add) add_student(lab, request.name);
    if (request.edit == StudentEdit::rename) {
        const std::size_t before = lab.students.current;
        rename_student(lab.students, request.name);
        if (before == 0 && lab.progress_of) lab.progress_of->second = lab.students.current;  // the same attempt
    }
    if (request.edit == StudentEdit::reset) reset_student(lab);
    if (request.edit == StudentEdit::restore) restore_student(lab);
}

}  // namespace braitenlab

// A student's progress in the exercises, the students of one computer, and their files.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/lesson/submission.h"
#include "core/result.h"

namespace braitenlab {

struct ExerciseProgress {
    bool passed = false;
    bool shown = false;      // the solution was shown, and the exercise was not passed without it since
    int best = 0;            // most starts that passed in one grade
    int starts = 0;          // of that grade; 0: never graded
    int hints = 0;           // most hints opened in one attempt
    std::string prediction;  // the option of the last prediction, as in the exercise's file; empty: none
    bool predicted_right = false;
    bool drew_path = false;  // a path was drawn as a prediction
    std::string notes;
    std::optional<Submission> submission{};  // of the last grade; of the last good grade once it is passed
    friend bool operator==(const ExerciseProgress&, const ExerciseProgress&) = default;
};

struct StudentProgress {
    std::string name;                                   // empty: the students of this computer who gave no name
    std::map<std::string, ExerciseProgress> exercises;  // by LessonView::key; only those with something to keep
    friend bool operator==(const StudentProgress&, const StudentProgress&) = default;
};

int passed_count(const StudentProgress&);

// That of one exercise; null if there is none.
const ExerciseProgress* find_progress(const StudentProgress&, std::string_view exercise);

// The progress with the changes of two windows, `ours` and `theirs`, that both began with `before`. An exercise that
// only one of them has changed is as there. One that both have changed is passed if it is in either, has the larger
// numbers, of predictions what `ours` has changed, and of notes this with the words that `theirs` has added below.
StudentProgress merged_progress(const StudentProgress& before, const StudentProgress& ours,
                                const StudentProgress& theirs);

// The students of one computer. Never empty; the first has no name and stays.
struct StudentBook {
    std::vector<StudentProgress> all = std::vector<StudentProgress>(1);
    std::size_t current = 0;                      // index of the student who works now
    std::optional<StudentProgress> before_reset;  // of the current student, until something of it changes
    friend bool operator==(const StudentBook&, const StudentBook&) = default;

    const StudentProgress& student() const { return all[current]; }
    StudentProgress& student() { return all[current]; }
};

inline constexpr std::size_t most_students = 200, longest_student_name = 60, longest_notes = 8000;  // bytes

// The name without blanks at its ends and without control characters, cut to longest_student_name. Empty: no name.
std::string tidy_student_name(std::string_view);

// Whether a student of this name can be added, or renamed to it: it is not empty and no other student has it.
bool is_free_name(const StudentBook&, std::string_view name);

// The file of one student, JSON. Values out of range are clamped and unknown keys ignored. Reading fails with the file
// and, for text that is no JSON, the line.
std::string write_progress(const StudentProgress&);
Result<StudentProgress> read_progress(std::string_view json, std::string file_name);

// A table of all students, one row for an exercise of a student: CSV with the columns student, exercise, passed,
// solution_shown, best_starts, starts, hints, prediction, predicted_right, notes.
std::string progress_csv(const std::vector<StudentProgress>&);

}  // namespace braitenlab

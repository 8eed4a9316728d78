// The results of a class in one exercise: a row for each file, their summary, and both as CSV.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/lesson/grade.h"
#include "core/lesson/hand_in.h"
#include "core/lesson/submitter.h"
#include "core/maths/spread.h"
#include "ui/words/strings.h"

namespace braitenlab {

// Why a row does not count or does not pass: an error of a file, or a text of the strings with its value.
struct RowProblem {
    std::string_view key;        // "report.replaced"; empty: `error`
    std::string value;           // of its {}
    std::optional<Error> error;  // with a key: file and line are its {}
};

// One file of the class.
struct ClassRow {
    std::string file;         // its name, with folders
    std::string student;      // the submitter's name; without one that in the hand-in, or the file's without the ending
    Submitter submitter{};    // by the names of the file and its folders
    std::string fingerprint;  // the same text for files that differ at most by the student's name
    std::optional<HandIn> hand_in;
    std::optional<Submission> submission;  // nullopt: broken, of another exercise, or values outside their ranges
    std::optional<RowProblem> problem;     // nullopt: the row counts
    std::optional<RowProblem> refusal;     // why the submission does not pass, whatever its grade is
    std::string same_as;                   // the first file of another person with the same content
    std::optional<Grade> grade;            // of the submission
    bool passed = false;                   // the grade is good and the submission is allowed
    bool unchanged = false;                // the behaviour is that of the shipped brain
    bool edited = false;                   // the submission is not as shipped
    std::optional<std::size_t> resembles;  // index of Exercise::wrong whose behaviour is alike; not where it passed
};

struct ClassReport {
    std::shared_ptr<const Exercise> exercise;
    std::uint64_t first_seed = 1;
    std::vector<ClassRow> rows;  // sorted by student
};

// The row of a file that holds no hand-in and no brain: "essay.docx".
ClassRow row_of_other_file(const std::string& file, const Submitter& = {});

// True if the text has no characters but spaces and line ends.
bool is_blank(std::string_view text);

// The row of a hand-in file, not graded. `file`: its name; `text`: its content or the error of reading it. A hand-in
// for another exercise is a row with a problem; one with values outside their ranges has a refusal, and passes no
// start.
ClassRow row_of_hand_in(const Exercise&, const std::string& file, const Result<std::string>& text,
                        const Submitter& = {});

// True for rows of one person: the platform's names say so or, where they do not tell, both are in one folder and their
// students are the same (is_same_student).
bool is_same_person(const ClassRow&, const ClassRow&);

// The name in the hand-in where it is not the student's: a word of it is not in the platform's name. Else empty.
// Letters count without accents and in any case; "Anna" and "Anna Müller" are in "Mueller Anna" and in "muelleranna".
std::string other_name(const ClassRow&);

// Of several hand-ins of one person, the one written last counts, of equal times the last by file name; the others get
// a problem that names it.
void mark_replaced(std::vector<ClassRow>&);

// Sets same_as.
void mark_same(std::vector<ClassRow>&);

// True for a row that mark_replaced() has given a problem: it is no failure.
bool is_superseded(const ClassRow&);

// True if the row passed and its hand-in says that the lab has set the solution.
bool passed_with_solution_shown(const ClassRow&);

// True if the number of passed starts that the hand-in states is not that of the grade. False where the two cannot be
// compared: the lab always grades from start 1.
bool states_another_result(const ClassReport&, const ClassRow&);

// By student, letters without accents and in any case (Öztürk after Nowak), so that the hand-ins of one student are
// together; equal names by bytes, then by folder and file.
void sort_by_student(std::vector<ClassRow>&);

// Sets grade, passed, unchanged, edited, resembles and the refusal of controls that are not offered. `shipped` and
// `wrong` are the grades of the shipped brain and of the wrong answers from the same seeds.
void judge(const Exercise&, ClassRow&, Grade, const Grade& shipped, const std::vector<Grade>& wrong);

// True if the submission has the wires of the wrong answer that it resembles, with the same signs: else what that
// answer's text says of wires is not true of it. Precondition: the row has `resembles`.
bool has_wires_of_mistake(const ClassReport&, const ClassRow&);

// Number of starts from which the step was done.
int starts_done(const Grade&, std::size_t step);

// The first row of each person none of whose files can be graded.
std::vector<const ClassRow*> people_without(const std::vector<ClassRow>&);

struct ClassSummary {
    int students = 0;                       // people of the class: `counted` and `without`
    int counted = 0;                        // rows without a problem
    int without = 0;                        // people none of whose files can be graded
    int passed = 0, passed_shown = 0;       // passed_shown: of them, those where the lab had set the solution
    maths::Spread starts;                   // passed, in the rows that count
    std::vector<int> failed;                // of each step: starts that it made fail, see failed_step()
    std::optional<std::size_t> worst_step;  // the one that made most starts fail
    int refused = 0;                        // students with a refusal; they are in none of the next three
    std::vector<int> resembling;            // of each wrong answer: students
    int unchanged = 0;                      // students whose behaviour is that of the shipped brain
    int other = 0;                          // students who fail in another way
};
ClassSummary summary_of(const ClassReport&);

// In the language of the strings. problem_text(): empty if the row has no problem.
std::string text_of(const RowProblem&, const Strings&);
std::string problem_text(const ClassRow&, const Strings&);

// What to tell the student, in the language of the strings.
std::string feedback(const ClassReport&, const ClassRow&, const Strings&);

// A header and one line a row. Texts that a spreadsheet would read as a formula begin with an apostrophe.
std::string class_csv(const ClassReport&, const Strings&);

// A self-contained page: the summary, a table that a click on a heading sorts, and each student's starts and feedback.
// `language`: its code.
std::string class_page(const ClassReport&, const Strings&, const std::string& language);

}  // namespace braitenlab

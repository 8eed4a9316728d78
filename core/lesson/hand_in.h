// What a student hands in for an exercise: one TOML file that `braitenctl grade` reads. The format: docs/grading.md.
#pragma once

#include <string>
#include <string_view>

#include "core/lesson/exercise.h"
#include "core/result.h"

namespace braitenlab {

namespace limits {
inline constexpr std::size_t student_length = 120, notes_length = 8000;  // bytes
}  // namespace limits

struct HandIn {
    std::string student;          // as typed
    std::string exercise;         // Exercise::id
    std::string written;          // time of writing in UTC: "2026-11-22T16:37:29Z"; may be empty
    int prediction = 0;           // number, from 1, of the option that the student chose; 0: none
    int runs = 0;                 // runs begun since the exercise was opened
    int hints = 0;                // hints shown
    bool solution_shown = false;  // the lab set the solution for the student
    int graded_starts = 0;        // starts that the student's lab has graded; 0: not graded
    int passed_starts = 0;        // of these
    std::string notes;
    Submission submission;
    friend bool operator==(const HandIn&, const HandIn&) = default;
};

// The ending of the file's name, and a name for the file without folder: "05-aggressor-ana-lopez.braiten-handin.toml".
// Letters with an accent lose it; what cannot be part of a file name becomes '-'. `number` from 2 on is added where
// another student's file has the name.
inline constexpr std::string_view hand_in_ending = ".braiten-handin.toml";
std::string hand_in_name(const std::string& exercise, const std::string& student, int number = 1);

// "05-aggressor-ana-lopez.html"; `number` as in hand_in_name().
std::string lab_record_name(const std::string& exercise, const std::string& student, int number = 1);

// True for the name of a hand-in file.
inline bool is_hand_in(std::string_view file_name) { return file_name.ends_with(hand_in_ending); }

// True for a hand-in by its name, or by its text if it was renamed.
inline bool holds_hand_in(std::string_view file_name, std::string_view toml) {
    return is_hand_in(file_name) || toml.find("\n[submission") != std::string_view::npos;
}

// parse_hand_in(write_hand_in(h)) == h, except that a four-neuron brain loses the order of its nodes and wires, and
// texts above their limits are cut between two characters.
std::string write_hand_in(HandIn);

// Errors carry file and line: syntax, unknown key, wrong type, value out of range, a missing student, exercise or
// submission, a brain that does not compile.
Result<HandIn> parse_hand_in(std::string_view toml, const std::string& file_name);

// With all errors. A value outside its range is left out; the others are those of the file.
template <class T>
struct ReadFile;
ReadFile<HandIn> read_hand_in_fully(std::string_view toml, const std::string& file_name);

// Two names of one student: equal but for spaces at the ends, repeated spaces and the case of ASCII letters.
bool is_same_student(std::string_view, std::string_view);

// The name as is_same_student() compares it: in small ASCII letters, with single spaces.
std::string for_comparison(std::string_view name);

}  // namespace braitenlab

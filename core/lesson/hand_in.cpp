#include "core/lesson/hand_in.h"

#include <utility>

#include <fmt/format.h>

#include "core/messages.h"
#include "core/plain_letters.h"
#include "core/scene/check.h"
#include "core/scene/toml_reader.h"
#include "core/scene/toml_writer.h"
#include "core/utf8.h"

namespace braitenlab {

void describe(auto& v, Of<Submission>) {
    v.table("body", &Submission::body, "chassis and wheels, as in a kind");
    v.named("sensor", &Submission::sensors, limits::sensors, "a sensor, as in a kind");
    v.brain("brain", &Submission::brain, "as in a kind");
}

void describe(auto& v, Of<HandIn>) {
    constexpr Range counts{0, 1e6};
    v.text("student", &HandIn::student, limits::student_length, "name of the student; required");
    v.text("exercise", &HandIn::exercise, limits::title_length, "id of the exercise, like 05-aggressor; required");
    v.text("written", &HandIn::written, limits::name_length, "time of writing in UTC, like \"2026-11-22T16:37:29Z\"");
    v.number("prediction", &HandIn::prediction, "", {0, 100}, "number of the option chosen, from 1; 0: none");
    v.number("runs", &HandIn::runs, "", counts, "runs begun since the exercise was opened");
    v.number("hints", &HandIn::hints, "", counts, "hints shown");
    v.flag("solution_shown", &HandIn::solution_shown, "the lab set the solution for the student");
    v.number("graded_starts", &HandIn::graded_starts, "", counts, "starts graded in the student's lab; 0: none");
    v.number("passed_starts", &HandIn::passed_starts, "", counts, "of these, passed");
    v.text("notes", &HandIn::notes, limits::notes_length, "the student's notes");
    v.table("submission", &HandIn::submission, "what the student has changed, complete; required");
}

namespace {

// Small ASCII letters, digits and single '-'; letters of other scripts stay as they are.
std::string for_file_name(std::string_view text) {
    std::string name = utf8_cut(with_dashes(plain_letters(text, Umlauts::spelled), true), 80);
    if (name.ends_with('-')) name.pop_back();
    return name.empty() ? "student" : name;
}

void check_hand_in(TomlTable& top, const HandIn& hand_in) {
    for (const char* key : {"student", "exercise", "submission"})
        if (!top.has(key)) top.fail_missing(key, message_of("missing_in_hand_in", key));
    TomlFile& file = top.file();
    if (!file.failed() && for_comparison(hand_in.student).empty())
        top.fail("student", message_of("empty_key", "student"));
    if (!file.failed() && hand_in.passed_starts > hand_in.graded_starts)
        top.fail("passed_starts", message_of("more_passed_than_graded"));
    if (file.failed()) return;
    if (const auto fault = find_fault(hand_in.submission.brain)) {
        const std::string path = "submission.brain" + (fault->path.empty() ? "" : "." + fault->path);
        file.add(path, file.fault_at(path, fault->what));
    }
}

HandIn read_hand_in_file(TomlFile& file) {
    HandIn hand_in;
    TomlTable top = read_top(file, hand_in);
    if (!file.failed()) check_hand_in(top, hand_in);
    return hand_in;
}

std::string numbered_name(const std::string& exercise, const std::string& student, int number) {
    const std::string more = number > 1 ? fmt::format("-{}", number) : "";
    return for_file_name(exercise) + "-" + for_file_name(student) + more;
}

}  // namespace

std::string hand_in_name(const std::string& exercise, const std::string& student, int number) {
    return numbered_name(exercise, student, number) + std::string(hand_in_ending);
}

std::string lab_record_name(const std::string& exercise, const std::string& student, int number) {
    return numbered_name(exercise, student, number) + ".html";
}

std::string write_hand_in(HandIn hand_in) {
    hand_in.student = utf8_cut(std::move(hand_in.student), limits::student_length);
    hand_in.notes = utf8_cut(std::move(hand_in.notes), limits::notes_length);
    // The file needs the table, also of a brain without nodes.
    return write_top(hand_in) + (hand_in.submission.brain.nodes.empty() ? "\n[submission.brain]\n" : "");
}

Result<HandIn> parse_hand_in(std::string_view toml, const std::string& file_name) {
    return read_whole(toml, file_name, read_hand_in_file);
}

ReadFile<HandIn> read_hand_in_fully(std::string_view toml, const std::string& file_name) {
    return read_fully(toml, file_name, read_hand_in_file);
}

std::string for_comparison(std::string_view name) {
    std::string words;
    for (const char c : name) {
        const bool is_space = c == ' ' || c == '\t';
        if (is_space && (words.empty() || words.back() == ' ')) continue;
        words += is_space ? ' ' : lower_case(c);
    }
    if (!words.empty() && words.back() == ' ') words.pop_back();
    return words;
}

bool is_same_student(std::string_view a, std::string_view b) { return for_comparison(a) == for_comparison(b); }

}  // namespace braitenlab

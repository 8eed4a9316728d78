// braitenctl check and grade: whether exercises are sound and whether brains pass them.
#include <iostream>

#include <fmt/format.h>

#include "app/ctl/ctl.h"
#include "app/ctl/table_file.h"
#include "app/files/data.h"
#include "app/files/safe_file.h"
#include "core/brain/recogniser.h"
#include "core/io/csv.h"
#include "core/lesson/exercise.h"
#include "core/lesson/grade.h"

namespace braitenlab {

namespace {

Result<Exercise> find_exercise(const std::string& name) {
    const auto path = find_shipped(name);
    if (!path) return path.error();
    return load_exercise(*path);
}

void print_grade(const Exercise& exercise, const Grade& grade) {
    std::cout << fmt::format("{}: {} of {} starts pass, {} needed: {}\n", exercise.id, grade.count, grade.passed.size(),
                             exercise.needed, grade.good ? "passed" : "not passed");
    for (std::size_t i = 0; i < grade.passed.size(); ++i)
        if (!grade.passed[i]) std::cout << fmt::format("  start {} fails\n", i + 1);
}

// An exercise is sound when no start passes as shipped and every start passes with the solution.
bool is_sound(const Exercise& exercise) {
    const Grade shipped = grade(exercise, as_shipped(exercise));
    const Grade solved = grade(exercise, with_solution(exercise));
    const bool sound = shipped.count == 0 && solved.count == exercise.starts;
    std::cout << fmt::format(
        "{}: as shipped {} of {} starts pass (none should), with its solution {} (all should): {}\n", exercise.id,
        shipped.count, exercise.starts, solved.count, sound ? "good" : "wrong");
    return sound;
}

// What a row of `grade` says about a file.
struct GradedFile {
    std::string file;
    std::string owner;      // of the brain
    std::string character;  // of the brain; empty with an error
    Grade grade;
    std::string error;  // empty: none
};

std::string graded_row(const Exercise& exercise, const GradedFile& graded) {
    std::string row;
    const auto add = [&](const io::CsvValue& value) {
        io::add_csv_cell(row, value);
        row += ',';
    };
    add(std::string_view(graded.file));
    add(std::string_view(graded.grade.good ? "yes" : "no"));
    for (const int number : {graded.grade.count, exercise.starts, exercise.needed}) add(std::int64_t{number});
    for (const std::string& text : {graded.character, graded.owner, graded.error}) add(std::string_view(text));
    for (std::size_t start = 0; start < static_cast<std::size_t>(exercise.starts); ++start)
        add(std::string_view(!graded.error.empty() ? "" : graded.grade.passed[start] ? "yes" : "no"));
    row.back() = '\n';
    return row;
}

}  // namespace

int check(const std::string& name, const std::string& brain_file, const BrainChoice& choice) {
    const auto exercise = find_exercise(name);
    if (!exercise) return complain(exercise.error());
    if (brain_file.empty() && !(choice.kind.empty() && choice.vehicle.empty()))
        return complain({"--kind and --vehicle need --brain FILE, from which the brain is taken"});
    if (brain_file.empty()) return is_sound(*exercise) ? exit_code::done : exit_code::failed;
    auto found = brain_of_file(brain_file, choice);
    if (!found) return complain(found.error());
    const Grade result = grade(*exercise, with_brain(*exercise, std::move(found->brain)));
    if (!found->owner.empty()) std::cout << fmt::format("brain of {} in {}\n", found->owner, brain_file);
    print_grade(*exercise, result);
    return result.good ? exit_code::done : exit_code::failed;
}

int check_all() {
    int wrong = 0;
    for (const auto& path : shipped_exercises()) {
        const auto exercise = load_exercise(path);
        if (!exercise) return complain(exercise.error());
        wrong += !is_sound(*exercise);
    }
    return wrong == 0 ? exit_code::done : exit_code::failed;
}

int grade_all(const std::string& name, const std::vector<std::string>& brain_files, const BrainChoice& choice,
              const std::string& csv) {
    const auto exercise = find_exercise(name);
    if (!exercise) return complain(exercise.error());
    std::string rows = "brain,passed,starts_passed,starts,needed,character,brain_of,error";
    for (int start = 1; start <= exercise->starts; ++start) rows += fmt::format(",start_{}", start);
    rows += "\n";
    bool all_read = true;
    for (const std::string& file : brain_files) {
        auto found = brain_of_file(file, choice);
        GradedFile graded{.file = file};
        if (found) {
            graded.owner = found->owner;
            graded.character = braitenlab::name(recognise(found->brain));
            graded.grade = grade(*exercise, with_brain(*exercise, std::move(found->brain)));
        } else {
            all_read = false;
            graded.error = found.error().text();
            if (!csv.empty()) complain(found.error());
        }
        rows += graded_row(*exercise, graded);
    }
    if (csv.empty() || csv == standard_output)
        std::cout << rows;
    else if (const auto error = write_whole(csv, rows))
        return complain(*error);
    return all_read ? exit_code::done : exit_code::bad_input;
}

}  // namespace braitenlab

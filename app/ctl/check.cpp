// braitenctl check and grade: whether exercises are sound and whether brains pass them.
#include <iostream>
#include <sstream>

#include <fmt/format.h>

#include "app/ctl/ctl.h"
#include "app/ctl/table_file.h"
#include "app/files/data.h"
#include "app/files/safe_file.h"
#include "core/brain/recogniser.h"
#include "core/lesson/exercise.h"
#include "core/lesson/grade.h"
#include "core/scene/scene_file.h"

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

// A cell of a CSV file (RFC 4180).
std::string cell(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + "\"";
}

}  // namespace

int check(const std::string& name, const std::string& brain_file) {
    const auto exercise = find_exercise(name);
    if (!exercise) return complain(exercise.error());
    if (brain_file.empty()) return is_sound(*exercise) ? exit_code::done : exit_code::failed;
    auto brain = load_brain(brain_file);
    if (!brain) return complain(brain.error());
    const Grade result = grade(*exercise, with_brain(*exercise, std::move(*brain)));
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

int grade_all(const std::string& name, const std::vector<std::string>& brain_files, const std::string& csv) {
    const auto exercise = find_exercise(name);
    if (!exercise) return complain(exercise.error());
    std::ostringstream rows;
    rows << "brain,passed,starts_passed,starts,needed,character,error";
    for (int start = 1; start <= exercise->starts; ++start) rows << ",start_" << start;
    rows << "\n";
    bool all_read = true;
    for (const std::string& file : brain_files) {
        const auto brain = load_brain(file);
        rows << cell(file) << ",";
        if (!brain) {
            all_read = false;
            if (!csv.empty()) complain(brain.error());
            rows << fmt::format("no,0,{},{},,{}", exercise->starts, exercise->needed, cell(brain.error().text()))
                 << std::string(static_cast<std::size_t>(exercise->starts), ',') << "\n";
            continue;
        }
        const Grade result = grade(*exercise, with_brain(*exercise, *brain));
        rows << fmt::format("{},{},{},{},{},", result.good ? "yes" : "no", result.count, exercise->starts,
                            exercise->needed, braitenlab::name(recognise(*brain)));
        for (const bool passed : result.passed) rows << (passed ? ",yes" : ",no");
        rows << "\n";
    }
    if (csv.empty() || csv == standard_output)
        std::cout << rows.str();
    else if (const auto error = write_whole(csv, rows.str()))
        return complain(*error);
    return all_read ? exit_code::done : exit_code::bad_input;
}

}  // namespace braitenlab

// braitenctl check and grade: does a brain pass an exercise?
#include <iostream>
#include <sstream>

#include <fmt/format.h>

#include "app/ctl.h"
#include "app/data.h"
#include "app/safe_file.h"
#include "core/brain/recogniser.h"
#include "core/lesson/exercise.h"
#include "core/lesson/referee.h"
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

const BrainGraph& pupil_brain(const Exercise& exercise) {
    return exercise.scene.kinds[static_cast<std::size_t>(pupil_kind(exercise.scene))].brain;
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
    BrainGraph brain = pupil_brain(*exercise);
    if (!brain_file.empty()) {
        auto own = load_brain(brain_file);
        if (!own) return complain(own.error());
        brain = *own;
    }
    const Grade result = grade(*exercise, brain);
    print_grade(*exercise, result);
    return result.good ? exit_code::done : exit_code::failed;
}

// Every shipped exercise must fail as shipped and pass with its solution, from every start.
int check_all() {
    int wrong = 0;
    for (const auto& path : shipped_exercises()) {
        const auto exercise = load_exercise(path);
        if (!exercise) return complain(exercise.error());
        const Grade shipped = grade(*exercise, pupil_brain(*exercise));
        const Grade solved = grade(*exercise, make_graph(exercise->solution));
        const bool good = shipped.count == 0 && solved.count == exercise->starts;
        std::cout << fmt::format(
            "{}: as shipped {} of {} starts pass (none should), with its solution {} (all should): {}\n", exercise->id,
            shipped.count, exercise->starts, solved.count, good ? "good" : "wrong");
        wrong += !good;
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
        const Grade result = grade(*exercise, *brain);
        rows << fmt::format("{},{},{},{},{},", result.good ? "yes" : "no", result.count, exercise->starts,
                            exercise->needed, braitenlab::name(recognise(*brain)));
        for (const bool passed : result.passed) rows << (passed ? ",yes" : ",no");
        rows << "\n";
    }
    if (csv.empty())
        std::cout << rows.str();
    else if (const auto error = write_whole(csv, rows.str()))
        return complain(*error);
    return all_read ? exit_code::done : exit_code::bad_input;
}

}  // namespace braitenlab

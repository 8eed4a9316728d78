// braitenctl check and grade: whether exercises are sound and whether brains pass them.
#include <algorithm>
#include <iostream>
#include <memory>

#include <fmt/format.h>

#include "app/ctl/ctl.h"
#include "app/ctl/table_file.h"
#include "app/files/data.h"
#include "app/files/safe_file.h"
#include "app/jobs/grading.h"
#include "core/brain/recogniser.h"
#include "core/io/csv.h"
#include "core/lesson/exercise.h"
#include "core/lesson/grade.h"

namespace braitenlab {

namespace {

using SharedExercise = std::shared_ptr<const Exercise>;

Result<SharedExercise> read_exercise(const std::filesystem::path& path) {
    auto exercise = load_exercise(path);
    if (!exercise) return exercise.error();
    return std::make_shared<const Exercise>(std::move(*exercise));
}

Result<SharedExercise> find_exercise(const std::string& name) {
    const auto path = find_shipped(name);
    if (!path) return path.error();
    return read_exercise(*path);
}

// The grades of the submissions, in their order. Their starts run on all processors.
Result<std::vector<Grade>> grade_several(const SharedExercise& exercise, const std::vector<Submission>& submissions) {
    Jobs jobs(threads_for(0));
    std::vector<Job<Grade>> running;
    for (const Submission& submission : submissions) running.push_back(submit_grading(jobs, exercise, submission));
    jobs.finish();
    std::vector<Grade> grades;
    for (Job<Grade>& job : running) {
        auto grade = job.take();
        if (!*grade) return grade->error();
        grades.push_back(std::move(**grade));
    }
    return grades;
}

void print_grade(const Exercise& exercise, const Grade& grade) {
    std::cout << fmt::format("{}: {} of {} starts pass, {} needed: {}\n", exercise.id, grade.count, grade.passed.size(),
                             exercise.needed, grade.good ? "passed" : "not passed");
    for (std::size_t i = 0; i < grade.passed.size(); ++i)
        if (!grade.passed[i]) std::cout << fmt::format("  start {} fails\n", i + 1);
}

// An exercise is sound when no start passes as shipped and every start passes with the solution. Returns the exit code.
int check_sound(const SharedExercise& exercise) {
    const auto grades = grade_several(exercise, {as_shipped(*exercise), with_solution(*exercise)});
    if (!grades) return complain(grades.error());
    const int shipped = grades->at(0).count, solved = grades->at(1).count;
    const bool sound = shipped == 0 && solved == exercise->starts;
    std::cout << fmt::format(
        "{}: as shipped {} of {} starts pass (none should), with its solution {} (all should): {}\n", exercise->id,
        shipped, exercise->starts, solved, sound ? "good" : "wrong");
    return sound ? exit_code::done : exit_code::failed;
}

// What a row of `grade` says about a file.
struct GradedFile {
    std::string file;
    Result<BrainOfFile> found;
    Grade grade;  // of the brain, if one is found
};

std::string graded_row(const Exercise& exercise, const GradedFile& graded) {
    const std::string character = graded.found ? name(recognise(graded.found->brain)) : "";
    const std::string owner = graded.found ? graded.found->owner : "";
    const std::string error = graded.found ? "" : graded.found.error().text();
    std::string row;
    const auto add = [&](const io::CsvValue& value) {
        io::add_csv_cell(row, value);
        row += ',';
    };
    add(std::string_view(graded.file));
    add(std::string_view(graded.grade.good ? "yes" : "no"));
    for (const int number : {graded.grade.count, exercise.starts, exercise.needed}) add(std::int64_t{number});
    for (const std::string_view text : {std::string_view(character), std::string_view(owner), std::string_view(error)})
        add(text);
    for (std::size_t start = 0; start < static_cast<std::size_t>(exercise.starts); ++start)
        add(std::string_view(!graded.found ? "" : graded.grade.passed[start] ? "yes" : "no"));
    row.back() = '\n';
    return row;
}

// The files with their grades, in their order.
Result<std::vector<GradedFile>> grade_files(const SharedExercise& exercise, const std::vector<std::string>& files,
                                            const BrainChoice& choice) {
    std::vector<GradedFile> graded;
    std::vector<Submission> submissions;
    for (const std::string& file : files) {
        graded.push_back({file, brain_of_file(file, choice), {}});
        if (const auto& found = graded.back().found) submissions.push_back(with_brain(*exercise, found->brain));
    }
    auto grades = grade_several(exercise, submissions);
    if (!grades) return grades.error();
    auto next = grades->begin();
    for (GradedFile& file : graded)
        if (file.found) file.grade = std::move(*next++);
    return graded;
}

}  // namespace

int check(const std::string& name, const std::string& brain_file, const BrainChoice& choice) {
    const auto exercise = find_exercise(name);
    if (!exercise) return complain(exercise.error());
    if (brain_file.empty() && !(choice.kind.empty() && choice.vehicle.empty()))
        return complain({"--kind and --vehicle need --brain FILE, from which the brain is taken"});
    if (brain_file.empty()) return check_sound(*exercise);
    auto found = brain_of_file(brain_file, choice);
    if (!found) return complain(found.error());
    const auto grades = grade_several(*exercise, {with_brain(**exercise, std::move(found->brain))});
    if (!grades) return complain(grades.error());
    if (!found->owner.empty()) std::cout << fmt::format("brain of {} in {}\n", found->owner, brain_file);
    print_grade(**exercise, grades->front());
    return grades->front().good ? exit_code::done : exit_code::failed;
}

int check_all() {
    int result = exit_code::done;
    for (const auto& path : shipped_exercises()) {
        const auto exercise = read_exercise(path);
        if (!exercise) return complain(exercise.error());
        result = std::max(result, check_sound(*exercise));
    }
    return result;
}

int grade_all(const std::string& name, const std::vector<std::string>& brain_files, const BrainChoice& choice,
              const std::string& csv) {
    const auto exercise = find_exercise(name);
    if (!exercise) return complain(exercise.error());
    const auto graded = grade_files(*exercise, brain_files, choice);
    if (!graded) return complain(graded.error());
    std::string rows = "brain,passed,starts_passed,starts,needed,character,brain_of,error";
    for (int start = 1; start <= (*exercise)->starts; ++start) rows += fmt::format(",start_{}", start);
    rows += "\n";
    bool all_read = true;
    for (const GradedFile& file : *graded) {
        rows += graded_row(**exercise, file);
        if (file.found) continue;
        all_read = false;
        if (!csv.empty()) complain(file.found.error());
    }
    if (csv.empty() || csv == standard_output)
        std::cout << rows;
    else if (const auto error = write_whole(csv, rows))
        return complain(*error);
    return all_read ? exit_code::done : exit_code::bad_input;
}

}  // namespace braitenlab

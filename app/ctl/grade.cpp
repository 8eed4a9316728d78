// braitenctl grade: grades brains against an exercise, one row each.

#include <fmt/format.h>

#include "app/ctl/ctl.h"
#include "app/ctl/exercises.h"
#include "app/ctl/table_file.h"
#include "core/brain/recogniser.h"
#include "core/io/csv.h"

namespace braitenlab {

namespace {

// What a row of `grade` says about a file.
struct GradedFile {
    std::string file;
    Result<BrainOfFile> found;
    Grade grade;          // of the brain, if one is found; not good if there is a fault
    std::string fault{};  // see offers_fault()
};

std::string graded_row(const Exercise& exercise, const GradedFile& graded) {
    const std::string character = graded.found ? name(recognise(graded.found->brain)) : "";
    const std::string owner = graded.found ? graded.found->owner : "";
    const std::string error = graded.found ? graded.fault : graded.found.error().text();
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
        add(std::string_view(!graded.found ? "" : graded.grade.starts[start].passed ? "yes" : "no"));
    row.back() = '\n';
    return row;
}

// The files with their grades, in their order.
Result<std::vector<GradedFile>> grade_files(const SharedExercise& exercise, const ClassOptions& options) {
    std::vector<GradedFile> graded;
    std::vector<Submission> submissions;
    for (const std::string& file : options.files) {
        graded.push_back({file, brain_of_file(file, options.choice), {}});
        if (const auto& found = graded.back().found) {
            submissions.push_back(submission_with(*exercise, *found));
            graded.back().fault = offers_fault(*exercise, submissions.back());
        }
    }
    auto grades = grade_several(exercise, submissions, options.first_seed);
    if (!grades) return grades.error();
    auto next = grades->begin();
    for (GradedFile& file : graded) {
        if (!file.found) continue;
        file.grade = std::move(*next++);
        file.grade.good = file.grade.good && file.fault.empty();
    }
    return graded;
}

}  // namespace

int grade(const ClassOptions& options) {
    if (!options.html.empty() || !options.platform.empty() || is_class(options.files)) return grade_class(options);
    const std::string& csv = options.csv;
    const auto exercise = find_exercise(options.exercise);
    if (!exercise) return complain(exercise.error());
    if (const auto error = missing_argument(options.files)) return complain(*error);
    const auto graded = grade_files(*exercise, options);
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
    const auto style = style_of(options.table);
    if (!style) return complain(style.error());
    if (const auto error = write_table(csv.empty() ? std::string(standard_output) : csv, *style, rows))
        return complain(*error);
    return all_read ? exit_code::done : exit_code::bad_input;
}

}  // namespace braitenlab

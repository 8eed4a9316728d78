// braitenctl grade with a folder or hand-in files: a row a student, as CSV and as a page.
#include <algorithm>
#include <filesystem>
#include <optional>
#include <string_view>

#include "app/ctl/ctl.h"
#include "app/ctl/exercises.h"
#include "app/ctl/table_file.h"
#include "app/files/data.h"
#include "app/files/safe_file.h"
#include "app/reports/class_report.h"
#include "core/lesson/submission.h"
#include "core/scene/file_kind.h"
#include "core/scene/folder_entries.h"

namespace braitenlab {

namespace fs = std::filesystem;

namespace {

// True for a file of a class: not hidden, and no result of an earlier grading.
bool is_to_be_graded(const fs::path& path) {
    const std::string name = path.filename().string();
    return !name.starts_with(".") && path.extension() != ".csv" && path.extension() != ".html";
}

// The files, with those of each folder in place of it, sorted by name.
std::vector<fs::path> files_of(const std::vector<std::string>& arguments) {
    std::vector<fs::path> files;
    for (const std::string& argument : arguments) {
        std::error_code none;
        if (!fs::is_directory(argument, none)) {
            files.emplace_back(argument);
            continue;
        }
        std::vector<fs::path> inside;
        for_each_entry(argument, [&](const fs::directory_entry& entry) {
            if (entry.is_regular_file(none) && is_to_be_graded(entry.path())) inside.push_back(entry.path());
        });
        std::sort(inside.begin(), inside.end());
        files.insert(files.end(), inside.begin(), inside.end());
    }
    return files;
}

ClassRow row_of_brain(const Exercise& exercise, const fs::path& path, const BrainChoice& choice) {
    ClassRow row{.file = path.filename().string(), .student = path.stem().string()};
    if (auto brain = brain_of_file(path.string(), choice))
        row.submission = with_brain(exercise, std::move(brain->brain));
    else
        row.problem = RowProblem{{}, {}, brain.error()};
    return row;
}

// True for the content of a picture, an archive or a document: it has a zero byte and is not UTF-16, of which the
// reader says what to do.
bool is_no_text(std::string_view content) {
    const bool is_utf16 = content.starts_with("\xFF\xFE") || content.starts_with("\xFE\xFF");
    return !is_utf16 && content.find('\0') != std::string_view::npos;
}

// A file is a hand-in by its name, or by its content if it was renamed.
ClassRow row_of_file(const Exercise& exercise, const fs::path& path, const BrainChoice& choice) {
    const std::string name = path.filename().string();
    if (path.extension() == ".run") return row_of_brain(exercise, path, choice);
    const auto text = read_text(path);
    const bool is_binary = text && is_no_text(*text);
    if (holds_hand_in(name, text ? *text : std::string()) || (text && is_blank(*text)))
        return row_of_hand_in(exercise, name, text);
    // A shipped scene is named without an ending, and does not exist at the path.
    const bool may_have_brain = path.extension() == ".toml" || !text;
    return may_have_brain && !is_binary ? row_of_brain(exercise, path, choice) : row_of_other_file(name);
}

// Grades the rows that have a submission, and the shipped brain and the wrong answers for comparison.
std::optional<Error> grade_rows(const SharedExercise& exercise, std::uint64_t first_seed, std::vector<ClassRow>& rows) {
    std::vector<Submission> submissions{as_shipped(*exercise)};
    for (const Answer& wrong : exercise->wrong) submissions.push_back(wrong.submission);
    const std::size_t known = submissions.size();
    for (const ClassRow& row : rows)
        if (row.submission) submissions.push_back(*row.submission);
    auto grades = grade_several(exercise, submissions, first_seed);
    if (!grades) return grades.error();
    const std::vector<Grade> wrong(grades->begin() + 1, grades->begin() + static_cast<std::ptrdiff_t>(known));
    std::size_t next = known;
    for (ClassRow& row : rows)
        if (row.submission) judge(*exercise, row, std::move((*grades)[next++]), grades->front(), wrong);
    return std::nullopt;
}

// The words of the language, with the translation of the exercise.
Result<Strings> words_for(const Exercise& exercise, const std::string& language) {
    const auto folder = data_folder();
    if (!folder) return folder.error();
    auto strings = strings_of(language);
    const fs::path translations = *folder / "exercises" / "words" / (language + ".toml");
    std::error_code none;
    if (!strings || !fs::exists(translations, none)) return strings;
    const auto words = Strings::load(translations);
    if (!words) return words.error();
    add_translations(*strings, texts_of(exercise), *words);
    return strings;
}

std::optional<Error> write_results(const ClassReport& report, const Strings& strings, const ClassOptions& options) {
    if (!options.html.empty())
        if (auto error = write_whole(options.html, class_page(report, strings, options.table.language))) return error;
    if (options.csv.empty() && !options.html.empty()) return std::nullopt;
    const auto style = style_of(options.table);
    if (!style) return style.error();
    TableFile table(options.csv.empty() ? std::string(standard_output) : options.csv, *style);
    table.write(class_csv(report, strings));
    return table.close();
}

}  // namespace

bool is_class(const std::vector<std::string>& files) {
    return std::any_of(files.begin(), files.end(), [](const std::string& file) {
        std::error_code none;
        return fs::is_directory(file, none) || is_hand_in(file);
    });
}

std::optional<Error> missing_argument(const std::vector<std::string>& arguments) {
    for (const std::string& argument : arguments)
        if (!find_shipped(argument))
            return Error{"there is no such file or folder, and no shipped scene of this name", argument};
    return std::nullopt;
}

int grade_class(const ClassOptions& options) {
    const auto exercise = find_exercise(options.exercise);
    if (!exercise) return complain(exercise.error());
    if (const auto error = missing_argument(options.files)) return complain(*error);
    const auto strings = words_for(**exercise, options.table.language);
    if (!strings) return complain(strings.error());
    ClassReport report{*exercise, options.first_seed, {}};
    for (const fs::path& file : files_of(options.files))
        report.rows.push_back(row_of_file(**exercise, file, options.choice));
    if (report.rows.empty()) return complain({"there is no file to grade; give a folder with hand-in files"});
    mark_replaced(report.rows);
    if (const auto error = grade_rows(*exercise, options.first_seed, report.rows)) return complain(*error);
    sort_by_student(report.rows);
    if (const auto error = write_results(report, *strings, options)) return complain(*error);
    bool all_read = true;
    for (const ClassRow& row : report.rows)
        if (!row.submission)
            all_read = false, complain({problem_text(row, *strings), row.problem->error ? "" : row.file});
    return all_read ? exit_code::done : exit_code::bad_input;
}

}  // namespace braitenlab

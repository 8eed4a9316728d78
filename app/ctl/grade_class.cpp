// braitenctl grade with a folder or hand-in files: a row a student, as CSV and as a page.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "app/ctl/class_files.h"
#include "app/ctl/ctl.h"
#include "app/ctl/exercises.h"
#include "app/ctl/table_file.h"
#include "app/files/data.h"
#include "app/files/safe_file.h"
#include "app/reports/class_report.h"
#include "app/reports/gradebook.h"
#include "app/terminal.h"
#include "core/lesson/exercise_file.h"
#include "core/lesson/submission.h"
#include "core/plain_letters.h"
#include "core/scene/file_kind.h"
#include "core/utf8.h"

namespace braitenlab {

namespace fs = std::filesystem;

namespace {

ClassRow with_brain_of(const Exercise& exercise, ClassRow row, Result<BrainOfFile> brain) {
    if (brain)
        row.submission = submission_with(exercise, std::move(*brain));
    else
        row.problem = RowProblem{{}, {}, brain.error()};
    return row;
}

// True for content that is no text: it has a zero byte and is not UTF-16, of which the reader says what to do.
bool is_no_text(std::string_view content) {
    const bool is_utf16 = content.starts_with("\xFF\xFE") || content.starts_with("\xFE\xFF");
    return !is_utf16 && content.find('\0') != std::string_view::npos;
}

// The key of the words for a file of another program, by its content or its ending; empty for none that is known.
std::string_view foreign_key(const fs::path& file, std::string_view content) {
    const auto begins = [&](std::string_view text) { return content.starts_with(text); };
    const std::string ending = lower_case(file.extension().string());
    if (begins("%PDF") || ending == ".pdf") return "report.is_pdf";
    if (ending == ".zip" || (is_zip(content) && ending == ".toml")) return "report.is_archive";
    if (begins("\x89PNG") || begins("\xFF\xD8\xFF") || ending == ".png" || ending == ".jpg" || ending == ".jpeg")
        return "report.is_picture";
    if (begins("<!DOCTYPE") || begins("<html")) return "report.is_page";
    return is_zip(content) || is_no_text(content) ? "report.no_hand_in" : "";
}

// A file is a hand-in by its name, or by its content if it was renamed.
ClassRow row_of_file(const Exercise& exercise, const ClassFile& file, const BrainChoice& choice) {
    const fs::path name = file.file;
    // A shipped scene is named without an ending, and does not exist at the path.
    std::error_code none;
    const bool is_shipped = !file.archive && !fs::exists(file.path, none);
    ClassRow row = row_of_other_file(file.file, file.submitter);
    row.problem.reset();
    if (is_shipped || (!file.archive && name.extension() == ".run"))
        return with_brain_of(exercise, std::move(row), brain_of_file(file.path.string(), choice));
    const auto text = text_of(file);
    const std::string_view content = text ? std::string_view(*text) : std::string_view();
    std::string_view key = foreign_key(name, content);
    if (key.empty() && file.archive && !text) key = "report.not_unpacked";
    if (key.empty() && file.archive && name.extension() == ".run") key = "report.run_in_archive";
    if (!key.empty()) {
        row.problem = RowProblem{key, "", {}};
        return row;
    }
    if (holds_hand_in(file.file, content) || !text || is_blank(content))
        return row_of_hand_in(exercise, file.file, text, file.submitter);
    if (name.extension() != ".toml") return row_of_other_file(file.file, file.submitter);
    row.fingerprint = content;
    return with_brain_of(exercise, std::move(row), brain_of_text(*text, file.file, choice));
}

ClassRow row_of_empty_folder(const ClassFile& folder) {
    const std::string& name = folder.submitter.folder;
    ClassRow row = row_of_other_file(name.empty() ? folder.file : name, folder.submitter);
    row.problem = RowProblem{"report.empty_folder", "", {}};
    return row;
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

std::optional<Error> write_results(const ClassReport& report, const Strings& strings, const ClassOptions& options) {
    if (!options.html.empty())
        if (auto error = write_whole(options.html, class_page(report, strings, options.table.language))) return error;
    if (options.csv.empty() && !options.html.empty()) return std::nullopt;
    const auto style = style_of(options.table);
    if (!style) return style.error();
    if (options.csv.empty() && !options.marks.empty()) return std::nullopt;
    return write_table(options.csv.empty() ? std::string(standard_output) : options.csv, *style,
                       class_csv(report, strings));
}

std::optional<Error> check_marks(const ClassOptions& options) {
    if (options.platform.empty())
        return options.marks.empty() && options.list.empty() && options.column.empty() && options.points == 0
                   ? std::nullopt
                   : std::optional(Error{"--marks, --list, --column and --points belong to --gradebook PLATFORM"});
    if (options.marks.empty()) return Error{"give the file of the marks with --marks FILE", "--gradebook"};
    const auto platform = named_in(platform_table, options.platform, "there is no platform", "--gradebook");
    return platform ? std::nullopt : std::optional(platform.error());
}

// A text with the number of the names and all of them.
std::string with_names(std::string_view text, const std::vector<std::string>& names) {
    return fill(text, {std::to_string(names.size()), fmt::format("{}", fmt::join(names, "; "))});
}

// Writes the marks. Returns exit_code::bad_input where one has no place in the list.
int write_marks(const ClassReport& report, const Strings& strings, const ClassOptions& options) {
    GradebookOptions wanted{.list_name = options.list, .column = options.column, .points = options.points};
    if (const auto platform = find_word(platform_table, options.platform)) wanted.platform = *platform;
    if (!options.list.empty()) {
        auto list = read_text(options.list);
        if (!list) return complain(list.error());
        wanted.list = std::move(*list);
        if (!is_utf8(wanted.list))  // names with umlauts would not be found
            return complain({"is not in UTF-8; export it again, or save it as “CSV UTF-8”", options.list});
    }
    const auto book = gradebook(report, strings, wanted);
    if (!book) return complain(book.error());
    if (options.marks == standard_output)
        std::cout << book->table;
    else if (const auto error = write_whole(options.marks, book->table))
        return complain(*error);
    std::cerr << fill(strings("report.marks"), {std::to_string(book->marked)}) << '\n';
    if (!book->shown.empty()) std::cerr << one_line(with_names(strings("report.marks_shown"), book->shown)) << '\n';
    const std::string_view unmarked = strings(options.list.empty() ? "report.unmarked_of_files" : "report.unmarked");
    if (!book->unmarked.empty()) std::cerr << one_line(with_names(unmarked, book->unmarked)) << '\n';
    std::vector<std::string> same, named;
    for (const ClassRow& row : report.rows) {
        if (!row.same_as.empty()) same.push_back(row.student);
        if (const std::string other = other_name(row); !other.empty())
            named.push_back(row.student + " (" + other + ")");
    }
    if (!same.empty()) std::cerr << one_line(with_names(strings("report.marks_same"), same)) << '\n';
    if (!named.empty()) std::cerr << one_line(with_names(strings("report.marks_other_name"), named)) << '\n';
    if (book->not_in_list.empty()) return exit_code::done;
    return complain({with_names(strings("report.not_in_list"), book->not_in_list)});
}

}  // namespace

bool is_class(const std::vector<std::string>& files) {
    return std::any_of(files.begin(), files.end(), [](const std::string& file) {
        std::error_code none;
        return fs::is_directory(file, none) || is_hand_in(file) || is_zip_file(file);
    });
}

std::optional<Error> missing_argument(const std::vector<std::string>& arguments) {
    for (const std::string& argument : arguments)
        if (!find_shipped(argument))
            return Error{"there is no such file or folder, and no shipped scene of this name", argument};
    return std::nullopt;
}

int grade_class(const ClassOptions& options) {
    if (const auto error = check_marks(options)) return complain(*error);
    const auto exercise = find_exercise(options.exercise);
    if (!exercise) return complain(exercise.error());
    if (const auto error = missing_argument(options.files)) return complain(*error);
    const auto strings = strings_with(options.table.language, texts_of(**exercise));
    if (!strings) return complain(strings.error());
    const auto files = class_files(options.files);
    if (!files) return complain(files.error());
    ClassReport report{*exercise, options.first_seed, {}};
    for (const ClassFile& file : files->files) report.rows.push_back(row_of_file(**exercise, file, options.choice));
    for (const ClassFile& folder : files->empty) report.rows.push_back(row_of_empty_folder(folder));
    if (report.rows.empty()) return complain({"there is no file to grade; give a folder with hand-in files"});
    if (!files->left_out.empty())
        std::cerr << one_line(fill((*strings)("report.left_out"), {fmt::to_string(fmt::join(files->left_out, ", "))}))
                  << '\n';
    mark_replaced(report.rows);
    mark_same(report.rows);
    if (const auto error = grade_rows(*exercise, options.first_seed, report.rows)) return complain(*error);
    sort_by_student(report.rows);
    if (const auto error = write_results(report, *strings, options)) return complain(*error);
    const int marks = options.platform.empty() ? exit_code::done : write_marks(report, *strings, options);
    if (marks != exit_code::done) return marks;
    bool all_read = true;
    for (const ClassRow& row : report.rows)
        if (!row.submission && row.problem)
            all_read = false, complain({text_of(*row.problem, *strings), row.problem->error ? "" : row.file});
    return all_read ? exit_code::done : exit_code::bad_input;
}

}  // namespace braitenlab

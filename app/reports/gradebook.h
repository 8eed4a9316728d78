// The marks of a class as the import of a learning platform reads them. docs/grading.md names the versions and sources.
#pragma once

#include <string>
#include <vector>

#include "app/reports/class_report.h"
#include "core/enum_table.h"

namespace braitenlab {

enum class Platform { moodle, canvas, ilias, csv };

inline constexpr auto platform_table = std::to_array<Word<Platform>>(
    {{Platform::moodle, "moodle"}, {Platform::canvas, "canvas"}, {Platform::ilias, "ilias"}, {Platform::csv, "csv"}});
constexpr const auto& table_of(Platform) { return platform_table; }
static_assert(is_complete_table<platform_table>());

struct GradebookOptions {
    Platform platform = Platform::csv;
    std::string list;       // the platform's exported table of students; empty: none. Moodle and Canvas need it
    std::string list_name;  // its file, for errors
    std::string column;     // heading of the column for the marks; empty: the platform's own, or the exercise's title
    double points = 0;      // the mark where all starts pass; 0: as the list says, or the number of starts
};

struct Gradebook {
    std::string table;
    int marked = 0;
    std::vector<std::string> shown;        // of those with a mark, who pass and had the solution shown
    std::vector<std::string> unmarked;     // people of the list, or without one of the files, without a graded hand-in
    std::vector<std::string> not_in_list;  // files with a grade for which the list has no person, or one with a mark
};

// Without a list, csv has a line for everybody, also without a mark, with the reason as feedback; ilias only for those
// with a mark, whose names must be from ILIAS.
// The list with marks and, where the platform takes it, feedback; all other cells are as they were. In that of Moodle
// who has handed in nothing that can be graded gets the reason as feedback, where there was none. People are found by
// the platform's number or, for files without one, by a name that only one of the list has, in any order of its words.
// A mark is the share of the starts that passed, of the points; 0 for a row with a refusal.
// Fails for a list that is missing or has not the platform's columns.
Result<Gradebook> gradebook(const ClassReport&, const Strings&, const GradebookOptions&);

}  // namespace braitenlab

#include "app/reports/gradebook.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "core/io/csv.h"
#include "core/plain_letters.h"

namespace braitenlab {

namespace {

using Cells = std::vector<std::string>;
using Rows = std::vector<const ClassRow*>;

bool has_mark(const ClassRow& row) { return row.grade && !row.problem; }

// The words of a name in small letters and in one order: "Müller, Anna" and "Anna Mueller" are the same.
std::string name_key(std::string_view name) {
    std::vector<std::string> words(1);
    for (const char c : plain_letters(name, Umlauts::spelled))
        if (c == ' ' || c == ',')
            words.emplace_back();
        else
            words.back() += c;
    std::sort(words.begin(), words.end());
    std::string key;
    for (const std::string& word : words)
        if (!word.empty()) key += word + " ";
    return key;
}

std::string number_at_end(std::string_view text) {
    return std::string(text.substr(text.find_last_not_of("0123456789") + 1));
}

// The index of the first heading that is one of the words, in any case of ASCII letters.
std::optional<std::size_t> column_of(const Cells& header, std::initializer_list<std::string_view> words) {
    for (std::size_t i = 0; i < header.size(); ++i)
        for (const std::string_view word : words)
            if (for_comparison(header[i]) == for_comparison(word)) return i;
    return std::nullopt;
}

std::string mark_text(double mark, bool has_comma = false) {
    std::string text = fmt::format("{:.2f}", mark);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    if (has_comma) std::replace(text.begin(), text.end(), '.', ',');
    return text;
}

std::optional<double> number_in(std::string text) {
    std::replace(text.begin(), text.end(), ',', '.');
    char* end = nullptr;  // strtod, because libc++ has no from_chars for floating point
    const double number = std::strtod(text.c_str(), &end);
    return end != text.c_str() && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

class People {
public:
    explicit People(const ClassReport& report) {
        for (const ClassRow& row : report.rows)
            if (!is_superseded(row)) rows_.push_back(&row);
        std::stable_partition(rows_.begin(), rows_.end(), [](const ClassRow* row) { return has_mark(*row); });
    }

    // Those with a mark who are not taken.
    Rows marked() const {
        Rows marked;
        for (const ClassRow* row : rows_)
            if (has_mark(*row)) marked.push_back(row);
        return marked;
    }

    // The row of this person of the list, one with a mark if there is one; it is then taken. Null for none.
    // `same_name`: people of the list with the name.
    const ClassRow* take(const std::string& id, const std::string& name, int same_name) {
        const auto is_it = [&](const ClassRow* row) {
            if (!row->submitter.id.empty() && !id.empty()) return row->submitter.id == id;
            return same_name == 1 && name_key(row->student) == name_key(name);
        };
        const auto found = std::find_if(rows_.begin(), rows_.end(), is_it);
        if (found == rows_.end()) return nullptr;
        const ClassRow* row = *found;
        rows_.erase(found);
        return row;
    }

private:
    Rows rows_;  // first those with a mark
};

struct Writer {
    const ClassReport& report;
    const Strings& strings;
    const GradebookOptions& options;
    People people{report};
    Gradebook book{};
    double points = options.points > 0 ? options.points : report.exercise->starts;

    double mark(const ClassRow& row) const {
        const int starts = static_cast<int>(row.grade->starts.size());
        return row.refusal || starts == 0 ? 0 : points * row.grade->count / starts;
    }

    // A row that gets a mark.
    void count(const ClassRow& row) {
        ++book.marked;
        if (passed_with_solution_shown(row)) book.shown.push_back(row.student);
    }

    std::string told(const ClassRow& row) const { return io::table_text(feedback(report, row, strings)); }

    Error wrong_columns(const std::string& wanted) const {
        return {"this is not the list that the platform exports: " + wanted, options.list_name};
    }

    void add(const Cells& cells, char separator) {
        for (const std::string& cell : cells) {
            io::add_csv_copy(book.table, cell, separator);  // texts of this program are inert already
            book.table += separator;
        }
        book.table.back() = '\n';
    }

    // Calls fill(cells, row) for each person of the list, with null for who has no row, and writes all lines from
    // `first` on.
    template <class Fill>
    void add_people(const io::CsvTable& list, std::size_t first, std::optional<std::size_t> id,
                    const std::vector<std::size_t>& names, const Fill& fill) {
        const auto name_of = [&](const Cells& cells) {
            std::string name;
            for (const std::size_t column : names) name += (name.empty() ? "" : " ") + cells[column];
            return name;
        };
        std::map<std::string, int> same_names;
        for (std::size_t i = first; i < list.rows.size(); ++i) ++same_names[name_key(name_of(list.rows[i]))];
        for (std::size_t i = first; i < list.rows.size(); ++i) {
            Cells cells = list.rows[i];
            const std::string name = name_of(cells);
            const ClassRow* row = people.take(id ? number_at_end(cells[*id]) : "", name, same_names[name_key(name)]);
            if (row && has_mark(*row))
                count(*row);
            else
                book.unmarked.push_back(name);
            fill(cells, row);
            add(cells, list.separator);
        }
        for (const ClassRow* row : people.marked()) book.not_in_list.push_back(row->file);
    }

    std::optional<Error> moodle(const io::CsvTable& list) {
        const Cells& header = list.rows.front();
        const auto id = column_of(header, {"Identifier", "ID", "Identificador"});
        const auto name = column_of(header, {"Full name", "Vollständiger Name", "Nombre completo"});
        const auto grade = options.column.empty() ? column_of(header, {"Grade", "Bewertung", "Calificación"})
                                                  : column_of(header, {options.column});
        const auto most = column_of(header, {"Maximum Grade", "Bestwertung", "Calificación máxima"});
        const auto comment =
            column_of(header, {"Feedback comments", "Feedback als Kommentar", "Comentarios de retroalimentación"});
        if (!id || !grade)
            return wrong_columns(
                "Identifier and Grade are missing; export the grading worksheet, and give --column "
                "where it is in another language than en, de and es");
        bool has_comma = false;
        for (std::size_t i = 1; most && i < list.rows.size(); ++i) {
            const auto number = number_in(list.rows[i][*most]);
            if (number && options.points <= 0) points = *number;
            has_comma |= list.rows[i][*most].find(',') != std::string::npos;
        }
        add(header, list.separator);
        add_people(list, 1, id, name ? std::vector{*name} : std::vector<std::size_t>{},
                   [&](Cells& cells, const ClassRow* row) {
                       if (!row) return;
                       if (has_mark(*row)) cells[*grade] = mark_text(mark(*row), has_comma);
                       if (comment && (has_mark(*row) || is_blank(cells[*comment]))) cells[*comment] = told(*row);
                   });
        return std::nullopt;
    }

    // Only the columns of the student and that of the exercise: Canvas leaves other columns as they are.
    std::optional<Error> canvas(const io::CsvTable& list) {
        const Cells& header = list.rows.front();
        const auto id = column_of(header, {"ID"}), section = column_of(header, {"Section"}),
                   student = column_of(header, {"Student"});
        if (!id || !section || student != std::size_t{0})
            return wrong_columns("Student, ID and Section are missing; export the gradebook");
        const std::string title = options.column.empty()
                                      ? std::string(strings.find(report.exercise->title, report.exercise->title))
                                      : options.column;
        const auto found = std::find_if(header.begin(), header.end(), [&](const std::string& heading) {
            return heading == title || heading.starts_with(title + " (");  // the number of the assignment
        });
        const auto column = static_cast<std::size_t>(found - header.begin());
        const bool is_new = found == header.end();
        const auto narrow = [&](const Cells& cells) {
            Cells kept(cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(*section + 1));
            kept.push_back(is_new ? "" : cells[column]);
            return kept;
        };
        io::CsvTable kept{list.separator, {}};
        std::size_t first = 1;  // of the students
        for (const Cells& cells : list.rows) kept.rows.push_back(narrow(cells));
        kept.rows.front().back() = is_new ? title : header[column];
        add(kept.rows.front(), list.separator);
        const auto is_above = [&](std::size_t row) {  // lines between the header and the students have no number
            return row < kept.rows.size() && kept.rows[row][*id].empty();
        };
        for (; is_above(first); ++first) {
            Cells& cells = kept.rows[first];
            if (cells.front().find("Points Possible") != std::string::npos) {
                const auto most = number_in(cells.back());
                if (most && options.points <= 0) points = *most;
                if (is_new) cells.back() = mark_text(points);
            }
            add(cells, list.separator);
        }
        add_people(kept, first, id, {0}, [&](Cells& cells, const ClassRow* row) {
            if (row && has_mark(*row)) cells.back() = mark_text(mark(*row));
        });
        return std::nullopt;
    }

    static constexpr auto status_columns =
        std::to_array<std::string_view>({"update", "usr_id", "login", "lastname", "firstname", "status", "mark",
                                         "notice", "comment", "plagiarism", "plag_comment"});

    void fill_status(Cells& cells, const ClassRow& row) const {
        cells[0] = "1";
        cells[5] = row.passed ? "passed" : "failed";
        cells[6] = mark_text(mark(row));
        cells[8] = told(row);
    }

    std::optional<Error> ilias(const io::CsvTable& list) {
        const bool is_status = std::equal(list.rows.front().begin(), list.rows.front().end(), status_columns.begin(),
                                          status_columns.end());
        if (!is_status) return wrong_columns("the first line must be update,usr_id,login,lastname,firstname,status, …");
        add(list.rows.front(), list.separator);
        add_people(list, 1, 1, {3, 4}, [&](Cells& cells, const ClassRow* row) {
            cells[0] = "0";
            if (row && has_mark(*row)) fill_status(cells, *row);
        });
        return std::nullopt;
    }

    std::optional<Error> ilias_without_list() {
        const auto is_of_ilias = [](const ClassRow& row) { return !row.submitter.login.empty(); };
        if (std::none_of(report.rows.begin(), report.rows.end(), is_of_ilias))
            return Error{"no name of a file or folder has a login of ILIAS; export status.csv and give it with --list"};
        const Cells header(status_columns.begin(), status_columns.end());
        add(header, ',');
        for (const ClassRow* row : people.marked()) {
            if (!is_of_ilias(*row)) {
                book.not_in_list.push_back(row->file);
                continue;
            }
            Cells cells(header.size());
            const Submitter& who = row->submitter;
            cells[1] = who.id, cells[2] = io::table_text(who.login), cells[4] = io::table_text(who.first_name);
            cells[3] = io::table_text(who.last_name.empty() ? who.name : who.last_name);
            fill_status(cells, *row);
            add(cells, ',');
            count(*row);
        }
        for (const ClassRow* row : people_without(report.rows)) book.unmarked.push_back(row->student);
        return std::nullopt;
    }

    void plain() {
        add({"student", "id", "folder", "mark", "points", "passed", "solution_shown", "feedback"}, ',');
        const auto line = [&](const ClassRow& row, const std::string& mark, std::string_view passed) {
            const std::string shown = !row.hand_in ? "" : row.hand_in->solution_shown ? "yes" : "no";
            add({io::table_text(row.student), row.submitter.id, io::table_text(row.submitter.folder), mark,
                 mark_text(points), std::string(passed), shown, told(row)},
                ',');
        };
        for (const ClassRow* row : people.marked())
            line(*row, mark_text(mark(*row)), row->passed ? "yes" : "no"), count(*row);
        for (const ClassRow* row : people_without(report.rows))
            line(*row, "", ""), book.unmarked.push_back(row->student);
    }
};

}  // namespace

Result<Gradebook> gradebook(const ClassReport& report, const Strings& strings, const GradebookOptions& options) {
    Writer writer{report, strings, options};
    const bool needs_list = options.platform == Platform::moodle || options.platform == Platform::canvas;
    if (options.list.empty() && needs_list)
        return Error{fmt::format("the marks for {} go into its own list of students; export it and give it with --list",
                                 word(options.platform))};
    std::optional<Error> error;
    if (options.platform == Platform::csv) {
        writer.plain();
    } else if (options.list.empty()) {
        error = writer.ilias_without_list();
    } else {
        const io::CsvTable list = io::parse_csv(options.list);
        if (list.rows.empty()) return writer.wrong_columns("it is empty");
        if (options.list.starts_with(io::byte_order_mark)) writer.book.table = io::byte_order_mark;
        if (options.platform == Platform::moodle) error = writer.moodle(list);
        if (options.platform == Platform::canvas) error = writer.canvas(list);
        if (options.platform == Platform::ilias) error = writer.ilias(list);
    }
    if (error) return *error;
    return std::move(writer.book);
}

}  // namespace braitenlab

// Tables as CSV (RFC 4180): a header line, then one line per row; commas, decimal points, lines end with \n.
//
// The name of a column ends with the unit of its values: `x_m`, `heading_rad`, `speed_m_s`. A name without a unit
// belongs to a text, a count or a value without unit; `seconds` is a time in seconds.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace braitenlab::io {

// The value of a cell: a number (five decimals; NaN: an empty cell), a whole number, or a text, of which
// table_text() is written, in quotes where it contains a separator. The text is not copied.
using CsvValue = std::variant<double, std::int64_t, std::string_view>;

// Appends the text of a cell, without a separator.
void add_csv_cell(std::string& line, const CsvValue&);

// Appends the text in quotes, as it is.
void add_quoted(std::string& line, std::string_view text);

// The text so that no spreadsheet takes it as a formula: an apostrophe precedes a text that begins with one of = + - @,
// also in full width or after blanks, or with a control character. A number is returned as it is, and so is a text that
// this function has returned. See OWASP, "CSV Injection".
std::string spreadsheet_text(std::string_view);

// The text as tables have it: spreadsheet_text(), and U+FFFD for what is no UTF-8 and for control characters other than
// tab and the ends of lines. Names of files and texts of strangers have both. add_csv_cell() applies it to each text.
std::string table_text(std::string_view);

// Text of a real number with at most so many digits. It has a point or an exponent, so that a program that guesses the
// type of a column by its first lines does not take it for a whole number: DuckDB reads 0, 0.1, 0.2 as whole numbers if
// it has seen enough zeros. Empty if not finite.
std::string real_text(double, int digits = 9);

// How a program wants a table.
struct CsvStyle {
    char separator = ',', decimal_mark = '.';
    bool has_byte_order_mark = false;  // of UTF-8; by it Excel knows the encoding
};
inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

// Whole lines of a table in another style; without the mark, which precedes the first line.
std::string in_style(std::string_view lines, const CsvStyle&);

// A table that another program has written. The first line tells the separator: comma, semicolon or tab. A byte order
// mark and empty lines are left out. Every row has as many cells as the first one.
struct CsvTable {
    char separator = ',';
    std::vector<std::vector<std::string>> rows;
};
CsvTable parse_csv(std::string_view);

// Appends the text of a cell of such a table as that program reads it back, formulas included.
void add_csv_copy(std::string& line, std::string_view cell, char separator);

template <class Row>
struct CsvColumn {
    std::string name;  // with the unit
    std::function<CsvValue(const Row&)> value;
};

template <class Columns>
std::string csv_header(const Columns& columns) {
    std::string line;
    for (const auto& column : columns) {
        if (!line.empty()) line += ',';
        add_csv_cell(line, std::string_view(column.name));
    }
    return line + '\n';
}

// Appends one line. Precondition: there is at least one column.
template <class Row, class Columns>
void add_csv_row(std::string& text, const Columns& columns, const Row& row) {
    for (const auto& column : columns) {
        add_csv_cell(text, column.value(row));
        text += ',';
    }
    text.back() = '\n';
}

}  // namespace braitenlab::io

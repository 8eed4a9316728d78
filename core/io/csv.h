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

// The value of a cell: a number (five decimals; NaN: an empty cell), a whole number, or a text, which is made inert by
// spreadsheet_text() and put in quotes where it contains a separator. The text is not copied.
using CsvValue = std::variant<double, std::int64_t, std::string_view>;

// Appends the text of a cell, without a separator.
void add_csv_cell(std::string& line, const CsvValue&);

// The text so that no spreadsheet takes it as a formula: an apostrophe precedes a text that begins with one of = + - @,
// also in full width or after blanks, or with a control character. A number is returned as it is, and so is a text that
// this function has returned. See OWASP, "CSV Injection". add_csv_cell() applies it to each text of a table.
std::string spreadsheet_text(std::string_view);

// The lines with semicolons between the cells, as a spreadsheet expects them where the decimal mark is a comma.
std::string with_semicolons(std::string_view lines);

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

#include "core/io/csv.h"

#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "core/match.h"

namespace braitenlab::io {

namespace {

void add_quoted(std::string& line, std::string_view text) {
    line += '"';
    for (const char c : text) {
        if (c == '"') line += '"';
        line += c;
    }
    line += '"';
}

}  // namespace

void add_csv_cell(std::string& line, const CsvValue& value) {
    std::visit(Match{[&](double number) {
                         if (!std::isnan(number)) fmt::format_to(std::back_inserter(line), "{:.5f}", number);
                     },
                     [&](std::int64_t number) { fmt::format_to(std::back_inserter(line), "{}", number); },
                     [&](std::string_view text) {
                         if (text.find_first_of(",;\"\n\r") == std::string_view::npos)
                             line += text;
                         else
                             add_quoted(line, text);
                     }},
               value);
}

std::string spreadsheet_text(std::string_view text) {
    constexpr std::string_view dangerous = "=+-@\t\r";
    const std::size_t first = text.find_first_not_of(' ');
    const bool is_formula = first != std::string_view::npos && dangerous.find(text[first]) != std::string_view::npos;
    return (is_formula ? "'" : "") + std::string(text);
}

std::string with_semicolons(std::string_view lines) {
    std::string changed(lines);
    bool quoted = false;
    for (char& c : changed) {
        if (c == '"') quoted = !quoted;
        if (c == ',' && !quoted) c = ';';
    }
    return changed;
}

}  // namespace braitenlab::io

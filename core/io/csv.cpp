#include "core/io/csv.h"

#include <charconv>
#include <cmath>
#include <iterator>
#include <system_error>

#include <fmt/format.h>

#include "core/match.h"
#include "core/utf8.h"

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

// A sign, digits and at most one point and one exponent: -0.25, +1e-3.
bool is_plain_number(std::string_view text) {
    if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
    if (text.empty() || (text[0] != '.' && (text[0] < '0' || text[0] > '9'))) return false;
    double number = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
    return problem == std::errc() && end == text.data() + text.size();
}

// Blanks that a spreadsheet removes from the beginning of a cell.
bool is_blank(char32_t code) {
    return code == ' ' || code == 0xA0 || code == 0x1680 || (code >= 0x2000 && code <= 0x200F) || code == 0x2028 ||
           code == 0x2029 || code == 0x202F || code == 0x205F || code == 0x2060 || code == 0x3000 || code == 0xFEFF;
}

bool begins_as_formula(std::string_view text) {
    constexpr std::u32string_view dangerous = U"=+-@\uFF1D\uFF0B\uFF0D\uFF20";
    while (!text.empty()) {
        const CodePoint first = first_code_point(text);
        if (first.code < 0x20 || (first.code >= 0x7F && first.code < 0xA0)) return true;
        if (!is_blank(first.code)) return dangerous.find(first.code) != std::u32string_view::npos;
        text.remove_prefix(first.size);
    }
    return false;
}

}  // namespace

void add_csv_cell(std::string& line, const CsvValue& value) {
    std::visit(Match{[&](double number) {
                         if (!std::isnan(number)) fmt::format_to(std::back_inserter(line), "{:.5f}", number);
                     },
                     [&](std::int64_t number) { fmt::format_to(std::back_inserter(line), "{}", number); },
                     [&](std::string_view text) {
                         const std::string inert = spreadsheet_text(text);
                         if (inert.find_first_of(",;\"\n\r\t") == std::string::npos)
                             line += inert;
                         else
                             add_quoted(line, inert);
                     }},
               value);
}

std::string spreadsheet_text(std::string_view text) {
    return (!is_plain_number(text) && begins_as_formula(text) ? "'" : "") + std::string(text);
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

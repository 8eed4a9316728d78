#include "core/io/csv.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "core/match.h"
#include "core/utf8.h"

namespace braitenlab::io {

void add_quoted(std::string& line, std::string_view text) {
    line += '"';
    for (const char c : text) {
        if (c == '"') line += '"';
        line += c;
    }
    line += '"';
}

namespace {

// A sign, digits and at most one point and one exponent: -0.25, +1e-3.
bool is_plain_number(std::string_view text) {
    const auto skip = [&](std::string_view any) {
        if (!text.empty() && any.find(text[0]) != std::string_view::npos) return text.remove_prefix(1), true;
        return false;
    };
    const auto skip_digits = [&] {
        const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
        text.remove_prefix(digits);
        return digits > 0;
    };
    skip("+-");
    const bool has_whole = skip_digits(), has_point = skip("."), has_fraction = has_point && skip_digits();
    if (!has_whole && !has_fraction) return false;
    if (!skip("eE")) return text.empty();
    skip("+-");
    return skip_digits() && text.empty();
}

// Blanks that a spreadsheet removes from the beginning of a cell, and characters that are not seen there.
bool is_blank(char32_t code) {
    constexpr std::u32string_view others =
        U" \u00A0\u00AD\u034F\u115F\u1160\u1680\u202F\u205F\u2800\u3000\u3164\uFEFF\uFFA0";
    return (code >= 0x2000 && code <= 0x200F) || (code >= 0x2060 && code <= 0x206F) || is_layout_mark(code) ||
           others.find(code) != std::u32string_view::npos;
}

bool begins_as_formula(std::string_view text) {
    constexpr std::u32string_view dangerous = U"=+-@\u2212\uFE62\uFE63\uFE66\uFE6B\uFF1D\uFF0B\uFF0D\uFF20";
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
                         const std::string inert = table_text(text);
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

std::string table_text(std::string_view text) {
    return utf8_without(spreadsheet_text(text), [](char32_t code) { return is_control(code) || is_layout_mark(code); });
}

std::string real_text(double number, int digits) {
    if (!std::isfinite(number)) return "";
    std::string text = fmt::format("{:.{}g}", number, digits);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string in_style(std::string_view lines, const CsvStyle& style) {
    std::string changed;
    while (!lines.empty()) {
        std::size_t end = 0;  // of the cell
        for (bool quoted = false; end < lines.size() && (quoted || (lines[end] != ',' && lines[end] != '\n')); ++end)
            if (lines[end] == '"') quoted = !quoted;
        std::string cell(lines.substr(0, end));
        if (is_plain_number(cell)) std::replace(cell.begin(), cell.end(), '.', style.decimal_mark);
        changed += cell;
        if (end < lines.size()) changed += lines[end] == ',' ? style.separator : lines[end];
        lines.remove_prefix(std::min(end + 1, lines.size()));
    }
    return changed;
}

CsvTable parse_csv(std::string_view text) {
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    CsvTable table;
    const std::string_view first = text.substr(0, text.find('\n'));
    for (const char separator : {';', '\t'})
        if (std::count(first.begin(), first.end(), separator) > std::count(first.begin(), first.end(), table.separator))
            table.separator = separator;
    std::vector<std::string> row(1);
    bool quoted = false;
    const auto end_row = [&] {
        if (!row.back().empty() && row.back().back() == '\r') row.back().pop_back();
        if (!table.rows.empty()) row.resize(table.rows.front().size());
        const bool is_blank_line =
            std::all_of(row.begin(), row.end(), [](const std::string& cell) { return cell.empty(); });
        if (!is_blank_line) table.rows.push_back(std::move(row));
        row.assign(1, "");
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"' && quoted && i + 1 < text.size() && text[i + 1] == '"')
            row.back() += text[++i];
        else if (c == '"')
            quoted = !quoted;
        else if (!quoted && c == table.separator)
            row.emplace_back();
        else if (!quoted && c == '\n')
            end_row();
        else
            row.back() += c;
    }
    end_row();
    return table;
}

void add_csv_copy(std::string& line, std::string_view cell, char separator) {
    const bool is_plain = cell.find_first_of("\"\n\r") == std::string_view::npos && cell.find(separator) == cell.npos;
    if (is_plain)
        line += cell;
    else
        add_quoted(line, cell);
}

}  // namespace braitenlab::io

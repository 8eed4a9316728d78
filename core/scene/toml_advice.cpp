#include "core/scene/toml_advice.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/plain_letters.h"
#include "core/scene/nearest.h"
#include "core/text_parts.h"
#include "core/utf8.h"

namespace braitenlab {

namespace {

constexpr const char* line_blanks = " \t\r";

std::string_view line_of(std::string_view text, int line) {
    for (; line > 1 && text.find('\n') != std::string_view::npos; --line) text.remove_prefix(text.find('\n') + 1);
    return text.substr(0, text.find('\n'));
}

// Calls use(index) for each character outside quotes, until it returns false. A quote that is not closed ends with the
// line.
template <class Use>
void each_outside_quotes(std::string_view line, Use use) {
    char quote = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (quote == '"' && line[i] == '\\')
            ++i;
        else if (quote != 0)
            quote = line[i] == quote ? char{0} : quote;
        else if (line[i] == '"' || line[i] == '\'')
            quote = line[i];
        else if (!use(i))
            return;
    }
}

std::string_view without_comment(std::string_view line) {
    std::size_t end = line.size();
    each_outside_quotes(line, [&](std::size_t i) {
        if (line[i] == '#') end = i;
        return line[i] != '#';
    });
    return line.substr(0, end);
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Sign, digits, point and digits at the begin of the text; empty if there are none.
std::string_view number_at_begin(std::string_view text) {
    std::size_t at = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
    const std::size_t first = at;
    while (at < text.size() && (is_digit(text[at]) || (text[at] == '.' && at > first))) ++at;
    return at > first ? text.substr(0, at) : std::string_view();
}

// A line, its comment removed, as key and value.
struct KeyLine {
    std::string_view whole, key, value;
    bool has_value = false;  // there is an =
};

KeyLine key_line_of(std::string_view line) {
    KeyLine found{.whole = trimmed(without_comment(line), line_blanks)};
    const std::size_t equals = found.whole.find('=');
    found.has_value = equals != std::string_view::npos && !found.whole.starts_with('[');
    found.key = trimmed(found.whole.substr(0, std::min(equals, found.whole.size())), line_blanks);
    if (found.has_value) found.value = trimmed(found.whole.substr(equals + 1), line_blanks);
    return found;
}

using Advice = std::optional<Message>;

// The line without its texts in quotes.
std::string outside_quotes(std::string_view line) {
    std::string outside;
    each_outside_quotes(line, [&](std::size_t i) {
        outside += line[i];
        return true;
    });
    return outside;
}

// The first character outside quotes that is meant, "U+00A0"; empty if there is none.
std::string named_outside_quotes(const KeyLine& line, bool (*is_meant)(char32_t)) {
    const std::string outside = outside_quotes(line.whole);
    for (std::string_view rest = outside; !rest.empty();) {
        const CodePoint first = first_code_point(rest);
        if (is_meant(first.code)) return fmt::format("U+{:04X}", static_cast<std::uint32_t>(first.code));
        rest.remove_prefix(first.size);
    }
    return {};
}

Advice of_special_space(const KeyLine& line) {
    const std::string space = named_outside_quotes(line, [](char32_t code) {  // Unicode's category Zs but for U+0020
        return code == 0xA0 || code == 0x1680 || (code >= 0x2000 && code <= 0x200A) || code == 0x202F ||
               code == 0x205F || code == 0x3000;
    });
    return space.empty() ? Advice() : message_of("advice_plain_blanks", space);
}

Advice of_invisible(const KeyLine& line) {
    const std::string mark = named_outside_quotes(line, [](char32_t code) {
        return is_layout_mark(code) || (code >= 0x200B && code <= 0x200D) || (code >= 0x2060 && code <= 0x2064) ||
               code == 0xFEFF || code == 0xAD || code == 0x85 || code == 0x180E || code == 0x2800 || code == 0x3164;
    });
    return mark.empty() ? Advice() : message_of("advice_no_invisible", mark);
}

Advice of_typographic_minus(const KeyLine& line) {
    const std::string outside = outside_quotes(line.whole);
    for (const std::string_view minus : {"\u2212", "\u2013", "\u2010", "\u2011"})
        if (outside.find(minus) != std::string::npos) return message_of("advice_plain_minus", minus);
    return std::nullopt;
}

Advice of_typographic_quotes(const KeyLine& line) {
    const std::size_t plain = line.whole.find_first_of("\"'");
    for (const std::string_view quote : {"„", "“", "”", "‚", "‘", "’", "«", "»"})
        if (const std::size_t at = line.whole.find(quote); at < plain)
            return message_of("advice_straight_quotes", quote);
    return std::nullopt;
}

Advice of_open_quote(const KeyLine& line) {
    const std::string_view text = line.has_value ? line.value : line.whole;
    if (text.empty() || text.find("\"\"\"") != std::string_view::npos) return std::nullopt;
    bool is_open = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (is_open && text[i] == '\\')
            ++i;
        else if (text[i] == '"')
            is_open = !is_open;
    }
    return is_open ? Advice(message_of("advice_closing_quote")) : std::nullopt;
}

Advice of_heading(const KeyLine& line) {
    if (!line.whole.starts_with('[')) return std::nullopt;
    const auto count = [&](char c) { return std::count(line.whole.begin(), line.whole.end(), c); };
    return count('[') > count(']') ? Advice(message_of("advice_closing_bracket")) : std::nullopt;
}

Advice of_missing_parts(const KeyLine& line) {
    if (line.has_value && line.value.empty()) return message_of("advice_missing_value", line.key);
    if (line.has_value || line.whole.empty() || !std::isalpha(static_cast<unsigned char>(line.whole[0])))
        return std::nullopt;
    return message_of("advice_key_and_value");
}

Advice of_decimal_comma(const KeyLine& line) {
    const std::string_view whole = number_at_begin(line.value), rest = line.value.substr(whole.size());
    if (whole.empty() || whole.find('.') != std::string_view::npos || !rest.starts_with(',')) return std::nullopt;
    const std::string_view fraction = number_at_begin(rest.substr(1));
    if (fraction.empty() || !is_digit(fraction[0]) || fraction.size() + 1 != rest.size()) return std::nullopt;
    return message_of("advice_decimal_point", std::string(whole) + "." + std::string(fraction));
}

// "e400", of a number that is too large.
bool is_exponent(std::string_view text) {
    if (text[0] != 'e' && text[0] != 'E') return false;
    const std::string_view number = number_at_begin(text.substr(1));
    return !number.empty() && number.size() + 1 == text.size();
}

Advice of_unit(const KeyLine& line) {
    const std::string_view number = number_at_begin(line.value);
    const std::string_view unit = trimmed(line.value.substr(number.size()), line_blanks);
    if (number.empty() || unit.empty() || is_exponent(unit)) return std::nullopt;
    const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) || (c & 0x80); };
    if (!is_letter(unit[0]) && unit[0] != '%') return std::nullopt;
    return message_of("advice_no_unit", number);
}

Advice of_bare_word(const KeyLine& line) {
    if (line.value.empty()) return std::nullopt;
    const auto first = static_cast<unsigned char>(line.value[0]);
    if (!std::isalpha(first) && first < 0x80) return std::nullopt;
    const std::string lower = lower_case(std::string(line.value));
    if (lower == "true" || lower == "false") return message_of("advice_small_letters", lower);
    return message_of("advice_text_in_quotes", in_quotes(line.value));
}

// The name in a heading, "step" of "[step]" and of "[[step]]"; empty for another line.
std::string_view heading_name(const KeyLine& line) {
    if (!line.whole.starts_with('[') || !line.whole.ends_with(']')) return {};
    const std::size_t first = line.whole.find_first_not_of("[ "), last = line.whole.find_last_not_of("] ");
    return first < last + 1 ? line.whole.substr(first, last + 1 - first) : std::string_view();
}

// A heading or a key that the lines above have, too.
Advice of_repetition(std::string_view above, const KeyLine& line) {
    const std::string_view heading = heading_name(line);
    bool has_heading = false, has_key = false;
    while (!above.empty()) {
        const std::string_view next = above.substr(0, above.find('\n'));
        above.remove_prefix(std::min(next.size() + 1, above.size()));
        const KeyLine other = key_line_of(next);
        has_heading |= !heading.empty() && heading_name(other) == heading;
        has_key = !other.whole.starts_with('[') && (has_key || (other.has_value && other.key == line.key));
    }
    if (has_heading) return message_of("advice_heading_twice", heading, heading);
    if (has_key && line.has_value && !line.value.empty()) return message_of("advice_key_twice", line.key);
    return std::nullopt;
}

constexpr std::array causes{of_invisible,  of_special_space, of_typographic_minus, of_typographic_quotes,
                            of_open_quote, of_heading,       of_missing_parts,     of_decimal_comma,
                            of_unit,       of_bare_word};

}  // namespace

Message toml_advice(std::string_view text, int line) {
    const std::string_view found = line_of(text, line);
    if (!is_utf8(found)) return message_of("advice_utf8");
    if (found.find('\0') != found.npos) return message_of("advice_no_zero");
    const KeyLine parts = key_line_of(found);
    for (const auto cause : causes)
        if (auto advice = cause(parts)) return *advice;
    const std::string_view above = text.substr(0, static_cast<std::size_t>(found.data() - text.data()));
    return of_repetition(above, parts).value_or(Message());
}

std::optional<OpenText> open_text(std::string_view text) {
    constexpr std::string_view all_quotes[]{"\"\"\"", "'''", "\"", "'"};
    OpenText open;  // without quotes outside a text
    int line = 1;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::string_view rest = text.substr(i);
        if (rest[0] == '\n') {
            ++line;
            if (open.quotes.size() == 1) open = {};
        } else if (open.quotes.empty() && rest[0] == '#') {
            i += std::min(rest.find('\n'), rest.size()) - 1;
        } else if (open.quotes.empty()) {
            const auto quotes = std::find_if(std::begin(all_quotes), std::end(all_quotes),
                                             [&](std::string_view each) { return rest.starts_with(each); });
            if (quotes == std::end(all_quotes)) continue;
            open = {line, *quotes};
            i += quotes->size() - 1;
        } else if (rest.starts_with(open.quotes)) {
            i += std::exchange(open, {}).quotes.size() - 1;
        } else if (open.quotes[0] == '"' && rest[0] == '\\' && rest.size() > 1 && rest[1] != '\n') {
            ++i;
        }
    }
    return open.quotes.size() == 3 ? std::optional(open) : std::nullopt;
}

int line_of_open_list(std::string_view text, int line) {
    const KeyLine next = key_line_of(line_of(text, line));
    if (!next.has_value && heading_name(next).empty()) return 0;
    std::ptrdiff_t open = 0;
    std::string_view above = text.substr(0, static_cast<std::size_t>(line_of(text, line).data() - text.data()));
    for (int at = line - 1; at > 0; --at) {
        above.remove_suffix(above.ends_with('\n'));
        const KeyLine before = key_line_of(above.substr(above.rfind('\n') + 1));
        above = above.substr(0, above.rfind('\n') + 1);
        const std::string outside = outside_quotes(before.has_value ? before.value : before.whole);
        open += std::count(outside.begin(), outside.end(), '[') - std::count(outside.begin(), outside.end(), ']');
        if (before.has_value) return before.value.starts_with('[') && open > 0 ? at : 0;
        if (!heading_name(before).empty()) return 0;
    }
    return 0;
}

}  // namespace braitenlab

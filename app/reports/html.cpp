#include "app/reports/html.h"

#include <fmt/format.h>

namespace braitenlab::html {

namespace {

// The number of bytes of the UTF-8 character that the text begins with; 0 for none.
std::size_t character_size(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const std::size_t size = byte(0) < 0x80 ? 1 : byte(0) < 0xC2 ? 0 : byte(0) < 0xE0 ? 2 : byte(0) < 0xF0 ? 3 : 4;
    if (size == 0 || size > text.size() || byte(0) > 0xF4) return 0;
    for (std::size_t i = 1; i < size; ++i)
        if ((byte(i) & 0xC0u) != 0x80u) return 0;
    const bool is_bad = (byte(0) == 0xE0 && byte(1) < 0xA0) || (byte(0) == 0xED && byte(1) > 0x9F) ||
                        (byte(0) == 0xF0 && byte(1) < 0x90) || (byte(0) == 0xF4 && byte(1) > 0x8F) ||
                        (byte(0) == 0xEF && byte(1) == 0xBF && byte(2) >= 0xBE);
    return is_bad ? 0 : size;
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const std::size_t size = character_size(text);
        const char c = text[0];
        if (size == 0) {
            out += "\xEF\xBF\xBD";
        } else if (size > 1) {
            out += text.substr(0, size);
        } else if (c == '&') {
            out += "&amp;";
        } else if (c == '<') {
            out += "&lt;";
        } else if (c == '>') {
            out += "&gt;";
        } else if (c == '"') {
            out += "&quot;";
        } else if (c == '\'') {
            out += "&#39;";
        } else {
            out += static_cast<unsigned char>(c) < 0x20 && c != '\n' ? ' ' : c;
        }
        text.remove_prefix(std::max<std::size_t>(size, 1));
    }
    return out;
}

std::string with_breaks(std::string_view text) {
    std::string out;
    for (const char c : escaped(text)) out += c == '\n' ? std::string("<br/>") : std::string(1, c);
    return out;
}

std::string element(std::string_view tag, std::string_view text, std::string_view css_class) {
    const std::string mark = css_class.empty() ? "" : fmt::format(" class=\"{}\"", css_class);
    return fmt::format("<{}{}>{}</{}>", tag, mark, with_breaks(text), tag);
}

std::string page(std::string_view language, std::string_view title, std::string_view style, std::string_view body,
                 std::string_view script) {
    std::string out = fmt::format(
        "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"{}\">\n<head>\n<meta "
        "charset=\"utf-8\"/>\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>{}</title>\n"
        "<style>\n{}</style>\n</head>\n<body>\n{}",
        escaped(language), escaped(title), style, body);
    if (!script.empty()) out += fmt::format("<script>\n{}</script>\n", script);
    return out + "</body>\n</html>\n";
}

}  // namespace braitenlab::html

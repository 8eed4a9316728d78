#include "app/reports/html.h"

#include <fmt/format.h>

namespace braitenlab::html {

std::string with_breaks(std::string_view text) {
    std::string out;
    for (const char c : xml_text(text)) out += c == '\n' ? std::string("<br/>") : std::string(1, c);
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
        xml_text(language), xml_text(title), style, body);
    if (!script.empty()) out += fmt::format("<script>\n{}</script>\n", script);
    return out + "</body>\n</html>\n";
}

}  // namespace braitenlab::html

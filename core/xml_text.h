// Text for XML, SVG and HTML.
#pragma once

#include <string>
#include <string_view>

#include "core/utf8.h"

namespace braitenlab {

// The text with &, <, >, " and ' as references. Control characters, of which XML allows some, become spaces; bytes
// that are no UTF-8, the two codes that XML has no character for, and marks that change the order of the text on the
// page become U+FFFD.
inline std::string xml_text(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const auto [code, size, is_valid] = first_code_point(text);
        switch (code) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            case '\'':
                out += "&#39;";
                break;
            default:
                if ((code < 0x20 && code != '\n') || (code >= 0x7F && code < 0xA0))
                    out += ' ';
                else if (!is_valid || code == 0xFFFE || code == 0xFFFF || is_layout_mark(code))
                    out += "\xEF\xBF\xBD";
                else
                    out += text.substr(0, size);
        }
        text.remove_prefix(size);
    }
    return out;
}

}  // namespace braitenlab

#include "core/export/text.h"

#include <fmt/format.h>

#include "core/plain_letters.h"

namespace braitenlab::robots {

namespace {

bool is_letter_or_digit(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); }

}  // namespace

std::string number(float value) {
    std::string text = fmt::format("{}", value);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

std::string c_number(float value) { return number(value) + "f"; }

std::string comment_text(std::string_view text) {
    std::string clean;
    for (const char c : text) {
        const bool plain =
            is_letter_or_digit(c) || std::string_view(" .,:;+-()=<>'\"").find(c) != std::string_view::npos;
        clean += plain || static_cast<unsigned char>(c) >= 0x80 ? c : '_';
    }
    return clean;
}

std::string filled(std::string_view text, const std::map<std::string, std::string>& values) {
    std::string made;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t key = text.find('@', at);
        made += text.substr(at, key - at);
        if (key == std::string_view::npos) break;
        const std::size_t end = text.find('@', key + 1);
        made += values.at(std::string(text.substr(key + 1, end - key - 1)));
        at = end + 1;
    }
    return made;
}

std::string Identifiers::make(std::string_view prefix, std::string_view name) {
    std::string id(prefix);
    for (const char c : name) id += is_letter_or_digit(c) ? c : '_';
    const std::string stem = id;
    for (int i = 2; !made_.insert(lower_case(id)).second; ++i) id = fmt::format("{}_{}", stem, i);
    return id;
}

}  // namespace braitenlab::robots

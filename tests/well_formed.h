// A strict check that a page is well-formed XML after its DOCTYPE line.
#pragma once

#include <regex>
#include <string>
#include <string_view>
#include <vector>

namespace braitenlab::tests {

// What is wrong, or an empty text: an open element, an attribute without quotes, a lone & or <, a control character.
inline std::string xml_fault(std::string_view page) {
    const std::regex tag(R"re((/?)([A-Za-z][A-Za-z0-9]*)((?:\s+[A-Za-z:-]+="[^"<]*")*)\s*(/?))re");
    const std::regex reference(R"re(&(amp|lt|gt|quot|#[0-9]+);)re");
    std::vector<std::string> open;
    std::size_t at = page.find('\n') + 1;  // after the DOCTYPE
    while (at < page.size()) {
        if (page[at] == '<') {
            const std::size_t end = page.find('>', at);
            if (end == page.npos) return "a tag has no end";
            const std::string inside(page.substr(at + 1, end - at - 1));
            std::smatch parts;
            if (!std::regex_match(inside, parts, tag)) return "bad tag <" + inside + ">";
            if (parts[1].length() > 0) {
                if (open.empty() || open.back() != parts[2]) return "</" + parts[2].str() + "> closes another element";
                open.pop_back();
            } else if (parts[4].length() == 0) {
                open.push_back(parts[2]);
            }
            at = end + 1;
        } else if (page[at] == '&') {
            const std::string rest(page.substr(at, 12));
            std::smatch found;
            if (!std::regex_search(rest, found, reference, std::regex_constants::match_continuous))
                return "a lone & before " + rest;
            at += static_cast<std::size_t>(found[0].length());
        } else {
            const auto byte = static_cast<unsigned char>(page[at]);
            if (byte < 0x20 && byte != '\n' && byte != '\t') return "a control character";
            ++at;
        }
    }
    return open.empty() ? "" : "<" + open.back() + "> is open";
}

}  // namespace braitenlab::tests

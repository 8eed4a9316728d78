// The languages that ship, and their words. A test that holds for each of them loops over shipped_languages()
// or shipped_codes().
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "ui/words/strings.h"

namespace braitenlab::tests {

inline const std::vector<Language>& shipped_languages() {
    static const std::vector<Language> known = languages(std::string(BRAITENLAB_SOURCE) + "/ui/strings");
    return known;
}

// "en" first.
inline const std::vector<std::string>& shipped_codes() {
    static const std::vector<std::string> codes = [] {
        std::vector<std::string> all{"en"};
        for (const Language& language : shipped_languages())
            if (language.code != "en") all.push_back(language.code);
        return all;
    }();
    return codes;
}

inline const Strings& speaking(const std::string& code) {
    static std::map<std::string, Strings> known;
    if (const auto found = known.find(code); found != known.end()) return found->second;
    auto strings = load_language(std::string(BRAITENLAB_SOURCE) + "/ui/strings", code);
    if (!strings) throw std::runtime_error(strings.error().text());
    return known[code] = *strings;
}

inline const Strings& english() { return speaking("en"); }

}  // namespace braitenlab::tests

#include "app/words.h"

#include <algorithm>

#include "app/platform.h"

namespace braitenlab {

std::string native_language(const std::filesystem::path& folder) {
    const std::string local = system_language();
    const auto spoken = languages(folder);
    const auto same = [&](const Language& language) { return language.code == local; };
    return std::any_of(spoken.begin(), spoken.end(), same) ? local : "en";
}

Result<Words> words_in(const std::filesystem::path& folder, const std::string& language) {
    auto strings = load_language(folder, language);
    if (!strings) return strings.error();
    return Words{folder, language, std::move(*strings), languages(folder)};
}

std::optional<Error> speak(Words& words, const std::string& language) {
    if (language == words.language) return std::nullopt;
    auto strings = load_language(words.folder, language);
    if (!strings) return strings.error();
    words.strings = std::move(*strings);
    words.language = language;
    return std::nullopt;
}

}  // namespace braitenlab

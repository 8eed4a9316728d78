// The texts in the current language, and the languages to choose from.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/view/picture.h"
#include "ui/words/strings.h"

namespace braitenlab {

struct Words {
    std::filesystem::path folder;  // of the string files
    std::string language;          // its code
    Strings strings;
    std::vector<Language> languages;
    NameMap names;  // of sources and zones in shipped files
};

// The system's language if there is a translation, else English.
std::string native_language(const std::filesystem::path& folder);

// Fails as load_language does.
Result<Words> load_words(const std::filesystem::path& folder, const std::string& language);

// Loads another language. On failure the words do not change.
std::optional<Error> change_language(Words&, const std::string& language);

}  // namespace braitenlab

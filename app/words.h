// The language that is spoken now, and those that could be.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ui/strings.h"

namespace braitenlab {

struct Words {
    std::filesystem::path folder;  // of the string files
    std::string language;          // by its code
    Strings strings;
    std::vector<Language> languages;
};

// The system's language, if the lab speaks it; else English.
std::string native_language(const std::filesystem::path& folder);

// Fails as load_language does.
Result<Words> words_in(const std::filesystem::path& folder, const std::string& language);

// Goes over to another language; on failure the words stay as they are.
std::optional<Error> speak(Words&, const std::string& language);

}  // namespace braitenlab

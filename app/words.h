// The texts in the current language, and the languages to choose from.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/view/picture.h"
#include "ui/words/strings.h"

namespace braitenlab {

struct Lab;

struct Words {
    std::filesystem::path folder;  // of the string files
    std::string language;          // its code
    Strings strings;
    std::vector<Language> languages;
    NameMap names;                         // of sources and zones in shipped files
    Strings of_shipped;                    // the translations that `strings` has, too, by the text in the shipped file
    std::vector<std::string> untouched{};  // texts of `of_shipped` without a translation in `strings`
};

// The system's language if there is a translation, else English.
std::string native_language(const std::filesystem::path& folder);

// Fails as load_language does.
Result<Words> load_words(const std::filesystem::path& folder, const std::string& language);

// The texts of each open file: the exercise or the scene, and the lecture.
std::vector<std::vector<TranslatableText>> open_texts(const Lab&);

// Shows a person's own file as it is written, also where a text of it is that of a shipped file: takes the translations
// of its texts out of the strings, and gives those of the last call back. `files`: texts of files. A file whose texts
// are all those of shipped files ships, or is a copy, and stays translated.
void leave_own_texts(Words&, const std::vector<std::vector<TranslatableText>>& files);

// Loads another language. On failure the words do not change.
std::optional<Error> change_language(Words&, const std::string& language);

}  // namespace braitenlab

#include "app/words.h"

#include <algorithm>

#include "app/files/breeding_files.h"
#include "app/files/data.h"
#include "app/files/study_files.h"
#include "app/platform/platform.h"
#include "core/lesson/exercise_file.h"
#include "core/lesson/lecture.h"
#include "core/scene/scene_file.h"
#include "ui/words/strings.h"

namespace braitenlab {

namespace {

// The strings of the window and of the shipped scenes and exercises. Texts without a translation are shown as in their
// files.
Result<Strings> load_strings(const std::filesystem::path& folder, const std::string& language) {
    auto strings = load_language(folder, language);
    if (!strings) return strings;
    const auto shipped = folder.parent_path().parent_path() / "exercises" / "words" / (language + ".toml");
    std::error_code none;
    if (!std::filesystem::exists(shipped, none)) return strings;
    const auto words = Strings::load(shipped);
    if (!words) return words.error();
    for (const auto& path : shipped_exercises())
        if (const auto exercise = load_exercise(path)) add_translations(*strings, texts_of(*exercise), *words);
    for (const auto& scenes : {shipped_scenes(), shipped_robots()})
        for (const auto& path : scenes)
            if (const auto scene = load_scene(path)) add_translations(*strings, texts_of(*scene), *words);
    for (const auto& path : shipped_lectures())
        if (const auto lecture = read_lecture(path)) add_translations(*strings, texts_of(*lecture), *words);
    for (const insight::Study& study : shipped_study_list()) add_translations(*strings, texts_of(study), *words);
    for (const evolve::Breeding& each : shipped_breeding_list()) add_translations(*strings, texts_of(each), *words);
    return strings;
}

NameMap names_of(const Strings& strings) {
    constexpr std::string_view stem = "name.";
    NameMap names;
    for (auto row = strings.all().lower_bound(std::string(stem)); row != strings.all().end(); ++row) {
        if (!row->first.starts_with(stem)) break;
        names.emplace(row->first.substr(stem.size()), row->second);
    }
    return names;
}

}  // namespace

std::string native_language(const std::filesystem::path& folder) {
    const std::string local = system_language();
    const auto available = languages(folder);
    const auto same = [&](const Language& language) { return language.code == local; };
    return std::any_of(available.begin(), available.end(), same) ? local : "en";
}

Result<Words> load_words(const std::filesystem::path& folder, const std::string& language) {
    auto strings = load_strings(folder, language);
    if (!strings) return strings.error();
    NameMap names = names_of(*strings);
    return Words{folder, language, std::move(*strings), languages(folder), std::move(names)};
}

std::optional<Error> change_language(Words& words, const std::string& language) {
    if (language == words.language) return std::nullopt;
    auto strings = load_strings(words.folder, language);
    if (!strings) return strings.error();
    words.strings = std::move(*strings);
    words.names = names_of(words.strings);
    words.language = language;
    return std::nullopt;
}

}  // namespace braitenlab

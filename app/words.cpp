#include "app/words.h"

#include <algorithm>

#include "app/files/breeding_files.h"
#include "app/files/data.h"
#include "app/files/study_files.h"
#include "app/lab.h"
#include "app/platform/platform.h"
#include "core/lesson/exercise_file.h"
#include "core/lesson/lecture.h"
#include "core/scene/scene_file.h"

namespace braitenlab {

namespace {

// The translations of the shipped scenes, exercises and other files, by the text in the file.
Result<Strings> load_shipped(const std::filesystem::path& folder, const std::string& language) {
    Strings strings;
    const auto shipped = folder.parent_path().parent_path() / "exercises" / "words" / (language + ".toml");
    std::error_code none;
    if (!std::filesystem::exists(shipped, none)) return strings;
    const auto words = Strings::load(shipped);
    if (!words) return words.error();
    for (const auto& path : shipped_exercises())
        if (const auto exercise = load_exercise(path)) add_translations(strings, texts_of(*exercise), *words);
    for (const auto& scenes : {shipped_scenes(), shipped_robots()})
        for (const auto& path : scenes)
            if (const auto scene = load_scene(path)) add_translations(strings, texts_of(*scene), *words);
    for (const auto& path : shipped_lectures())
        if (const auto lecture = read_lecture(path)) add_translations(strings, texts_of(*lecture), *words);
    for (const insight::Study& study : shipped_study_list()) add_translations(strings, texts_of(study), *words);
    for (const evolve::Breeding& each : shipped_breeding_list()) add_translations(strings, texts_of(each), *words);
    return strings;
}

// Texts without a translation are shown as in their files.
Result<Words> load_all(const std::filesystem::path& folder, const std::string& language) {
    auto strings = load_language(folder, language);
    if (!strings) return strings.error();
    auto shipped = load_shipped(folder, language);
    if (!shipped) return shipped.error();
    strings->fall_back_on(*shipped);
    return Words{.folder = folder,
                 .language = language,
                 .strings = std::move(*strings),
                 .languages = {},
                 .names = {},
                 .of_shipped = std::move(*shipped)};
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
    auto words = load_all(folder, language);
    if (!words) return words;
    words->languages = languages(folder);
    words->names = names_of(words->strings);
    return words;
}

std::vector<std::vector<TranslatableText>> open_texts(const Lab& lab) {
    const auto& lesson = lab.document.lesson;
    std::vector<std::vector<TranslatableText>> files{lesson ? texts_of(*lesson->exercise)
                                                            : texts_of(*lab.document.session.snapshot().scene)};
    if (lab.pages) files.push_back(texts_of(*lab.pages->lecture));
    return files;
}

void leave_own_texts(Words& words, const std::vector<std::vector<TranslatableText>>& files) {
    for (const std::string& text : words.untouched)
        words.strings.add(text, std::string(words.of_shipped.find(text, text)));
    words.untouched.clear();
    const auto is_shipped = [&](const TranslatableText& each) { return words.of_shipped.all().contains(each.text); };
    for (const auto& texts : files) {
        if (std::all_of(texts.begin(), texts.end(), is_shipped)) continue;
        for (const TranslatableText& each : texts)
            if (is_shipped(each)) words.strings.erase(each.text), words.untouched.push_back(each.text);
    }
}

std::optional<Error> change_language(Words& words, const std::string& language) {
    if (language == words.language) return std::nullopt;
    auto other = load_all(words.folder, language);
    if (!other) return other.error();
    other->languages = std::move(words.languages);
    other->names = names_of(other->strings);
    words = std::move(*other);
    return std::nullopt;
}

}  // namespace braitenlab

// All visible texts, by key; one file per language: ui/strings/*.toml.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/lesson/exercise.h"
#include "core/result.h"

namespace braitenlab {

class Strings {
public:
    // Reads a file with nested tables: play under [button] has the key "button.play". Fails with file and line on
    // malformed TOML, a missing `format = 1`, or a value that is no text.
    static Result<Strings> load(const std::filesystem::path&);
    static Result<Strings> parse(std::string_view toml, std::string file_name);

    // The text of a key, or the key itself when it is missing. The view lives as long as this object or the key, and is
    // null-terminated.
    std::string_view operator()(std::string_view key) const;

    // The text of a key, or `otherwise`.
    std::string_view find(std::string_view key, std::string_view otherwise) const;

    const std::map<std::string, std::string, std::less<>>& all() const { return words_; }

    // Adds the texts of keys that are missing here.
    void fall_back_on(const Strings& others) { words_.insert(others.words_.begin(), others.words_.end()); }

    // Removes the text of a key.
    void erase(std::string_view key) {
        if (const auto found = words_.find(key); found != words_.end()) words_.erase(found);
    }

    // Adds the text of a key that has none yet.
    void add(std::string key, std::string words) { words_.try_emplace(std::move(key), std::move(words)); }

private:
    std::map<std::string, std::string, std::less<>> words_;
};

// The error in the language of the strings, "file:line: what"; a message without a translation in English after a
// lead-in in that language.
std::string text_of(const Error&, const Strings&);

// The name of an object of a file as the scene shows it: "dim" as "schwach", "my_lamp" as "my lamp".
std::string shown_name(const Strings&, std::string_view name);

// The mark between the ones and the tenths of a number in this language.
char decimal_mark(const Strings&);

// Adds the translation of each text that has one. The key is the text, so a text that the user has changed has no
// translation. `by_id`: a file of exercises/words; ids are those of texts_of() in core/lesson/exercise_file.h.
void add_translations(Strings&, const std::vector<TranslatableText>&, const Strings& by_id);

// A language, by its file: de.toml has the code "de" and its name in the key language.name.
struct Language {
    std::string code, name;
};

// The languages with a readable file in the folder, sorted by code.
std::vector<Language> languages(const std::filesystem::path& folder);

// The texts of a language; missing texts are in English, and the English ones of messages are those of core/messages.h,
// which no file repeats. An error names the available languages, or the wrong line.
Result<Strings> load_language(const std::filesystem::path& folder, std::string_view code);

// Replaces the {} of the pattern by the values, in order: fill("Passed {} of {}", {"8", "10"}). Surplus {} are kept.
std::string fill(std::string_view pattern, std::initializer_list<std::string_view> values);

}  // namespace braitenlab

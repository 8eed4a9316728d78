// Every visible word, by key, from one file a language: ui/strings/*.toml.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace braitenlab {

class Strings {
public:
    // Reads a file whose tables nest: play under [button] is "button.play". Fails with file and line on bad TOML, a
    // missing `format = 1`, or a value that is no text.
    static Result<Strings> load(const std::filesystem::path&);
    static Result<Strings> parse(std::string_view toml, std::string file_name);

    // The words for a key; the key itself where the file has none, so that a gap is seen and not a crash. The view
    // lives as long as this object or the key, and its characters are followed by a null.
    std::string_view operator()(std::string_view key) const;

    // The words for a key, or `otherwise`.
    std::string_view find(std::string_view key, std::string_view otherwise) const;

    const std::map<std::string, std::string, std::less<>>& all() const { return words_; }

    // Takes over what these words lack and the others have: half a language is better than bare keys.
    void fall_back_on(const Strings& others) { words_.insert(others.words_.begin(), others.words_.end()); }

    // Adds words for a key that has none yet.
    void add(std::string key, std::string words) { words_.try_emplace(std::move(key), std::move(words)); }

private:
    std::map<std::string, std::string, std::less<>> words_;
};

// A language that the lab speaks, by its file: de.toml is "de", and calls itself by the key language.name.
struct Language {
    std::string code, name;
};

// Those with a readable file in the folder, in the order of their codes.
std::vector<Language> languages(const std::filesystem::path& folder);

// The words of a language, with English ones where it has none. An error names the languages there are, or the line
// that is wrong.
Result<Strings> load_language(const std::filesystem::path& folder, std::string_view code);

// Puts the values into the pattern's {}s in order: fill("Passed {} of {}", {"8", "10"}). Spare {}s stay as they are.
std::string fill(std::string_view pattern, std::initializer_list<std::string_view> values);

}  // namespace braitenlab

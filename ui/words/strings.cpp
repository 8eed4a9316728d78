#include "ui/words/strings.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include "core/messages.h"
#include "core/scene/file_kind.h"
#include "core/scene/toml_tree.h"

namespace braitenlab {

namespace {

using Words = std::map<std::string, std::string, std::less<>>;

std::optional<Error> flatten(TomlNode::Table& table, const std::string& prefix, const std::string& file, Words& words) {
    for (TomlMember& member : table) {
        const std::string path = prefix.empty() ? member.key : prefix + "." + member.key;
        if (auto* inner = std::get_if<TomlNode::Table>(&member.value.content)) {
            if (auto error = flatten(*inner, path, file, words)) return error;
        } else if (auto* text = std::get_if<std::string>(&member.value.content)) {
            words.insert_or_assign(path, std::move(*text));
        } else if (path != "format") {
            return Error{"'" + path + "' must be text in quotes", file, static_cast<int>(member.value.place.line)};
        }
    }
    return std::nullopt;
}

Result<Strings> load_english(const std::filesystem::path& folder) {
    auto english = Strings::load(folder / "en.toml");
    if (english)
        for (const MessageText& message : message_table)
            english->add("error." + std::string(message.id), std::string(message.english));
    return english;
}

}  // namespace

Result<Strings> Strings::load(const std::filesystem::path& path) {
    const auto text = read_text(path);
    if (!text) return text.error();
    return parse(*text, path.string());
}

Result<Strings> Strings::parse(std::string_view text, std::string file_name) {
    auto file = parse_toml(text, std::move(file_name));
    if (!file) return file.error();
    const TomlNode* format = file->root.get("format");
    if (!format || !format->as_whole() || *format->as_whole() != 1)
        return Error{"must begin with format = 1", file->name, 1};
    Strings strings;
    auto& top = std::get<TomlNode::Table>(file->root.content);
    if (auto error = flatten(top, "", file->name, strings.words_)) return *error;
    return strings;
}

std::string_view Strings::operator()(std::string_view key) const { return find(key, key); }

std::string_view Strings::find(std::string_view key, std::string_view otherwise) const {
    const auto found = words_.find(key);
    return found == words_.end() ? otherwise : std::string_view(found->second);
}

std::string text_of(const Error& error, const Strings& strings) {
    Error shown = error;
    const bool has_translation = std::any_of(error.phrases.begin(), error.phrases.end(),
                                             [](const Phrase& phrase) { return !phrase.id.empty(); });
    if (has_translation) shown.what.clear();
    if (has_translation)
        for (const Phrase& phrase : error.phrases)
            shown.what += phrase.id.empty() ? phrase.values.front()
                                            : filled(strings("error." + std::string(phrase.id)), phrase.values);
    else
        shown.what = fill(strings("error.english"), {error.what});
    std::string text = shown.text();
    if (text[0] >= 'a' && text[0] <= 'z' && shown.file.empty()) text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

std::string shown_name(const Strings& strings, std::string_view name) {
    std::string words(name);
    if (const std::string_view known = strings.find("name." + words, ""); !known.empty()) return std::string(known);
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

char decimal_mark(const Strings& strings) {
    const std::string_view mark = strings.find("number.decimal_mark", ".");
    return mark.empty() ? '.' : mark.front();
}

void add_translations(Strings& strings, const std::vector<TranslatableText>& texts, const Strings& by_id) {
    for (const TranslatableText& text : texts)
        if (const std::string_view translation = by_id.find(text.id, {}); !translation.empty())
            strings.add(text.text, std::string(translation));
}

std::vector<Language> languages(const std::filesystem::path& folder) {
    std::vector<Language> found;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
        if (entry.path().extension() != ".toml") continue;
        const std::string code = entry.path().stem().string();
        if (const auto strings = Strings::load(entry.path()))
            found.push_back({code, std::string(strings->find("language.name", code))});
    }
    std::sort(found.begin(), found.end(), [](const Language& a, const Language& b) { return a.code < b.code; });
    return found;
}

Result<Strings> load_language(const std::filesystem::path& folder, std::string_view code) {
    std::string known;
    bool there = false;
    for (const Language& language : languages(folder)) {
        known += (known.empty() ? "" : ", ") + language.code;
        there |= language.code == code;
    }
    const auto file = folder / (std::string(code) + ".toml");
    std::error_code none;
    // A code that contains a folder is not a language. A broken file is loaded to report its error with the line.
    const bool plain = file.parent_path() == folder && !code.empty();
    if (!there && !(plain && std::filesystem::exists(file, none)))
        return known.empty() ? Error{"holds no language, not even en.toml; install the lab once more, or set "
                                     "BRAITENLAB_DATA to the folder of its data",
                                     folder.string()}
                             : Error{"language '" + std::string(code) + "' is not available; choose one of " + known};
    if (code == "en") return load_english(folder);
    auto strings = Strings::load(file);
    if (!strings) return strings;
    const auto english = load_english(folder);
    if (!english) return english.error();
    strings->fall_back_on(*english);
    return strings;
}

std::string fill(std::string_view pattern, std::initializer_list<std::string_view> values) {
    return filled(pattern, values);
}

}  // namespace braitenlab

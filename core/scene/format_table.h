// Prints schemas as the tables of docs/scene-format.md and docs/exercise-format.md.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "core/maths/angle.h"
#include "core/scene/enums.h"
#include "core/scene/schema.h"
#include "core/scene/settings.h"

namespace braitenlab {

// The visitor of core/scene/schema.h that prints one table per struct: its own keys, then its inner tables.
template <class T>
class FormatTable {
public:
    // `path`: the struct's table in a file, e.g. "kind.NAME.", empty at the top; `title`: the heading.
    FormatTable(std::string path, const std::string& title, const std::string& meaning) : path_(std::move(path)) {
        heading_ = "\n## " + title + "\n\n";
        if (!meaning.empty()) heading_ += capital(meaning) + ".\n\n";
    }
    // Keys of another struct in the same table, with the defaults that the outer struct gives them.
    FormatTable(std::string path, const T& defaults) : defaults_(defaults), path_(std::move(path)) {}

    void number(const char* key, auto T::*member, const char* unit, Range range, const char* meaning) {
        // A default outside the range stands for "no default".
        const bool has_default = range.holds(static_cast<double>(defaults_.*member));
        row(key, unit, limits_text(range), has_default ? fmt::format("{}", defaults_.*member) : "", meaning);
    }
    void angle(const char* key, float T::*member, Range range, const char* meaning) {
        row(key, "°", limits_text(range), fmt::format("{:g}", maths::degrees(defaults_.*member)), meaning);
    }
    void flag(const char* key, bool T::*member, const char* meaning) {
        row(key, "", "true, false", defaults_.*member ? "true" : "false", meaning);
    }
    void place(const char* key, std::optional<maths::vec2> T::*, Range range, const char* meaning) {
        row(key, "canvas units", fmt::format("[x, y], each {}", limits_text(range)), "tidied", meaning);
    }
    template <class Enum>
    void word(const char* key, Enum T::*member, const char* meaning) {
        std::string all;
        for (const auto& named : table_of(Enum{})) all += fmt::format("{}\"{}\"", all.empty() ? "" : ", ", named.word);
        row(key, "", all, fmt::format("\"{}\"", braitenlab::word(defaults_.*member)), meaning);
    }
    template <class Enum>
    void word(const char* key, std::optional<Enum> T::*, const char* meaning) {
        std::string all;
        for (const auto& named : table_of(Enum{})) all += fmt::format("{}\"{}\"", all.empty() ? "" : ", ", named.word);
        row(key, "", all, "", meaning);
    }
    void text(const char* key, std::string T::*, std::size_t longest, const char* meaning) {
        row(key, "", fmt::format("text, up to {} characters", longest), "", meaning);
    }
    void colour(const char* key, std::string T::*, const char* meaning) { row(key, "", "\"#rrggbb\"", "", meaning); }
    void texts(const char* key, std::vector<std::string> T::*, std::size_t most, std::size_t, const char* meaning) {
        row(key, "", fmt::format("up to {} texts", most), "", meaning);
    }
    void numbers(const char* key, std::vector<double> T::*, std::size_t most, Range range, const char* meaning) {
        row(key, "", fmt::format("up to {} numbers, {}", most, limits_text(range)), "", meaning);
    }
    void choice(const char* key, int T::*, std::vector<std::string> T::*, const char* meaning) {
        row(key, "", "text", "", meaning);
    }
    void brain_keys(BrainText T::*, const char* meaning) {
        rows_ += fmt::format("| | | the keys of a brain, see scene-format.md | | {} |\n", meaning);
    }
    void settings(const char* key, std::vector<Setting> T::*, const char* meaning) {
        tables_ += fmt::format("\n## `[{}{}]`\n\n{}.\n", path_, key, capital(meaning));
    }
    template <class... Types>
    void variant(const char* key, std::variant<Types...> T::*, const char* meaning) {
        std::string all;
        ((all += fmt::format("{}\"{}\"", all.empty() ? "" : ", ", Types::traits.word)), ...);
        row(key, "", all, "", meaning);
    }
    template <class Part>
    void part(Part T::*member) {
        FormatTable<Part> inner(path_, defaults_.*member);
        describe(inner, Of<Part>{});
        rows_ += inner.rows();
        tables_ += inner.tables();
    }
    template <class Inner>
    void table(const char* key, Inner T::*, const char* meaning) {
        add<Inner>("[", path_ + key, "]", meaning);
    }
    template <class Element>
    void named(const char* key, std::vector<Element> T::*, std::size_t most, const char* meaning) {
        add<Element>("[", path_ + key + ".NAME", "]", fmt::format("{}; up to {}", meaning, most));
    }
    template <class Element>
    void named(const char* key, std::optional<std::vector<Element>> T::*, std::size_t most, const char* meaning) {
        add<Element>("[", path_ + key + ".NAME", "]", fmt::format("{}; up to {}", meaning, most));
    }
    template <class Element>
    void list(const char* key, std::vector<Element> T::*, std::size_t most, const char* meaning) {
        add<Element>("[[", path_ + key, "]]", fmt::format("{}; up to {}", meaning, most));
    }
    template <class Graph>  // BrainGraph or an optional one
    void brain(const char* key, Graph T::*, const char* meaning) {
        add<BrainText>("[", path_ + key, "]", meaning);
    }

    std::string text() const {
        const std::string head = "| Key | Unit | Range | Default | Meaning |\n|---|---|---|---|---|\n";
        return heading_ + (rows_.empty() ? "" : head + rows_) + tables_;
    }
    const std::string& rows() const { return rows_; }
    const std::string& tables() const { return tables_; }

private:
    static std::string limits_text(Range range) { return fmt::format("{} .. {}", range.low, range.high); }
    static std::string capital(std::string text) {
        if (text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
        return text;
    }
    void row(const char* key, const char* unit, const std::string& range, const std::string& standard,
             const char* meaning) {
        rows_ += fmt::format("| `{}` | {} | {} | {} | {} |\n", key, unit, range, standard, meaning);
    }
    template <class Inner>
    void add(const char* open, const std::string& path, const char* close, const std::string& meaning) {
        FormatTable<Inner> inner(path + ".", fmt::format("`{}{}{}`", open, path, close), meaning);
        describe(inner, Of<Inner>{});
        tables_ += inner.text();
    }

    const T defaults_{};
    std::string path_, heading_, rows_, tables_;
};

// All tables of a file whose top is a T.
template <class T>
std::string describe_top() {
    FormatTable<T> table("", "The top of the file", "");
    describe(table, Of<T>{});
    return table.text();
}

}  // namespace braitenlab

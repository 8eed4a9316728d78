// Reads a struct from a table of a TOML file by the struct's description (core/scene/schema.h), and says what is wrong.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/maths/angle.h"
#include "core/scene/brain_text.h"
#include "core/scene/check.h"
#include "core/scene/enums.h"
#include "core/scene/nearest.h"
#include "core/scene/schema.h"
#include "core/scene/toml_tree.h"

namespace braitenlab {

// One table of a file, whose keys are asked for one after the other; then done() complains about the others.
// Every reading returns nothing when the key is absent or wrong; what is wrong goes to the file's error.
class TomlTable {
public:
    TomlTable(TomlFile& file, const toml::table& table, std::string path)
        : file_(file), table_(table), path_(std::move(path)) {}

    std::optional<double> number(std::string_view key, Range);
    std::optional<std::int64_t> whole(std::string_view key, Range);
    std::optional<maths::vec2> pair(std::string_view key, Range);  // [x, y], each in the range
    std::optional<bool> flag(std::string_view key);
    std::optional<std::string> text(std::string_view key, std::size_t longest);
    std::optional<std::size_t> one_of(std::string_view key, const std::vector<std::string_view>& words);  // which
    const toml::table* table(std::string_view key);
    const toml::array* list(std::string_view key, std::size_t most);
    const toml::array* list_of_tables(std::string_view key, std::size_t most);
    // The tables inside table `key`, by name, in the order of the file.
    std::vector<std::pair<std::string, const toml::table*>> named(std::string_view key, std::size_t most);

    // The value itself, for what none of the above can read; null when absent. Counts as known.
    const toml::node* find(std::string_view key);

    // An unknown key is an error that names the nearest known one.
    void done();

    bool has(std::string_view key) const { return table_.contains(key); }
    std::string path(std::string_view key) const {
        return path_.empty() ? std::string(key) : path_ + "." + std::string(key);
    }
    void fail(std::string_view key, std::string what) { file_.fail(path(key), table_.get(key), std::move(what)); }
    void fail_whole(std::string what) { file_.fail(path_, &table_, std::move(what)); }  // the table itself
    TomlFile& file() { return file_; }
    const toml::table& content() const { return table_; }

private:
    void wrong_type(std::string_view key, const toml::node&, std::string_view wanted);

    TomlFile& file_;
    const toml::table& table_;
    std::string path_;
    std::vector<std::string> known_;
};

// The keys that a description names directly.
template <class T>
struct KeyNames {
    std::vector<std::string_view> names;

    template <class Number>
    void number(const char* key, Number T::*, const char*, Range, const char*) {
        names.emplace_back(key);
    }
    void text(const char* key, std::string T::*, std::size_t, const char*) { names.emplace_back(key); }
    void flag(const char* key, bool T::*, const char*) { names.emplace_back(key); }
    template <class Element>
    void list(const char* key, std::vector<Element> T::*, std::size_t, const char*) {
        names.emplace_back(key);
    }
};
template <class T>
std::vector<std::string_view> key_names() {
    KeyNames<T> keys;
    describe(keys, Of<T>{});
    return keys.names;
}

// The visitor (see core/scene/schema.h); members that the scene does not use serve core/lesson.
template <class T>
class TomlReader {
public:
    TomlReader(TomlTable& table, T& object) : table_(table), object_(object) {}

    void number(const char* key, float T::*member, const char*, Range range, const char*) {
        if (const auto value = table_.number(key, range)) object_.*member = static_cast<float>(*value);
    }
    template <class Whole>
    void number(const char* key, Whole T::*member, const char*, Range range, const char*) {
        if (const auto value = table_.whole(key, range)) object_.*member = static_cast<Whole>(*value);
    }
    void angle(const char* key, float T::*member, Range degrees, const char*) {
        if (const auto value = table_.number(key, degrees))
            object_.*member = static_cast<float>(*value * (maths::pi_d / 180));
    }
    void place(const char* key, std::optional<maths::vec2> T::*member, Range range, const char*) {
        if (const auto value = table_.pair(key, range)) object_.*member = *value;
    }
    void flag(const char* key, bool T::*member, const char*) {
        if (const auto value = table_.flag(key)) object_.*member = *value;
    }
    template <class Enum>
    void word(const char* key, Enum T::*member, const char*) {
        std::vector<std::string_view> known;
        for (const auto& named : table_of(Enum{})) known.push_back(named.word);
        if (const auto which = table_.one_of(key, known)) object_.*member = table_of(Enum{})[*which].value;
    }
    void text(const char* key, std::string T::*member, std::size_t longest, const char*) {
        if (auto value = table_.text(key, longest)) object_.*member = std::move(*value);
    }
    template <class Part>
    void part(Part T::*member) {
        TomlReader<Part> reader(table_, object_.*member);
        describe(reader, Of<Part>{});
    }
    template <class Inner>
    void table(const char* key, Inner T::*member, const char*) {
        if (const toml::table* inner = table_.table(key)) read(*inner, table_.path(key), object_.*member);
    }
    template <class Element>
    void named(const char* key, std::vector<Element> T::*member, std::size_t most, const char*) {
        for (const auto& [name, inner] : table_.named(key, most)) {
            Element& element = (object_.*member).emplace_back();
            element.name = name;
            read(*inner, table_.path(key) + "." + name, element);
        }
    }
    template <class Element>
    void list(const char* key, std::vector<Element> T::*member, std::size_t most, const char*) {
        const toml::array* tables = table_.list_of_tables(key, most);
        if (!tables) return;
        (object_.*member).clear();
        for (const toml::node& inner : *tables) {
            Element& element = (object_.*member).emplace_back();
            read(*inner.as_table(), table_.path(key) + "." + std::to_string((object_.*member).size()), element);
        }
    }
    void brain(const char* key, BrainGraph T::*member, const char*) {
        if (const toml::table* inner = table_.table(key)) read_brain(*inner, table_.path(key), object_.*member);
    }
    void texts(const char* key, std::vector<std::string> T::*member, std::size_t most, std::size_t longest,
               const char*) {
        const toml::array* values = table_.list(key, most);
        if (!values) return;
        for (const toml::node& value : *values) {
            const auto text = value.value_exact<std::string>();
            if (!text || text->size() > longest)
                return table_.fail(key, "'" + std::string(key) + "' should be a list of short texts");
            (object_.*member).push_back(*text);
        }
    }
    void choice(const char* key, int T::*member, std::vector<std::string> T::*options, const char*) {
        const std::vector<std::string_view> known((object_.*options).begin(), (object_.*options).end());
        if (const auto which = table_.one_of(key, known)) object_.*member = static_cast<int>(*which);
    }
    // The word at `key` names the alternative by its traits. The alternative's keys stand in the same table: each must
    // be given, and none of another alternative.
    template <class... Types>
    void variant(const char* key, std::variant<Types...> T::*member, const char*) {
        const std::vector<std::string_view> known{Types::traits.word...};
        const auto which = table_.one_of(key, known);
        if (!which) return;
        std::size_t index = 0;
        ((index++ == *which && (read_alternative<Types>(key, object_.*member), true)) || ...);
        const std::vector<std::string_view> own = std::vector{key_names<Types>()...}[*which];
        for (const auto& keys : {key_names<Types>()...})
            for (const std::string_view other : keys)
                if (std::find(own.begin(), own.end(), other) == own.end() && table_.find(other))
                    table_.fail(other, "the " + std::string(key) + " '" + std::string(known[*which]) + "' has no '" +
                                           std::string(other) + "'; remove it");
    }

private:
    template <class Type, class Variant>
    void read_alternative(const char* key, Variant& variant) {
        for (const std::string_view needed : key_names<Type>())
            if (!table_.has(needed))
                table_.fail_whole("the " + std::string(key) + " '" + std::string(Type::traits.word) + "' needs '" +
                                  std::string(needed) + "'; add it");
        TomlReader<Type> reader(table_, variant.template emplace<Type>());
        describe(reader, Of<Type>{});
    }

    template <class Inner>
    void read(const toml::table& inner, const std::string& path, Inner& object) {
        TomlTable table(table_.file(), inner, path);
        TomlReader<Inner> reader(table, object);
        describe(reader, Of<Inner>{});
        table.done();
    }
    void read_brain(const toml::table& inner, const std::string& path, BrainGraph& graph) {
        BrainText text;
        read(inner, path, text);
        for (const Dial dial : all_dials)
            if (inner.contains(name(dial))) text.given.push_back(dial);
        const std::optional<Fault> fault = to_graph(text, graph);
        TomlFile& file = table_.file();
        if (fault && !file.error) file.error = file.fault_at(path + "." + fault->path, fault->what);
    }

    TomlTable& table_;
    T& object_;
};

}  // namespace braitenlab

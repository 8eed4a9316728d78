// Reads structs from TOML tables by their schema (core/scene/schema.h); errors carry file and line.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
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
#include "core/utf8.h"

namespace braitenlab {

// The order of vehicles gives them their numbers, and these their random numbers. This key of a vehicle sets it. It is
// no value of the scene: the files that the lab writes have the tables in this order.
inline constexpr std::string_view order_key = "order";

// Reads the keys of one table of a file. Every function returns nullopt or null when the key is absent or its value is
// wrong; a wrong value adds an error to the file.
class TomlTable {
public:
    // Precondition: `table` is a table and outlives this object.
    TomlTable(TomlFile& file, const TomlNode& table, std::string path)
        : file_(file), table_(table), path_(std::move(path)) {}

    std::optional<double> number(std::string_view key, Range);
    std::optional<std::int64_t> whole(std::string_view key, Range);
    std::optional<maths::vec2> pair(std::string_view key, Range);  // [x, y], each in the range
    std::optional<std::vector<double>> numbers(std::string_view key, std::size_t most, Range);
    std::optional<bool> flag(std::string_view key);
    std::optional<std::string> text(std::string_view key, std::size_t longest);
    std::optional<std::size_t> one_of(std::string_view key, const std::vector<std::string_view>& words);  // which
    const TomlNode* table(std::string_view key);
    const TomlNode::List* list(std::string_view key, std::size_t most);
    const TomlNode::List* list_of_tables(std::string_view key, std::size_t most);
    // The tables inside table `key` in the order of the file.
    std::vector<const TomlMember*> named(std::string_view key, std::size_t most);
    // Likewise, sorted by their whole number `order`, 0 without it; those of equal numbers in the order of the file.
    std::vector<const TomlMember*> named_in_order(std::string_view key, std::size_t most);

    // The value of any type, or null. Makes the key known, as all of the above do.
    const TomlNode* find(std::string_view key);

    // Makes keys known without reading them.
    void know(const std::vector<std::string_view>& keys) { known_.insert(known_.end(), keys.begin(), keys.end()); }

    // Call it after the last key: every key that is not known is an error that names the nearest known one.
    void done();

    // Fails as done() does at a key that is neither known nor in `own` nor in `foreign`, and whose nearest, of the
    // known ones and `own`, is `needed`. False if there is none.
    bool fail_if_misspelt(std::string_view needed, const std::vector<std::string_view>& own,
                          const std::vector<std::string_view>& foreign);

    // Adds the values of a table at `path` and of the tables in it, each with its dotted path from `prefix` on.
    void gather_settings(const TomlNode& table, const std::string& path, const std::string& prefix,
                         std::vector<Setting>&);

    bool has(std::string_view key) const { return table_.contains(key); }
    std::string path(std::string_view key) const {
        return path_.empty() ? std::string(key) : path_ + "." + std::string(key);
    }
    void fail(std::string_view key, Message what) { file_.fail(path(key), table_.get(key), std::move(what)); }
    // At the line of the table, for a key that it lacks.
    void fail_missing(std::string_view key, Message what) { file_.fail(path(key), &table_, std::move(what)); }
    TomlFile& file() { return file_; }
    const TomlNode& content() const { return table_; }

private:
    void fail_unknown(const TomlMember&, const std::vector<std::string_view>& candidates);
    void wrong_type(std::string_view key, const TomlNode&, const Message& wanted);

    TomlFile& file_;
    const TomlNode& table_;
    std::string path_;
    std::vector<std::string> known_;
};

// The keys that a description names directly.
template <class T>
struct KeyNames {
    std::vector<std::string_view> names;

    void number(const char* key, auto T::*, const char*, Range, const char*) { names.emplace_back(key); }
    void text(const char* key, std::string T::*, std::size_t, const char*) { names.emplace_back(key); }
    void flag(const char* key, bool T::*, const char*) { names.emplace_back(key); }
    void list(const char* key, auto T::*, std::size_t, const char*) { names.emplace_back(key); }
    template <class... Types>
    void variant(const char* key, std::variant<Types...> T::*, const char*) {
        names.emplace_back(key);
    }
};
template <class T>
std::vector<std::string_view> key_names() {
    KeyNames<T> keys;
    describe(keys, Of<T>{});
    return keys.names;
}

// The visitor of core/scene/schema.h that reads a struct. texts(), numbers(), choice() and variant() serve the
// schemas of exercises, lectures and studies.
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
        if (const auto value = read_word<Enum>(key)) object_.*member = *value;
    }
    template <class Enum>
    void word(const char* key, std::optional<Enum> T::*member, const char*) {
        if (const auto value = read_word<Enum>(key)) object_.*member = *value;
    }
    void text(const char* key, std::string T::*member, std::size_t longest, const char*) {
        if (auto value = table_.text(key, longest)) object_.*member = std::move(*value);
    }
    void colour(const char* key, std::string T::*member, const char*) {
        auto value = table_.text(key, 7);
        if (!value) return;
        if (!is_colour(*value)) return table_.fail(key, message_of("a_colour", key));
        object_.*member = std::move(*value);
    }
    template <class Part>
    void part(Part T::*member) {
        TomlReader<Part> reader(table_, object_.*member);
        describe(reader, Of<Part>{});
    }
    void table(const char* key, auto T::*member, const char*) {
        if (const TomlNode* inner = table_.table(key)) read(*inner, table_.path(key), object_.*member);
    }
    template <class Element>
    void named(const char* key, std::vector<Element> T::*member, std::size_t most, const char*) {
        read_named(key, most, object_.*member);
    }
    template <class Element>
    void named(const char* key, std::optional<std::vector<Element>> T::*member, std::size_t most, const char*) {
        if (table_.has(key)) read_named(key, most, (object_.*member).emplace());
    }
    template <class Element>
    void list(const char* key, std::vector<Element> T::*member, std::size_t most, const char*) {
        const TomlNode::List* tables = table_.list_of_tables(key, most);
        if (!tables) return;
        (object_.*member).clear();
        for (const TomlNode& inner : *tables) {
            Element& element = (object_.*member).emplace_back();
            read(inner, table_.path(key) + "." + std::to_string((object_.*member).size()), element);
        }
    }
    void brain(const char* key, BrainGraph T::*member, const char*) {
        if (const TomlNode* inner = table_.table(key)) read_brain(*inner, table_.path(key), object_.*member);
    }
    void brain(const char* key, std::optional<BrainGraph> T::*member, const char*) {
        if (const TomlNode* inner = table_.table(key))
            read_brain(*inner, table_.path(key), (object_.*member).emplace());
    }
    void texts(const char* key, std::vector<std::string> T::*member, std::size_t most, std::size_t longest,
               const char*) {
        const TomlNode::List* values = table_.list(key, most);
        if (!values) return;
        for (const TomlNode& value : *values) {
            const std::string* text = value.as_text();
            if (!text || count_characters(*text) > longest)
                return (object_.*member).clear(), table_.fail(key, message_of("short_texts", key));
            (object_.*member).push_back(*text);
        }
    }
    void numbers(const char* key, std::vector<double> T::*member, std::size_t most, Range range, const char*) {
        if (auto values = table_.numbers(key, most, range)) object_.*member = std::move(*values);
    }
    void choice(const char* key, int T::*member, std::vector<std::string> T::*options, const char*) {
        const std::vector<std::string_view> known((object_.*options).begin(), (object_.*options).end());
        if (known.empty()) return void(table_.find(key));  // the options are absent or wrong
        if (const auto which = table_.one_of(key, known)) object_.*member = static_cast<int>(*which);
    }
    // The keys of a brain in the same table.
    void brain_keys(BrainText T::*member, const char*) { part(member); }
    // Values of a scene by their paths: "kind.one.brain.LL" = 0.8, or kind.one.brain.LL = 0.8, which TOML nests.
    void settings(const char* key, std::vector<Setting> T::*member, const char*) {
        if (const TomlNode* inner = table_.table(key))
            table_.gather_settings(*inner, table_.path(key), "", object_.*member);
    }
    // The word at `key` names the alternative by its traits. The alternative's keys stand in the same table: each must
    // be given, and none of another alternative.
    template <class... Types>
    void variant(const char* key, std::variant<Types...> T::*member, const char*) {
        const std::vector<std::string_view> known{Types::traits.word...};
        const auto which = table_.one_of(key, known);
        if (!which && !table_.has(key)) return;
        std::vector<std::string_view> all;
        for (const auto& keys : {key_names<Types>()...}) all.insert(all.end(), keys.begin(), keys.end());
        if (!which) return table_.know(all);  // what belongs to an unknown word cannot be said
        std::size_t index = 0;
        (void)((index++ == *which && (read_alternative<Types>(key, object_.*member, all), true)) || ...);
        const std::vector<std::string_view> own = std::vector{key_names<Types>()...}[*which];
        for (const auto& keys : {key_names<Types>()...})
            for (const std::string_view other : keys)
                if (std::find(own.begin(), own.end(), other) == own.end() && table_.find(other))
                    table_.fail(other, message_of("key_of_other", key, known[*which], other));
    }

private:
    template <class Enum>
    std::optional<Enum> read_word(const char* key) {
        const auto which = table_.one_of(key, words_of(table_of(Enum{})));
        return which ? std::optional(table_of(Enum{})[*which].value) : std::nullopt;
    }
    template <class Type, class Variant>
    void read_alternative(const char* key, Variant& variant, const std::vector<std::string_view>& foreign) {
        const std::vector<std::string_view> needs = key_names<Type>();
        std::vector<std::string_view> own = key_names<T>();
        own.insert(own.end(), needs.begin(), needs.end());
        for (const std::string_view needed : needs)
            if (!table_.has(needed) && !table_.fail_if_misspelt(needed, own, foreign))
                table_.fail_missing(needed, message_of("key_of_own", key, Type::traits.word, needed));
        TomlReader<Type> reader(table_, variant.template emplace<Type>());
        describe(reader, Of<Type>{});
    }

    template <class Element>
    void read_named(const char* key, std::size_t most, std::vector<Element>& elements) {
        const bool is_ordered = std::is_same_v<Element, Start>;
        for (const TomlMember* inner : is_ordered ? table_.named_in_order(key, most) : table_.named(key, most)) {
            Element& element = elements.emplace_back();
            element.name = inner->key;
            read(inner->value, table_.path(key) + "." + inner->key, element);
        }
    }
    template <class Inner>
    void read(const TomlNode& inner, const std::string& path, Inner& object) {
        TomlTable table(table_.file(), inner, path);
        if constexpr (std::is_same_v<Inner, Start>) table.know({order_key});
        TomlReader<Inner> reader(table, object);
        describe(reader, Of<Inner>{});
        table.done();
    }
    void read_brain(const TomlNode& inner, const std::string& path, BrainGraph& graph) {
        BrainText text;
        read(inner, path, text);
        for (const Dial dial : all_dials)
            if (inner.contains(name(dial))) text.given.push_back(dial);
        const std::optional<Fault> fault = to_graph(text, graph);
        TomlFile& file = table_.file();
        const std::string place = fault ? path + "." + fault->path : "";
        if (fault && !file.failed_at(path)) file.add(place, file.fault_at(place, fault->what));
    }

    TomlTable& table_;
    T& object_;
};

// Reads a whole file with its format number. Returns its top, for further checks.
template <class T>
TomlTable read_top(TomlFile& file, T& object) {
    check_format(file);
    TomlTable top(file, file.root, "");
    top.find("format");
    TomlReader<T> reader(top, object);
    describe(reader, Of<T>{});
    top.done();
    return top;
}

// What read(TomlFile&) reads from a text, with every independent error by line.
template <class Read, class T = std::invoke_result_t<Read, TomlFile&>>
ReadFile<T> read_fully(std::string_view toml, const std::string& file_name, const Read& read) {
    auto file = parse_toml(toml, file_name);
    if (!file) return {{}, syntax_errors(toml, file_name)};
    T object = read(*file);
    return {std::move(object), file->errors()};
}

// The same, or the error that is found first.
template <class Read, class T = std::invoke_result_t<Read, TomlFile&>>
Result<T> read_whole(std::string_view toml, const std::string& file_name, const Read& read) {
    auto file = parse_toml(toml, file_name);
    if (!file) return file.error();
    T object = read(*file);
    if (file->failed()) return file->error();
    return object;
}

}  // namespace braitenlab

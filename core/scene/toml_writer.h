// Writes structs as TOML tables by their schema (core/scene/schema.h): every value that differs from its default, in
// the order of the schema. The opposite of core/scene/toml_reader.h.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/scene/brain_text.h"
#include "core/scene/enums.h"
#include "core/scene/schema.h"
#include "core/scene/settings.h"

namespace braitenlab {

namespace toml_text {
std::string number(float);           // the shortest decimal that reads back as the same float; never "-0"
std::string degrees(float radians);  // the decimal of fewest places that reads back as the same float in radians
std::string quote(std::string_view);
std::string setting(const Setting&);  // a line: "path" = value
}  // namespace toml_text

// The visitor of core/scene/schema.h that collects the text of one struct. texts(), numbers(), choice() and variant()
// serve the schemas of exercises and studies.
template <class T>
class TomlWriter {
public:
    // `path`: "kind.prey.", the prefix of inner tables; empty at the top.
    TomlWriter(const T& object, std::string path) : TomlWriter(object, T{}, std::move(path)) {}
    TomlWriter(const T& object, T defaults, std::string path)
        : object_(object), defaults_(std::move(defaults)), path_(std::move(path)) {}

    // The table under this heading ("[kind.prey]"; empty at the top), followed by its inner tables. A table without
    // values is left out unless it is `kept`.
    std::string text(std::string_view heading, bool kept) const {
        const bool shown = !heading.empty() && (kept || !values_.empty());
        return (shown ? fmt::format("\n{}\n", heading) : "") + values_ + tables_;
    }

    // From now on values at their defaults are written, too.
    void write_defaults() { all_ = true; }

    void number(const char* key, float T::*member, const char*, Range, const char*) {
        if (differs(member)) line(key, toml_text::number(object_.*member));
    }
    void number(const char* key, auto T::*member, const char*, Range, const char*) {
        if (differs(member)) line(key, fmt::format("{}", object_.*member));
    }
    void angle(const char* key, float T::*member, Range, const char*) {
        if (differs(member)) line(key, toml_text::degrees(object_.*member));
    }
    void place(const char* key, std::optional<maths::vec2> T::*member, Range, const char*) {
        if (const auto& at = object_.*member)
            line(key, fmt::format("[{}, {}]", toml_text::number(at->x), toml_text::number(at->y)));
    }
    void flag(const char* key, bool T::*member, const char*) {
        if (differs(member)) line(key, object_.*member ? "true" : "false");
    }
    void word(const char* key, auto T::*member, const char*) {
        if (differs(member)) line(key, fmt::format("\"{}\"", braitenlab::word(object_.*member)));
    }
    template <class Enum>
    void word(const char* key, std::optional<Enum> T::*member, const char*) {
        if (const auto& value = object_.*member) line(key, fmt::format("\"{}\"", braitenlab::word(*value)));
    }
    void text(const char* key, std::string T::*member, std::size_t, const char*) {
        if (differs(member)) line(key, toml_text::quote(object_.*member));
    }
    void colour(const char* key, std::string T::*member, const char*) { text(key, member, 0, ""); }
    void texts(const char* key, std::vector<std::string> T::*member, std::size_t, std::size_t, const char*) {
        if (!differs(member)) return;
        std::string list;
        for (const std::string& each : object_.*member)
            list += fmt::format("{}{}", list.empty() ? "" : ", ", toml_text::quote(each));
        line(key, fmt::format("[{}]", list));
    }
    void numbers(const char* key, std::vector<double> T::*member, std::size_t, Range, const char*) {
        if (differs(member)) line(key, fmt::format("[{}]", fmt::join(object_.*member, ", ")));
    }
    // The text of the chosen option; nothing without options.
    void choice(const char* key, int T::*member, std::vector<std::string> T::*options, const char*) {
        const auto which = static_cast<std::size_t>(object_.*member);
        if (which < (object_.*options).size()) line(key, toml_text::quote((object_.*options)[which]));
    }
    // The alternative's word and all of its keys.
    template <class... Types>
    void variant(const char* key, std::variant<Types...> T::*member, const char*) {
        std::visit(
            [&]<class Type>(const Type& value) {
                line(key, toml_text::quote(Type::traits.word));
                TomlWriter<Type> inner(value, path_);
                inner.write_defaults();
                describe(inner, Of<Type>{});
                add(inner);
            },
            object_.*member);
    }
    void settings(const char* key, std::vector<Setting> T::*member, const char*) {
        if ((object_.*member).empty()) return;
        tables_ += fmt::format("\n[{}{}]\n", path_, key);
        for (const Setting& each : object_.*member) tables_ += toml_text::setting(each);
    }
    template <class Part>
    void part(Part T::*member) {
        TomlWriter<Part> inner(object_.*member, defaults_.*member, path_);
        describe(inner, Of<Part>{});
        add(inner);
    }
    // The keys of a brain in the same table, also given dials of value 0: a brain with any dial is a four-neuron brain.
    void brain_keys(BrainText T::*member, const char*) {
        TomlWriter<BrainText> inner(object_.*member, path_);
        inner.write_brain();
        add(inner);
    }
    void table(const char* key, auto T::*member, const char*) { write(object_.*member, key, false); }
    template <class Element>
    void named(const char* key, std::vector<Element> T::*member, std::size_t, const char*) {
        write_named(key, object_.*member);
    }
    // An empty list is a table without content.
    template <class Element>
    void named(const char* key, std::optional<std::vector<Element>> T::*member, std::size_t, const char*) {
        if (!(object_.*member)) return;
        if ((object_.*member)->empty()) tables_ += fmt::format("\n[{}{}]\n", path_, key);
        write_named(key, *(object_.*member));
    }
    template <class Element>
    void list(const char* key, std::vector<Element> T::*member, std::size_t, const char*) {
        if constexpr (requires(const Element& e) { e == e; }) {
            if (!differs(member)) return;
        }
        for (const Element& element : object_.*member) {
            TomlWriter<Element> inner(element, fmt::format("{}{}.", path_, key));
            describe(inner, Of<Element>{});
            tables_ += inner.text(fmt::format("[[{}{}]]", path_, key), true);
        }
    }
    void brain(const char* key, BrainGraph T::*member, const char*) {
        if (differs(member)) write_graph(object_.*member, key);
    }
    void brain(const char* key, std::optional<BrainGraph> T::*member, const char*) {
        if (const auto& graph = object_.*member) write_graph(*graph, key);
    }

private:
    bool differs(auto T::*member) const { return all_ || !(object_.*member == defaults_.*member); }

    void line(std::string_view key, const std::string& value) { values_ += fmt::format("{} = {}\n", key, value); }

    // Adds keys of another struct to this table.
    template <class Part>
    void add(const TomlWriter<Part>& inner) {
        values_ += inner.values_;
        tables_ += inner.tables_;
    }

    template <class Element>
    void write_named(const char* key, const std::vector<Element>& elements) {
        for (const Element& element : elements) write(element, fmt::format("{}.{}", key, element.name), true);
    }
    template <class Inner>
    void write(const Inner& object, const std::string& key, bool kept) {
        TomlWriter<Inner> inner(object, fmt::format("{}{}.", path_, key));
        describe(inner, Of<Inner>{});
        tables_ += inner.text(fmt::format("[{}{}]", path_, key), kept);
    }
    void write_graph(const BrainGraph& graph, const std::string& key) {
        const BrainText brain = to_text(graph);
        TomlWriter<BrainText> inner(brain, fmt::format("{}{}.", path_, key));
        inner.write_brain();
        tables_ += inner.text(fmt::format("[{}{}]", path_, key), true);
    }
    // Of BrainText only.
    void write_brain() {
        for (const Dial dial : object_.given)
            if (at(object_.dials, dial) == 0) line(name(dial), "0");
        describe(*this, Of<T>{});
    }

    template <class Other>
    friend class TomlWriter;

    const T& object_;
    const T defaults_;
    std::string path_;
    std::string values_, tables_;
    bool all_ = false;
};

// A whole file with its format number. The opposite of read_top().
template <class T>
std::string write_top(const T& object) {
    TomlWriter<T> writer(object, "");
    describe(writer, Of<T>{});
    return "format = 1\n" + writer.text("", false);
}

}  // namespace braitenlab

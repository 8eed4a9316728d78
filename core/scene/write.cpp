// Writes scenes and brains as TOML, in the order of the schema.
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "core/maths/angle.h"
#include "core/scene/brain_text.h"
#include "core/scene/enums.h"
#include "core/scene/scene_file.h"
#include "core/scene/schema.h"

namespace braitenlab {

namespace {

// The shortest decimal that reads back as the same float. Never "-0".
std::string number_text(float value) { return fmt::format("{}", value == 0 ? 0.0f : value); }

// The decimal of fewest places, in degrees, that reads back as the same float in radians.
std::string degrees_text(float radians) {
    const double degrees = static_cast<double>(radians) * (180 / maths::pi_d);
    double scale = 1;
    for (int places = 0; places <= 12; ++places, scale *= 10) {
        const double rounded = std::round(degrees * scale) / scale;
        if (static_cast<float>(rounded * (maths::pi_d / 180)) == radians)
            return fmt::format("{}", rounded == 0 ? 0.0 : rounded);
    }
    return fmt::format("{}", degrees);
}

std::string quote(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (c == '\n') {
            out += "\\n";
        } else if (byte < 0x20 || byte == 0x7f) {
            out += fmt::format("\\u{:04X}", byte);
        } else {
            out += c;
        }
    }
    return out + "\"";
}

// The visitor of core/scene/schema.h that writes every value that differs from its default. Values of a table come
// before its inner tables; the header is written before the first value.
template <class T>
class TomlWriter {
public:
    // `header`: "[kind.prey]", empty at the top; `path`: "kind.prey.", the prefix of inner tables.
    TomlWriter(const T& object, std::string header, std::string path, std::string& out)
        : object_(object), header_(std::move(header)), path_(std::move(path)), out_(out) {}

    void number(const char* key, float T::*member, const char*, Range, const char*) {
        if (differs(member)) line(key, number_text(object_.*member));
    }
    template <class Whole>
    void number(const char* key, Whole T::*member, const char*, Range, const char*) {
        if (differs(member)) line(key, fmt::format("{}", object_.*member));
    }
    void angle(const char* key, float T::*member, Range, const char*) {
        if (differs(member)) line(key, degrees_text(object_.*member));
    }
    void place(const char* key, std::optional<maths::vec2> T::*member, Range, const char*) {
        if (const auto& at = object_.*member)
            line(key, fmt::format("[{}, {}]", number_text(at->x), number_text(at->y)));
    }
    void flag(const char* key, bool T::*member, const char*) {
        if (differs(member)) line(key, object_.*member ? "true" : "false");
    }
    template <class Enum>
    void word(const char* key, Enum T::*member, const char*) {
        if (differs(member)) line(key, fmt::format("\"{}\"", braitenlab::word(object_.*member)));
    }
    template <class Enum>
    void word(const char* key, std::optional<Enum> T::*member, const char*) {
        if (const auto& value = object_.*member) line(key, fmt::format("\"{}\"", braitenlab::word(*value)));
    }
    void text(const char* key, std::string T::*member, std::size_t, const char*) {
        if (differs(member)) line(key, quote(object_.*member));
    }
    void colour(const char* key, std::string T::*member, const char*) { text(key, member, 0, ""); }
    template <class Part>
    void part(Part T::*member) {
        TomlWriter<Part> inner(object_.*member, defaults_.*member, header_, path_, out_);
        describe(inner, Of<Part>{});
        if (inner.begun()) header_.clear();
    }
    template <class Inner>
    void table(const char* key, Inner T::*member, const char*) {
        write(object_.*member, key, false);
    }
    template <class Element>
    void named(const char* key, std::vector<Element> T::*member, std::size_t, const char*) {
        write_named(key, object_.*member);
    }
    // An empty list is a table without content.
    template <class Element>
    void named(const char* key, std::optional<std::vector<Element>> T::*member, std::size_t, const char*) {
        if (!(object_.*member)) return;
        if ((object_.*member)->empty()) out_ += fmt::format("{}[{}{}]\n", out_.empty() ? "" : "\n", path_, key);
        write_named(key, *(object_.*member));
    }
    template <class Element>
    void list(const char* key, std::vector<Element> T::*member, std::size_t, const char*) {
        if constexpr (requires(const Element& e) { e == e; }) {
            if (!differs(member)) return;
        }
        for (const Element& element : object_.*member) {
            begin();
            TomlWriter<Element> inner(element, fmt::format("[[{}{}]]", path_, key), "", out_);
            describe(inner, Of<Element>{});
            inner.begin();
        }
    }
    void brain(const char* key, BrainGraph T::*member, const char*) {
        if (differs(member)) write(to_text(object_.*member), key, true);
    }
    void brain(const char* key, std::optional<BrainGraph> T::*member, const char*) {
        if (const auto& graph = object_.*member) write(to_text(*graph), key, true);
    }

    TomlWriter(const T& object, const T& defaults, std::string header, std::string path, std::string& out)
        : object_(object), defaults_(defaults), header_(std::move(header)), path_(std::move(path)), out_(out) {}

    // Writes the header unless it is written already.
    void begin() {
        if (!header_.empty()) out_ += fmt::format("{}{}\n", out_.empty() ? "" : "\n", header_);
        header_.clear();
    }
    bool begun() const { return header_.empty(); }

private:
    template <class Value>
    bool differs(Value T::*member) const {
        return !(object_.*member == defaults_.*member);
    }

    void line(std::string_view key, const std::string& value) {
        begin();
        out_ += fmt::format("{} = {}\n", key, value);
    }

    template <class Element>
    void write_named(const char* key, const std::vector<Element>& elements) {
        for (const Element& element : elements) write(element, fmt::format("{}.{}", key, element.name), true);
    }
    template <class Inner>
    void write(const Inner& object, const std::string& key, bool even_if_default) {
        TomlWriter<Inner> inner(object, fmt::format("[{}{}]", path_, key), path_ + key + ".", out_);
        if (even_if_default) inner.begin();
        describe(inner, Of<Inner>{});
    }
    // Also writes given dials of value 0: a brain with any dial is a four-neuron brain.
    void write(const BrainText& text, const std::string& key, bool) {
        TomlWriter<BrainText> inner(text, fmt::format("[{}{}]", path_, key), path_ + key + ".", out_);
        inner.begin();
        for (const Dial dial : text.given)
            if (at(text.dials, dial) == 0) inner.line(name(dial), "0");
        describe(inner, Of<BrainText>{});
    }

    template <class Other>
    friend class TomlWriter;

    const T& object_;
    const T defaults_{};
    std::string header_, path_;
    std::string& out_;
};

}  // namespace

std::string write_scene(const Scene& scene) {
    std::string out = "format = 1\n";
    TomlWriter<Scene> writer(scene, "", "", out);
    describe(writer, Of<Scene>{});
    return out;
}

std::string write_brain(const BrainGraph& graph) {
    std::string out = "format = 1\n";
    const BrainFile file{graph};
    TomlWriter<BrainFile> writer(file, "", "", out);
    describe(writer, Of<BrainFile>{});
    return out;
}

}  // namespace braitenlab

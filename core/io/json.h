// Conversion of scenes, brains and commands to and from JSON, for run files (scene files are TOML). Structs that
// core/scene/schema.h describes need no code here. Inside core/io, core/lesson
// and core/evolve only.
//
// Reading throws Json::exception for missing values and wrong types. The caller checks ranges.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/brain/four_neurons.h"
#include "core/scene/enums.h"
#include "core/scene/schema.h"
#include "core/world/command.h"

namespace braitenlab::io {
using Json = nlohmann::json;
}  // namespace braitenlab::io

// to_json and from_json are in the namespaces of their types, because the library finds them by argument-dependent
// lookup.
namespace braitenlab {

using io::Json;

// ── Words ───────────────────────────────────────────────────────────────────────────────────────────────────────────
template <class Enum>
concept HasWords = requires(Enum e) {
    table_of(e);
};

template <HasWords Enum>
void to_json(Json& json, const Enum& value) {
    json = word(value);
}
template <HasWords Enum>
void from_json(const Json& json, Enum& value) {
    const auto& text = json.get_ref<const std::string&>();
    const auto known = find_word(table_of(Enum{}), text);
    if (!known) throw Json::other_error::create(501, "unknown word '" + text + "'", &json);
    value = *known;
}

inline void to_json(Json& json, const Dial& dial) { json = name(dial); }
inline void from_json(const Json& json, Dial& dial) {
    const auto& text = json.get_ref<const std::string&>();
    const auto known = dial_named(text);
    if (!known) throw Json::other_error::create(501, "unknown dial '" + text + "'", &json);
    dial = *known;
}

// ── Plain structs ───────────────────────────────────────────────────────────────────────────────────────────────────
namespace maths {
inline void to_json(Json& json, const vec2& v) { json = {v.x, v.y}; }
inline void from_json(const Json& json, vec2& v) { json.at(0).get_to(v.x), json.at(1).get_to(v.y); }
}  // namespace maths

// Node ids of a wire's two ends.
inline void add_ends(Json& json, const Wire& wire) { json["from"] = wire.from, json["to"] = wire.to; }
inline void take_ends(const Json& json, Wire& wire) {
    json.at("from").get_to(wire.from), json.at("to").get_to(wire.to);
}

void to_json(Json&, const BrainGraph&);
void from_json(const Json&, BrainGraph&);

// ── Structs described in core/scene/schema.h ────────────────────────────────────────────────────────────────────────
namespace io {

template <class T>
class JsonWriter {
public:
    JsonWriter(const T& object, Json& json) : object_(object), json_(json) {}

    void number(const char* key, auto T::*member, const char*, Range, const char*) { json_[key] = object_.*member; }
    void angle(const char* key, float T::*member, Range, const char*) { json_[key] = object_.*member; }  // rad
    void place(const char* key, std::optional<maths::vec2> T::*member, Range, const char*) {
        if (object_.*member) json_[key] = *(object_.*member);
    }
    void flag(const char* key, bool T::*member, const char*) { json_[key] = object_.*member; }
    void word(const char* key, auto T::*member, const char*) { json_[key] = object_.*member; }
    template <class Enum>
    void word(const char* key, std::optional<Enum> T::*member, const char*) {
        if (object_.*member) json_[key] = *(object_.*member);
    }
    void text(const char* key, std::string T::*member, std::size_t, const char*) { json_[key] = object_.*member; }
    void colour(const char* key, std::string T::*member, const char*) {
        if (!(object_.*member).empty()) json_[key] = object_.*member;
    }
    template <class Part>
    void part(Part T::*member) {
        JsonWriter<Part> inner(object_.*member, json_);
        describe(inner, Of<Part>{});
    }
    void table(const char* key, auto T::*member, const char*) { json_[key] = object_.*member; }
    template <class Element>
    void named(const char* key, std::vector<Element> T::*member, std::size_t, const char*) {
        json_[key] = object_.*member;
    }
    template <class Element>
    void named(const char* key, std::optional<std::vector<Element>> T::*member, std::size_t, const char*) {
        if (object_.*member) json_[key] = *(object_.*member);
    }
    void list(const char* key, auto T::*member, std::size_t, const char*) { json_[key] = object_.*member; }
    void brain(const char* key, BrainGraph T::*member, const char*) { json_[key] = object_.*member; }
    void brain(const char* key, std::optional<BrainGraph> T::*member, const char*) {
        if (object_.*member) json_[key] = *(object_.*member);
    }

private:
    const T& object_;
    Json& json_;
};

template <class T>
class JsonReader {
public:
    JsonReader(const Json& json, T& object) : json_(json), object_(object) {}

    void number(const char* key, auto T::*member, const char*, Range, const char*) {
        json_.at(key).get_to(object_.*member);
    }
    void angle(const char* key, float T::*member, Range, const char*) { json_.at(key).get_to(object_.*member); }
    void place(const char* key, std::optional<maths::vec2> T::*member, Range, const char*) {
        if (json_.contains(key)) object_.*member = json_.at(key).get<maths::vec2>();
    }
    void flag(const char* key, bool T::*member, const char*) { json_.at(key).get_to(object_.*member); }
    void word(const char* key, auto T::*member, const char*) { json_.at(key).get_to(object_.*member); }
    template <class Enum>
    void word(const char* key, std::optional<Enum> T::*member, const char*) {
        if (json_.contains(key)) object_.*member = json_.at(key).get<Enum>();
    }
    void text(const char* key, std::string T::*member, std::size_t, const char*) {
        json_.at(key).get_to(object_.*member);
    }
    void colour(const char* key, std::string T::*member, const char*) {
        if (json_.contains(key)) json_.at(key).get_to(object_.*member);
    }
    template <class Part>
    void part(Part T::*member) {
        JsonReader<Part> inner(json_, object_.*member);
        describe(inner, Of<Part>{});
    }
    void table(const char* key, auto T::*member, const char*) { json_.at(key).get_to(object_.*member); }
    template <class Element>
    void named(const char* key, std::vector<Element> T::*member, std::size_t, const char*) {
        json_.at(key).get_to(object_.*member);
    }
    template <class Element>
    void named(const char* key, std::optional<std::vector<Element>> T::*member, std::size_t, const char*) {
        if (json_.contains(key)) object_.*member = json_.at(key).get<std::vector<Element>>();
    }
    void list(const char* key, auto T::*member, std::size_t, const char*) { json_.at(key).get_to(object_.*member); }
    void brain(const char* key, BrainGraph T::*member, const char*) { json_.at(key).get_to(object_.*member); }
    void brain(const char* key, std::optional<BrainGraph> T::*member, const char*) {
        if (json_.contains(key)) object_.*member = json_.at(key).get<BrainGraph>();
    }

private:
    const Json& json_;
    T& object_;
};

}  // namespace io

template <class T>
concept Described = std::is_class_v<T> && requires(io::JsonWriter<Scene>& any_visitor) {
    describe(any_visitor, Of<T>{});
};

template <Described T>
void to_json(Json& json, const T& object) {
    json = Json::object();
    if constexpr (requires { object.name; }) json["name"] = object.name;
    if constexpr (std::is_same_v<T, Wire>) add_ends(json, object);
    if constexpr (std::is_same_v<T, Kind>)
        if (object.hidden) json["hidden"] = true;  // the schema has it as the table `sealed` of a scene file
    io::JsonWriter<T> writer(object, json);
    describe(writer, Of<T>{});
}
template <Described T>
void from_json(const Json& json, T& object) {
    if constexpr (requires { object.name; }) json.at("name").get_to(object.name);
    if constexpr (std::is_same_v<T, Wire>) take_ends(json, object);
    if constexpr (std::is_same_v<T, Kind>) object.hidden = json.contains("hidden") && json.at("hidden").get<bool>();
    io::JsonReader<T> reader(json, object);
    describe(reader, Of<T>{});
}

inline void to_json(Json& json, const BrainGraph& graph) { json = {{"nodes", graph.nodes}, {"wires", graph.wires}}; }
inline void from_json(const Json& json, BrainGraph& graph) {
    json.at("nodes").get_to(graph.nodes);
    json.at("wires").get_to(graph.wires);
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Look, label, colour)

// ── Commands: {"TurnDial": {…}} ─────────────────────────────────────────────────────────────────────────────────────
void to_json(Json&, const Command&);
void from_json(const Json&, Command&);

}  // namespace braitenlab

// The library requires this specialization for types of other namespaces.
template <class T>
struct nlohmann::adl_serializer<std::optional<T>> {
    static void to_json(braitenlab::Json& json, const std::optional<T>& value) {
        json = value ? braitenlab::Json(*value) : braitenlab::Json();
    }
    static void from_json(const braitenlab::Json& json, std::optional<T>& value) {
        if (json.is_null())
            value.reset();
        else
            value = json.get<T>();
    }
};

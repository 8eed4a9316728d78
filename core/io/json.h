// Conversion of scenes, brains and commands to and from JSON, for run files (scene files are TOML). Structs that
// core/scene/schema.h describes need no code here. Inside core/io, core/lesson
// and core/evolve only.
//
// Reading throws Json::exception for missing values and wrong types. The caller checks ranges.
#pragma once

#include <optional>
#include <string>

#include "core/brain/four_neurons.h"
#include "core/io/checked_json.h"
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

void to_json(Json&, const BrainGraph&);
void from_json(const Json&, BrainGraph&);

// ── Structs described in core/scene/schema.h ────────────────────────────────────────────────────────────────────────
namespace io {

// Writes or reads the visited members of an object, so that one list of them serves both directions.
struct JsonWriter {
    Json& json;
    void value(const char* key, const auto& member) { json[key] = member; }
    // Without the key it is nullopt.
    void optional(const char* key, const auto& member) {
        if (member) json[key] = *member;
    }
    // Without the key it is as usual.
    void unusual(const char* key, const auto& member, const auto& usual) {
        if (member != usual) json[key] = member;
    }
};
struct JsonReader {
    const Json& json;
    void value(const char* key, auto& member) { json.at(key).get_to(member); }
    template <class Value>
    void optional(const char* key, std::optional<Value>& member) {
        if (json.contains(key)) member = json.at(key).get<Value>();
    }
    void unusual(const char* key, auto& member, const auto&) {
        if (json.contains(key)) json.at(key).get_to(member);
    }
};

template <class T, class Members, class Object>
void visit_described(Members, Object&);

// The visitor of core/scene/schema.h for both directions. Object: T, or const T for a JsonWriter.
template <class T, class Members, class Object>
class JsonVisitor {
public:
    JsonVisitor(Members members, Object& object) : members_(members), object_(object) {}

    void number(const char* key, auto T::*member, const char*, Range, const char*) { add(key, object_.*member); }
    void angle(const char* key, auto T::*member, Range, const char*) { add(key, object_.*member); }  // rad
    void place(const char* key, auto T::*member, Range, const char*) { add(key, object_.*member); }
    void flag(const char* key, auto T::*member, const char*) { add(key, object_.*member); }
    void word(const char* key, auto T::*member, const char*) { add(key, object_.*member); }
    void text(const char* key, auto T::*member, std::size_t, const char*) { add(key, object_.*member); }
    void colour(const char* key, std::string T::*member, const char*) {
        members_.unusual(key, object_.*member, std::string());
    }
    template <class Part>
    void part(Part T::*member) {
        visit_described<Part>(members_, object_.*member);
    }
    void table(const char* key, auto T::*member, const char*) { add(key, object_.*member); }
    void named(const char* key, auto T::*member, std::size_t, const char*) { add(key, object_.*member); }
    void list(const char* key, auto T::*member, std::size_t, const char*) { add(key, object_.*member); }
    void brain(const char* key, auto T::*member, const char*) { add(key, object_.*member); }

private:
    void add(const char* key, auto& member) {
        if constexpr (requires { member.has_value(); })
            members_.optional(key, member);
        else
            members_.value(key, member);
    }
    Members members_;
    Object& object_;
};

// The members of a T that its description has.
template <class T, class Members, class Object>
void visit_described(Members members, Object& object) {
    JsonVisitor<T, Members, Object> visitor(members, object);
    describe(visitor, Of<T>{});
}

}  // namespace io

template <class T>
concept Described = std::is_class_v<T> && requires(io::JsonVisitor<Scene, io::JsonReader, Scene>& any_visitor) {
    describe(any_visitor, Of<T>{});
};

template <Described T>
void visit_members(auto members, auto& object) {
    if constexpr (requires { object.name; }) members.value("name", object.name);
    if constexpr (std::is_same_v<T, Wire>) members.value("from", object.from), members.value("to", object.to);
    // The schema has it as the table `sealed` of a scene file.
    if constexpr (std::is_same_v<T, Kind>) members.unusual("hidden", object.hidden, false);
    io::visit_described<T>(members, object);
}
template <Described T>
void to_json(Json& json, const T& object) {
    json = Json::object();
    visit_members<T>(io::JsonWriter{json}, object);
}
template <Described T>
void from_json(const Json& json, T& object) {
    visit_members<T>(io::JsonReader{json}, object);
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BrainGraph, nodes, wires)
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

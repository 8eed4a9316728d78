#include "core/scene/scene_number.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>
#include <vector>

#include "core/maths/angle.h"
#include "core/text_parts.h"

namespace braitenlab {

namespace {

// The part of a visitor of core/scene/schema.h for values that are no numbers.
template <class T>
struct NoNumbers {
    void flag(const char*, bool T::*, const char*) {}
    void word(const char*, auto T::*, const char*) {}
    void text(const char*, std::string T::*, std::size_t, const char*) {}
    void colour(const char*, std::string T::*, const char*) {}
    void list(const char*, auto T::*, std::size_t, const char*) {}
    void named(const char*, auto T::*, std::size_t, const char*) {}
    void brain(const char*, auto T::*, const char*) {}
};

template <class T>
struct NumberReader : NoNumbers<T> {
    const T& record;
    std::string_view wanted;
    std::optional<SceneNumber> found{};

    NumberReader(const T& of, std::string_view key) : record(of), wanted(key) {}
    void number(const char* key, auto T::*member, const char* unit, Range range, const char*) {
        if (key == wanted) found = SceneNumber{static_cast<double>(record.*member), range, unit};
    }
    void angle(const char* key, float T::*member, Range degrees, const char*) {
        if (key == wanted) found = SceneNumber{static_cast<double>(record.*member) * (180 / maths::pi_d), degrees, "°"};
    }
};

template <class T>
struct NumberWriter : NoNumbers<T> {
    T& record;
    std::string_view wanted;
    double value;
    bool found = false;

    NumberWriter(T& of, std::string_view key, double to) : record(of), wanted(key), value(to) {}
    template <class Number>
    void number(const char* key, Number T::*member, const char*, Range range, const char*) {
        if (key != wanted) return;
        const double to = std::clamp(value, range.low, range.high);
        record.*member = static_cast<Number>(std::is_integral_v<Number> ? std::round(to) : to);
        found = true;
    }
    void angle(const char* key, float T::*member, Range degrees, const char*) {
        if (key != wanted) return;
        // As the reader of files computes it, so that both give the same run.
        record.*member = static_cast<float>(std::clamp(value, degrees.low, degrees.high) * (maths::pi_d / 180));
        found = true;
    }
};

template <class T>
std::optional<SceneNumber> read_number(const T& record, std::string_view key) {
    NumberReader<T> reader(record, key);
    describe(reader, Of<T>{});
    return reader.found;
}

template <class T>
bool write_number(T& record, std::string_view key, double value) {
    NumberWriter<T> writer(record, key, value);
    describe(writer, Of<T>{});
    return writer.found;
}

template <class Element>
Element* element_named(std::vector<Element>& elements, const std::string& name) {
    const auto found =
        std::find_if(elements.begin(), elements.end(), [&](const Element& each) { return each.name == name; });
    return found == elements.end() ? nullptr : &*found;
}

// parts: TABLE, NAME, "sensor", SENSOR, KEY.
bool set_sensor(std::vector<Sensor>* sensors, const std::vector<std::string>& parts, double value) {
    if (!sensors || parts.size() != 5 || parts[2] != "sensor") return false;
    Sensor* sensor = element_named(*sensors, parts[3]);
    return sensor && set_number(*sensor, parts[4], value);
}

}  // namespace

std::optional<SceneNumber> number_of(const Arena& of, std::string_view key) { return read_number(of, key); }
std::optional<SceneNumber> number_of(const Body& of, std::string_view key) { return read_number(of, key); }
std::optional<SceneNumber> number_of(const Sensor& of, std::string_view key) { return read_number(of, key); }
std::optional<SceneNumber> number_of(const Source& of, std::string_view key) { return read_number(of, key); }
std::optional<SceneNumber> number_of(const Start& of, std::string_view key) { return read_number(of, key); }

bool set_number(Arena& of, std::string_view key, double value) { return write_number(of, key, value); }
bool set_number(Body& of, std::string_view key, double value) { return write_number(of, key, value); }
bool set_number(Sensor& of, std::string_view key, double value) { return write_number(of, key, value); }
bool set_number(Source& of, std::string_view key, double value) { return write_number(of, key, value); }
bool set_number(Start& of, std::string_view key, double value) { return write_number(of, key, value); }

bool set_number_at(Scene& scene, std::string_view path, double value) {
    const std::vector<std::string> parts = parts_of(path, '.');
    const std::string& table = parts.front();
    if (table == "arena" && parts.size() == 2) return set_number(scene.arena, parts[1], value);
    if (parts.size() < 3) return false;
    const std::string &name = parts[1], &key = parts[2];
    if (table == "source") {
        Source* source = element_named(scene.sources, name);
        return source && parts.size() == 3 && set_number(*source, key, value);
    }
    if (table == "vehicle") {
        Start* start = element_named(scene.starts, name);
        if (start && parts.size() == 3) return set_number(*start, key, value);
        return start && set_sensor(start->sensors ? &*start->sensors : nullptr, parts, value);
    }
    if (table == "member") {
        Member* member = element_named(scene.members, name);
        return member && set_sensor(member->sensors ? &*member->sensors : nullptr, parts, value);
    }
    Kind* kind = table == "kind" ? element_named(scene.kinds, name) : nullptr;
    if (kind && parts.size() == 4 && key == "body") return set_number(kind->body, parts[3], value);
    return kind && set_sensor(&kind->sensors, parts, value);
}

}  // namespace braitenlab

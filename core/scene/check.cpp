#include "core/scene/check.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/brain/brain.h"
#include "core/maths/angle.h"
#include "core/scene/arena.h"
#include "core/scene/nearest.h"
#include "core/scene/size_limits.h"
#include "core/utf8.h"

namespace braitenlab {

namespace {

// The visitor of core/scene/schema.h that checks every value against its range.
template <class T>
class RangeCheck {
public:
    RangeCheck(const T& object, std::string path, std::optional<Fault>& fault)
        : object_(object), path_(std::move(path)), fault_(fault) {}

    template <class Number>
    void number(const char* key, Number T::*member, const char*, Range range, const char*) {
        // A float represents an end like 0.005 only approximately.
        if (object_.*member == static_cast<Number>(range.low) || object_.*member == static_cast<Number>(range.high))
            return;
        check(key, static_cast<double>(object_.*member), range);
    }
    void angle(const char* key, float T::*member, Range degrees, const char*) {
        constexpr double rounding = 1e-3;  // 360 degrees in radians may come back as 360.00001
        const double value = static_cast<double>(object_.*member) * (180 / maths::pi_d);
        if (Range{degrees.low - rounding, degrees.high + rounding}.holds(value)) return;
        check(key, value, degrees);
    }
    void flag(const char*, bool T::*, const char*) {}
    void word(const char*, auto T::*, const char*) {}
    void text(const char* key, std::string T::*member, std::size_t longest, const char*) {
        if (count_characters(object_.*member) > longest) fail(key, message_of("longer_than", key, longest));
    }
    void colour(const char* key, std::string T::*member, const char*) {
        if (!(object_.*member).empty() && !is_colour(object_.*member))
            fail(key, message_of("no_colour", in_quotes(object_.*member)));
    }
    template <class Part>
    void part(Part T::*member) {
        RangeCheck<Part> inner(object_.*member, path_, fault_);
        describe(inner, Of<Part>{});
    }
    template <class Inner>
    void table(const char* key, Inner T::*member, const char*) {
        RangeCheck<Inner> inner(object_.*member, path_ + key + ".", fault_);
        describe(inner, Of<Inner>{});
    }
    template <class Element>
    void named(const char* key, std::vector<Element> T::*member, std::size_t most, const char*) {
        check_named(key, object_.*member, most);
    }
    template <class Element>
    void named(const char* key, std::optional<std::vector<Element>> T::*member, std::size_t most, const char*) {
        if (object_.*member) check_named(key, *(object_.*member), most);
    }
    template <class Element>
    void list(const char* key, std::vector<Element> T::*member, std::size_t most, const char*) {
        if (!count(key, (object_.*member).size(), most)) return;
        for (std::size_t i = 0; i < (object_.*member).size(); ++i) {
            RangeCheck<Element> inner((object_.*member)[i], fmt::format("{}{}.{}.", path_, key, i + 1), fault_);
            describe(inner, Of<Element>{});
        }
    }
    void brain(const char*, auto T::*, const char*) {}  // checked as a whole, below

private:
    template <class Element>
    void check_named(const char* key, const std::vector<Element>& elements, std::size_t most) {
        if (!count(key, elements.size(), most)) return;
        std::set<std::string_view> names;
        for (const Element& element : elements) {
            const std::string at = fmt::format("{}.{}", key, element.name);
            if (const auto fault = name_fault(element.name)) return fail(at, *fault);
            if (!names.insert(element.name).second)
                return fail(at, message_of("same_name", path_ + key, in_quotes(element.name)));
            RangeCheck<Element> inner(element, path_ + at + ".", fault_);
            describe(inner, Of<Element>{});
        }
    }
    void check(const char* key, double value, Range range) {
        if (!range.holds(value)) fail(key, outside(key, value, range));
    }
    bool count(const char* key, std::size_t number, std::size_t most) {
        if (number > most) fail(key, message_of("too_many_times", number, path_ + key, most));
        return number <= most;
    }
    void fail(const std::string& key, Message what) {
        if (!fault_) fault_ = Fault{path_ + key, std::move(what)};
    }

    const T& object_;
    std::string path_;
    std::optional<Fault>& fault_;
};

template <class T>
std::optional<Fault> range_fault(const T& object) {
    std::optional<Fault> fault;
    RangeCheck<T> check(object, "", fault);
    describe(check, Of<T>{});
    return fault;
}

std::optional<Fault> wheels_fault(const Kind& kind) {
    float load = 0;
    for (const Wheel& wheel : kind.body.wheels) load += wheel.load;
    if (std::fabs(load - 1) <= 1e-3f) return std::nullopt;
    return Fault{"kind." + kind.name + ".body.wheel",
                 message_of("wheel_loads", told_apart(static_cast<double>(load), 1, Digits::in_all, 3).first)};
}

// `path`: of the owner of the sensors.
std::optional<Fault> triangle_fault(const std::vector<Sensor>& sensors, const std::string& path) {
    constexpr float widest = maths::radians(179);
    for (const Sensor& s : sensors)
        if (s.shape == SensorShape::triangle && s.fov > widest + 1e-3f)
            return Fault{path + ".sensor." + s.name + ".field", message_of("wide_triangle")};
    return std::nullopt;
}

// The points of a table, and that other responses have none. `path`: of the owner of the sensors.
std::optional<Fault> points_fault(const std::vector<Sensor>& sensors, const std::string& path) {
    for (const Sensor& s : sensors) {
        const std::string at = path + ".sensor." + s.name;
        const bool is_table = s.response == SensorResponse::table;
        if (is_table && s.points.size() < 2) return Fault{at + ".response", message_of("few_points")};
        if (!is_table && !s.points.empty()) return Fault{at + ".point.1", message_of("points_of_table")};
        for (std::size_t i = 1; i < s.points.size(); ++i)
            if (!(s.points[i].distance > s.points[i - 1].distance))
                return Fault{fmt::format("{}.point.{}.distance", at, i + 1),
                             message_of("point_order", i + 1, s.points[i].distance, s.points[i - 1].distance)};
    }
    return std::nullopt;
}

std::optional<Fault> sensors_fault(const std::vector<Sensor>& sensors, const std::string& path) {
    auto fault = triangle_fault(sensors, path);
    return fault ? fault : points_fault(sensors, path);
}

// Physics requires outlines that turn left at every corner, with a distance between any two corners.
// `path`: of the corners; `few`: the message for fewer than three corners.
template <class Outlined>
std::optional<Fault> outline_fault(const Outlined& object, const std::string& path, const Message& few) {
    constexpr float least = 0.01f, least_left = 0.001f;  // m: between corners; of a corner from every other edge
    const std::size_t count = object.corners.size();
    if (count == 0) return std::nullopt;
    if (count < 3) return Fault{path, few};
    const std::vector<maths::vec2> corners = corners_of(object);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t next = (i + 1) % count;
        const maths::vec2 edge = corners[next] - corners[i];
        if (!(maths::length(edge) >= least)) return Fault{path, message_of("close_corners", i + 1, next + 1)};
        for (std::size_t j = 0; j < count; ++j)
            if (j != i && j != next &&
                !(maths::cross(edge, corners[j] - corners[i]) >= least_left * maths::length(edge)))
                return Fault{path, message_of("corner_order", j + 1, i + 1, next + 1)};
    }
    return std::nullopt;
}

// Of the brain and the sensors of a Start or Member.
template <class Own>
std::optional<Fault> own_values_fault(const Own& own, const std::string& path) {
    if (own.sensors)
        if (auto fault = sensors_fault(*own.sensors, path)) return fault;
    if (!own.brain) return std::nullopt;
    auto fault = find_fault(*own.brain);
    if (fault) fault->path = path + ".brain";
    return fault;
}

std::optional<Fault> start_fault(const Scene& scene, const Start& start) {
    const std::string path = "vehicle." + start.name;
    if (start.kind.empty()) return Fault{path, message_of("vehicle_without_kind")};
    if (find_kind(scene, start.kind) < 0)
        return Fault{path + ".kind", message_of("no_kind_called", in_quotes(start.kind)) +
                                         nearest_of(start.kind, known_names(scene.kinds))};
    if (!start.facing.empty() && find_source(scene, start.facing) < 0)
        return Fault{path + ".facing", message_of("no_source_called", in_quotes(start.facing)) +
                                           nearest_of(start.facing, known_names(scene.sources))};
    if (!is_inside(scene.arena, {start.x, start.y})) {
        const bool only_y = std::fabs(start.x) <= scene.arena.width / 2 && std::fabs(start.y) > scene.arena.height / 2;
        return Fault{path + (only_y ? ".y" : ".x"), message_of("starts_outside")};
    }
    return own_values_fault(start, path);
}

std::optional<Fault> member_fault(const Scene& scene, const Member& member) {
    const std::string path = "member." + member.name;
    const int number = number_of(member);
    if (number < 0) return Fault{path, message_of("member_name")};
    if (number >= scene.ecology.population) return Fault{path, message_of("member_beyond", scene.ecology.population)};
    if (!member.kind.empty() && find_kind(scene, member.kind) < 0)
        return Fault{path + ".kind", message_of("no_kind_called", in_quotes(member.kind)) +
                                         nearest_of(member.kind, known_names(scene.kinds))};
    if (member.placed && !is_inside(scene.arena, {member.x, member.y}))
        return Fault{path, message_of("starts_outside")};
    return own_values_fault(member, path);
}

std::optional<Fault> on_times_fault(const Source& source) {
    for (std::size_t i = 0; i < source.on.size(); ++i)
        if (source.on[i].from >= source.on[i].until)
            return Fault{fmt::format("source.{}.on.{}", source.name, i + 1), message_of("off_before_on")};
    return std::nullopt;
}

}  // namespace

std::optional<Fault> find_fault(const BrainGraph& graph) {
    for (const Node& node : graph.nodes)
        if (const auto fault = name_fault(node.name)) return Fault{"", *fault};
    if (const auto error = check_graph(graph)) return Fault{"", message_of(*error)};
    return std::nullopt;
}

std::optional<Fault> find_fault(const Scene& scene) {
    if (auto fault = range_fault(scene)) return fault;
    if (scene.arena.round && scene.arena.edge == Boundary::torus)
        return Fault{"arena.round", message_of("round_torus")};
    for (const Kind& kind : scene.kinds) {
        if (auto fault = wheels_fault(kind)) return fault;
        if (auto fault = sensors_fault(kind.sensors, "kind." + kind.name)) return fault;
        if (auto fault = find_fault(kind.brain)) return Fault{"kind." + kind.name + ".brain", std::move(fault->what)};
    }
    for (const Obstacle& obstacle : scene.obstacles)
        if (auto fault =
                outline_fault(obstacle, "obstacle." + obstacle.name + ".corner", message_of("few_corners_box")))
            return fault;
    for (const Zone& zone : scene.zones)
        if (auto fault = outline_fault(zone, "zone." + zone.name + ".corner", message_of("few_corners_rectangle")))
            return fault;
    for (const Source& source : scene.sources)
        if (auto fault = on_times_fault(source)) return fault;
    for (const Start& start : scene.starts)
        if (auto fault = start_fault(scene, start)) return fault;
    for (const Member& member : scene.members)
        if (auto fault = member_fault(scene, member)) return fault;
    if (scene.ecology.population > 0 && scene.kinds.empty())
        return Fault{"ecology.population", message_of("no_kind_to_populate")};
    if (scene.goal.role == Role::wiring) return Fault{"goal.role", message_of("no_role_to_count")};
    return size_fault(scene);
}

Message outside(std::string_view key, double value, Range range) {
    const double limit = value < range.low ? range.low : range.high;
    return message_of("out_of_range", key, told_apart(value, limit, Digits::in_all, 6).first, range.low, range.high);
}

std::optional<Message> name_fault(std::string_view name) {
    const auto allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    };
    if (!name.empty() && name.size() <= limits::name_length && std::all_of(name.begin(), name.end(), allowed))
        return std::nullopt;
    return message_of("bad_name", in_quotes(name), limits::name_length);
}

}  // namespace braitenlab

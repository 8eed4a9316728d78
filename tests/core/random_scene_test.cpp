// Random scenes within the ranges of the fields: each is written and read again.
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/maths/angle.h"
#include "core/maths/random.h"
#include "core/scene/enums.h"
#include "core/scene/scene_file.h"
#include "core/scene/schema.h"

namespace braitenlab::tests::random_scene_test {
namespace {

struct Dice {
    maths::Random random;

    bool toss() { return random.next() % 2 == 0; }
    std::size_t below(std::size_t count) { return random.next() % count; }
    // Sometimes an end of the range, which is a valid value.
    double in(Range range) {
        const std::size_t side = below(12);
        if (side < 2) return side == 0 ? range.low : range.high;
        const auto share = static_cast<double>(random.uniform(0, 1));
        return range.low + share * (range.high - range.low);
    }
    std::string text(std::size_t longest) {
        static const std::string_view parts[] = {"a",   "Z", " ", "\"",  "\\", "\n", "\t",
                                                 "'''", "=", "#", "[x]", "ä",  "→",  "0"};
        std::string made;
        for (std::size_t i = below(12); i > 0; --i) made += parts[below(std::size(parts))];
        return made.size() <= longest ? made : "long";
    }
};

// The visitor (see core/scene/schema.h): sets every value to a random value in its range.
template <class T>
class AtRandom {
public:
    AtRandom(T& object, Dice& dice) : object_(object), dice_(dice) {}

    template <class Number>
    void number(const char*, Number T::*member, const char*, Range range, const char*) {
        if (dice_.toss()) return;  // the default
        object_.*member = static_cast<Number>(dice_.in(range));
    }
    void angle(const char*, float T::*member, Range degrees, const char*) {
        if (dice_.toss()) object_.*member = static_cast<float>(dice_.in(degrees) * (maths::pi_d / 180));
    }
    void place(const char*, std::optional<maths::vec2> T::*member, Range range, const char*) {
        if (dice_.toss()) object_.*member = {static_cast<float>(dice_.in(range)), static_cast<float>(dice_.in(range))};
    }
    void flag(const char*, bool T::*member, const char*) { object_.*member = dice_.toss(); }
    template <class Enum>
    void word(const char*, Enum T::*member, const char*) {
        const auto& known = table_of(Enum{});
        object_.*member = known[dice_.below(known.size())].value;
    }
    template <class Enum>
    void word(const char*, std::optional<Enum> T::*member, const char*) {
        const auto& known = table_of(Enum{});
        if (dice_.toss()) object_.*member = known[dice_.below(known.size())].value;
    }
    void text(const char*, std::string T::*member, std::size_t longest, const char*) {
        object_.*member = dice_.text(longest);
    }
    void colour(const char*, std::string T::*member, const char*) {
        if (dice_.toss()) object_.*member = dice_.toss() ? "#3d7cc9" : "#00FF9a";
    }
    template <class Part>
    void part(Part T::*member) {
        fill(object_.*member);
    }
    template <class Inner>
    void table(const char*, Inner T::*member, const char*) {
        fill(object_.*member);
    }
    template <class Element>
    void named(const char* key, std::vector<Element> T::*member, std::size_t, const char*) {
        for (std::size_t i = 0, count = dice_.below(4); i < count; ++i) {
            Element& element = (object_.*member).emplace_back();
            element.name = fmt::format("{}_{}", key, i);
            fill(element);
        }
    }
    template <class Element>
    void named(const char* key, std::optional<std::vector<Element>> T::*member, std::size_t, const char*) {
        if (dice_.toss()) return;
        (object_.*member).emplace();
        for (std::size_t i = 0, count = dice_.below(4); i < count; ++i) {
            Element& element = (object_.*member)->emplace_back();
            element.name = fmt::format("{}_{}", key, i);
            fill(element);
        }
    }
    template <class Element>
    void list(const char*, std::vector<Element> T::*member, std::size_t, const char*) {
        if (dice_.toss()) return;
        (object_.*member).resize(1 + dice_.below(4));
        for (Element& element : object_.*member) fill(element);
    }
    template <class Graph>
    void brain(const char*, Graph T::*, const char*) {}  // below

private:
    template <class Inner>
    void fill(Inner& inner) {
        AtRandom<Inner> visitor(inner, dice_);
        describe(visitor, Of<Inner>{});
    }

    T& object_;
    Dice& dice_;
};

template <class T>
T any(Dice& dice) {
    T made{};
    AtRandom<T> visitor(made, dice);
    describe(visitor, Of<T>{});
    return made;
}

BrainGraph any_brain(Dice& dice, const Kind& kind) {
    if (dice.toss()) return make_graph(any<FourNeurons>(dice));
    BrainGraph brain;
    const auto add = [&](NodeKind of, const std::string& name) {
        Node node = of == NodeKind::sensor ? Node{} : any<Node>(dice);  // a sensor has no input
        node.id = static_cast<int>(brain.nodes.size()) * 3 + 5;
        node.kind = of;
        node.name = name;
        brain.nodes.push_back(node);
    };
    for (const Sensor& sensor : kind.sensors) add(NodeKind::sensor, sensor.name);
    for (std::size_t i = dice.below(4); i > 0; --i) add(NodeKind::neuron, fmt::format("N{}", i));
    const std::size_t sources = brain.nodes.size();
    add(NodeKind::motor, "ML"), add(NodeKind::motor, "MR");
    for (std::size_t from = 0; from < sources; ++from)
        for (std::size_t to = kind.sensors.size(); to < brain.nodes.size(); ++to) {
            if (dice.toss()) continue;
            Wire wire = any<Wire>(dice);
            wire.from = brain.nodes[from].id, wire.to = brain.nodes[to].id;
            brain.wires.push_back(wire);
        }
    return brain;
}

void make_sound(std::vector<Sensor>& sensors) {
    for (Sensor& sensor : sensors) {
        if (sensor.shape == SensorShape::triangle) sensor.fov = std::min(sensor.fov, maths::radians(179));
        if (sensor.response != SensorResponse::table) sensor.points.clear();
        if (sensor.response == SensorResponse::table)
            sensor.points.resize(std::max<std::size_t>(sensor.points.size(), 2));
        float distance = 0;
        for (ResponsePoint& point : sensor.points) point.distance = distance += 0.01f + std::fmod(point.distance, 3.0f);
    }
}

// The range of some values depends on other values.
void make_sound(Scene& scene, Dice& dice) {
    scene.name = "by-chance";
    if (scene.goal.role == Role::wiring) scene.goal.role = Role::prey;
    scene.arena.round &= scene.arena.edge != Boundary::torus;
    const float within = scene.arena.round ? 0.35f : 0.5f;  // of the size: where starts are inside for certain
    if (scene.kinds.empty()) scene.ecology.population = 0, scene.starts.clear();
    scene.ecology.population %= 50;  // more need an arena that has room for them
    for (Kind& kind : scene.kinds) {
        for (Wheel& wheel : kind.body.wheels) wheel.load = 1.0f / static_cast<float>(kind.body.wheels.size());
        make_sound(kind.sensors);
        kind.brain = any_brain(dice, kind);
    }
    for (Start& start : scene.starts) {
        start.kind = scene.kinds[dice.below(scene.kinds.size())].name;
        start.facing = scene.sources.empty() || dice.toss() ? "" : scene.sources[dice.below(scene.sources.size())].name;
        start.x = std::fmod(start.x, scene.arena.width * within);
        start.y = std::fmod(start.y, scene.arena.height * within);
        if (dice.toss()) start.brain = any_brain(dice, scene.kinds.front());
        if (start.sensors) make_sound(*start.sensors);
    }
    scene.members.resize(std::min(scene.members.size(), static_cast<std::size_t>(scene.ecology.population)));
    for (std::size_t i = 0; i < scene.members.size(); ++i) {
        Member& member = scene.members[i];
        member.name = std::to_string(i);
        member.kind = dice.toss() ? scene.kinds.front().name : "";
        member.x = std::fmod(member.x, scene.arena.width * within);
        member.y = std::fmod(member.y, scene.arena.height * within);
        if (dice.toss()) member.brain = any_brain(dice, scene.kinds.front());
        if (member.sensors) make_sound(*member.sensors);
    }
    const auto make_convex = [&](std::vector<PolygonCorner>& outline) {
        const std::size_t corners = outline.size() < 3 ? 0 : outline.size();
        outline.resize(corners);
        for (std::size_t i = 0; i < corners; ++i) {
            const maths::vec2 at =
                maths::from_polar(2, maths::pi * 2 * (static_cast<float>(i) + dice.random.uniform(0, 0.5f)) /
                                         static_cast<float>(corners));
            outline[i].x = at.x, outline[i].y = at.y;
        }
    };
    for (Obstacle& obstacle : scene.obstacles) make_convex(obstacle.corners);
    for (Zone& zone : scene.zones) make_convex(zone.corners);
    for (Source& source : scene.sources)
        for (OnTime& time : source.on) {
            if (time.from > time.until) std::swap(time.from, time.until);
            if (time.from == time.until) time = {0, 1};
        }
}

TEST(SceneFile, ReadsBackRandomScenes) {
    Dice dice{maths::Random(2026, 3)};
    std::size_t wires = 0, starts = 0;
    for (int i = 0; i < 400; ++i) {
        Scene scene = any<Scene>(dice);
        make_sound(scene, dice);
        const auto fault = check_scene(scene);
        ASSERT_FALSE(fault) << fault->text();
        const std::string text = write_scene(scene);
        const auto again = parse_scene(text, "by-chance.toml");
        ASSERT_TRUE(again) << again.error().text() << "\n" << text;
        ASSERT_EQ(*again, scene) << text << "\n── written again ──\n" << write_scene(*again);
        for (const Kind& kind : scene.kinds) wires += kind.brain.wires.size();
        starts += scene.starts.size();
    }
    EXPECT_GT(wires, 2000u);
    EXPECT_GT(starts, 300u);
}

}  // namespace
}  // namespace braitenlab::tests::random_scene_test

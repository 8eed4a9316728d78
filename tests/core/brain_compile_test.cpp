// compile() and check_graph() of core/brain/brain.h.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/brain/brain.h"
#include "core/brain/four_neurons.h"
#include "tests/tells.h"

namespace braitenlab::tests::brain_compile_test {
namespace {

const std::array<std::string, 2> two_eyes{"SL", "SR"};

TEST(Brain, CompileRefusesAnInvalidGraphWithAReason) {
    BrainGraph twice = make_graph({});
    twice.wires.push_back(twice.wires.front());
    EXPECT_TRUE(tells(compile(twice, two_eyes).error(), message_of("same_wire", "SL", "ML")));

    BrainGraph into_eye = make_graph({});
    into_eye.wires.push_back({.from = 2, .to = 0});
    EXPECT_TRUE(tells(compile(into_eye, two_eyes).error(), message_of("wire_into_sensor", "SL")));

    BrainGraph nowhere = make_graph({});
    nowhere.wires.push_back({.from = 0, .to = 99});
    EXPECT_FALSE(compile(nowhere, two_eyes));

    BrainGraph not_a_number = make_graph({});
    not_a_number.wires.front().weight = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(compile(not_a_number, two_eyes));
}

TEST(Brain, CompileRefusesEveryNumberThatIsNotFiniteOrOutsideItsRange) {
    const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    const auto refused = [](auto set, float value) {
        BrainGraph graph = make_graph({.LL = 1});
        graph.nodes.push_back({.id = 9, .kind = NodeKind::neuron, .name = "N"});
        graph.wires.push_back({.from = 0, .to = 9});
        set(graph.nodes.back(), graph.wires.back(), value);
        return !compile(graph, two_eyes);
    };
    const auto refuses = [&](auto set, float low, float high) {
        for (const float bad : {nan, inf, -inf, low - 0.01f, high + 0.01f}) EXPECT_TRUE(refused(set, bad)) << bad;
        for (const float good : {low, high}) EXPECT_FALSE(refused(set, good)) << good;
    };
    refuses([](Node& n, Wire&, float x) { n.bias = x; }, -1, 1);
    refuses([](Node& n, Wire&, float x) { n.time_constant = x; }, 0, 600);
    refuses([](Node& n, Wire&, float x) { n.curve.peak = x; }, -2, 2);
    refuses([](Node& n, Wire&, float x) { n.curve.width = x; }, 0.001f, 10);
    refuses([](Node&, Wire& w, float x) { w.weight = x; }, -2, 2);
    refuses([](Node&, Wire& w, float x) { w.threshold = x; }, 0, 1);
    refuses([](Node&, Wire& w, float x) { w.curve.peak = x; }, -2, 2);
    refuses([](Node&, Wire& w, float x) { w.curve.width = x; }, 0.001f, 10);
    refuses([](Node&, Wire& w, float x) { w.learning_rate = x; }, 0, 10);
    refuses([](Node&, Wire& w, float x) { w.decay = x; }, 0, 10);
}

TEST(Brain, CompileNamesTheNumberItsRangeAndItsNodeOrWire) {
    BrainGraph graph = make_graph({});
    graph.wires[1].decay = 11;
    EXPECT_TRUE(tells(compile(graph, two_eyes).error(), message_of("in_wire", "SR", "ML")));
    EXPECT_TRUE(tells(compile(graph, two_eyes).error(), message_of("out_of_range", "decay", 11, 0, 10)));
    find_node(graph, "MR")->bias = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(tells(compile(graph, two_eyes).error(), message_of("in_node", "MR")));
    EXPECT_TRUE(tells(compile(graph, two_eyes).error(), message_of("out_of_range", "bias", "nan", -1, 1)));
}

// A four-neuron brain with `count` more nodes of a kind.
BrainGraph crowded(NodeKind kind, int count) {
    BrainGraph graph = make_graph({});
    for (int i = 0; i < count; ++i) graph.nodes.push_back({.id = 10 + i, .kind = kind, .name = fmt::format("n{}", i)});
    return graph;
}

TEST(Brain, CompileAcceptsTheLargestBrainAndRefusesALargerOneWithItsSize) {
    EXPECT_TRUE(compile(crowded(NodeKind::sensor, 62), two_eyes));  // SL and SR make 64
    EXPECT_TRUE(
        tells(compile(crowded(NodeKind::sensor, 63), two_eyes).error(), message_of("too_many_sensors", 64, 65)));
    EXPECT_TRUE(
        tells(compile(crowded(NodeKind::neuron, 1025), two_eyes).error(), message_of("too_many_neurons", 1024, 1025)));

    BrainGraph graph = crowded(NodeKind::neuron, 1024);
    for (int i = 0; graph.wires.size() < 8192; ++i)
        graph.wires.push_back({.from = 10 + i % 1024, .to = 10 + (i * 7 + i / 1024) % 1024, .weight = 2});
    const auto largest = compile(graph, two_eyes);
    ASSERT_TRUE(largest) << largest.error().what;
    std::vector<float> state(static_cast<std::size_t>(largest->state_size()), 1.0f);
    std::array<float, 2> motors{};
    for (int tick = 0; tick < 100; ++tick) think(*largest, std::array{1.0f, 1.0f}, state, motors);
    EXPECT_TRUE(std::all_of(state.begin(), state.end(), [](float x) { return std::isfinite(x); }));

    graph.wires.push_back({.from = 0, .to = 10});
    EXPECT_TRUE(tells(compile(graph, two_eyes).error(), message_of("too_many_wires", 8192, 8193)));
}

}  // namespace
}  // namespace braitenlab::tests::brain_compile_test

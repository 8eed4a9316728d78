// The MicroPython program for a Thymio 3, as it is exported: in MicroPython on an emulated micro:bit and in Python 3,
// with a stand-in for the robot's module that moves readings in and speeds out.
#include "core/export/thymio3.h"

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <utility>

#include "core/brain/four_neurons.h"
#include "core/scene/enums.h"
#include "tests/robots/exported.h"

namespace braitenlab::tests::thymio3_test {
namespace {

using robots::BrainToExport;
using robots::Target;

Result<std::vector<robots::ExportedFile>> exported(const BrainToExport& brain) {
    return robots::export_brain(brain, Target::micropython, *robots::find_robot("thymio3"));
}

// N neurons with a wire from an eye, each to the left motor.
BrainToExport fan(int neurons) {
    BrainGraph graph = make_graph({});
    for (int i = 0; i < neurons; ++i) {
        graph.nodes.push_back({.id = 50 + i, .kind = NodeKind::neuron, .name = fmt::format("N{}", i)});
        graph.wires.push_back({.from = find_node(graph, "SL")->id, .to = 50 + i, .weight = 0.5f});
        graph.wires.push_back({.from = 50 + i, .to = find_node(graph, "ML")->id, .weight = 0.25f});
    }
    return {"fan", graph, {}};
}

// Neurons of the largest fan that is exported.
int largest_fan() {
    int neurons = 1;
    while (exported(fan(neurons + 1))) ++neurons;
    return neurons;
}

TEST(Thymio3, SaysInItsReadmeHowToCalibrateTheSensorsOfItsProgramOnly) {
    for (const Channel channel : {Channel::floor, Channel::obstacle}) {
        const auto files = exported({"", make_graph({.LL = 1}), {{.name = "SL", .channel = channel}}});
        ASSERT_TRUE(files);
        const std::string &program = (*files)[0].text, &readme = (*files)[1].text;
        for (const char* name : {"WHITE", "FAR"})
            EXPECT_EQ(readme.find(name) != std::string::npos, program.find(name) != std::string::npos) << name;
        EXPECT_EQ(readme.find("`WHITE`") != std::string::npos, channel == Channel::floor);
    }
}

// 7 proximity sensors, 2 ground sensors, 5 buttons, of which the forward button may be pressed.
std::string line_of(const robots::Plan& plan, const std::vector<float>& sensed, bool starts) {
    long values[14] = {};
    values[12] = starts;
    for (std::size_t i = 0; i < sensed.size(); ++i) {
        const char side = plan.inputs[i].name.back();
        if (plan.inputs[i].channel == Channel::floor)
            values[side == 'R' ? 8 : 7] = std::lround(1024 * sensed[i]);
        else  // the outer sensor of a pair; the inner one reads less
            values[side == 'L' ? 0 : side == 'R' ? 4 : 2] = std::lround(3500 * sensed[i]);
    }
    std::string line;
    for (const long value : values) line += fmt::format("{} ", value);
    return line + "\n";
}

std::vector<std::pair<int, int>> speeds(const Folder& folder, const std::string& program, const std::string& lines,
                                        bool here) {
    put_text(folder / "brain.py", program);
    put_text(folder / "lines", lines);
    const Ran ran =
        shell(fmt::format("cd '{}' && python3 '{}/thymio3_run.py' brain.py {} < lines", folder.path.string(),
                          BRAITENLAB_SOURCE "/tests/robots/run", here ? "--here" : ""));
    EXPECT_EQ(ran.code, 0) << ran.out.substr(0, 500);
    std::vector<std::pair<int, int>> pairs;
    std::istringstream rows(ran.out);
    for (int left = 0, right = 0; rows >> left >> right;) pairs.emplace_back(left, right);
    return pairs;
}

// Compares the exported program with golden vectors: each speed within 1 of 500; at the end both motors stop.
void compare(const BrainToExport& brain, int ticks, bool here) {
    const Folder folder;
    const auto plan = robots::make_plan(brain, 50);
    const auto vectors = robots::golden_vectors(brain, 50, ticks);
    const auto files = exported(brain);
    ASSERT_TRUE(files) << brain.title;
    std::string lines;
    for (const auto& row : vectors->ticks) lines += line_of(*plan, row.sensed, lines.empty());
    const auto found = speeds(folder, files->front().text, lines, here);
    ASSERT_EQ(found.size(), vectors->ticks.size() + 1) << brain.title;
    long worst = 0;
    for (std::size_t i = 0; i < vectors->ticks.size(); ++i)
        for (const auto& [speed, command] :
             {std::pair(found[i].first, vectors->ticks[i].left), std::pair(found[i].second, vectors->ticks[i].right)})
            worst = std::max(worst, std::labs(speed - std::lround(500 * command)));
    EXPECT_LE(worst, 1) << brain.title;
    EXPECT_EQ(found.back(), std::pair(0, 0)) << brain.title;
    if (!here)
        std::printf("%-28s %5zu bytes, worst %ld of 500\n", brain.title.c_str(), files->front().text.size(), worst);
}

TEST(Thymio3, GivesTheSpeedsOfEveryShippedBrainInPython) {
    each_exported(Target::micropython, "thymio3",
                  [](const BrainToExport& brain, const auto&) { compare(brain, 300, true); });
}

TEST(Thymio3, FitsIntoTheBytesOfTheRobotAndLeavesOutCommentsForThat) {
    bool commented = false, shortened = false;
    for (int neurons = 1; neurons <= largest_fan(); ++neurons) {
        const auto files = exported(fan(neurons));
        const std::string& text = files->front().text;
        EXPECT_LE(text.size(), 2000u) << neurons;
        EXPECT_EQ(text.front(), '#');
        const bool has_comments = text.find("# neuron N0") != std::string::npos;
        EXPECT_EQ(files->back().text.find("without comments") == std::string::npos, has_comments) << neurons;
        (has_comments ? commented : shortened) = true;
    }
    EXPECT_TRUE(commented);
    EXPECT_TRUE(shortened);
    BrainToExport named = fan(largest_fan());
    named.title = std::string(500, 'x');
    EXPECT_TRUE(exported(named)) << "a long title is a comment";
    const auto large = exported(fan(largest_fan() + 1));
    ASSERT_FALSE(large);
    EXPECT_NE(large.error().what.find("Thymio 3 takes 2000"), std::string::npos) << large.error().what;
    EXPECT_NE(large.error().what.find("'ML'"), std::string::npos) << large.error().what;
}

TEST(Thymio3, RefusesSensorsThatItDoesNotHaveByName) {
    const auto smells = exported({"", make_graph({.LL = 1}), {{.name = "SL", .channel = Channel::smell}}});
    ASSERT_FALSE(smells);
    EXPECT_NE(smells.error().what.find("'SL'"), std::string::npos) << smells.error().what;
    const auto pairs = exported({"", find_preset("3c-values")->brain, {}});
    ASSERT_FALSE(pairs);
    EXPECT_NE(pairs.error().what.find("'HL'"), std::string::npos) << pairs.error().what;
}

TEST(Thymio3, ReadsTheNearerOfTwoSensorsAndTheGround) {
    const Folder folder;
    const auto front = exported({"", make_graph({.LL = 1, .RR = 1}), {}});
    const std::string lines =
        "0 3500 0 0 0 0 0 0 0 0 0 0 1 0\n"
        "700 350 3500 700 1400 3500 3500 1024 1024 0 0 0 0 0\n"
        "4500 0 0 -5 0 0 0 0 0 0 0 0 0 0\n";
    using Speeds = std::vector<std::pair<int, int>>;
    EXPECT_EQ(speeds(folder, front->front().text, lines, true), (Speeds{{500, 0}, {100, 200}, {500, 0}, {0, 0}}));
    const std::vector<Sensor> floors{{.name = "SL", .channel = Channel::floor},
                                     {.name = "SR", .channel = Channel::floor}};
    const auto ground = exported({"", make_graph({.LL = 1, .RR = 1}), floors});
    EXPECT_EQ(speeds(folder, ground->front().text, "3500 0 0 0 3500 0 0 1024 512 0 0 0 1 0\n", true),
              (Speeds{{500, 250}, {0, 0}}));
}

TEST(Thymio3, StandsUntilTheForwardButtonAndAfterTheCentreButton) {
    const Folder folder;
    const auto files = exported({"", make_graph({.LM = 1, .RM = 0.5f}), {}});
    const std::string sensors = "0 0 0 0 0 0 0 0 0 ";
    std::string lines;
    for (const char* buttons : {"1 1 0 0 1", "0 0 0 1 0", "0 0 1 0 0", "0 0 0 0 0", "0 0 0 1 0", "0 0 0 0 0"})
        lines += sensors + buttons + "\n";
    EXPECT_EQ(speeds(folder, files->front().text, lines, true),
              (std::vector<std::pair<int, int>>{{0, 0}, {500, 250}, {0, 0}, {0, 0}, {500, 250}, {500, 250}, {0, 0}}));
}

TEST(Thymio3InMicropython, GivesTheSpeedsOfEveryShippedBrainThatItHolds) {
    if (!has_tool("firmware-microbit-micropython")) GTEST_SKIP() << "./dev robots installs an emulator and MicroPython";
    each_exported(Target::micropython, "thymio3",
                  [](const BrainToExport& brain, const auto&) { compare(brain, 150, false); });
}

// A neuron with a memory and a sigmoid, and a wire that learns.
BrainToExport learner() {
    BrainGraph graph = make_graph({.LL = 0.3f, .RM = 0.1f});
    graph.nodes.push_back({.id = 50,
                           .kind = NodeKind::neuron,
                           .name = "N",
                           .curve = {.response = Response::sigmoid, .peak = 0.4f, .width = 0.2f},
                           .time_constant = 0.5f});
    graph.wires.push_back({.from = find_node(graph, "SR")->id, .to = 50, .weight = 0.9f});
    graph.wires.push_back(
        {.from = 50, .to = find_node(graph, "ML")->id, .weight = 0.1f, .learning_rate = 0.5f, .decay = 0.1f});
    return {"learner", graph, {}};
}

TEST(Thymio3, HoldsMemoriesCurvesAndLearningWires) { compare(learner(), 1000, true); }

TEST(Thymio3InMicropython, HoldsMemoriesCurvesAndLearningWires) {
    if (!has_tool("firmware-microbit-micropython")) GTEST_SKIP() << "./dev robots installs an emulator and MicroPython";
    compare(learner(), 150, false);
}

TEST(Thymio3InMicropython, RunsTheLargestProgram) {
    if (!has_tool("firmware-microbit-micropython")) GTEST_SKIP() << "./dev robots installs an emulator and MicroPython";
    compare(fan(largest_fan()), 150, false);
}

}  // namespace
}  // namespace braitenlab::tests::thymio3_test

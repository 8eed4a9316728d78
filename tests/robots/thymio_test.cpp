// The Aseba program for a Thymio II: what is refused, and the rest in Aseba's own compiler and virtual machine.
#include "core/export/thymio.h"

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "core/brain/four_neurons.h"
#include "core/scene/enums.h"
#include "tests/robots/exported.h"
#include "tests/robots/random_brain.h"
#include "tests/robots/simulators.h"

namespace braitenlab::tests::thymio_test {
namespace {

using robots::BrainToExport;
using robots::Target;

Result<std::vector<robots::ExportedFile>> exported(const BrainToExport& brain) {
    return robots::export_brain(brain, Target::thymio, *robots::find_robot("thymio2"));
}

bool refuses(const BrainToExport& brain, const std::string& name) {
    const auto files = exported(brain);
    if (files) return false;
    EXPECT_NE(files.error().what.find("'" + name + "'"), std::string::npos) << files.error().what;
    return true;
}

Wire& join(BrainGraph& graph, const char* from, const char* to, float weight) {
    return graph.wires.emplace_back(
        Wire{.from = find_node(graph, from)->id, .to = find_node(graph, to)->id, .weight = weight});
}

// Two eyes, and a neuron N from both to both motors.
BrainGraph with_neuron(float into, float out) {
    BrainGraph graph = make_graph({});
    graph.nodes.push_back({.id = 50, .kind = NodeKind::neuron, .name = "N"});
    for (const char* eye : {"SL", "SR"}) join(graph, eye, "N", into);
    for (Wire& wire : graph.wires)
        if (wire.from == find_node(graph, "SL")->id && wire.to == find_node(graph, "ML")->id) wire.weight = 0.5f;
    join(graph, "N", "MR", out);
    return graph;
}

// N neurons in a row, each twice the one before.
BrainGraph doubling(int neurons) {
    BrainGraph graph = make_graph({});
    std::string before = "SL";
    for (int i = 0; i < neurons; ++i) {
        const std::string name = "N" + std::to_string(i);
        graph.nodes.push_back({.id = 50 + i, .kind = NodeKind::neuron, .name = name});
        join(graph, before.c_str(), name.c_str(), 2);
        before = name;
    }
    join(graph, before.c_str(), "ML", 0.01f);
    return graph;
}

TEST(Thymio, RefusesABrainWhoseSumsCouldWrap) {
    EXPECT_TRUE(exported({"", doubling(5), {}}));       // 32
    EXPECT_TRUE(refuses({"", doubling(6), {}}, "N5"));  // 64
    BrainGraph loop = with_neuron(1, 0.5f);
    join(loop, "N", "N", 1.5f);
    EXPECT_TRUE(refuses({"", loop, {}}, "N"));
    find_node(loop, "N")->curve.response = Response::step;
    EXPECT_TRUE(exported({"", loop, {}}));
}

TEST(Thymio, RefusesWhatItCannotHoldByName) {
    BrainGraph learning = with_neuron(1, 0.5f);
    learning.wires.back().learning_rate = 1;
    EXPECT_TRUE(refuses({"", learning, {}}, "MR"));
    BrainGraph slow = with_neuron(1, 0.5f);
    find_node(slow, "N")->time_constant = 100;
    EXPECT_TRUE(refuses({"", slow, {}}, "N"));
    find_node(slow, "N")->time_constant = 1;
    EXPECT_TRUE(exported({"", slow, {}}));
    const BrainToExport smells{"", make_graph({.LL = 1}), {{.name = "SL", .channel = Channel::smell}}};
    EXPECT_TRUE(refuses(smells, "SL"));
    EXPECT_TRUE(refuses({"", find_preset("3c-values")->brain, {}}, "HL"));  // a second pair
}

// ---- In Aseba's virtual machine ----

struct Compared {
    std::size_t rows = 0;
    int words = 0;
    long worst = 0;    // of 500
    long largest = 0;  // target that was seen
};

Compared compare(VirtualMachine& machine, const BrainToExport& brain, int ticks) {
    const auto plan = robots::make_plan(brain, 10);
    const auto vectors = robots::golden_vectors(brain, 10, ticks);
    const auto files = exported(brain);
    std::string lines = "forward\n";
    for (const auto& row : vectors->ticks) lines += raw_line(*plan, row.sensed);
    const Ran ran = machine.run(files->front().text, lines);
    EXPECT_EQ(ran.code, 0) << brain.title << " " << ran.out.substr(0, 500);
    std::istringstream rows(ran.out);
    Compared found;
    rows >> found.words;
    for (int left = 0, right = 0; rows >> left >> right && found.rows < vectors->ticks.size(); ++found.rows) {
        const auto& row = vectors->ticks[found.rows];
        for (const auto& [target, command] : {std::pair(left, row.left), std::pair(right, row.right)}) {
            found.worst = std::max(found.worst, std::labs(target - std::lround(500 * command)));
            found.largest = std::max(found.largest, std::labs(target));
        }
    }
    return found;
}

TEST(ThymioInAseba, GivesTheTargetsOfEveryShippedBrainThatItHolds) {
    if (!has_tool("aseba")) GTEST_SKIP() << "./dev robots installs Aseba";
    VirtualMachine machine;
    each_exported(Target::thymio, "thymio2", [&](const BrainToExport& brain, const auto&) {
        const Compared found = compare(machine, brain, 3000);
        EXPECT_EQ(found.rows, 3000u) << brain.title;
        EXPECT_LE(found.worst, 1) << brain.title;
        std::printf("%-28s %4d words, worst %ld of 500\n", brain.title.c_str(), found.words, found.worst);
    });
}

TEST(ThymioInAseba, StandsUntilTheForwardButtonAndAfterTheCentreButton) {
    if (!has_tool("aseba")) GTEST_SKIP() << "./dev robots installs Aseba";
    VirtualMachine machine;
    const auto files = exported({"", make_graph({.LM = 1, .RM = 0.5f}), {}});
    ASSERT_TRUE(files);
    const std::string values = "0 0 0 0 0 0 0 0 0\n";
    const Ran ran = machine.run(files->front().text,
                                values + values + "forward\n" + values + "centre\n" + values + "forward\n" + values);
    EXPECT_EQ(ran.out.substr(ran.out.find('\n') + 1), "0 0\n0 0\n500 250\n0 0\n500 250\n");
}

TEST(ThymioInAseba, HoldsEveryCurveThresholdAndMemory) {
    if (!has_tool("aseba")) GTEST_SKIP() << "./dev robots installs Aseba";
    VirtualMachine machine;
    for (const auto& row : responses)
        for (const bool on_wire : {true, false}) {
            BrainGraph graph = with_neuron(0.8f, 0.4f);
            Node& neuron = *find_node(graph, "N");
            neuron.bias = -0.1f;
            neuron.time_constant = on_wire ? 0.4f : 0;
            (on_wire ? graph.wires.back().curve : neuron.curve) = {row.value, 0.3f, 0.25f};
            for (Wire& wire : graph.wires) wire.threshold = on_wire ? 0 : 0.2f;
            const Compared found = compare(machine, {std::string(row.word), graph, {}}, 3000);
            EXPECT_EQ(found.rows, 3000u) << row.word;
            EXPECT_LE(found.worst, 1) << row.word << (on_wire ? " on a wire" : " of a neuron");
            EXPECT_GT(found.largest, 100) << row.word;
        }
}

TEST(ThymioInAseba, WrapsInNoRandomBrainThatIsExported) {
    if (!has_tool("aseba")) GTEST_SKIP() << "./dev robots installs Aseba";
    VirtualMachine machine;
    maths::Random random(9, 1);
    int brains = 0;
    int above_one = 0;
    long worst = 0;
    for (int i = 0; i < 150; ++i) {
        const BrainToExport brain{"random " + std::to_string(i), random_brain(random, true), {}};
        if (!exported(brain)) continue;
        const Compared found = compare(machine, brain, 300);
        EXPECT_EQ(found.rows, 300u) << i;
        EXPECT_LE(found.worst, 40) << i;  // rounding grows in loops; a sum that wraps is off by hundreds
        above_one += found.worst > 1;
        worst = std::max(worst, found.worst);
        ++brains;
    }
    EXPECT_GT(brains, 20);
    std::printf("%d of 150 brains, %d of them off by more than 1 of 500, worst %ld\n", brains, above_one, worst);
}

TEST(ThymioInAseba, RunsTheLargestNumbersThatAreAllowed) {
    if (!has_tool("aseba")) GTEST_SKIP() << "./dev robots installs Aseba";
    VirtualMachine machine;
    const Compared found = compare(machine, {"doubling", doubling(5), {}}, 3000);  // up to 32, the unit is 1000
    EXPECT_EQ(found.rows, 3000u);
    EXPECT_LE(found.worst, 1);
    EXPECT_GT(found.largest, 140);
}

}  // namespace
}  // namespace braitenlab::tests::thymio_test

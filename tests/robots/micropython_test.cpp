// MicroPython: brain.py in Python 3, and in MicroPython on an emulated micro:bit.
#include "core/export/micropython.h"

#include <cmath>
#include <sstream>

#include "core/brain/four_neurons.h"
#include "tests/robots/exported.h"

namespace braitenlab::tests::micropython_test {
namespace {

using robots::BrainToExport;
using robots::Target;

Result<std::vector<robots::ExportedFile>> exported(const BrainToExport& brain) {
    return robots::export_brain(brain, Target::micropython, *robots::find_robot("microbit"));
}

struct Compared {
    std::size_t rows = 0;
    double worst = 0;
};

// brain.py in MicroPython on an emulated micro:bit, or in this computer's Python.
Compared compare(const Folder& folder, const BrainToExport& brain, int ticks, bool here) {
    const auto vectors = robots::golden_vectors(brain, 50, ticks);
    const auto plan = robots::make_plan(brain, 50);
    put_text(folder / "brain.py", robots::micropython::brain_py(*plan));
    std::string lines;
    for (const auto& row : vectors->ticks) {
        for (const float value : row.sensed) lines += fmt::format("{} ", std::lround(1000 * value));
        lines += "\n";
    }
    put_text(folder / "lines", lines);
    const Ran ran =
        shell(fmt::format("cd '{}' && python3 '{}/microbit_run.py' brain.py {} < lines", folder.path.string(),
                          BRAITENLAB_SOURCE "/tests/robots/run", here ? "--here" : ""));
    EXPECT_EQ(ran.code, 0) << brain.title << " " << ran.out.substr(0, 500);
    std::istringstream rows(ran.out);
    Compared found;
    for (double left = 0, right = 0; rows >> left >> right && found.rows < vectors->ticks.size(); ++found.rows) {
        const auto& row = vectors->ticks[found.rows];
        found.worst = std::max({found.worst, std::fabs(left / 1e6 - static_cast<double>(row.left)),
                                std::fabs(right / 1e6 - static_cast<double>(row.right))});
    }
    return found;
}

TEST(Micropython, ComputesWhatTheLabComputesInPython) {
    const Folder folder;
    for (const BrainToExport& brain : shipped_brains()) {
        const Compared found = compare(folder, brain, 300, true);
        EXPECT_EQ(found.rows, 300u) << brain.title;
        EXPECT_LE(found.worst, 1e-5) << brain.title;
    }
}

// A ring of threshold units, each with an eye.
BrainToExport ring(int neurons) {
    BrainGraph graph = make_graph({.LM = 0.1f});
    const auto join = [&](NodeId from, NodeId to, float weight) {
        graph.wires.push_back({.from = from, .to = to, .weight = weight});
    };
    for (int i = 0; i < neurons; ++i)
        graph.nodes.push_back({.id = 50 + i,
                               .kind = NodeKind::neuron,
                               .name = "N" + std::to_string(i),
                               .curve = {.response = Response::step, .peak = 0.7f}});
    for (int i = 0; i < neurons; ++i) {
        join(find_node(graph, i % 2 ? "SL" : "SR")->id, 50 + i, 1);
        join(50 + i, 50 + (i + 1) % neurons, 0.4f);
        join(50 + i, find_node(graph, "ML")->id, 0.05f);
    }
    return {"ring", graph, {}};
}

// Neurons of the largest ring that is exported.
int largest_ring() {
    int neurons = 2;
    while (exported(ring(neurons + 1))) ++neurons;
    return neurons;
}

TEST(Micropython, RefusesWhatItCannotHoldByName) {
    const auto values = exported({"", find_preset("3c-values")->brain, {}});
    ASSERT_FALSE(values);
    EXPECT_NE(values.error().what.find("'HR'"), std::string::npos) << values.error().what;
    const auto memory = exported({"", make_graph({.LL = 1}), {{.name = "SL", .channel = Channel::memory}}});
    ASSERT_FALSE(memory);
    EXPECT_NE(memory.error().what.find("'SL'"), std::string::npos) << memory.error().what;
    EXPECT_TRUE(exported({"", find_preset("5-logic")->brain, {}}));
    const auto large = exported(ring(largest_ring() + 1));
    ASSERT_FALSE(large);
    EXPECT_NE(large.error().what.find("bytes"), std::string::npos) << large.error().what;
}

TEST(Micropython, WritesAMainProgramThatPythonReads) {
    const Folder folder;
    const auto files = exported({"2a-coward", find_preset("2a-coward")->brain, {}});
    ASSERT_TRUE(files);
    for (const auto& file : *files)
        if (file.name.ends_with(".py")) {
            put_text(folder / file.name, file.text);
            const std::string path = (folder / file.name).string();
            const Ran ran = shell(fmt::format("python3 -c 'compile(open(\"{0}\").read(), \"{0}\", \"exec\")'", path));
            EXPECT_EQ(ran.code, 0) << ran.out;
        }
}

TEST(Micropython, WritesTheWiringOfItsPinsAndTheParts) {
    const auto files = exported({"2a-coward", find_preset("2a-coward")->brain, {}});
    ASSERT_TRUE(files);
    const auto text = [&](std::string_view name) {
        for (const auto& file : *files)
            if (file.name == name) return file.text;
        return std::string{};
    };
    const std::string svg = text("wiring.svg"), main = text("main.py");
    for (const int pin : {0, 1, 8, 12, 13, 14, 15, 16}) {
        EXPECT_NE(svg.find(fmt::format(">P{}<", pin)), std::string::npos) << pin;
        EXPECT_NE(main.find(fmt::format("pin{}", pin)), std::string::npos) << pin;
    }
    EXPECT_EQ(svg.find(">P2<"), std::string::npos) << "the brain has two sensors";
    EXPECT_EQ(svg.find("VIN"), std::string::npos) << "the micro:bit has its own battery";
    EXPECT_NE(text("parts.csv").find("for sensor SR"), std::string::npos);
}

TEST(MicropythonOnMicrobit, ComputesWhatTheLabComputesForEveryShippedBrainThatItHolds) {
    if (!has_toolchains()) GTEST_SKIP() << "./dev robots installs an emulator and MicroPython";
    const Folder folder;
    each_exported(Target::micropython, "microbit", [&](const BrainToExport& brain, const auto& files) {
        const Compared found = compare(folder, brain, 150, false);
        EXPECT_EQ(found.rows, 150u) << brain.title;
        EXPECT_LE(found.worst, 1e-4) << brain.title;
        std::printf("%-28s %5zu bytes, worst %.6f\n", brain.title.c_str(), files.front().text.size(), found.worst);
    });
}

TEST(MicropythonOnMicrobit, HoldsABrainOfTheLargestSize) {
    if (!has_toolchains()) GTEST_SKIP() << "./dev robots installs an emulator and MicroPython";
    const Folder folder;
    const BrainToExport brain = ring(largest_ring());
    EXPECT_GT(exported(brain)->front().text.size(), 2200u);
    const Compared found = compare(folder, brain, 150, false);
    EXPECT_EQ(found.rows, 150u);
    EXPECT_LE(found.worst, 1e-4);
}

}  // namespace
}  // namespace braitenlab::tests::micropython_test

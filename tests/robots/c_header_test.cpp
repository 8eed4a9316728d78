// The C99 header: compiled without warnings and compared with golden vectors.
#include <algorithm>
#include <cmath>

#include "tests/robots/exported.h"

namespace braitenlab::tests::c_header_test {
namespace {

using robots::BrainToExport;
using robots::Target;

// A program that feeds the vectors to brain.h. It prints the largest error of a command.
std::string driver(const robots::Plan& plan, const robots::GoldenVectors& vectors) {
    const std::size_t columns = plan.inputs.size() + 2;
    std::string text =
        fmt::format("#include <stdio.h>\n#include \"brain.h\"\nstatic const float rows[][{}] = {{\n", columns);
    for (const auto& row : vectors.ticks) {
        text += "{";
        for (const float value : row.sensed) text += fmt::format("{:.9g},", value);
        text += fmt::format("{:.9g},{:.9g}}},\n", row.left, row.right);
    }
    text +=
        "};\nint main(void) {\n  Brain brain = {0};\n  double worst = 0;\n"
        "  for (unsigned t = 0; t < sizeof rows / sizeof rows[0]; ++t) {\n";
    for (std::size_t i = 0; i < plan.inputs.size(); ++i)
        text += fmt::format("    brain.{} = rows[t][{}];\n", plan.inputs[i].id, i);
    text += fmt::format(
        "    brain_think(&brain);\n    double l = brain.left - rows[t][{}], r = brain.right - rows[t][{}];\n"
        "    if (l < 0) l = -l;\n    if (r < 0) r = -r;\n"
        "    if (!(l <= worst)) worst = l;\n    if (!(r <= worst)) worst = r;\n  }}\n"
        "  printf(\"%.9f\\n\", worst);\n  return 0;\n}}\n",
        columns - 2, columns - 1);
    return text;
}

// The largest error of a command over these vectors; 9 when the program does not compile.
double worst_error(const BrainToExport& brain, const std::string& compiler, const Folder& folder) {
    const robots::Robot& robot = *robots::find_robot("any");
    const auto plan = robots::make_plan(brain, static_cast<float>(robot.rate_hz));
    const auto vectors = robots::golden_vectors(brain, static_cast<float>(robot.rate_hz), 1000);
    const auto files = robots::export_brain(brain, Target::c, robot);
    EXPECT_TRUE(plan && vectors && files) << brain.title;
    put_text(folder / "brain.h", files->front().text);
    put_text(folder / "main.c", driver(*plan, *vectors));
    const std::string program = (folder / "program").string();
    const Ran ran = shell(fmt::format("cd '{}' && {} -O1 -Wall -Wextra -Werror main.c -o program -lm && ./program",
                                      folder.path.string(), compiler));
    EXPECT_EQ(ran.code, 0) << brain.title << "\n" << ran.out;
    return ran.code == 0 ? std::stod(ran.out) : 9;
}

TEST(CHeader, ComputesWhatTheLabComputesForEveryShippedBrain) {
    const Folder folder;
    std::size_t brains = 0;
    for (const BrainToExport& brain : shipped_brains()) {
        EXPECT_LT(worst_error(brain, "gcc -std=c99 -pedantic", folder), 2e-6) << brain.title;
        ++brains;
    }
    EXPECT_GT(brains, presets().size());
}

// Every curve on a wire and on a neuron, thresholds, memory, loops, learning and names that are no identifiers.
BrainToExport everything() {
    BrainGraph graph;
    NodeId id = 0;
    const auto add = [&](NodeKind kind, const std::string& name) -> Node& {
        return graph.nodes.emplace_back(Node{.id = id++, .kind = kind, .name = name});
    };
    const auto wire = [&](const std::string& from, const std::string& to, float weight) -> Wire& {
        return graph.wires.emplace_back(
            Wire{.from = find_node(graph, from)->id, .to = find_node(graph, to)->id, .weight = weight});
    };
    for (const char* name : {"S L", "S-L", "*/ int x", "covered"}) add(NodeKind::sensor, name);
    graph.nodes.back().silenced = true;
    for (const char* name : {"ML", "MR"}) add(NodeKind::motor, name);
    find_node(graph, "ML")->time_constant = 0.3f;
    for (const auto& row : responses) {
        const std::string name = "N " + std::string(row.word);
        Node& node = add(NodeKind::neuron, name);
        node.curve = {row.value, 0.4f, 0.3f};
        node.bias = 0.1f;
        if (row.value == Response::sigmoid) node.time_constant = 0.5f;
        wire("S L", name, 0.9f).threshold = 0.3f;
        wire("S-L", name, -0.7f).curve = {row.value, 0.5f, 0.2f};
        wire(name, "ML", 0.2f);
        wire(name, "MR", -0.15f);
    }
    wire("covered", "MR", 0.3f).curve.response = Response::inverted;
    add(NodeKind::neuron, "GROWS");
    wire("S-L", "GROWS", 1);
    wire("GROWS", "GROWS", 1.5f);  // up to the bound of 1000
    wire("GROWS", "ML", 0.0002f);
    wire("ML", "N hump", 0.2f);
    Wire& link = wire("*/ int x", "N sigmoid", 0);
    link.learning_rate = 2;
    link.decay = 0.5f;
    return {"every \"part\" */ \\", graph, {}};
}

TEST(CHeader, HoldsEveryPartOfABrain) {
    const Folder folder;
    const auto vectors = robots::golden_vectors(everything(), 60, 1000);
    ASSERT_TRUE(vectors);
    for (float robots::GoldenVector::*command : {&robots::GoldenVector::left, &robots::GoldenVector::right}) {
        const auto full = std::count_if(vectors->ticks.begin(), vectors->ticks.end(),
                                        [&](const auto& row) { return std::fabs(row.*command) >= 1; });
        EXPECT_LT(full, 100) << "a command at its limit shows no error";
    }
    EXPECT_LT(worst_error(everything(), "gcc -std=c99 -pedantic", folder), 2e-5);
}

TEST(CHeader, IsValidCppForArduino) {
    const Folder folder;
    const auto files = robots::export_brain(everything(), Target::c, *robots::find_robot("any"));
    ASSERT_TRUE(files);
    put_text(folder / "brain.h", files->front().text);
    put_text(folder / "use.cpp",
             "#include \"brain.h\"\nint main() { Brain brain = {}; brain_think(&brain); return 0; }\n");
    const Ran ran =
        shell(fmt::format("g++ -std=c++11 -Wall -Wextra -Werror -fsyntax-only '{}'", (folder / "use.cpp").string()));
    EXPECT_EQ(ran.code, 0) << ran.out;
}

}  // namespace
}  // namespace braitenlab::tests::c_header_test

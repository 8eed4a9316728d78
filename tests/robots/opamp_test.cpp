// The circuit: its values, what is refused, and the netlist in ngspice.
#include "core/export/opamp.h"

#include <cctype>
#include <cmath>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "core/brain/four_neurons.h"
#include "core/maths/random.h"
#include "tests/robots/exported.h"

namespace braitenlab::tests::opamp_test {
namespace {

using robots::BrainToExport;
using robots::Target;
namespace opamp = robots::opamp;

Result<std::vector<robots::ExportedFile>> exported(const BrainToExport& brain) {
    return robots::export_brain(brain, Target::opamp, *robots::find_robot("lm324"));
}

double ohms_from(const std::vector<opamp::Resistor>& resistors, const std::string& from) {
    for (const auto& r : resistors)
        if (r.from == from) return r.exact;
    return 0;
}

TEST(Opamp, HasTheResistorsOfADifferentialSummer) {
    const auto plan =
        robots::make_plan({"", make_graph({.LL = -0.8f, .LR = 0.3f, .RR = 2, .LM = 0.5f, .RM = 0.5f}), {}}, 60);
    ASSERT_TRUE(plan);
    const auto left = opamp::summer(*plan, plan->units[0], "left"),
               right = opamp::summer(*plan, plan->units[1], "right");
    EXPECT_NEAR(ohms_from(left, "buffered_SL"), 125e3, 1);
    EXPECT_NEAR(ohms_from(left, "buffered_SR"), 333.3e3, 100);
    EXPECT_NEAR(ohms_from(left, "v5"), 200e3, 1);
    EXPECT_NEAR(ohms_from(left, "0"), 100e3, 1);  // 1 + 0.8 − 0.3 − 0.5 = 1
    EXPECT_EQ(left.back().to, "left_plus");
    EXPECT_NEAR(ohms_from(right, "0"), 100e3 / 1.5, 1);  // 1 − 2 − 0.5 = −1.5
    EXPECT_EQ(right.back().to, "right_minus");
}

TEST(Opamp, TakesTheNearestValueOfE24) {
    EXPECT_NEAR(opamp::nearest_e24(124e3), 120e3, 1);
    EXPECT_NEAR(opamp::nearest_e24(126e3), 130e3, 1);
    EXPECT_NEAR(opamp::nearest_e24(332e3), 330e3, 1);
    EXPECT_NEAR(opamp::nearest_e24(9.7e3), 10e3, 1);
    EXPECT_NEAR(opamp::nearest_e24(100e3), 100e3, 1);
}

TEST(Opamp, RefusesWhatItCannotHoldByName) {
    const auto refuses = [](const char* preset, const char* name) {
        const auto files = exported({"", find_preset(preset)->brain, {}});
        return !files && files.error().what.find(name) != std::string::npos;
    };
    EXPECT_TRUE(refuses("5-logic", "'SEEN'"));
    EXPECT_TRUE(refuses("7-mnemotrix", "'SEES'"));
    EXPECT_TRUE(refuses("4a-orbit", "hump"));
    EXPECT_TRUE(refuses("4b-decision", "step"));
    BrainGraph masked = make_graph({.LL = 1, .RR = 1});
    masked.wires[0].threshold = 0.2f;
    const auto files = exported({"", masked, {}});
    ASSERT_FALSE(files);
    EXPECT_NE(files.error().what.find("threshold"), std::string::npos);
    BrainGraph neuron = make_graph({.RR = 1});
    neuron.nodes.push_back({.id = 50, .kind = NodeKind::neuron, .name = "N"});
    neuron.wires.push_back({.from = find_node(neuron, "SL")->id, .to = 50});
    neuron.wires.push_back({.from = 50, .to = find_node(neuron, "ML")->id});
    const auto linear = exported({"", neuron, {}});
    ASSERT_FALSE(linear);
    EXPECT_NE(linear.error().what.find("'N' is a neuron"), std::string::npos) << linear.error().what;
    EXPECT_FALSE(exported({"", make_graph({.LL = 0.001f, .RR = 1}), {}}));
}

// The resistors of a netlist of KiCad as "from to ohms", with the names of nodes in brain.cir.
std::multiset<std::string> kicad_resistors(const std::string& text) {
    std::map<std::string, std::string> ohms, from, to;
    const auto node = [](const std::string& net) { return net == "GND" ? "0" : net == "+5V" ? "v5" : net; };
    const std::regex part(R"re(\(ref "(R\d+)"\) \(value "([\d.]+)([kM]?)"\))re"),
        net(R"re(\(net .*\(name "([^"]+)"\))re"), pin(R"re(\(node \(ref "(R\d+)"\) \(pin "([12])"\)\))re");
    std::istringstream lines(text);
    std::string present;
    std::smatch found;
    for (std::string line; std::getline(lines, line);) {
        if (std::regex_search(line, found, part))
            ohms[found[1]] = fmt::format("{:.4g}", std::stod(found[2]) * (found[3] == "k"   ? 1e3
                                                                          : found[3] == "M" ? 1e6
                                                                                            : 1));
        if (std::regex_search(line, found, net)) present = found[1];
        if (std::regex_search(line, found, pin)) (found[2] == "1" ? from : to)[found[1]] = node(present);
    }
    std::multiset<std::string> all;
    for (const auto& [ref, value] : ohms) all.insert(from[ref] + " " + to[ref] + " " + value);
    return all;
}

// "R3 …", not the input resistance of the amplifier.
bool is_resistor(const std::string& line) { return line.size() > 1 && line[0] == 'R' && std::isdigit(line[1]) != 0; }

std::multiset<std::string> spice_resistors(const std::string& text) {
    std::multiset<std::string> all;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string name, from, to;
        double ohms = 0;
        if (is_resistor(line) && words >> name >> from >> to >> ohms)
            all.insert(fmt::format("{} {} {:.4g}", from, to, ohms));
    }
    return all;
}

const std::string& text_of(const std::vector<robots::ExportedFile>& files, std::string_view name) {
    return std::find_if(files.begin(), files.end(), [&](const auto& file) { return file.name == name; })->text;
}

TEST(Opamp, HasTheSameResistorsBetweenTheSameNetsInKicadAndSpice) {
    each_exported(Target::opamp, "lm324", [](const BrainToExport& brain, const auto& files) {
        const auto kicad = kicad_resistors(text_of(files, "brain.net"));
        EXPECT_GE(kicad.size(), 3u) << brain.title;
        EXPECT_EQ(kicad, spice_resistors(text_of(files, "brain.cir"))) << brain.title;
    });
}

TEST(Opamp, ConnectsEveryPinOfAnLm324InKicadOnce) {
    each_exported(Target::opamp, "lm324", [](const BrainToExport& brain, const auto& files) {
        const std::string& text = text_of(files, "brain.net");
        EXPECT_EQ(std::count(text.begin(), text.end(), '('), std::count(text.begin(), text.end(), ')'));
        for (int pin = 1; pin <= 14; ++pin) {
            const std::string node = fmt::format("(node (ref \"U1\") (pin \"{}\"))", pin);
            const auto first = text.find(node);
            EXPECT_NE(first, std::string::npos) << brain.title << " " << node;
            EXPECT_EQ(text.find(node, first + 1), std::string::npos) << brain.title << " " << node;
        }
    });
}

// ---- In ngspice ----

struct Simulated {
    std::size_t rows = 0;
    double worst = 0;    // of 1
    double largest = 0;  // command that was seen
};

// Commands outside 0..1 leave the linear range of the outputs: 0 V, and more than 5 V.
double error_of(double volts, double command) {
    const double value = volts / 5;
    if (command >= 1) return std::max(0.0, 1 - value);
    return std::fabs(value - std::max(command, 0.0));
}

// The netlist with resistors that differ from their values by up to 1 %.
std::string with_tolerance(const std::string& netlist, maths::Random& random) {
    std::istringstream lines(netlist);
    std::string made;
    for (std::string line; std::getline(lines, line);) {
        const std::size_t value = line.rfind(' ') + 1;
        if (is_resistor(line))
            line = line.substr(0, value) + fmt::format("{:.7g}", std::stod(line.substr(value)) *
                                                                     static_cast<double>(random.uniform(0.99f, 1.01f)));
        made += line + "\n";
    }
    return made;
}

Simulated simulate(const Folder& folder, const BrainToExport& brain, const std::string& file,
                   maths::Random* tolerance = nullptr) {
    const auto plan = robots::make_plan(brain, 60);
    const auto vectors = robots::golden_vectors(brain, 60, 57);
    const auto files = exported(brain);
    for (const auto& each : *files)
        put_text(folder / each.name, tolerance ? with_tolerance(each.text, *tolerance) : each.text);
    std::string deck = "test\n.include " + file + "\nV5 v5 0 5\nX1 ", commands;
    for (const auto& input : plan->inputs) deck += input.id + " ";
    deck += "left right v5 brain\n";
    for (const auto& input : plan->inputs) deck += fmt::format("V{0} {0} 0 0\n", input.id);
    for (const auto& row : vectors->ticks) {
        for (std::size_t i = 0; i < row.sensed.size(); ++i)
            commands += fmt::format("alter V{} = {:.9g}\n", plan->inputs[i].id, 5 * row.sensed[i]);
        commands += "op\nprint v(left) v(right)\n";
    }
    put_text(folder / "test.cir", deck + ".control\nset numdgt=8\n" + commands + "quit\n.endc\n.end\n");
    const Ran ran = shell(fmt::format("cd '{}' && ngspice -b test.cir", folder.path.string()));
    EXPECT_EQ(ran.out.find("aborted"), std::string::npos) << brain.title;
    Simulated found;
    std::istringstream lines(ran.out);
    std::size_t left_rows = 0;
    for (std::string line; std::getline(lines, line);) {
        const bool left = line.starts_with("v(left) = "), right = line.starts_with("v(right) = ");
        if (!left && !right) continue;
        std::size_t& row = left ? left_rows : found.rows;
        if (row >= vectors->ticks.size()) break;
        const double command = static_cast<double>(left ? vectors->ticks[row].left : vectors->ticks[row].right);
        found.worst = std::max(found.worst, error_of(std::stod(line.substr(line.find('=') + 1)), command));
        found.largest = std::max(found.largest, command);
        ++row;
    }
    return found;
}

TEST(OpampInNgspice, GivesTheCommandsOfEveryShippedBrainThatItHolds) {
    if (!has_toolchains()) GTEST_SKIP() << "./dev robots installs ngspice";
    const Folder folder;
    each_exported(Target::opamp, "lm324", [&](const BrainToExport& brain, const auto&) {
        const Simulated exact = simulate(folder, brain, "brain-exact.cir"), e24 = simulate(folder, brain, "brain.cir");
        EXPECT_EQ(exact.rows, 57u) << brain.title;
        EXPECT_EQ(e24.rows, 57u) << brain.title;
        EXPECT_LE(exact.worst, 0.01) << brain.title;
        EXPECT_LE(e24.worst, 0.04) << brain.title;
        const double computed = opamp::e24_error(*robots::make_plan(brain, 60));
        EXPECT_LE(e24.worst, computed + 0.005) << brain.title;
        maths::Random random(1, 1);
        double worst_sample = 0;
        for (int sample = 0; sample < 5; ++sample)
            worst_sample = std::max(worst_sample, simulate(folder, brain, "brain.cir", &random).worst);
        EXPECT_LE(worst_sample, 0.04) << brain.title;
        std::printf("%-28s exact %.2f %%, E24 %.2f %%, computed %.2f %%, with 1 %% parts %.2f %%\n",
                    brain.title.c_str(), 100 * exact.worst, 100 * e24.worst, 100 * computed, 100 * worst_sample);
    });
}

TEST(OpampInNgspice, HoldsNegativeWeightsAndBiases) {
    if (!has_toolchains()) GTEST_SKIP() << "./dev robots installs ngspice";
    const Folder folder;
    const BrainToExport brain{
        "mixed", make_graph({.LL = -0.8f, .LR = 0.3f, .RL = 1.5f, .RR = 1.2f, .LM = 0.5f, .RM = -0.4f}), {}};
    const Simulated exact = simulate(folder, brain, "brain-exact.cir"), e24 = simulate(folder, brain, "brain.cir");
    EXPECT_EQ(exact.rows, 57u);
    EXPECT_LE(exact.worst, 0.01);
    EXPECT_LE(e24.worst, 0.04);
    EXPECT_GT(exact.largest, 0.9);
}

}  // namespace
}  // namespace braitenlab::tests::opamp_test

// The circuit: its values, what is refused, and the netlist in ngspice.
#include "core/export/opamp.h"

#include <cctype>
#include <cmath>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include <fmt/ranges.h>

#include "core/brain/four_neurons.h"
#include "core/export/e24.h"
#include "core/export/sensor_parts.h"
#include "core/maths/random.h"
#include "core/world/world.h"
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
    EXPECT_NEAR(robots::nearest_e24(124e3), 120e3, 1);
    EXPECT_NEAR(robots::nearest_e24(126e3), 130e3, 1);
    EXPECT_NEAR(robots::nearest_e24(332e3), 330e3, 1);
    EXPECT_NEAR(robots::nearest_e24(9.7e3), 10e3, 1);
    EXPECT_NEAR(robots::nearest_e24(100e3), 100e3, 1);
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

TEST(Opamp, WarnsOfAWheelWhoseCommandsDoNotReachTheDriversThreshold) {
    const auto warnings = [](const BrainGraph& brain) {
        std::vector<std::string> ids;
        for (const Error& warning : robots::export_warnings({"", brain, {}}, *robots::find_robot("lm324")))
            ids.push_back(std::string(warning.phrases[0].id) + " " + warning.phrases[0].values[0]);
        return ids;
    };
    using Ids = std::vector<std::string>;
    EXPECT_EQ(warnings(make_graph({.LL = 1, .RR = 1})), Ids{});
    EXPECT_EQ(warnings(make_graph({.LL = 0.8f, .RR = 0.5f})), Ids{"circuit_may_stand 'MR'"});
    EXPECT_EQ(warnings(make_graph({.LL = -1, .RR = 1, .LM = 0.3f})), Ids{"circuit_stands 'ML'"});
    EXPECT_EQ(warnings(find_preset("3a-love")->brain), (Ids{"circuit_may_stand 'ML'", "circuit_may_stand 'MR'"}));
    for (const robots::Robot& robot : robots::robots())
        if (robot.target != Target::opamp) {
            EXPECT_TRUE(robots::export_warnings({"", make_graph({.LL = 0.1f}), {}}, robot).empty()) << robot.name;
        }
}

TEST(Opamp, SaysForEachWheelWhatTheDriversDo) {
    const auto files = exported({"", make_graph({.LL = 0.3f, .RR = 0.9f, .RM = -0.1f}), {}});
    ASSERT_TRUE(files);
    const std::string& readme = text_of(*files, "README.md");
    EXPECT_NE(readme.find("| left (ML) | 0.00 to 0.27 | never turns | never turns | 0.00: stands | no reading |"),
              std::string::npos)
        << readme;
    EXPECT_NE(readme.find("| right (MR) | -0.10 to 0.71 | may never turn | turns | -0.10: stands | SR 0.88 ("),
              std::string::npos)
        << readme;
    EXPECT_NE(readme.find("**Warning: the wheel of 'ML' never turns"), std::string::npos) << readme;
    EXPECT_NE(text_of(*files, "parts.csv").find(",L298N board,"), std::string::npos) << "a TB6612 does not turn it";
    EXPECT_NE(readme.find("Neither driver turns each wheel"), std::string::npos);
    // An eye reads 0.9 near a torch, never 1: a weight of 1 does not reach the threshold of a TB6612.
    for (const auto& [weight, driver] : {std::pair{1.0f, ",L298N board,"}, std::pair{1.2f, ",TB6612 board,"}}) {
        const auto made = exported({"", make_graph({.LL = weight, .RR = weight}), {}});
        EXPECT_NE(text_of(*made, "parts.csv").find(driver), std::string::npos) << weight;
        EXPECT_EQ(text_of(*made, "README.md").find("Neither driver"), std::string::npos) << weight;
    }
    // Nominal values convert by the divider, 0.72, and 5 V for the command 1.
    for (const char* row : {"stands | 1.5 V | 2.1 V | 0.42 | 0.37 |", "L298 turns it | 2.3 V | 3.2 V | 0.64 | 0.70 |",
                            "TB6612 turns it | 3.5 V | 4.9 V | 0.97 | 1.00 |"})
        EXPECT_NE(readme.find(row), std::string::npos) << row << readme;
    const auto strong = exported({"", make_graph({.LL = 2, .RR = 2, .LM = 0.1f}), {}});
    for (const auto& [made, may] : {std::pair{&files, true}, std::pair{&strong, false}})
        EXPECT_EQ(text_of(**made, "README.md").find("it may do either") != std::string::npos, may);
}

// At its limits an L7805 gives 4.8 V and 5.2 V, and the resistors of a divider are off by 1 %.
TEST(Opamp, CountsTheTolerancesOfItsPartsInTheThresholdsOfTheDrivers) {
    const auto driver_volts = [](double command, double supply, double tolerance) {
        const double upper = (opamp::limit_ohms + opamp::divider_ohms) * (1 - tolerance),
                     lower = opamp::driver_pull_down_ohms * (1 + tolerance);
        return command * supply * lower / (upper + lower);
    };
    EXPECT_LT(driver_volts(opamp::stands_below, 5.2, 0.01), opamp::low_volts);
    EXPECT_LT(driver_volts(opamp::stands_below, 5.2, 0.01), 0.3 * 5.2);
    EXPECT_GT(driver_volts(opamp::l298_turns_from, 4.8, -0.01), opamp::l298_high_volts);
    for (const double supply : {4.8, 5.2})
        EXPECT_GT(driver_volts(opamp::tb6612_turns_from, supply, -0.01), 0.7 * supply) << supply;
}

// The lab's vehicle drives by a bias of 0.2 in the dark; this robot stands until an eye reads enough.
TEST(Opamp, WarnsOfAWheelThatStandsWhileItsSensorsSenseNothing) {
    const auto rest = [](const FourNeurons& brain) {
        std::vector<std::string> wheels;
        for (const Error& warning : robots::export_warnings({"", make_graph(brain), {}}, *robots::find_robot("lm324")))
            if (warning.phrases[0].id == "circuit_rest")
                wheels.push_back(fmt::format("{}", fmt::join(warning.phrases[0].values, " ")));
        return wheels;
    };
    using Wheels = std::vector<std::string>;
    EXPECT_EQ(rest({.LL = 0.8f, .RR = 0.8f}), Wheels{}) << "the lab's vehicle stands, too";
    EXPECT_EQ(rest({.LL = 0.8f, .RR = 0.9f, .LM = 0.2f}), Wheels{"'ML' 0.20 L298N 0.70"});
    EXPECT_EQ(rest({.LL = 2, .RR = 2, .LM = 0.8f, .RM = 1}), Wheels{"'ML' 0.80 TB6612 1.00"});
    EXPECT_EQ(rest({.LL = 0.8f, .RR = 0.8f, .LM = 0.7f}), Wheels{}) << "it turns in the dark";
    const auto files = exported({"", make_graph({.LR = 0.8f, .RL = 0.65f, .LM = 0.2f, .RM = 0.15f}), {}});
    ASSERT_TRUE(files);
    const std::string& readme = text_of(*files, "README.md");
    EXPECT_NE(readme.find("| left (ML) | 0.20 to 0.92 | may never turn | turns | 0.20: stands | SR 0.62 (516 lx) |"),
              std::string::npos)
        << readme;
    EXPECT_NE(readme.find("**Warning: while its sensors sense nothing, in total darkness, the command of 'ML' is 0.20"),
              std::string::npos);
    EXPECT_NE(readme.find("`left` gives 1.0 V, `right` 0.8 V"), std::string::npos);
}

// Eyes read the room without a lamp: the reading that a run of the scene without its lamps has.
TEST(Opamp, JudgesAWheelAtRestInTheLightOfTheScenesRoom) {
    for (const char* name : {"tt2wd-ldr", "romi"})
        for (const float half_lux : {268.0f, 60.0f}) {
            Scene scene = *load_scene(fmt::format("{}/exercises/robots/{}.toml", BRAITENLAB_SOURCE, name));
            scene.sources.clear();
            for (Start& start : scene.starts) start.facing.clear();
            if (half_lux < 100) scene.arena.lux = 30;
            Kind& kind = scene.kinds[0];
            kind.brain = make_graph({.LL = 0.8f, .RR = 0.8f, .LM = 0.2f, .RM = 0.7f});
            for (Sensor& sensor : kind.sensors)
                sensor.half_lux = half_lux, sensor.gain_spread = sensor.noise = sensor.latency = 0;
            auto world = World::create(scene, 1);
            ASSERT_TRUE(world) << world.error().text();
            world->step();
            const BrainToExport brain{"", kind.brain,     kind.sensors, kind.body.length, kind.body.width,
                                      0,  scene.arena.lux};
            const auto plan = robots::make_plan(brain, 60);
            ASSERT_EQ(plan->inputs.size(), 2u);
            const float in_room = plan->inputs[0].in_room;
            EXPECT_NEAR(in_room, snapshot_of(*world).sensed[0], 0.001) << name;
            EXPECT_NEAR(in_room, half_lux < 100 ? 0.38 : 0.09, 0.005) << name;
            const std::string readme = text_of(*exported(brain), "README.md");
            for (const std::string& text :
                 {fmt::format("| Command in the scene's room of {:g} lx, while they sense nothing else |",
                              scene.arena.lux),
                  fmt::format("| may never turn | turns | {:.2f}: ", 0.2f + 0.8f * in_room),
                  fmt::format("light of the scene's room, the command of 'ML' is {:.2f}", 0.2f + 0.8f * in_room)})
                EXPECT_NE(readme.find(text), std::string::npos) << text << readme;
        }
}

// What the warning and the README say is just enough: 0.01 less is not. Love turns in the dark by its bias alone, and
// in a room that its eyes read as 0.2 by more of it.
TEST(Opamp, SaysTheSmallestBiasAndWeightWithWhichAWheelTurns) {
    const auto love = [](float bias, float ambient) {
        BrainToExport brain{"", find_preset("3a-love")->brain, {{.name = "SL"}, {.name = "SR"}}};
        for (Node& node : brain.brain.nodes)
            if (node.kind == NodeKind::motor) node.bias = bias;
        brain.ambient = ambient;
        return brain;
    };
    const auto row = [](const BrainToExport& brain) {
        const std::string readme = text_of(*exported(brain), "README.md"), head = "|---|---|---|\n| left (ML) | ";
        const std::size_t at = readme.find(head, readme.find("The smallest change"));
        return at == std::string::npos
                   ? ""
                   : readme.substr(at + head.size(), readme.find('\n', at + head.size()) - at - head.size());
    };
    EXPECT_EQ(row(love(0.5f, 0)), "bias 0.70 (now 0.50) | bias 0.70 (now 0.50) |");
    EXPECT_EQ(row(love(0.69f, 0)), "bias 0.70 (now 0.69) | bias 0.70 (now 0.69) |");
    EXPECT_EQ(row(love(0.7f, 0)), "");
    EXPECT_EQ(row(love(0.7f, 0.2f)), "bias 0.90 (now 0.70) | as it is |");
    EXPECT_EQ(row(love(0.9f, 0.2f)), "");
    const auto warnings = robots::export_warnings(love(0.5f, 0), *robots::find_robot("lm324"));
    ASSERT_EQ(warnings.size(), 2u);
    EXPECT_NE(warnings[0].what.find("a bias of 0.70"), std::string::npos) << warnings[0].what;
    const auto weak = [](float weight) { return BrainToExport{"", make_graph({.LL = weight, .RR = 1}), {}}; };
    EXPECT_EQ(row(weak(0.5f)), "bias 0.70 (now 0.00) | bias 0.25 (now 0.00) or weight of SL 0.77 (now 0.50) |");
    EXPECT_EQ(row(weak(0.77f)), "bias 0.70 (now 0.00) | as it is |");
}

// A weight ends at 2: the effect of the lab's 1.2 would take 3.2.
TEST(Opamp, SaysWhichWeightGivesTheEffectOfTheLabAndWhereNoneDoes) {
    const auto files = exported({"",
                                 make_graph({.LL = 0.5f, .RL = -1.2f, .LM = 0.5f, .RM = 0.9f}),
                                 {{.name = "SL", .channel = Channel::obstacle}}});
    ASSERT_TRUE(files);
    const std::string& readme = text_of(*files, "README.md");
    EXPECT_NE(readme.find("  - to ML: 1.32 instead of 0.50, and -0.11 to the bias\n"), std::string::npos) << readme;
    EXPECT_NE(readme.find("  - to MR: -2.00 instead of -1.20, and +0.16 to the bias. The same effect would take -3.2, "
                          "but a weight ends at ±2: it has 63 % of it\n"),
              std::string::npos);
}

TEST(Opamp, WarnsOfASensorThatReadsTheReverseOfTheLab) {
    for (const Channel channel : {Channel::floor, Channel::light}) {
        const auto warnings = robots::export_warnings(
            {"", make_graph({.LL = 1, .RR = 1}), {{.name = "SL", .channel = channel}, {.name = "SR"}}},
            *robots::find_robot("lm324"));
        EXPECT_EQ(warnings.size(), channel == Channel::floor ? 1u : 0u);
        if (channel == Channel::floor && !warnings.empty()) {
            EXPECT_EQ(warnings[0].phrases[0].id, "circuit_inverted");
        }
    }
}

// A distance sensor without a calibration reads 0.08 to 0.46, a released switch 0.
TEST(Opamp, JudgesAWheelByWhatItsSensorsRead) {
    const auto commands = [](Channel channel, const FourNeurons& brain) {
        const auto plan = robots::make_plan({"", make_graph(brain), {{.name = "SL", .channel = channel}}}, 60);
        const robots::Range range = opamp::commands_of(*plan, plan->units[0]);
        return std::pair{range.low, range.high};
    };
    for (const auto& row : channel_table) {
        const robots::SensorPart part = robots::part_of({"SL", "sensor_SL", row.value}, robots::Board::circuit);
        if (part.part.empty()) continue;
        const auto [low, high] = part.readings;
        EXPECT_TRUE(low >= 0 && low < high && high <= 1) << row.word;
        for (const float weight : {1.0f, -1.0f}) {
            const auto [least, most] = commands(row.value, {.LL = weight, .LM = 0.3f});
            EXPECT_NEAR(least, 0.3f + (weight > 0 ? low : -high), 1e-6) << row.word;
            EXPECT_NEAR(most, 0.3f + (weight > 0 ? high : -low), 1e-6) << row.word;
        }
    }
    const auto files = exported(
        {"", make_graph({.LL = 1, .RL = 1, .LM = 0.3f, .RM = 0.3f}), {{.name = "SL", .channel = Channel::obstacle}}});
    ASSERT_TRUE(files);
    EXPECT_NE(text_of(*files, "README.md").find("| left (ML) | 0.38 to 0.76 | may never turn | turns |"),
              std::string::npos)
        << text_of(*files, "README.md");
    EXPECT_NE(text_of(*files, "parts.csv").find(",L298N board,"), std::string::npos);
}

// Each pin of the driver is at a connector of the board, and each sensor has its supply and ground at its own one.
TEST(Opamp, HasASupplyPinForTheDriverAndForEachSensor) {
    each_exported(Target::opamp, "lm324", [](const BrainToExport& brain, const auto& files) {
        const auto plan = robots::make_plan(brain, 60);
        const opamp::Circuit circuit = opamp::circuit_of(*plan);
        ASSERT_EQ(circuit.connectors.size(), plan->inputs.size() + 2) << brain.title;
        for (std::size_t i = 1; i < circuit.connectors.size(); ++i) {
            const auto& nodes = circuit.connectors[i].nodes;
            for (const char* node : {"v5", "0"}) EXPECT_EQ(std::count(nodes.begin(), nodes.end(), node), 1) << node;
            EXPECT_NE(text_of(files, "robot.svg").find(">" + circuit.connectors[i].name + " pin "), std::string::npos)
                << brain.title << circuit.connectors[i].name;
        }
        for (const char* word : {"TB6612", "left motor", "right motor", "battery +"})
            EXPECT_NE(text_of(files, "robot.svg").find(word), std::string::npos) << word;
    });
}

TEST(Opamp, TakesALargerSupplyForSensorsThatNeedMoreThanABlockBatteryGives) {
    for (const auto& [channel, is_block] : {std::pair{Channel::light, true}, std::pair{Channel::smell, false}}) {
        const BrainToExport brain{"",
                                  make_graph({.LL = 1, .RR = 1}),
                                  {{.name = "SL", .channel = channel}, {.name = "SR", .channel = channel}}};
        const auto files = exported(brain);
        ASSERT_TRUE(files);
        const double load = opamp::milliamperes_at_9_volts(*robots::make_plan(brain, 60));
        EXPECT_EQ(load < opamp::block_milliamperes, is_block) << load;
        EXPECT_NE(text_of(*files, "README.md").find(fmt::format("take up to {:.0f} mA", std::ceil(load))),
                  std::string::npos);
        EXPECT_EQ(text_of(*files, "parts.csv").find("1,block battery") != std::string::npos, is_block);
        EXPECT_EQ(text_of(*files, "parts.csv").find("1,holder for six AA cells with a switch,9 V") != std::string::npos,
                  !is_block);
    }
}

TEST(Opamp, SaysForEachChannelWhatItsSensorReadsWithoutACalibration) {
    for (const auto& row : channel_table) {
        const robots::SensorPart part = robots::part_of({"SL", "sensor_SL", row.value}, robots::Board::circuit);
        if (part.part.empty()) continue;
        const auto files = exported({"", make_graph({.LL = 1}), {{.name = "SL", .channel = row.value}}});
        ASSERT_TRUE(files) << row.word;
        EXPECT_FALSE(part.uncalibrated.empty()) << row.word;
        EXPECT_NE(text_of(*files, "README.md").find(fmt::format("| {} |\n", part.uncalibrated)), std::string::npos)
            << row.word;
    }
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

// The line of a netlist that says how to use it: "X1 sensor_SL … v5 brain_coward_1a2b3c".
std::string use_of(const std::string& netlist) {
    const std::size_t at = netlist.find("* X1 ");
    return at == std::string::npos ? "" : netlist.substr(at + 2, netlist.find('\n', at) - at - 2);
}

Simulated simulate(const Folder& folder, const BrainToExport& brain, const std::string& file,
                   maths::Random* tolerance = nullptr) {
    const auto plan = robots::make_plan(brain, 60);
    const auto vectors = robots::golden_vectors(brain, 60, 57);
    const auto files = exported(brain);
    for (const auto& each : *files)
        put_text(folder / each.name, tolerance ? with_tolerance(each.text, *tolerance) : each.text);
    std::string deck = "test\n.include " + file + "\nV5 v5 0 5\n" + use_of(tests::text_of(folder / file)) + "\n";
    std::string commands;
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
    if (!has_tool("ngspice")) GTEST_SKIP() << "./dev robots installs ngspice";
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
    if (!has_tool("ngspice")) GTEST_SKIP() << "./dev robots installs ngspice";
    const Folder folder;
    const BrainToExport brain{
        "mixed", make_graph({.LL = -0.8f, .LR = 0.3f, .RL = 1.5f, .RR = 1.2f, .LM = 0.5f, .RM = -0.4f}), {}};
    const Simulated exact = simulate(folder, brain, "brain-exact.cir"), e24 = simulate(folder, brain, "brain.cir");
    EXPECT_EQ(exact.rows, 57u);
    EXPECT_LE(exact.worst, 0.01);
    EXPECT_LE(e24.worst, 0.04);
    EXPECT_GT(exact.largest, 0.9);
}

// Numbers that `print` shows for this expression, in order.
std::vector<double> printed(const std::string& out, const std::string& expression) {
    std::vector<double> values;
    std::istringstream lines(out);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with(expression + " = ")) values.push_back(std::stod(line.substr(expression.size() + 3)));
    return values;
}

// What ngspice prints for a deck with the subcircuit of these netlists.
std::string simulated(const Folder& folder, const std::string& deck, const std::string& commands) {
    put_text(folder / "deck.cir", "test\n" + deck + ".control\nset numdgt=9\n" + commands + "quit\n.endc\n.end\n");
    const Ran ran = shell(fmt::format("cd '{}' && ngspice -b deck.cir >out 2>err; cat out err", folder.path.string()));
    EXPECT_EQ(ran.out.find("aborted"), std::string::npos) << deck << ran.out;
    return ran.out;
}

// A source at each sensor, at these volts or with this waveform.
std::string sources(const robots::Plan& plan, const std::vector<std::string>& volts) {
    std::string text = "V5 v5 0 5\n";
    for (std::size_t i = 0; i < plan.inputs.size(); ++i)
        text += fmt::format("V{0} {0} 0 {1}\n", plan.inputs[i].id, volts[i]);
    return text;
}

// Volts at a motor's output for readings of the sensors.
double wanted_volts(const robots::PlanUnit& motor, const std::vector<float>& sensed) {
    double command = static_cast<double>(motor.bias);
    for (const auto& tap : motor.taps)
        command += static_cast<double>(tap.weight) * static_cast<double>(sensed[static_cast<std::size_t>(tap.source)]);
    return std::clamp(5 * command, 0.0, 7.5);
}

TEST(OpampInNgspice, FollowsEdgesOfEverySensorInATransient) {
    if (!has_tool("ngspice")) GTEST_SKIP() << "./dev robots installs ngspice";
    const Folder folder;
    each_exported(Target::opamp, "lm324", [&](const BrainToExport& brain, const auto& files) {
        const auto plan = robots::make_plan(brain, 60);
        put_text(folder / "brain.cir", text_of(files, "brain-exact.cir"));
        const std::string use = ".include brain.cir\n" + use_of(text_of(files, "brain-exact.cir")) + "\n";
        for (const char* edge : {"PULSE(0 5 1m 1m 1m 2m 9m)", "PULSE(0 5 1m 1u 1u 2m 9m)"})
            for (std::size_t i = 0; i < plan->inputs.size(); ++i) {
                std::vector<std::string> volts(plan->inputs.size(), "1");
                volts[i] = edge;
                const std::string out =
                    simulated(folder, use + sources(*plan, volts),
                              "tran 10u 6m\nmeas tran high find v(left) at=2.9m\nmeas tran low find v(left) at=5.9m\n"
                              "let last=time[length(time)-1]\nprint last\n");
                ASSERT_EQ(printed(out, "last").size(), 1u) << brain.title << out;
                EXPECT_NEAR(printed(out, "last")[0], 6e-3, 1e-9) << brain.title << " " << edge;
                for (const bool high : {true, false}) {
                    std::vector<float> sensed(plan->inputs.size(), 0.2f);
                    sensed[i] = high ? 1 : 0;
                    const std::regex value((high ? "high" : "low") + std::string(R"re(\s+=\s+(\S+))re"));
                    std::smatch found;
                    ASSERT_TRUE(std::regex_search(out, found, value)) << out;
                    EXPECT_NEAR(std::stod(found[1]), wanted_volts(plan->units[0], sensed), 2e-3) << brain.title << edge;
                }
            }
    });
}

TEST(OpampInNgspice, IsOffByItsResistorsOnly) {
    if (!has_tool("ngspice")) GTEST_SKIP() << "./dev robots installs ngspice";
    const Folder folder;
    each_exported(Target::opamp, "lm324", [&](const BrainToExport& brain, const auto& files) {
        const auto plan = robots::make_plan(brain, 60);
        const std::string& netlist = text_of(files, "brain-exact.cir");
        put_text(folder / "brain.cir", netlist);
        std::vector<float> sensed(plan->inputs.size(), 0.2f);
        std::string commands;
        std::vector<double> wanted[2];
        for (const float level : {0.0f, 0.3f, 0.7f, 1.0f})
            for (std::size_t i = 0; i < plan->inputs.size(); ++i) {
                sensed[i] = level;
                commands += fmt::format("alter V{} = {}\nop\nprint v(left) v(right)\n", plan->inputs[i].id, 5 * level);
                for (std::size_t motor = 0; motor < 2; ++motor)
                    wanted[motor].push_back(wanted_volts(plan->units[motor], sensed));
            }
        const std::vector<std::string> volts(plan->inputs.size(), "1");
        const std::string out =
            simulated(folder, ".include brain.cir\n" + use_of(netlist) + "\n" + sources(*plan, volts), commands);
        for (std::size_t motor = 0; motor < 2; ++motor) {
            const auto seen = printed(out, motor == 0 ? "v(left)" : "v(right)");
            ASSERT_EQ(seen.size(), wanted[motor].size()) << brain.title << out;
            for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_NEAR(seen[i], wanted[motor][i], 5e-5) << brain.title;
        }
    });
}

TEST(OpampInNgspice, HoldsTwoBrainsOfOneTitleInADeck) {
    if (!has_tool("ngspice")) GTEST_SKIP() << "./dev robots installs ngspice";
    const Folder folder;
    const BrainToExport brains[] = {{"Mine", make_graph({.LL = 1}), {}}, {"mine", make_graph({.LL = 0.5f}), {}}};
    std::string deck = "V5 v5 0 5\nVS sensor_SL 0 2\n";
    for (int i = 0; i < 2; ++i) {
        const std::string netlist = text_of(*exported(brains[i]), "brain.cir");
        put_text(folder / fmt::format("{}.cir", i), netlist);
        std::string use = use_of(netlist);
        use = fmt::format("X{0} sensor_SL left{0} right{0} l{0} r{0} v5 {1}\n", i, use.substr(use.rfind(' ')));
        deck += fmt::format(".include {}.cir\n{}", i, use);
    }
    const std::string out = simulated(folder, deck, "op\nprint v(left0) v(left1)\n");
    ASSERT_EQ(printed(out, "v(left1)").size(), 1u) << out;
    EXPECT_NEAR(printed(out, "v(left0)")[0], 2, 1e-3);
    EXPECT_NEAR(printed(out, "v(left1)")[0], 1, 1e-3);
    EXPECT_EQ(out.find("redefinition"), std::string::npos) << out;
}

TEST(OpampInNgspice, KeepsSensorsApartWhoseNamesDifferByCaseOnly) {
    if (!has_tool("ngspice")) GTEST_SKIP() << "./dev robots installs ngspice";
    BrainGraph graph = make_graph({.LL = 0.5f, .RR = 0.5f});
    find_node(graph, "SL")->name = "eyeL";
    find_node(graph, "SR")->name = "EyeL";
    const BrainToExport brain{"case", graph, {}};
    const Simulated found = simulate(Folder(), brain, "brain-exact.cir");
    EXPECT_EQ(found.rows, 57u);
    EXPECT_LE(found.worst, 0.001);
}

// An LM324 that sinks the least that its data sheet promises near 0 V, with a battery that is fresh: 8.2 V at its
// output, which has 83 Ω and gives 6 mA.
std::string with_weakest_sink(std::string netlist) {
    const std::size_t from = netlist.find("Eout"), to = netlist.find("Rin");
    netlist.replace(from, to - from,
                    "Bout out 0 I = 12u * tanh(1000 * uramp(V(out) - V(g))) - 0.012 * uramp(V(g) - V(out))\n");
    const std::size_t limit = netlist.find("7.5)");
    return netlist.replace(limit, 3, "8.7");
}

TEST(OpampInNgspice, KeepsTheDriversInputsBetweenLowAndTheirLimitWithTheWeakestAmplifier) {
    if (!has_tool("ngspice")) GTEST_SKIP() << "./dev robots installs ngspice";
    const Folder folder;
    std::vector<BrainToExport> brains{
        {"strong", make_graph({.LL = -2, .LR = -2, .RL = 2, .RR = 2, .LM = -1, .RM = 1}), {}}};
    each_exported(Target::opamp, "lm324", [&](const BrainToExport& brain, const auto&) { brains.push_back(brain); });
    for (const BrainToExport& brain : brains) {
        const auto plan = robots::make_plan(brain, 60);
        const std::string netlist = text_of(*exported(brain), "brain-exact.cir");
        put_text(folder / "brain.cir", with_weakest_sink(netlist));
        const std::string use = ".include brain.cir\n" + use_of(netlist) + "\n";
        // Each combination of dark and bright; of many sensors 64 that are spread over all.
        const std::size_t sensors = plan->inputs.size();
        const unsigned combinations = 1u << std::min<std::size_t>(sensors, 6);
        const auto is_bright = [&](unsigned combination, std::size_t sensor) {
            return ((sensors <= 6 ? combination : combination * 2654435769u >> (32 - sensors)) >> sensor & 1u) != 0;
        };
        std::string commands;
        for (unsigned c = 0; c < combinations; ++c) {
            for (std::size_t i = 0; i < sensors; ++i)
                commands += fmt::format("alter V{} = {}\n", plan->inputs[i].id, is_bright(c, i) ? 5 : 0);
            commands += "op\nprint v(left_driver) v(right_driver)\n";
        }
        const std::string out =
            simulated(folder, use + sources(*plan, std::vector(plan->inputs.size(), std::string("0"))), commands);
        // A dark sensor counts a little more than 0.
        const double slack = 0.02 + 2 * 3.6 * opamp::largest_reading_of_dark(*plan);
        for (std::size_t motor = 0; motor < 2; ++motor) {
            const auto seen = printed(out, motor == 0 ? "v(left_driver)" : "v(right_driver)");
            ASSERT_EQ(seen.size(), combinations) << brain.title << out;
            for (unsigned bits = 0; bits < combinations; ++bits) {
                const auto& unit = plan->units[motor];
                double command = static_cast<double>(unit.bias);
                for (const auto& tap : unit.taps)
                    if (is_bright(bits, static_cast<std::size_t>(tap.source)))
                        command += static_cast<double>(tap.weight);
                const double low = command <= 0   ? -0.01
                                   : command >= 1 ? 3.5
                                                  : 3.6 * command - slack,
                             high = command <= 0   ? 0.1
                                    : command >= 1 ? opamp::largest_driver_volts
                                                   : 3.6 * command + slack;
                EXPECT_GE(seen[bits], low) << brain.title << " " << bits;
                EXPECT_LE(seen[bits], high) << brain.title << " " << bits;
            }
        }
    }
}

}  // namespace
}  // namespace braitenlab::tests::opamp_test

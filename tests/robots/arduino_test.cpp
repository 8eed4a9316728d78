// The Arduino sketch: compiled with Debian's avr-gcc and Arduino core, and run in simavr with golden vectors.
#include "core/export/arduino.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/brain/four_neurons.h"
#include "core/export/sensor_parts.h"
#include "core/scene/enums.h"
#include "tests/robots/exported.h"
#include "tests/robots/simulators.h"

namespace braitenlab::tests::arduino_test {
namespace {

using robots::BrainToExport;
using robots::Target;

Result<std::vector<robots::ExportedFile>> exported(const BrainToExport& brain) {
    return robots::export_brain(brain, Target::arduino, *robots::find_robot("tt2wd-ldr"));
}

BrainToExport with_channel(Channel channel) {
    return {"",
            make_graph({.LL = 1, .RR = 1}),
            {Sensor{.name = "SL", .channel = channel}, Sensor{.name = "SR", .channel = channel}}};
}

TEST(Arduino, RefusesASensorThatTheRobotCannotHaveByName) {
    for (const Channel channel : {Channel::memory, Channel::predator, Channel::oxygen}) {
        const auto files = exported(with_channel(channel));
        ASSERT_FALSE(files);
        EXPECT_NE(files.error().what.find("'SL'"), std::string::npos) << files.error().what;
        EXPECT_NE(files.error().what.find(word(channel)), std::string::npos) << files.error().what;
    }
    EXPECT_TRUE(exported(with_channel(Channel::floor)));
}

TEST(Export, ASensorForChanceIsAnInputInCAndRefusedByNameElsewhere) {
    for (const robots::Robot& robot : robots::robots()) {
        const auto files = robots::export_brain(with_channel(Channel::random), robot.target, robot);
        EXPECT_EQ(bool(files), robot.target == Target::c) << robot.name;
        if (files) continue;
        EXPECT_NE(files.error().what.find("'SL' senses random"), std::string::npos) << files.error().what;
    }
}

TEST(Arduino, RefusesMoreSensorsThanThereArePins) {
    const auto files = exported({"", find_preset("3c-values")->brain, {}});
    ASSERT_FALSE(files);
    EXPECT_NE(files.error().what.find("'AL'"), std::string::npos) << files.error().what;
}

TEST(Arduino, RefusesARobotOfAnotherTarget) {
    EXPECT_FALSE(robots::export_brain(with_channel(Channel::light), Target::arduino, *robots::find_robot("any")));
}

TEST(Arduino, SaysForEachChannelWhatIsShownForTheReadings0And1) {
    for (const auto& row : channel_table) {
        const auto files = exported(with_channel(row.value));
        if (!files) continue;
        const auto text = [&](std::string_view ending) {
            for (const robots::ExportedFile& file : *files)
                if (file.name.ends_with(ending)) return file.text;
            return std::string();
        };
        const robots::SensorPart part = robots::part_of({"SL", "sensor_SL", row.value}, robots::Board::uno);
        EXPECT_NE(text(".ino").find(fmt::format("calibrateEye(0, F(\"{}\"), F(\"{}\"));", part.zero, part.one)),
                  std::string::npos)
            << row.word;
        EXPECT_NE(text("README.md").find(fmt::format("0: {}, 1: {} |", part.zero, part.one)), std::string::npos);
    }
}

TEST(Arduino, SaysThatASensorOfABrainAloneIsTakenForAnEye) {
    const robots::Input alone{"ears", "sensor_ears"}, known{"SL", "sensor_SL", Channel::light};
    const auto files = exported({"", make_graph({.LL = 1, .RR = 1}), {}});
    ASSERT_TRUE(files);
    EXPECT_EQ(robots::doubt_about(known), "");
    EXPECT_NE((*files)[2].text.find(std::string(robots::doubt_about(alone)) + " |"), std::string::npos);
}

TEST(Arduino, StandsForThreeSecondsAsItsReadmeSays) {
    const auto files = exported(with_channel(Channel::light));
    ASSERT_TRUE(files);
    const auto file = [&](std::string_view ending) {
        const auto found = std::find_if(files->begin(), files->end(),
                                        [&](const robots::ExportedFile& each) { return each.name.ends_with(ending); });
        return found == files->end() ? std::string() : found->text;
    };
    EXPECT_NE(file(".ino").find("START_DELAY = 3000;"), std::string::npos);
    EXPECT_NE(file(".ino").find("while (millis() - start < START_DELAY && "), std::string::npos);
    EXPECT_NE(file("README.md").find("the wheels stand for 3 s"), std::string::npos);
}

TEST(Arduino, ExportsOrRefusesEveryShippedBrainWithAReason) {
    std::set<std::string> exports, refusals;
    for (const BrainToExport& brain : shipped_brains()) {
        const auto files = exported(brain);
        if (files)
            exports.insert(brain.title);
        else
            refusals.insert(brain.title + ": " + files.error().what);
    }
    for (const std::string& refusal : refusals) EXPECT_NE(refusal.find("the sensor '"), std::string::npos) << refusal;
    EXPECT_TRUE(exports.count("2a-coward") && exports.count("5-logic") && exports.count("4a-orbit coward") == 0);
    EXPECT_GT(exports.size(), 2 * refusals.size());
}

// Neurons that each read every sensor by such a wire. `numbers`: how many different ones there are of each value.
BrainToExport brain_of(int neurons, const Wire& wire, float time_constant = 0, int sensors = 6, int numbers = 499) {
    BrainToExport made{fmt::format("{} {} {}", neurons, word(wire.curve.response), wire.threshold), {}, {}};
    const auto join = [&](int from, int to, Wire with) {
        with.from = from, with.to = to;
        const int n = (37 * from + 11 * to) % numbers;  // a compiler shares equal ones
        with.weight = (to < 20 && from % 4 < 2 ? -1.0f : 1.0f) * (0.05f + 0.0006f * static_cast<float>(n));
        with.curve.peak += 0.0002f * static_cast<float>(n), with.curve.width *= 1 + 0.0003f * static_cast<float>(n);
        made.brain.wires.push_back(with);
    };
    for (int i = 0; i < sensors; ++i)
        made.brain.nodes.push_back({.id = i, .kind = NodeKind::sensor, .name = fmt::format("S{}", i)});
    for (int i = 0; i < 2; ++i)
        made.brain.nodes.push_back({.id = 10 + i, .kind = NodeKind::motor, .name = i == 0 ? "ML" : "MR"});
    for (int n = 20; n < 20 + neurons; ++n) {
        made.brain.nodes.push_back(
            {.id = n, .kind = NodeKind::neuron, .name = fmt::format("N{}", n), .time_constant = time_constant});
        for (int i = 0; i < sensors; ++i) join(i, n, wire);
        join(n, 10 + n % 2, {});
    }
    return made;
}

constexpr Curve sigmoid{.response = Response::sigmoid, .peak = 0.4f, .width = 0.15f};
constexpr Curve hump{.response = Response::hump, .peak = 0.4f, .width = 0.4f};

const std::string& named(const std::vector<robots::ExportedFile>& files, std::string_view ending) {
    return std::find_if(files.begin(), files.end(), [&](const auto& file) { return file.name.ends_with(ending); })
        ->text;
}

TEST(Arduino, LowersTheRateOfALongBrainWithItsMemoriesAndSaysSo) {
    const BrainToExport brain = brain_of(36, {.curve = sigmoid}, 0.5f);
    const auto files = exported(brain);
    ASSERT_TRUE(files) << files.error().what;
    const std::string &header = named(*files, "brain.h"), &readme = named(*files, "README.md");
    EXPECT_NE(header.find("#define BRAIN_RATE_HZ 40 "), std::string::npos);
    const auto slow = robots::make_plan(brain, 40), fast = robots::make_plan(brain, 50);
    EXPECT_NE(header.find(fmt::format("+ {}f *", slow->units[0].follow)), std::string::npos);
    EXPECT_EQ(header.find(fmt::format("+ {}f *", fast->units[0].follow)), std::string::npos);
    EXPECT_NE(named(*files, ".ino").find("// Each 1/40 s"), std::string::npos);
    EXPECT_NE(readme.find("computed 40 times per second"), std::string::npos);
    EXPECT_NE(readme.find("Smaller brains are computed 50 times per second"), std::string::npos);
    const auto small = exported(with_channel(Channel::light));
    EXPECT_NE(named(*small, "brain.h").find("#define BRAIN_RATE_HZ 50 "), std::string::npos);
    EXPECT_EQ(named(*small, "README.md").find("Smaller brains"), std::string::npos);
}

TEST(Arduino, RefusesABrainThatIsTooLargeWithTheNumbers) {
    const auto large = exported(brain_of(56, {.curve = hump}));
    ASSERT_FALSE(large);
    EXPECT_NE(large.error().what.find("holds 32256"), std::string::npos) << large.error().what;
}

TEST(Arduino, HasNoRateForAStepOfMoreThanATenthOfASecond) {
    EXPECT_EQ(robots::arduino::rate_for({1'600'000, 0}, 50), 10);
    EXPECT_EQ(robots::arduino::rate_for({1'600'001, 0}, 50), std::nullopt);
}

TEST(Arduino, LooksUpSigmoidsAndHumpsInOneTableEachIfItNeedsThem) {
    const auto header = [](const BrainToExport& brain) { return named(*exported(brain), "brain.h"); };
    const std::string plain = header(brain_of(2, {})), curved = header(brain_of(2, {.curve = sigmoid}));
    EXPECT_EQ(plain.find("PROGMEM"), std::string::npos);
    EXPECT_EQ(curved.find("brain_hump"), std::string::npos);
    EXPECT_EQ(curved.find("expf"), std::string::npos);
    EXPECT_EQ(curved.find("PROGMEM"), curved.rfind("PROGMEM"));
}

TEST(Arduino, MarksACalibrationByNumberOrderAndChannelOfTheSensors) {
    const auto mark = [](const std::vector<std::pair<const char*, Channel>>& sensors) {
        BrainToExport brain = brain_of(0, {}, 0, 0);
        for (const auto& [name, channel] : sensors) {
            const int id = static_cast<int>(brain.brain.nodes.size());
            brain.brain.nodes.push_back({.id = id, .kind = NodeKind::sensor, .name = name});
            brain.brain.wires.push_back({.from = id, .to = 10, .weight = 1});
            brain.sensors.push_back({.name = name, .channel = channel});
        }
        return robots::arduino::calibration_mark(*robots::make_plan(brain, 50));
    };
    const std::set<unsigned> marks{mark({}),
                                   mark({{"A", Channel::light}}),
                                   mark({{"A", Channel::floor}}),
                                   mark({{"A", Channel::light}, {"B", Channel::light}}),
                                   mark({{"B", Channel::light}, {"A", Channel::light}}),
                                   mark({{"A", Channel::light}, {"B", Channel::floor}}),
                                   0xffff};
    EXPECT_EQ(marks.size(), 7u);
}

TEST(Arduino, WarmsUpSensorsThatNeedItBeforeItCalibratesAndDrives) {
    for (const auto& row : channel_table) {
        const auto files = exported(with_channel(row.value));
        if (!files) continue;
        const int seconds = robots::part_of({"SL", "sensor_SL", row.value}, robots::Board::uno).warm_up;
        const std::string& sketch = named(*files, ".ino");
        const std::size_t call = sketch.find("  warmUp();"), calibrates = sketch.find(" calibrate();");
        EXPECT_EQ(call < calibrates && calibrates<sketch.find("  waitBeforeStart();"), seconds> 0) << row.word;
        EXPECT_EQ(sketch.find(fmt::format("< {}000UL", seconds)) != std::string::npos, seconds > 0) << row.word;
        EXPECT_EQ(
            named(*files, "README.md").find(fmt::format("after {} minutes only", seconds / 60)) != std::string::npos,
            seconds > 0)
            << row.word;
    }
}

// ---- In the simulator ----

// The PWM that the README promises for a command.
int expected_pwm(float command, int least, int most) {
    if (std::fabs(command) < 0.02f) return 0;
    const int size = static_cast<int>(std::lround(least + std::fabs(static_cast<double>(command)) * (most - least)));
    return command < 0 ? -size : size;
}

struct Compared {
    std::size_t rows = 0;
    int worst = 0;    // PWM counts
    int largest = 0;  // PWM of a wheel that was seen
};

// Sensor values as ADC counts, without loss where bright − dark is 1000 or −1000.
Compared compare(Simulator& simulator, const BrainToExport& brain, int ticks, const Calibrated& calibrated = {},
                 float rate = 50) {
    const auto vectors = robots::golden_vectors(brain, rate, ticks);
    const auto files = exported(brain);
    if (!vectors || !files || !simulator.compile(*files)) return {};
    const std::size_t inputs = vectors->sensors.size();
    const auto plan = robots::make_plan(brain, rate);
    std::string lines = eeprom(calibrated, inputs, robots::arduino::calibration_mark(*plan)) + "\n";
    for (const auto& row : vectors->ticks) {
        for (const float value : row.sensed)
            lines += fmt::format("{} ", std::lround(calibrated.dark + static_cast<double>(value) *
                                                                          (calibrated.bright - calibrated.dark)));
        lines += "\n";
    }
    const Ran ran = simulator.run(inputs, lines, "", 1000 / static_cast<double>(rate));
    EXPECT_EQ(ran.code, 0) << brain.title << " " << ran.out.substr(0, 300);
    std::istringstream rows(ran.out);
    Compared found;
    for (int left = 0, right = 0; rows >> left >> right; ++found.rows) {
        if (found.rows >= vectors->ticks.size()) break;
        const auto& row = vectors->ticks[found.rows];
        const int left_error = std::abs(left - expected_pwm(row.left, calibrated.minimum[0], calibrated.fastest[0]));
        const int right_error = std::abs(right - expected_pwm(row.right, calibrated.minimum[1], calibrated.fastest[1]));
        found.worst = std::max({found.worst, left_error, right_error});
        found.largest = std::max({found.largest, std::abs(left), std::abs(right)});
    }
    return found;
}

TEST(ArduinoInSimavr, GivesThePwmOfEveryShippedBrain) {
    if (!has_tool("libsimavr-dev")) GTEST_SKIP() << "./dev robots installs avr-gcc and simavr";
    Simulator simulator;
    std::vector<BrainGraph> done;
    for (const BrainToExport& brain : shipped_brains()) {
        if (!exported(brain) || std::find(done.begin(), done.end(), brain.brain) != done.end()) continue;
        done.push_back(brain.brain);
        const auto plan = robots::make_plan(brain, 50);
        const bool blind = plan->inputs.empty();
        const Compared found = compare(simulator, brain, blind ? 1 : 150);
        EXPECT_EQ(found.rows, blind ? 1u : 150u) << brain.title;
        EXPECT_LE(found.worst, 1) << brain.title;
        if (found.worst > 0) std::printf("%s: %d counts\n", brain.title.c_str(), found.worst);
    }
    EXPECT_GT(done.size(), 10u);
}

TEST(ArduinoInSimavr, UsesTheCalibratedRanges) {
    if (!has_tool("libsimavr-dev")) GTEST_SKIP() << "./dev robots installs avr-gcc and simavr";
    Simulator simulator;
    const BrainToExport love{"3a-love", find_preset("3a-love")->brain, {}};
    // A sensor that reads less in the light, motors that differ.
    const Compared found = compare(simulator, love, 300, {1010, 10, {46, 60}, {240, 255}});
    EXPECT_EQ(found.rows, 300u);
    EXPECT_LE(found.worst, 1);
    EXPECT_GT(found.largest, 100);
}

TEST(ArduinoInSimavr, StandsForThreeSecondsAfterPowerOn) {
    if (!has_tool("libsimavr-dev")) GTEST_SKIP() << "./dev robots installs avr-gcc and simavr";
    Simulator simulator;
    const auto files = exported({"", make_graph({.LM = 1, .RM = 1}), {}});
    ASSERT_TRUE(files && simulator.compile(*files));
    const auto plan = robots::make_plan({"", make_graph({.LM = 1, .RM = 1}), {}}, 50);
    const Ran ran = simulator.run(0, eeprom({}, 0, robots::arduino::calibration_mark(*plan)) + "\n", "wait");
    EXPECT_EQ(ran.code, 0) << ran.out;
    std::istringstream rows(ran.out);
    std::vector<int> standing(40);
    for (int& stands : standing) {
        int left = 1, right = 1;
        rows >> left >> right;
        stands = left == 0 && right == 0;
    }
    EXPECT_EQ(std::count(standing.begin(), standing.begin() + 29, 1), 29) << "it moves before 2.9 s";
    EXPECT_EQ(std::count(standing.begin() + 32, standing.end(), 1), 0) << "it does not move after 3.2 s";
}

int byte_at(const std::string& hexadecimal, std::size_t index) {
    return std::stoi(hexadecimal.substr(2 * index, 2), nullptr, 16);
}
int word_at(const std::string& hexadecimal, std::size_t index) {
    return byte_at(hexadecimal, index) + 256 * byte_at(hexadecimal, index + 1);
}

TEST(ArduinoInSimavr, KeepsWhatTheFirstStartCalibrates) {
    if (!has_tool("libsimavr-dev")) GTEST_SKIP() << "./dev robots installs avr-gcc and simavr";
    Simulator simulator;
    const auto files = exported({"2a-coward", find_preset("2a-coward")->brain, {}});
    ASSERT_TRUE(files && simulator.compile(*files));
    const std::string eyes =
        "adc 0 40\npress\nwait 400\nadc 0 800\npress\nwait 400\n"  // SL
        "adc 1 55\npress\nwait 400\nadc 1 60\npress\nwait 2400\n"  // SR: too close, again
        "adc 1 55\npress\nwait 400\nadc 1 900\npress\nwait 400\n";
    const std::string motors = "press\nwait 1800\npress\nwait 200\npress\nwait 3000\npress\nwait 200\n";
    // Turned left once, then straight: three presses. Without an answer it waits.
    const std::string run =
        "press\nwait 4300\npress\nwait 2500\npress\nwait 4300\nwait 9000\npress\npress\npress\nwait 2500\n";
    const Ran ran = simulator.run(2, "-\n" + eyes + motors + run, "calibrate");
    ASSERT_EQ(ran.code, 0) << ran.out;
    const auto plan = robots::make_plan({"2a-coward", find_preset("2a-coward")->brain, {}}, 50);
    EXPECT_EQ(word_at(ran.out, 0), static_cast<int>(robots::arduino::calibration_mark(*plan))) << ran.out;
    EXPECT_EQ(word_at(ran.out, 2), 40);
    EXPECT_EQ(word_at(ran.out, 4), 55);
    EXPECT_EQ(word_at(ran.out, 6), 800);
    EXPECT_EQ(word_at(ran.out, 8), 900);
    EXPECT_NEAR(byte_at(ran.out, 10), 30, 4);  // 1.8 s at 60 ms each
    EXPECT_NEAR(byte_at(ran.out, 11), 50, 4);
    EXPECT_EQ(byte_at(ran.out, 12), 255);
    EXPECT_EQ(byte_at(ran.out, 13), 250);  // turned left: the right motor was faster
}

TEST(ArduinoInSimavr, WaitsForTheReleaseOfTheButtonThatIsHeldDuringReset) {
    if (!has_tool("libsimavr-dev")) GTEST_SKIP() << "./dev robots installs avr-gcc and simavr";
    Simulator simulator;
    const auto files = exported({"2a-coward", find_preset("2a-coward")->brain, {}});
    ASSERT_TRUE(files && simulator.compile(*files));
    const auto plan = robots::make_plan({"2a-coward", find_preset("2a-coward")->brain, {}}, 50);
    const std::string own = eeprom({}, 2, robots::arduino::calibration_mark(*plan)) + "\n";
    const std::string eye =
        "adc 0 700\nwait 1000\nup\nwait 400\nadc 0 40\npress\nwait 400\nadc 0 800\npress\nwait 400\n";
    const Ran ran = simulator.run(2, own + eye, "held");
    ASSERT_EQ(ran.code, 0) << ran.out;
    EXPECT_EQ(word_at(ran.out, 2), 40);
    EXPECT_EQ(word_at(ran.out, 6), 800);
    EXPECT_EQ(byte_at(ran.out, 14), 1) << "steps that are done";
}

TEST(ArduinoInSimavr, CalibratesTheMotorsAloneWhenTheButtonIsHeldLonger) {
    if (!has_tool("libsimavr-dev")) GTEST_SKIP() << "./dev robots installs avr-gcc and simavr";
    Simulator simulator;
    const auto files = exported({"2a-coward", find_preset("2a-coward")->brain, {}});
    ASSERT_TRUE(files && simulator.compile(*files));
    const auto plan = robots::make_plan({"2a-coward", find_preset("2a-coward")->brain, {}}, 50);
    const std::string own = eeprom({40, 900, {11, 12}, {200, 210}}, 2, robots::arduino::calibration_mark(*plan)) + "\n";
    const std::string left = "wait 5000\nup\nwait 400\npress\nwait 1800\npress\nwait 200\n";
    const Ran ran = simulator.run(2, own + left, "held");
    ASSERT_EQ(ran.code, 0) << ran.out;
    EXPECT_EQ(word_at(ran.out, 2), 40);
    EXPECT_EQ(word_at(ran.out, 6), 900);
    EXPECT_NEAR(byte_at(ran.out, 10), 30, 4);
    EXPECT_EQ(byte_at(ran.out, 12), 255);
    EXPECT_EQ(byte_at(ran.out, 14), 3) << "steps that are done: two sensors, one motor";
}

TEST(ArduinoInSimavr, KeepsNoStraightRunWithoutAnAnswer) {
    if (!has_tool("libsimavr-dev")) GTEST_SKIP() << "./dev robots installs avr-gcc and simavr";
    Simulator simulator;
    const auto files = exported({"", make_graph({.LM = 1, .RM = 1}), {}});
    ASSERT_TRUE(files && simulator.compile(*files));
    const std::string motors = "press\nwait 600\npress\nwait 200\npress\nwait 600\npress\nwait 200\n";
    for (const bool answers : {false, true}) {
        const Ran ran = simulator.run(
            0, "-\n" + motors + "press\nwait 4300\nwait 12000\n" + (answers ? "press\npress\npress\nwait 2500\n" : ""),
            "calibrate");
        ASSERT_EQ(ran.code, 0) << ran.out;
        EXPECT_EQ(byte_at(ran.out, 6), answers ? 3 : 2) << "steps that are done";
    }
}

TEST(ArduinoInSimavr, KeepsEachStepOfTheCalibrationAndGoesOnWithTheNextOne) {
    if (!has_tool("libsimavr-dev")) GTEST_SKIP() << "./dev robots installs avr-gcc and simavr";
    Simulator simulator;
    const auto files = exported({"2a-coward", find_preset("2a-coward")->brain, {}});
    ASSERT_TRUE(files && simulator.compile(*files));
    std::string kept = "-";
    for (int eye = 0; eye < 2; ++eye) {
        const Ran ran = simulator.run(
            2, fmt::format("{0}\nadc {1} {2}\npress\nwait 400\nadc {1} 900\npress\nwait 400\n", kept, eye, 30 + eye),
            "calibrate");
        ASSERT_EQ(ran.code, 0) << ran.out;
        EXPECT_EQ(byte_at(ran.out, 14), eye + 1);
        kept = ran.out.substr(0, ran.out.find('\n'));
    }
    EXPECT_EQ(word_at(kept, 2), 30);
    EXPECT_EQ(word_at(kept, 4), 31);
}

TEST(ArduinoInSimavr, GivesUpASensorThatReadsTheSameThreeTimes) {
    if (!has_tool("libsimavr-dev")) GTEST_SKIP() << "./dev robots installs avr-gcc and simavr";
    Simulator simulator;
    const auto files = exported({"2a-coward", find_preset("2a-coward")->brain, {}});
    ASSERT_TRUE(files && simulator.compile(*files));
    const std::string same = "adc 0 55\npress\nwait 400\nadc 0 60\npress\nwait 2600\n",
                      different = "adc 0 55\npress\nwait 400\nadc 0 900\npress\nwait 2600\n";
    for (const int tries : {2, 3}) {
        std::string steps = "-\n";
        for (int i = 0; i < tries; ++i) steps += same;
        const Ran ran = simulator.run(2, steps + different, "calibrate");
        ASSERT_EQ(ran.code, 0) << ran.out;
        EXPECT_EQ(byte_at(ran.out, 14), tries == 2 ? 1 : 0xff) << "steps that are done";
    }
}

TEST(ArduinoInSimavr, HoldsBrainsUpToTheirLimitsAtTheRateOfTheReadme) {
    if (!has_tool("libsimavr-dev")) GTEST_SKIP() << "./dev robots installs avr-gcc and simavr";
    Simulator simulator;
    const BrainToExport brains[] = {
        brain_of(36, {.curve = sigmoid}, 0.5f),
        brain_of(47, {.curve = sigmoid}),
        brain_of(47, {.curve = hump}),
        brain_of(58, {}, 0, 6, 3),
        brain_of(47, {.curve = hump}, 0, 6, 7),
        brain_of(58, {}),
        brain_of(29, {.threshold = 0.2f}, 0.5f),
        brain_of(30, {.curve = {.response = Response::step, .peak = 0.4f}}),
        brain_of(30, {.curve = {.response = Response::rectified}}, 0.3f),
        brain_of(12, {.learning_rate = 0.5f, .decay = 0.1f}),
    };
    for (const BrainToExport& brain : brains) {
        const auto plan = robots::make_plan(brain, 50);
        const robots::arduino::Cost cost = robots::arduino::cost_of(*plan);
        const auto rate = robots::arduino::rate_for(cost, 50);
        ASSERT_TRUE(rate && cost.bytes <= robots::arduino::largest_program) << brain.title << " " << cost.bytes;
        const Compared found = compare(simulator, brain, 100, {}, static_cast<float>(*rate));
        EXPECT_EQ(found.rows, 100u) << brain.title;
        EXPECT_LE(found.worst, 1) << brain.title;
        const int bytes = simulator.program_bytes();
        EXPECT_LE(bytes, cost.bytes) << brain.title;
        EXPECT_GE(1.3 * bytes, cost.bytes) << brain.title;
        std::printf("%-20s %2d Hz, %5d bytes of %5d, %.1f ms\n", brain.title.c_str(), *rate, bytes, cost.bytes,
                    cost.cycles / 16e3);
    }
}

TEST(ArduinoInSimavr, NeedsNoMoreMemoryThanItsReadmeSaysForAnySensor) {
    if (!has_tool("libsimavr-dev")) GTEST_SKIP() << "./dev robots installs avr-gcc and simavr";
    Simulator simulator;
    for (const auto& row : channel_table) {
        const BrainToExport brain = with_channel(row.value);
        const auto files = exported(brain);
        if (!files) continue;
        ASSERT_TRUE(simulator.compile(*files)) << row.word;
        EXPECT_LE(simulator.program_bytes(), robots::arduino::cost_of(*robots::make_plan(brain, 50)).bytes) << row.word;
    }
}

TEST(ArduinoInSimavr, DoesNotUseTheCalibrationOfOtherSensors) {
    if (!has_tool("libsimavr-dev")) GTEST_SKIP() << "./dev robots installs avr-gcc and simavr";
    Simulator simulator;
    const BrainToExport two = brain_of(2, {}, 0, 2);
    BrainToExport three = brain_of(3, {}, 0, 3);
    for (const char* motor : {"ML", "MR"}) find_node(three.brain, motor)->bias = 0.9f;
    const auto files = exported(three);
    ASSERT_TRUE(files && simulator.compile(*files));
    for (const bool is_own : {false, true}) {
        const unsigned mark = robots::arduino::calibration_mark(*robots::make_plan(is_own ? three : two, 50));
        const Ran ran = simulator.run(3, eeprom({}, is_own ? 3 : 2, mark) + "\n", "wait");
        ASSERT_EQ(ran.code, 0) << ran.out;
        std::istringstream rows(ran.out);
        int left = 0, right = 0, read = 0, moving = 0;
        for (; rows >> left >> right; ++read) moving += left != 0 || right != 0;
        EXPECT_EQ(read, 40);
        // 4 s, of which the sketch waits for 3 s; a sketch that calibrates waits for its button.
        EXPECT_EQ(moving > 0, is_own) << moving;
    }
}

}  // namespace
}  // namespace braitenlab::tests::arduino_test

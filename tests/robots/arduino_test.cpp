// The Arduino sketch: compiled with Debian's avr-gcc and Arduino core, and run in simavr with golden vectors.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/brain/four_neurons.h"
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

TEST(Arduino, RefusesMoreSensorsThanThereArePins) {
    const auto files = exported({"", find_preset("3c-values")->brain, {}});
    ASSERT_FALSE(files);
    EXPECT_NE(files.error().what.find("'AL'"), std::string::npos) << files.error().what;
}

TEST(Arduino, RefusesARobotOfAnotherTarget) {
    EXPECT_FALSE(robots::export_brain(with_channel(Channel::light), Target::arduino, *robots::find_robot("any")));
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
Compared compare(Simulator& simulator, const BrainToExport& brain, int ticks, const Calibrated& calibrated = {}) {
    const auto vectors = robots::golden_vectors(brain, 50, ticks);
    const auto files = exported(brain);
    if (!vectors || !files || !simulator.compile(*files)) return {};
    const std::size_t inputs = vectors->sensors.size();
    std::string lines = eeprom(calibrated, inputs) + "\n";
    for (const auto& row : vectors->ticks) {
        for (const float value : row.sensed)
            lines += fmt::format("{} ", std::lround(calibrated.dark + static_cast<double>(value) *
                                                                          (calibrated.bright - calibrated.dark)));
        lines += "\n";
    }
    const Ran ran = simulator.run(inputs, lines);
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
    if (!has_toolchains()) GTEST_SKIP() << "./dev robots installs avr-gcc and simavr";
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
    if (!has_toolchains()) GTEST_SKIP() << "./dev robots installs avr-gcc and simavr";
    Simulator simulator;
    const BrainToExport love{"3a-love", find_preset("3a-love")->brain, {}};
    // A sensor that reads less in the light, motors that differ.
    const Compared found = compare(simulator, love, 300, {1010, 10, {46, 60}, {240, 255}});
    EXPECT_EQ(found.rows, 300u);
    EXPECT_LE(found.worst, 1);
    EXPECT_GT(found.largest, 100);
}

TEST(ArduinoInSimavr, StandsForThreeSecondsAfterPowerOn) {
    if (!has_toolchains()) GTEST_SKIP() << "./dev robots installs avr-gcc and simavr";
    Simulator simulator;
    const auto files = exported({"", make_graph({.LM = 1, .RM = 1}), {}});
    ASSERT_TRUE(files && simulator.compile(*files));
    const Ran ran = simulator.run(0, eeprom({}, 0) + "\n", "wait");
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
    if (!has_toolchains()) GTEST_SKIP() << "./dev robots installs avr-gcc and simavr";
    Simulator simulator;
    const auto files = exported({"2a-coward", find_preset("2a-coward")->brain, {}});
    ASSERT_TRUE(files && simulator.compile(*files));
    const std::string eyes =
        "adc 0 40\npress\nwait 400\nadc 0 800\npress\nwait 400\n"  // SL
        "adc 1 55\npress\nwait 400\nadc 1 60\npress\nwait 400\n"   // SR: too close, again
        "adc 1 55\npress\nwait 400\nadc 1 900\npress\nwait 400\n";
    const std::string motors = "press\nwait 1800\npress\nwait 200\npress\nwait 3000\npress\nwait 200\n";
    // Turned left once, then straight.
    const std::string run = "press\nwait 4300\npress\nwait 5500\npress\nwait 4300\nwait 6000\n";
    const Ran ran = simulator.run(2, "-\n" + eyes + motors + run, "calibrate");
    ASSERT_EQ(ran.code, 0) << ran.out;
    EXPECT_EQ(word_at(ran.out, 0), 0xB7A1) << ran.out;
    EXPECT_EQ(word_at(ran.out, 2), 40);
    EXPECT_EQ(word_at(ran.out, 4), 55);
    EXPECT_EQ(word_at(ran.out, 6), 800);
    EXPECT_EQ(word_at(ran.out, 8), 900);
    EXPECT_NEAR(byte_at(ran.out, 10), 30, 4);  // 1.8 s at 60 ms each
    EXPECT_NEAR(byte_at(ran.out, 11), 50, 4);
    EXPECT_EQ(byte_at(ran.out, 12), 255);
    EXPECT_EQ(byte_at(ran.out, 13), 250);  // turned left: the right motor was faster
}

}  // namespace
}  // namespace braitenlab::tests::arduino_test

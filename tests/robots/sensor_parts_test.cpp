// The parts of sensors: every file of an export has the same ones, and none brings more to a pin than it takes.
#include "core/export/sensor_parts.h"

#include <cmath>
#include <regex>

#include "core/brain/four_neurons.h"
#include "core/scene/enums.h"
#include "tests/robots/exported.h"
#include "tests/well_formed.h"

namespace braitenlab::tests::sensor_parts_test {
namespace {

using robots::Board;
using robots::SensorPart;

struct BoardOfRobot {
    Board board;
    const char* robot;
};
constexpr BoardOfRobot boards[] = {{Board::uno, "tt2wd-ldr"}, {Board::circuit, "lm324"}, {Board::microbit, "microbit"}};

Result<std::vector<robots::ExportedFile>> exported(Channel channel, const char* robot) {
    const robots::Robot& found = *robots::find_robot(robot);
    return robots::export_brain({"", make_graph({.LL = 1}), {{.name = "SL", .channel = channel}}}, found.target, found);
}

const std::string& file_of(const std::vector<robots::ExportedFile>& files, std::string_view name) {
    return std::find_if(files.begin(), files.end(), [&](const auto& file) { return file.name == name; })->text;
}

template <class Test>
void each_part(Test test) {
    for (const auto& [board, robot] : boards)
        for (const auto& row : channel_table) {
            const SensorPart part = robots::part_of({"SL", "sensor_SL", row.value}, board);
            const auto files = exported(row.value, robot);
            EXPECT_EQ(bool(files), !part.part.empty()) << robot << " " << row.word;
            if (files) test(part, board, *files, fmt::format("{} {}", robot, row.word));
        }
}

TEST(SensorParts, AreInTheDrawingTheListAndTheReadmeWithTheirResistors) {
    each_part([](const SensorPart& part, Board board, const auto& files, const std::string& which) {
        const std::string &drawing = file_of(files, "wiring.svg"), &list = file_of(files, "parts.csv");
        EXPECT_EQ(xml_fault("<!DOCTYPE svg>\n" + drawing), "") << which;
        EXPECT_NE(file_of(files, "README.md").find("| " + robots::joining_text(part)), std::string::npos) << which;
        if (board == Board::circuit) {
            EXPECT_EQ(xml_fault("<!DOCTYPE svg>\n" + file_of(files, "robot.svg")), "") << which;
            EXPECT_NE(drawing.find(part.part), std::string::npos) << which;
        }
        if (part.joining != robots::Joining::battery) {
            EXPECT_NE(list.find(fmt::format("1,\"{}\",\"for sensor SL\"", part.part)), std::string::npos) << which;
        }
        for (const std::string_view ohms : {part.in_series, part.to_ground}) {
            if (ohms.empty()) continue;
            EXPECT_NE(drawing.find(fmt::format(">{}<", ohms)), std::string::npos) << which << " " << ohms;
            EXPECT_NE(list.find(fmt::format("1,\"resistor {}\",", ohms)), std::string::npos) << which << " " << ohms;
        }
        if (part.capacitor.empty()) return;
        EXPECT_NE(drawing.find(part.capacitor), std::string::npos) << which;
        EXPECT_NE(list.find(fmt::format("1,\"capacitor {}\",", part.capacitor)), std::string::npos) << which;
    });
}

double kiloohms(std::string_view text) { return std::stod(std::string(text)); }  // "1.5 kΩ"

// A fresh battery of four alkaline cells gives 6.4 V, one of six, which an L298N needs, 9.6 V.
TEST(SensorParts, BringNoMoreToAPinThanItTakes) {
    each_part([](const SensorPart& part, Board board, const auto&, const std::string& which) {
        const double most = board == Board::microbit ? 3 : 5;
        double volts = part.joining == robots::Joining::battery ? (board == Board::microbit ? 6.4 : 9.6)
                                                                : std::stod(std::string(part.supply));
        if (!part.in_series.empty())
            volts *= kiloohms(part.to_ground) / (kiloohms(part.in_series) + kiloohms(part.to_ground));
        EXPECT_LE(volts, most + 1e-9) << which;
    });
}

// Where the sensors take more than the board gives, no board supplies the modules.
TEST(SensorParts, TakeNoMoreFromABoardThanItGives) {
    const std::pair<Board, const char*> five_volts[] = {{Board::uno, "tt2wd-ldr"}, {Board::circuit, "lm324"}};
    for (const auto& [board, robot] : five_volts)
        for (const Channel channel : {Channel::smell, Channel::obstacle, Channel::light})
            for (int count = 1; count <= 6; ++count) {
                robots::BrainToExport brain{"", {}, {}};
                brain.brain.nodes = {{.id = 10, .kind = NodeKind::motor, .name = "ML"},
                                     {.id = 11, .kind = NodeKind::motor, .name = "MR"}};
                for (int i = 0; i < count; ++i) {
                    const std::string name = fmt::format("S{}", i);
                    brain.brain.nodes.push_back({.id = i, .kind = NodeKind::sensor, .name = name});
                    brain.brain.wires.push_back({.from = i, .to = 10, .weight = 1});
                    brain.sensors.push_back({.name = name, .channel = channel});
                }
                const auto parts = robots::parts_of(*robots::make_plan(brain, 50), board);
                EXPECT_LE(robots::board_milliamperes(parts), 440) << robot << " " << word(channel) << count;
                const double own = robots::own_milliamperes(parts);
                EXPECT_EQ(own > 0, count * parts[0].milliamperes > 440) << robot << " " << word(channel) << count;
                const robots::Robot& found = *robots::find_robot(robot);
                const auto files = robots::export_brain(brain, found.target, found);
                ASSERT_TRUE(files);
                const std::string supply = fmt::format("supply of 5 V, {:.0f} mA", std::ceil(own));
                EXPECT_EQ(file_of(*files, "parts.csv").find(supply) != std::string::npos, own > 0) << robot;
                EXPECT_EQ(file_of(*files, "README.md").find(fmt::format("up to {:.0f} mA in sum", std::ceil(own))) !=
                              std::string::npos,
                          own > 0)
                    << robot;
            }
}

TEST(SensorParts, OfABodyHaveTheirPlacesAsSharesOfIt) {
    const BrainGraph brain = make_graph({.LL = 1, .RR = 1});
    const std::vector<Sensor> sensors{{.name = "SL", .x = 0.09f, .y = 0.05f, .angle = 0.610865f},
                                      {.name = "SR", .x = -0.09f, .y = 0, .angle = -0.610865f}};
    const auto place = [&](const robots::BrainToExport& given, std::size_t input) {
        return robots::place_text(robots::make_plan(given, 50)->inputs[input]);
    };
    const robots::BrainToExport with_body{"", brain, sensors, 0.2f, 0.1f}, without{"", brain, sensors};
    EXPECT_EQ(place(with_body, 0),
              "45 % of the length ahead of the middle, 50 % of the width to the left; it looks 35° to the left");
    EXPECT_EQ(place(with_body, 1), "45 % of the length behind the middle; it looks 35° to the right");
    EXPECT_EQ(place(without, 0), "0.09 m ahead of the middle, 0.05 m to the left; it looks 35° to the left");
    for (const robots::Robot& robot : robots::robots()) {
        if (robot.is_thymio) continue;
        const auto files = robots::export_brain(with_body, robot.target, robot);
        ASSERT_TRUE(files) << robot.name;
        for (const std::size_t input : {0u, 1u})
            EXPECT_NE(file_of(*files, "README.md").find(place(with_body, input)), std::string::npos) << robot.name;
    }
}

// A GL5528 of 15 kΩ at 10 lx and exponent 0.7: 4.3 kΩ give half at 57 lx.
TEST(SensorParts, GiveAPhotoresistorTheResistorOfTheScenesHalfLux) {
    for (const auto& [half_lux, ohms, reads] : {std::tuple{268.0f, "1.5 kΩ", "0.5 at 268 lx, 0.9 at 6,200 lx"},
                                                {60.0f, "4.3 kΩ", "0.5 at 60 lx, 0.9 at 1,400 lx"},
                                                {1e5f, "220 Ω", "0.5 at 4,200 lx"},
                                                {0.1f, "390 kΩ", "0.5 at 0.095 lx"}})
        for (const auto& [board, robot] : boards) {
            const Sensor eye{.name = "SL", .response = SensorResponse::photocell, .half_lux = half_lux};
            const robots::Robot& found = *robots::find_robot(robot);
            const auto files = robots::export_brain({"", make_graph({.LL = 1}), {eye}}, found.target, found);
            ASSERT_TRUE(files) << robot;
            EXPECT_NE(file_of(*files, "README.md").find(fmt::format("; {} from the input to ground", ohms)),
                      std::string::npos)
                << robot << half_lux;
            EXPECT_NE(file_of(*files, "parts.csv").find(fmt::format("1,\"resistor {}\"", ohms)), std::string::npos)
                << robot << half_lux;
            EXPECT_NE(file_of(*files, "wiring.svg").find(fmt::format(">{}<", ohms)), std::string::npos) << robot;
            if (board == Board::circuit) {
                EXPECT_NE(file_of(*files, "README.md").find(reads), std::string::npos) << half_lux;
            }
        }
}

TEST(SensorParts, WarnOfAPlaceBeyondTheChassisAndOfARangeThatThePartLacks) {
    using Ids = std::vector<std::string>;
    const auto warnings = [](const Sensor& sensor, const char* robot) {
        const robots::BrainToExport given{"", make_graph({.LL = 2}), {sensor}, 0.2f, 0.15f};
        const robots::Robot& found = *robots::find_robot(robot);
        const auto files = robots::export_brain(given, found.target, found);
        Ids ids;
        for (const Error& warning : robots::export_warnings(given, found)) {
            if (warning.phrases[0].id.starts_with("circuit_")) continue;
            ids.emplace_back(warning.phrases[0].id);
            EXPECT_NE(file_of(*files, "README.md").find("**Warning: " + warning.what + ".**"), std::string::npos)
                << robot;
        }
        return ids;
    };
    const Sensor far{.name = "SL", .channel = Channel::obstacle, .x = 0.45f, .range = 2.5f},
        aside{.name = "SL", .x = 0.05f, .y = -0.09f},
        near{.name = "SL", .channel = Channel::obstacle, .x = 0.1f, .range = 0.8f},
        between{.name = "SL", .channel = Channel::obstacle, .x = 0.1f, .range = 1.2f};
    for (const auto& [board, robot] : boards) {
        EXPECT_EQ(warnings(far, robot), (Ids{"part_beyond", "part_range"})) << robot;
        EXPECT_EQ(warnings(aside, robot), Ids{"part_beyond"}) << robot;
        EXPECT_EQ(warnings(near, robot), Ids{}) << robot;
        EXPECT_EQ(warnings(between, robot), board == Board::microbit ? Ids{} : Ids{"part_range"}) << robot;
    }
}

// No label of a part is wider than the room left of the board, whatever shows it.
TEST(SensorParts, HaveLabelsLeftOfTheBoardInTheWiring) {
    const std::regex text(R"re(<text x="20" y="\d+" text-anchor="start" class="small">([^<]*)<)re");
    each_part([&](const SensorPart& part, Board board, const auto& files, const std::string& which) {
        const std::string& drawing = file_of(files, board == Board::circuit ? "robot.svg" : "wiring.svg");
        std::string words;
        for (std::sregex_iterator found(drawing.begin(), drawing.end(), text), end; found != end; ++found) {
            words += (words.empty() ? "" : " ") + (*found)[1].str();
            EXPECT_LE((*found)[1].length(), 50) << which;
        }
        EXPECT_EQ(words, part.part) << which;
    });
}

TEST(SensorParts, OfEqualSensorsAreCounted) {
    const robots::Robot& uno = *robots::find_robot("tt2wd-ldr");
    const auto files = robots::export_brain({"", make_graph({.LL = 1, .RR = 1}), {}}, uno.target, uno);
    ASSERT_TRUE(files);
    const std::string& list = file_of(*files, "parts.csv");
    EXPECT_NE(list.find("2,\"photoresistor GL5528\",\"for sensors SL, SR\"\n"), std::string::npos) << list;
    EXPECT_NE(list.find("2,\"resistor 1.5 kΩ\",\"from the input to ground, of sensors SL, SR\"\n"), std::string::npos)
        << list;
}

}  // namespace
}  // namespace braitenlab::tests::sensor_parts_test

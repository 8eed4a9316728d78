// The parts of sensors: every file of an export has the same ones, and none brings more to a pin than it takes.
#include "core/export/sensor_parts.h"

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
    each_part([](const SensorPart& part, Board, const auto& files, const std::string& which) {
        const std::string &drawing = file_of(files, "wiring.svg"), &list = file_of(files, "parts.csv");
        EXPECT_EQ(xml_fault("<!DOCTYPE svg>\n" + drawing), "") << which;
        EXPECT_NE(file_of(files, "README.md").find("| " + robots::joining_text(part)), std::string::npos) << which;
        EXPECT_NE(drawing.find(part.part), std::string::npos) << which;
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

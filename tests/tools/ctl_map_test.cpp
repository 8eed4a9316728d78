// braitenctl map: output, files and messages.
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/insight/behaviour.h"
#include "tests/tools/ctl.h"

namespace braitenlab::tests::ctl_map_test {
namespace {

using namespace ctl_runs;

TEST(CtlMap, TheHelpDefinesEveryWordOfAMap) {
    const std::string help = ctl("map --help").out;
    for (const auto& row : insight::behaviour_table)
        EXPECT_NE(help.find("\n  " + std::string(row.word) + " "), std::string::npos) << row.word;
    for (const auto& row : insight::map_measure_table)
        EXPECT_NE(help.find("\n  " + std::string(row.word) + " "), std::string::npos) << row.word;
}

TEST(CtlMap, PrintsJsonThatDoesNotDependOnThreads) {
    const std::string arguments =
        "map 2b-aggressor --size 6 --x LL=RR=-1:1 --y kind.aggressor.brain.LR=RL=-1:1.5 --json";
    const Ran one = ctl(arguments + " --threads 1"), two = ctl(arguments + " --threads 3");
    EXPECT_EQ(one.code, 0);
    EXPECT_EQ(one.out, two.out);
    const Json map = Json::parse(one.out);
    EXPECT_EQ(keys(map), (std::set<std::string>{"scene", "x_path", "y_path", "x", "y", "measure", "cells"}));
    EXPECT_EQ(map["measure"], "kind");
    ASSERT_EQ(map["x"].size(), 6u);
    EXPECT_EQ(map["x"][0], -1.0);
    EXPECT_EQ(map["y"][5], 1.5);
    ASSERT_EQ(map["cells"].size(), 6u);
    EXPECT_EQ(map["cells"][5][2], "touches");  // crossed wires
    EXPECT_EQ(map["cells"][0][5], "flees");    // straight wires
}

TEST(CtlMap, PrintsALetterPerCellWithTheLargestYInTheFirstLine) {
    const Ran ran = ctl("map 2b-aggressor --size 6 --x LL=RR=-1:1 --y kind.aggressor.brain.LR=RL=-1:1.5");
    EXPECT_EQ(ran.code, 0);
    std::istringstream printed(ran.out);
    std::vector<std::string> rows(6);
    for (std::string& row : rows) std::getline(printed, row);
    EXPECT_EQ(rows[0].substr(0, 8), "    1.50");
    EXPECT_EQ(rows[5].substr(0, 8), "   -1.00");
    for (const std::string& row : rows) ASSERT_EQ(row.size(), 16u) << row;
    EXPECT_EQ(rows[0][10 + 2], 'T') << "crossed wires\n" << ran.out;
    EXPECT_EQ(rows[5][10 + 5], 'F') << "straight wires\n" << ran.out;
}

TEST(CtlMap, HasNumbersNullsAndShares) {
    const Json map = Json::parse(ctl("map 2b-aggressor --size 4 --measure touch --seeds 3 --json").out);
    EXPECT_TRUE(map["cells"][0][3].is_null());
    EXPECT_GT(map["cells"][3][2].get<double>(), 1);
    EXPECT_LE(map["agree"][0][0].get<double>(), 1);
}

TEST(CtlMap, WritesATableAndAPicture) {
    const std::string csv = scratch("map.csv"), png = scratch("map.png");
    EXPECT_EQ(ctl("map 2b-aggressor --size 4 --csv " + csv + " --png " + png).code, 0);
    std::ifstream table(csv), picture(png, std::ios::binary);
    std::string line;
    std::getline(table, line);
    EXPECT_EQ(line, "LL=RR,LR=RL,kind,agree,closest_m,final_m,touch_s,captures,survival_s");
    int rows = 0;
    while (std::getline(table, line)) ++rows;
    EXPECT_EQ(rows, 16);
    char head[8] = {};
    picture.read(head, sizeof head);
    EXPECT_EQ(std::string(head, 8), "\x89PNG\r\n\x1a\n");
    std::filesystem::remove(csv), std::filesystem::remove(png);
}

TEST(CtlMap, WritesADrawingWithAxesAndLegend) {
    const std::string svg = scratch("map.svg");
    const Ran kinds = ctl("map 2b-aggressor --size 8 --seconds 5 --seeds 2 --lang de --svg " + svg);
    EXPECT_EQ(kinds.code, 0) << kinds.out;
    EXPECT_EQ(kinds.out, "") << "the file has the map";
    std::string text = shell("cat " + svg).out;
    for (const char* part : {">Gewicht LR = RL</text>", ">Gewicht LL = RR</text>", ">das Gehirn der Szene</text>",
                             ">−1</text>", ">Verhalten</text>", "<title>"})
        EXPECT_NE(text.find(part), std::string::npos) << part;
    EXPECT_NE(text.find("2 Läufe von 5 s mit den Startwerten 1 bis 2"), std::string::npos);
    EXPECT_EQ(shell("python3 -c 'import sys, xml.dom.minidom as m; m.parse(sys.argv[1])' " + svg).code, 0);
    ASSERT_EQ(
        ctl("map 2b-aggressor --size 8 --seconds 5 --title 'Two eyes' --x-label 'angle (°)' --y-label 'mass (kg)' "
            "--svg " +
            svg)
            .code,
        0);
    text = shell("cat " + svg).out;
    for (const char* label : {">Two eyes</text>", ">angle (°)</text>", ">mass (kg)</text>"})
        EXPECT_NE(text.find(label), std::string::npos) << label << text;
    EXPECT_EQ(text.find("LL = RR"), std::string::npos) << text;
    ASSERT_EQ(ctl("map 2b-aggressor --size 2 --seconds 1 --x "
                  "kind.aggressor.sensor.SL.angle=-kind.aggressor.sensor.SR.angle=0:90 --svg " +
                  svg)
                  .code,
              0);
    EXPECT_NE(shell("cat " + svg).out.find(">sensor direction (°)</text>"), std::string::npos);
    ASSERT_EQ(ctl("map 2b-aggressor --size 8 --seconds 5 --measure touch --svg " + svg).code, 0);
    text = shell("cat " + svg).out;
    EXPECT_NE(text.find(">time to touch (s)</text>"), std::string::npos);
    EXPECT_NE(text.find(">never</text>"), std::string::npos);
    std::filesystem::remove(svg);
}

TEST(CtlMap, AxesOfADrawingHaveNamesAndUnitsInTheLanguage) {
    const std::string svg = scratch("map.svg");
    const auto drawn = [&](const std::string& arguments) {
        const Ran ran = ctl("map " + arguments + " --size 2 --seconds 1 --svg " + svg);
        EXPECT_EQ(ran.code, 0) << ran.out;
        return shell("cat " + svg).out;
    };
    const std::string mass = "2b-aggressor --x kind.aggressor.body.mass=5:20 --measure closest";
    const std::string english = drawn(mass), german = drawn(mass + " --lang de");
    for (const char* part : {">mass (kg)</text>", ">weight LR = RL</text>", ">Vehicle 2b: Aggressor</text>"})
        EXPECT_NE(english.find(part), std::string::npos) << part << english;
    for (const char* part : {">Masse (kg)</text>", ">Fahrzeug 2b: Angreifer</text>", ">kleinster Abstand (m)</text>"})
        EXPECT_NE(german.find(part), std::string::npos) << part << german;
    const std::string other = drawn("moth-and-hunter --x kind.moth.body.mass=5:20 --y kind.hunter.body.mass=5:20");
    for (const char* part : {">moth: mass (kg)</text>", ">hunter: mass (kg)</text>"})
        EXPECT_NE(other.find(part), std::string::npos) << part << other;
    EXPECT_NE(drawn("2b-aggressor --x kind.aggressor.body.width=0.3:0.6").find(">body.width</text>"), std::string::npos)
        << "a value without a name has its path";
    std::filesystem::remove(svg);
}

TEST(CtlMap, SaysWhatIsWrongWithAnArgument) {
    expect_refused("map 2b-aggressor --x LL=1", "an axis is PATH=A:B");
    expect_refused("map 2b-aggressor --x LX=0:1", "the nearest is 'LL'");
    expect_refused("map 2b-aggressor --x LL=-3:3", "from -2 to 2");
    expect_refused("map 2b-aggressor --x arena.gripp=0:1", "the nearest is 'arena.grip'");
    expect_refused("map 2b-aggressor --y LL=0:1", "both axes");
    expect_refused("map 2b-aggressor --measure kinds", "the nearest is 'kind'");
    expect_refused("map 2b-aggressor --size 1", "2 to 128");
    EXPECT_EQ(ctl("map 05-aggressor").code, 2);
}

}  // namespace
}  // namespace braitenlab::tests::ctl_map_test

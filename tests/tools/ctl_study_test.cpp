// braitenctl study: output, tables and messages.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/tools/ctl.h"

namespace braitenlab::tests::ctl_study_test {
namespace {

using namespace ctl_runs;

TEST(CtlStudy, PrintsMediansAndATableThatDoesNotDependOnThreads) {
    const std::string file = scratch("study.toml"), csv = scratch("study.csv");
    std::ofstream(file) << "format = 1\ntitle = \"T\"\nscene = \"2b-aggressor\"\nseconds = 10\nseeds = 3\n"
                           "measures = [\"touch\", \"contacts\"]\n[[value]]\nname = \"weight\"\n"
                           "paths = [\"kind.aggressor.brain.LR\", \"kind.aggressor.brain.RL\"]\nlevels = [0, 1]\n";
    const Ran one = ctl("study " + file + " --csv - --threads 1"), two = ctl("study " + file + " --csv - --threads 3");
    EXPECT_EQ(one.code, 0);
    EXPECT_EQ(one.out, two.out);
    EXPECT_EQ(one.out.substr(0, one.out.find('\n')), "run,seed,weight,touch_s,contacts");
    const Json summary = Json::parse(ctl("study " + file + " --json --csv " + csv).out);
    EXPECT_EQ(summary["runs"], 6);
    ASSERT_EQ(summary["results"].size(), 4u);
    EXPECT_TRUE(summary["results"][0]["median"].is_null());  // no wires: never
    EXPECT_GT(summary["results"][2]["median"].get<double>(), 1);
    EXPECT_EQ(summary["results"][2]["paired"]["below"], 3);
    std::ifstream table(csv);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(table), {}), one.out);
    EXPECT_EQ(summary["results"][0]["present"], 0);
    EXPECT_EQ(summary["results"][2]["present"], 3);
    const std::string text = ctl("study " + file).out;
    EXPECT_TRUE(std::regex_search(text, std::regex("touch \\(s\\) +of 3 +median"))) << text;
    EXPECT_TRUE(std::regex_search(text, std::regex("weight 0 +0 +never"))) << text;
    EXPECT_TRUE(std::regex_search(text, std::regex("weight 1 +3 .+ – +0 +3\n"))) << "no pair of numbers\n" << text;
    EXPECT_EQ(text.find("nan"), std::string::npos) << text;
    EXPECT_NE(text.find("count never as the longest"), std::string::npos) << text;
    std::filesystem::remove(file), std::filesystem::remove(csv);
}

TEST(CtlStudy, DrawsMediansAndQuartilesWithNamedAxes) {
    const std::string file = scratch("drawn-study.toml"), svg = scratch("study.svg");
    std::ofstream(file) << "format = 1\ntitle = \"Weight & eyes\"\nscene = \"2b-aggressor\"\nseconds = 5\nseeds = 4\n"
                           "measures = [\"final\", \"contacts\"]\n[[value]]\nname = \"weight\"\n"
                           "paths = [\"kind.aggressor.brain.LR\"]\nlevels = [0, 0.5, 1]\n[[value]]\nname = \"speed\"\n"
                           "unit = \"m/s\"\npaths = [\"kind.aggressor.body.top_speed\"]\nlevels = [1, 2]\n";
    const std::string command = "study " + file + " --svg " + svg;
    const Ran ran = ctl(command);
    ASSERT_EQ(ran.code, 0) << ran.out;
    std::string text = shell("cat " + svg).out;
    for (const char* part :
         {">Weight &amp; eyes</text>", ">weight</text>", ">final distance (m)</text>", ">contacts</text>",
          ">speed 1 m/s</text>", ">speed 2 m/s</text>", "medians of 4 runs", ">0.5</text>"})
        EXPECT_NE(text.find(part), std::string::npos) << part;
    std::size_t dots = 0;
    for (std::size_t at = 0; (at = text.find("<circle", at)) != std::string::npos; ++at) ++dots;
    EXPECT_EQ(dots, 12U) << "two measures of six combinations";
    EXPECT_EQ(text.find("nan"), std::string::npos);
    EXPECT_EQ(shell("python3 -c 'import sys, xml.dom.minidom as m; m.parse(sys.argv[1])' " + svg).code, 0);
    ASSERT_EQ(ctl(command + " --lang de --title Mine --x-label 'w (1)' --y-label 'd (m)'").code, 0);
    text = shell("cat " + svg).out;
    for (const char* part : {">Mine</text>", ">w (1)</text>", ">d (m)</text>", "Mediane aus 4", ">0,5</text>"})
        EXPECT_NE(text.find(part), std::string::npos) << part;
    std::ofstream(file, std::ios::app) << "[axis]\nx = \"Weight of LR\"\ny = \"Distance (m)\"\n";
    ASSERT_EQ(ctl(command + " --x-label w").code, 0);
    text = shell("cat " + svg).out;
    for (const char* part : {">w</text>", ">Distance (m)</text>", ">contacts</text>"})
        EXPECT_NE(text.find(part), std::string::npos) << part << ": an option goes before the file";
    expect_refused("study " + file + " --svg a.png", ".svg");
    std::filesystem::remove(file), std::filesystem::remove(svg);
}

TEST(CtlStudy, AFigureCountsTheRunsThatNeverComeToTheMeasureAboveItsFrame) {
    const std::string file = scratch("empty-study.toml"), svg = scratch("empty-study.svg");
    std::ofstream(file) << "format = 1\ntitle = \"T\"\nscene = \"2b-aggressor\"\nseconds = 5\nseeds = 2\n"
                           "measures = [\"touch\"]\n[[value]]\nname = \"weight\"\n"
                           "paths = [\"kind.aggressor.brain.LR\", \"kind.aggressor.brain.RL\"]\nlevels = [-1, 1.5]\n"
                           "[[value]]\nname = \"drive\"\npaths = [\"kind.aggressor.brain.LM\"]\nlevels = [-0.1, 0.1]\n";
    for (const auto& [language, words, caption] : {std::tuple{"en", ">never</text>", "never: number of the 2 runs"},
                                                   {"de", ">nie</text>", "nie: Zahl der 2 Läufe"},
                                                   {"es", ">nunca</text>", "nunca: número de las 2"}}) {
        const Ran ran = ctl("study " + file + " --svg " + svg + " --lang " + language);
        ASSERT_EQ(ran.code, 0) << ran.out;
        const std::string text = shell("cat " + svg).out;
        EXPECT_NE(text.find(words), std::string::npos) << text;
        EXPECT_NE(text.find("fill=\"#fff\" stroke=\"#0072b2\""), std::string::npos) << "the ring of its series";
        EXPECT_NE(text.find("drive −0"), std::string::npos) << "a minus, no hyphen";
        EXPECT_NE(text.find(caption), std::string::npos) << "what the strip is";
        EXPECT_NE(text.find(">2</text>"), std::string::npos) << "all runs of the combination that turns away";
        std::smatch ring;
        ASSERT_TRUE(std::regex_search(text, ring, std::regex("<circle cx=\"([0-9.]+)\"[^>]* r=\"3.5\"")));
        EXPECT_EQ(ring[1], "23.6") << "at the first level";
        EXPECT_EQ(text.find("no value"), std::string::npos);
        EXPECT_EQ(shell("python3 -c 'import sys, xml.dom.minidom as m; m.parse(sys.argv[1])' " + svg).code, 0);
    }
    std::filesystem::remove(file), std::filesystem::remove(svg);
}

TEST(CtlStudy, AFigureHasTheWordsOfTheTablePointsAtTheirLevelsAndBarsSideBySide) {
    const std::string file = scratch("drawn-study.toml"), svg = scratch("study.svg");
    std::ofstream(file) << "format = 1\ntitle = \"T\"\nscene = \"predator-prey\"\nseconds = 1\nseeds = 2\n"
                           "measures = [\"captures\"]\n[[value]]\nname = \"eyes\"\nunit = \"°\"\n"
                           "paths = [\"kind.prey.sensor.SL.angle\"]\nlevels = [80, 110, 130]\n[[value]]\n"
                           "name = \"speed\"\nunit = \"m/s\"\npaths = [\"kind.prey.body.top_speed\"]\n"
                           "levels = [3.0, 3.9]\n";
    const Ran ran = ctl("study " + file + " --svg " + svg);
    ASSERT_EQ(ran.code, 0) << ran.out;
    const std::string text = shell("cat " + svg).out;
    EXPECT_NE(text.find(">captures</text>"), std::string::npos) << text;
    std::vector<float> places;
    for (std::size_t at = 0; (at = text.find("<circle cx=\"", at)) != std::string::npos; ++at)
        places.push_back(std::stof(text.substr(at + 12)));
    ASSERT_EQ(places.size(), 6U);
    std::sort(places.begin(), places.end());
    for (std::size_t i = 0; i < places.size(); i += 2) EXPECT_EQ(places[i], places[i + 1]) << "of the same level";
    for (std::size_t i = 2; i < places.size(); i += 2) EXPECT_GT(places[i] - places[i - 2], 8.5f) << "points of 8 px";
    std::vector<float> bars;
    const std::regex bar("M([0-9.]+) [0-9.]+V");
    for (std::sregex_iterator at(text.begin(), text.end(), bar), end; at != end; ++at)
        bars.push_back(std::stof((*at)[1]));
    std::erase_if(bars, [&](float x) { return x < places.front() - 8 || x > places.back() + 8; });
    ASSERT_EQ(bars.size(), 6U);
    std::sort(bars.begin(), bars.end());
    for (std::size_t i = 1; i < bars.size(); ++i) EXPECT_GT(bars[i] - bars[i - 1], 4) << "beside each other";
    EXPECT_EQ(ctl("study " + file + " --csv -").out.substr(0, 36), "run,seed,eyes_deg,speed_m_s,captures");
    std::filesystem::remove(file), std::filesystem::remove(svg);
}

TEST(CtlStudy, NamesTheNearestStudyAndTheLineOfAnError) {
    EXPECT_NE(ctl("study prey-eye").out.find("'prey-eyes'"), std::string::npos);
    const std::string file = scratch("bad-study.toml");
    std::ofstream(file) << "format = 1\ntitle = \"T\"\nscene = \"2b-aggressor\"\nmeasures = [\"tuch\"]\n[[value]]\n"
                           "name = \"m\"\npaths = [\"arena.grip\"]\nlevels = [1]\n";
    const Ran ran = ctl("study " + file);
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.out.find("bad-study.toml:4: there is no measure 'tuch'; the nearest is 'touch'"), std::string::npos);
    std::ofstream(file) << "format = 1\ntitle = \"T\"\nscene = \"2b-aggressor\"\nmeasures = [\"touch\"]\n[[value]]\n"
                           "name = \"m\"\npaths = [\"arena.grip\",\n\"arena.gripp\"]\nlevels = [1]\n";
    const std::string path = ctl("study " + file).out;
    EXPECT_NE(path.find("bad-study.toml:8: no such value 'arena.gripp'; the nearest is 'arena.grip'"),
              std::string::npos)
        << path;
    std::ofstream(file) << "format = 1\ntitle = \"T\"\nscene = \"2b-aggressor\"\nmeasures = [\"touch\"]\n[value]\n"
                           "name = \"m\"\n";
    const std::string single = ctl("study " + file).out;
    EXPECT_NE(single.find("bad-study.toml:5: write [[value]] instead of [value]"), std::string::npos) << single;
    std::filesystem::remove(file);
}

TEST(CtlStudy, NamesEveryErrorOfAStudyAndOfItsPathsByLine) {
    const std::string file = scratch("errors-study.toml");
    std::ofstream(file) << "format = 1\ntitle = \"T\"\nscene = \"2b-aggressor\"\nseconds = 0\nmeasures = [\"tuch\",\n"
                           "\"final\", \"finale\"]\n[[value]]\nname = \"m\"\npaths = [\"arena.gripp\"]\nlevels = [1]\n"
                           "[[value]]\nnmae = \"n\"\npaths = [\"kind.aggressor.body.mass\"]\nlevels = [5, 5000]\n"
                           "[[value]]\nname = \"m\"\npaths = [\"arena.grip\"]\n";
    const Ran ran = ctl("study " + file);
    EXPECT_EQ(ran.code, 2);
    std::vector<int> lines;
    std::istringstream in(ran.out);
    for (std::string line; std::getline(in, line);) {
        const std::size_t at = line.find("errors-study.toml:");
        ASSERT_NE(at, line.npos) << ran.out;
        lines.push_back(std::stoi(line.substr(at + 18)));
    }
    EXPECT_EQ(lines, (std::vector{4, 5, 6, 9, 12, 13, 15, 16})) << ran.out;
    std::ofstream(file) << "format = 1\ntitel = \"T\"\nscene = \"2b-agressor\"\n";
    const std::string out = ctl("study " + file).out;
    EXPECT_NE(out.find("'titel'"), out.npos) << out;
    EXPECT_EQ(out.find("'title' is missing"), out.npos) << "it is misspelt: " << out;
    for (const char* words : {"'measures' is missing", "'value' is missing", "2b-aggressor"})
        EXPECT_NE(out.find(words), out.npos) << words << out;
    std::filesystem::remove(file);
}

}  // namespace
}  // namespace braitenlab::tests::ctl_study_test

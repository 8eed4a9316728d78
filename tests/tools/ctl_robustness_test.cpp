// braitenctl robustness: robots with the figures of a workshop, on any number of threads.
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "tests/tools/ctl.h"

namespace braitenlab::tests::ctl_robustness_test {
namespace {

using namespace ctl_runs;

TEST(CtlRobustness, PrintsTheSameRobotsOnAnyNumberOfThreads) {
    const std::string arguments = "robustness 2b-aggressor --robots 6 --reality 2 --seed 4 --json";
    const Ran one = ctl(arguments + " --threads 1"), two = ctl(arguments + " --threads 3");
    EXPECT_EQ(one.code, 0);
    EXPECT_EQ(one.out, two.out);
    const Json json = Json::parse(one.out);
    EXPECT_EQ(keys(json), (std::set<std::string>{"scene", "reality", "robots", "working", "share", "weakest", "figures",
                                                 "ideal", "each"}));
    EXPECT_EQ(json["scene"], "2b-aggressor");
    ASSERT_EQ(json["each"].size(), 6u);
    EXPECT_EQ(json["each"][0]["seed"], 4);
    EXPECT_EQ(json["each"][5]["seed"], 9);
    EXPECT_EQ(json["ideal"]["kind"], "touches");
    EXPECT_EQ(json["figures"]["mismatch"], 0.2) << "a typical robot, twice as real";
    int working = 0;
    for (const Json& robot : json["each"]) working += robot["works"].get<bool>() ? 1 : 0;
    EXPECT_EQ(json["working"], working);
    EXPECT_NE(json["each"][0]["closest_m"], json["each"][1]["closest_m"]);
    const Json ideal = Json::parse(ctl("robustness 2b-aggressor --robots 3 --reality 0 --json").out);
    EXPECT_EQ(ideal["share"], 1.0);
    EXPECT_EQ(ideal["each"][2]["closest_m"], ideal["ideal"]["closest_m"]);
}

TEST(CtlRobustness, NamesTheStepThatARobotFailsInAnExercise) {
    const Json solved = Json::parse(ctl("robustness 21-reality --robots 6 --json").out);
    EXPECT_EQ(solved["exercise"], "21-reality");
    EXPECT_GE(solved["working"].get<int>(), 5);
    const std::string file = scratch("straight.toml");
    std::ofstream(file) << "format = 1\n[brain]\nLM = 0.2\nRM = 0.2\n";
    const std::string csv = scratch("robots.csv");
    EXPECT_EQ(ctl("robustness 21-reality --robots 6 --brain " + file + " --csv " + csv).code, 0);
    std::ifstream table(csv);
    std::string line;
    std::getline(table, line);
    EXPECT_EQ(line, "robot,seed,works,kind,failed_step,seconds,closest_m,final_m");
    int rows = 0, failed = 0;
    while (std::getline(table, line)) ++rows, failed += std::regex_search(line, std::regex("^\\d+,\\d+,0,\\w+,[12],"));
    EXPECT_EQ(rows, 6);
    EXPECT_GE(failed, 4) << "without wires";
    std::filesystem::remove(file), std::filesystem::remove(csv);
}

TEST(CtlRobustness, SaysWhatIsWrongWithAnArgument) {
    expect_refused("robustness 2b-aggressor --reality 3", "0 (ideal) to 2");
    expect_refused("robustness 2b-aggressor --robots 0", "1 to 1000 robots");
    expect_refused("robustness 2b-aggressor --vehicle two", "no vehicle 'two'");
    expect_refused("robustness 2b-aggressor --brain a.toml", "needs an exercise");
    expect_refused("robustness 05-aggressor --set arena.width=9", "this is an exercise");
    expect_refused("robustness 2b-agressor", "2b-aggressor");
}

}  // namespace
}  // namespace braitenlab::tests::ctl_robustness_test

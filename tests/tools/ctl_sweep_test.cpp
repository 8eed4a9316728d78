// braitenctl run with several values or seeds: the one table of all runs.
#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/tools/ctl.h"

namespace braitenlab::tests::ctl_sweep_test {
namespace {

using namespace ctl_runs;

TEST(CtlSweep, WritesOneTableOfAllCombinationsAndSeeds) {
    const std::string fixed = "run 2a-coward --seconds 0.2 --csv - ";
    const Ran ran = ctl(fixed + "--set kind.coward.brain.LL=0:1:0.5 --set source.lamp.x=3,-3 --seed 4:5");
    ASSERT_EQ(ran.code, 0) << ran.out;
    std::istringstream lines(ran.out);
    std::string line, runs;
    std::getline(lines, line);
    EXPECT_TRUE(line.starts_with("run,seed,kind.coward.brain.LL,source.lamp.x,seconds,id,kind,role,x_m,")) << line;
    while (std::getline(lines, line))
        if (line.find(",0.10000,0,coward,") != std::string::npos) runs += line.substr(0, line.find(",0.10000,")) + " ";
    EXPECT_EQ(
        runs,
        "1,4,0.0,3 2,5,0.0,3 3,4,0.0,-3 4,5,0.0,-3 5,4,0.5,3 6,5,0.5,3 7,4,0.5,-3 8,5,0.5,-3 9,4,1.0,3 10,5,1.0,3 "
        "11,4,1.0,-3 12,5,1.0,-3 ");
}

TEST(CtlSweep, ARunOfASweepHasTheRowsOfTheSingleRun) {
    const std::string fixed = "run predator-prey --seconds 3 --columns sensors --csv - ";
    const std::string single = ctl(fixed + "--set kind.prey.brain.LL=0.5 --seed 3").out;
    const std::string sweep = ctl(fixed + "--set kind.prey.brain.LL=1,0.5 --seed 2:3").out;
    std::istringstream lines(sweep);
    std::string line, fourth;
    std::getline(lines, line);
    const std::string first = "run,seed,kind.prey.brain.LL,", cells = "4,3,0.5,";
    ASSERT_TRUE(line.starts_with(first));
    fourth = line.substr(first.size()) + "\n";
    while (std::getline(lines, line))
        if (line.starts_with(cells)) fourth += line.substr(cells.size()) + "\n";
    EXPECT_EQ(fourth, single);
}

TEST(CtlSweep, TheTableOfASweepDoesNotDependOnTheNumberOfThreads) {
    const std::string sweep = "run predator-prey --seconds 1 --seed 1:30 --csv - --threads ";
    const Ran one = ctl(sweep + "1");
    EXPECT_EQ(one.code, 0);
    EXPECT_EQ(std::ranges::count(one.out, '\n'), 1 + 30 * 11 * 20);
    EXPECT_EQ(ctl(sweep + "2").out, one.out);
    EXPECT_EQ(ctl(sweep + "5").out, one.out);
}

TEST(CtlSweep, ABadValueOfASweepIsReportedBeforeTheFirstRun) {
    const auto expect_no_table = [&](const std::string& arguments, const std::string& message) {
        const Ran ran = ctl("run 2a-coward --seconds 1 --csv - " + arguments);
        EXPECT_EQ(ran.code, 2) << arguments;
        EXPECT_NE(ran.out.find(message), std::string::npos) << ran.out;
        EXPECT_EQ(ran.out.find("run,seed"), std::string::npos) << "the table was begun";
    };
    expect_no_table("--set kind.coward.brain.LX=1,2", "no such value 'kind.coward.brain.LX'; the nearest is");
    expect_no_table("--set kind.coward.brain.LL=1:3:1", "--set: 'LL' is 3, outside -2 .. 2");
    expect_no_table("--set kind.coward.brain.LL=1:0:1", "--set kind.coward.brain.LL=1:0:1: the step leads away");
    expect_no_table("--set kind.coward.brain.LL=1,lots", "--set: 'LL' should be a number");
    EXPECT_NE(ctl("run 2a-coward --seed 1:2 --csv /dev/null --json").out.find("leave out --json"), std::string::npos);
}

TEST(CtlSweep, ASweepNeedsATableAndAScene) {
    const Ran ran = ctl("run 2a-coward --seconds 1 --seed 1:3");
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.out.find("these are 3 runs; add --csv FILE"), std::string::npos) << ran.out;
    const std::string saved = scratch("sweep.run");
    ASSERT_EQ(ctl("run 2a-coward --seconds 1 --save " + saved).code, 0);
    const Ran of_a_run = ctl("run " + saved + " --seed 1:3 --csv -");
    EXPECT_EQ(of_a_run.code, 2);
    EXPECT_NE(of_a_run.out.find("a saved run has its own seed"), std::string::npos) << of_a_run.out;
    std::filesystem::remove(saved);
}

TEST(CtlSweep, ASweepLeavesNoFileIfItIsInterrupted) {
    const std::filesystem::path folder = scratch("interrupted-sweep");
    std::filesystem::create_directory(folder);
    const Ran ran = shell(BRAITENLAB_BINARY "/braitenctl run predator-prey --seconds 100000 --seed 1:9 --csv " +
                          (folder / "a.csv").string() + " & ran=$!; until [ -n \"$(ls -A " + folder.string() +
                          ")\" ]; do sleep 0.1; done; sleep 0.2; kill -TERM $ran; wait $ran");
    EXPECT_EQ(ran.code, 130) << ran.out;
    EXPECT_TRUE(std::filesystem::is_empty(folder));
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace braitenlab::tests::ctl_sweep_test

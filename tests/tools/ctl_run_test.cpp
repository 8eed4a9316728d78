// braitenctl run: JSON, hashes, tables and saved runs.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/tools/ctl.h"

namespace braitenlab::tests::ctl_run_test {
namespace {

using namespace ctl_runs;

TEST(CtlRun, PrintsJsonOfAFixedShape) {
    const Json run = Json::parse(ctl("run 2b-aggressor --seconds 2 --seed 4 --json").out);
    EXPECT_EQ(keys(run), (std::set<std::string>{"scene", "seed", "ticks", "seconds", "hash", "generation", "population",
                                                "predators", "prey", "events", "sources", "vehicles"}));
    EXPECT_EQ(keys(run["events"]), (std::set<std::string>{"captures", "deaths", "births", "contacts"}));
    EXPECT_EQ(keys(run["sources"][0]), (std::set<std::string>{"id", "channel", "x", "y"}));
    EXPECT_EQ(keys(run["vehicles"][0]),
              (std::set<std::string>{"id", "kind", "role", "x", "y", "heading", "speed", "energy", "left", "right",
                                     "sensors", "neurons", "learned"}));
    EXPECT_EQ(run["scene"], "2b-aggressor");
    EXPECT_EQ(run["ticks"], 120);
    EXPECT_EQ(run["seconds"], 2);
    EXPECT_EQ(run["vehicles"][0]["role"], "none");
    EXPECT_EQ(run["vehicles"][0]["sensors"].size(), 2u);
    EXPECT_EQ(run["hash"].get<std::string>().size(), 16u);
}

TEST(CtlRun, SetsValuesAndNamesTheNearestPathOfAnUnknownOne) {
    const Json few = Json::parse(ctl("run predator-prey --seconds 0 --set ecology.population=3 --json").out);
    EXPECT_EQ(few["population"], 3);
    const Ran wrong = ctl("run predator-prey --seconds 0 --set kind.prey.brain.LX=1");
    EXPECT_EQ(wrong.code, 2);
    EXPECT_NE(wrong.out.find("kind.prey.brain.L"), std::string::npos) << wrong.out;
}

TEST(CtlRun, PrintsAHashThatDependsOnTheSeed) {
    const std::string a = ctl("run predator-prey --seconds 5 --seed 1 --hash").out;
    EXPECT_EQ(ctl("run predator-prey --seconds 5 --seed 1 --hash").out, a);
    EXPECT_NE(ctl("run predator-prey --seconds 5 --seed 2 --hash").out, a);
}

TEST(CtlRun, WritesACsvRowPerVehiclePerTenthOfASecond) {
    const std::filesystem::path file = scratch("run.csv");
    ASSERT_EQ(ctl("run predator-prey --seconds 2 --csv " + file.string()).code, 0);
    std::ifstream csv(file);
    std::string line;
    std::getline(csv, line);
    EXPECT_EQ(line, "seconds,id,kind,role,x_m,y_m,heading_rad,speed_m_s,energy,left,right");
    int rows = 0;
    while (std::getline(csv, line)) ++rows;
    EXPECT_EQ(rows, 21 * 20);
    std::filesystem::remove(file);
}

TEST(CtlRun, AddsTheColumnsThatAreAskedFor) {
    const std::filesystem::path file = scratch("columns.csv");
    ASSERT_EQ(ctl("run 7-mnemotrix --seconds 1 --columns learned,sensors --csv " + file.string()).code, 0);
    std::ifstream csv(file);
    std::string header, row;
    std::getline(csv, header), std::getline(csv, row);
    EXPECT_NE(header.find(",right,sensor_SL,"), std::string::npos) << header;
    EXPECT_TRUE(header.ends_with(",learned_SEES>FEAR")) << header;
    EXPECT_EQ(std::ranges::count(row, ','), std::ranges::count(header, ','));
    std::filesystem::remove(file);
}

TEST(CtlRun, NamesTheNearestWordOfUnknownColumns) {
    const Ran wrong = ctl("run 2a-coward --seconds 0 --columns sensor --csv /dev/null");
    EXPECT_EQ(wrong.code, 2);
    EXPECT_NE(wrong.out.find("--columns: there are no columns 'sensor'; the nearest is 'sensors'"), std::string::npos)
        << wrong.out;
    EXPECT_EQ(ctl("run 2a-coward --seconds 0 --columns sensors").code, 2) << "there is no table";
}

TEST(CtlRun, WritesTheTableAloneToStandardOutput) {
    const std::filesystem::path file = scratch("same.csv");
    ASSERT_EQ(ctl("run predator-prey --seconds 1 --csv " + file.string()).code, 0);
    std::ifstream csv(file);
    const std::string text{std::istreambuf_iterator<char>(csv), {}};
    const Ran ran = ctl("run predator-prey --seconds 1 --csv -");
    EXPECT_EQ(ran.code, 0);
    EXPECT_EQ(ran.out, text);
    EXPECT_EQ(ctl("run 2a-coward --seconds 1 --csv - --json").code, 2);
    EXPECT_EQ(ctl("run 2a-coward --seconds 1 --csv - --hash").code, 2);
    EXPECT_FALSE(std::filesystem::exists("-"));
    std::filesystem::remove(file);
}

// The program is interrupted once it has written the beginning of its temporary file.
TEST(CtlRun, LeavesNoFileIfItIsInterrupted) {
    const std::filesystem::path folder = scratch("interrupted");
    std::filesystem::create_directory(folder);
    const Ran ran = shell(BRAITENLAB_BINARY "/braitenctl run predator-prey --seconds 100000 --csv " +
                          (folder / "a.csv").string() + " & ran=$!; until [ -n \"$(find " + folder.string() +
                          " -size +0 -type f)\" ]; do sleep 0.1; done; kill -TERM $ran; wait $ran");
    EXPECT_EQ(ran.code, 130) << ran.out;
    EXPECT_TRUE(std::filesystem::is_empty(folder));
    std::filesystem::remove_all(folder);
}

TEST(CtlRun, FailsIfTheCsvFileCannotBeWritten) {
    const Ran ran = ctl("run 2a-coward --seconds 1 --csv /nowhere/at/all.csv");
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.out.find("/nowhere/at/all.csv"), std::string::npos);
    if (std::filesystem::exists("/dev/full")) {
        EXPECT_EQ(ctl("run 2a-coward --seconds 1 --csv /dev/full").code, 2);
    }
}

// A limit on the size of files simulates a full disk.
TEST(CtlRun, KeepsTheOldCsvFileIfTheDiskIsFull) {
    const std::string file = scratch("old.csv");
    std::ofstream(file) << "old";
    const std::string command = "run predator-prey --seconds 60 --csv " + file;
    EXPECT_EQ(shell("trap '' XFSZ; ulimit -f 4; " BRAITENLAB_BINARY "/braitenctl " + command).code, 2);
    std::ifstream csv(file);
    std::string text;
    std::getline(csv, text);
    EXPECT_EQ(text, "old");
    std::filesystem::remove(file);
}

TEST(CtlRun, SaysWhatToDoWithAFileThatIsNoScene) {
    for (const char* file : {"05-aggressor", "four-numbers"})
        for (const char* more : {"", " --seed 1:2 --csv /dev/null"}) {
            const Ran ran = ctl(std::string("run ") + file + more);
            EXPECT_EQ(ran.code, 2) << file;
            EXPECT_NE(ran.out.find("takes a scene or a saved run; use 'check'"), std::string::npos) << ran.out;
        }
    const Ran exercise = ctl("run 05-aggressor");
    EXPECT_NE(exercise.out.find("this is an exercise"), std::string::npos) << exercise.out;
    const Ran lecture = ctl("show four-numbers");
    EXPECT_EQ(lecture.code, 2);
    EXPECT_NE(lecture.out.find("this is a lecture"), std::string::npos) << lecture.out;
}

TEST(CtlRun, DoesNotSaveToAPipe) {
    const std::string pipe = scratch("pipe.run");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_EQ(ctl("run 2a-coward --seconds 1 --save " + pipe).code, 2);
    EXPECT_TRUE(std::filesystem::is_fifo(pipe));
    std::filesystem::remove(pipe);
}

TEST(CtlRun, ContinuesASavedRunExactly) {
    const std::string file = scratch("hunt.run");
    ASSERT_EQ(ctl("run predator-prey --seconds 7 --seed 3 --save " + file).code, 0);
    const Ran on = ctl("run " + file + " --seconds 8 --hash");
    EXPECT_EQ(on.code, 0) << on.out;
    EXPECT_EQ(on.out, ctl("run predator-prey --seconds 15 --seed 3 --hash").out);
    EXPECT_NE(ctl("show " + file).out.find("7.0 s"), std::string::npos);
    EXPECT_EQ(ctl("run " + file + " --seed 4").code, 2);
    EXPECT_EQ(ctl("run 2a-coward --seconds 1 --save /dev/null/a.run").code, 2);
    std::filesystem::remove(file);
}

}  // namespace
}  // namespace braitenlab::tests::ctl_run_test

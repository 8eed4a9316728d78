// The command-line tool: output, files and exit codes.
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include "core/io/run_file.h"
#include "core/scene/scene_file.h"
#include "core/world/world.h"
#include "tests/tools/ctl.h"

namespace braitenlab::tests::braitenctl_test {
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

TEST(CtlPicture, WritesDrawingsAndRefusesWhatItCannotDraw) {
    const std::string wiring = scratch("wiring.svg"), paths = scratch("paths.svg");
    const Ran both = ctl("picture 3a-love --wiring " + wiring + " --paths " + paths + " --seconds 3 --lang es");
    EXPECT_EQ(both.code, 0) << both.out;
    EXPECT_NE(shell("cat " + wiring).out.find("kind lover"), std::string::npos);
    EXPECT_NE(shell("cat " + paths).out.find("0,0 s a 3,0 s"), std::string::npos);
    for (const std::string& file : {wiring, paths}) {
        EXPECT_EQ(shell("python3 -c 'import sys, xml.dom.minidom as m; m.parse(sys.argv[1])' " + file).code, 0) << file;
        std::filesystem::remove(file);
    }
    EXPECT_EQ(ctl("picture 3a-love").code, 2) << "nothing to draw";
    const Ran exercise = ctl("picture 05-aggressor --paths " + paths);
    EXPECT_EQ(exercise.code, 2);
    EXPECT_NE(exercise.out.find("takes a scene"), std::string::npos) << exercise.out;
    EXPECT_FALSE(std::filesystem::exists(paths));
}

TEST(CtlHashes, NamesEachFileWhoseHashDiffers) {
    const std::filesystem::path file = scratch("hashes.json");
    ASSERT_EQ(ctl("hashes --seconds 0 > " + file.string()).code, 0);
    EXPECT_EQ(ctl("hashes --seconds 0 --compare " + file.string()).code, 0);
    std::ifstream in(file);
    Json hashes = Json::parse(in);
    EXPECT_TRUE(hashes.contains("2a-coward") && hashes.contains("05-aggressor")) << "scenes and exercises";
    hashes["2a-coward"] = "0123456789abcdef";
    std::ofstream(file) << hashes;
    const Ran compared = ctl("hashes --seconds 0 --compare " + file.string());
    EXPECT_EQ(compared.code, 1);
    EXPECT_TRUE(compared.out.starts_with("2a-coward: ")) << compared.out;
    EXPECT_NE(compared.out.find(", expected 0123456789abcdef\n"), std::string::npos) << compared.out;
    std::filesystem::remove(file);
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

TEST(CtlRun, FailsIfStandardOutputCannotBeWritten) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP();
    const Ran ran = ctl("run 2a-coward --seconds 1 --csv - > /dev/full");
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.out.find("--csv -: standard output could not be written"), std::string::npos) << ran.out;
}

TEST(CtlRun, WritesOneTableOfAllCombinationsAndSeeds) {
    const std::string fixed = "run 2a-coward --seconds 0.2 --csv - ";
    const Ran ran = ctl(fixed + "--set kind.coward.brain.LL=0:1:0.5 --set source.lamp.x=3,-3 --seed 4:5");
    ASSERT_EQ(ran.code, 0) << ran.out;
    std::istringstream lines(ran.out);
    std::string line, runs;
    std::getline(lines, line);
    EXPECT_TRUE(line.starts_with("run,seed,kind.coward.brain.LL,source.lamp.x,seconds,id,kind,role,x_m,")) << line;
    while (std::getline(lines, line))
        if (line.find(",0.10000,0,coward,") != std::string::npos) runs += line.substr(0, line.find(",0.10000,")) + " ";
    EXPECT_EQ(runs,
              "1,4,0,3 2,5,0,3 3,4,0,-3 4,5,0,-3 5,4,0.5,3 6,5,0.5,3 7,4,0.5,-3 8,5,0.5,-3 9,4,1,3 10,5,1,3 "
              "11,4,1,-3 12,5,1,-3 ");
}

TEST(CtlRun, ARunOfASweepHasTheRowsOfTheSingleRun) {
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

TEST(CtlRun, TheTableOfASweepDoesNotDependOnTheNumberOfThreads) {
    const std::string sweep = "run predator-prey --seconds 1 --seed 1:30 --csv - --threads ";
    const Ran one = ctl(sweep + "1");
    EXPECT_EQ(one.code, 0);
    EXPECT_EQ(std::ranges::count(one.out, '\n'), 1 + 30 * 11 * 20);
    EXPECT_EQ(ctl(sweep + "2").out, one.out);
    EXPECT_EQ(ctl(sweep + "5").out, one.out);
}

TEST(CtlRun, ABadValueOfASweepIsReportedBeforeTheFirstRun) {
    const auto expect_refused = [&](const std::string& arguments, const std::string& message) {
        const Ran ran = ctl("run 2a-coward --seconds 1 --csv - " + arguments);
        EXPECT_EQ(ran.code, 2) << arguments;
        EXPECT_NE(ran.out.find(message), std::string::npos) << ran.out;
        EXPECT_EQ(ran.out.find("run,seed"), std::string::npos) << "the table was begun";
    };
    expect_refused("--set kind.coward.brain.LX=1,2", "no such value 'kind.coward.brain.LX'; the nearest is");
    expect_refused("--set kind.coward.brain.LL=1:3:1", "--set: 'LL' is 3, outside -2 .. 2");
    expect_refused("--set kind.coward.brain.LL=1:0:1", "--set kind.coward.brain.LL=1:0:1: the step leads away");
    expect_refused("--set kind.coward.brain.LL=1,lots", "--set: 'LL' should be a number");
    EXPECT_NE(ctl("run 2a-coward --seed 1:2 --csv /dev/null --json").out.find("leave out --json"), std::string::npos);
}

TEST(CtlRun, ASweepNeedsATableAndAScene) {
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

TEST(CtlRun, ASweepLeavesNoFileIfItIsInterrupted) {
    const std::filesystem::path folder = scratch("interrupted-sweep");
    std::filesystem::create_directory(folder);
    const Ran ran = shell(BRAITENLAB_BINARY "/braitenctl run predator-prey --seconds 100000 --seed 1:9 --csv " +
                          (folder / "a.csv").string() + " & ran=$!; until [ -n \"$(ls -A " + folder.string() +
                          ")\" ]; do sleep 0.1; done; sleep 0.2; kill -TERM $ran; wait $ran");
    EXPECT_EQ(ran.code, 130) << ran.out;
    EXPECT_TRUE(std::filesystem::is_empty(folder));
    std::filesystem::remove_all(folder);
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

TEST(Braitenctl, ExitsWithTwoOnBadInput) {
    EXPECT_EQ(ctl("run no-such-scene").code, 2);
    EXPECT_EQ(ctl("run 2a-coward --seconds minus").code, 2);
    EXPECT_EQ(ctl("").code, 2);
    EXPECT_NE(ctl("run 2a-cowrad").out.find("2a-coward"), std::string::npos);
}

TEST(Braitenctl, NamesTheNearestCommandAndExplainsASeed) {
    EXPECT_NE(ctl("chekc 05-aggressor").out.find("the nearest is 'check'"), std::string::npos);
    const Ran seed = ctl("run 2a-coward --seed -1");
    EXPECT_EQ(seed.code, 2);
    EXPECT_NE(seed.out.find("a whole number"), std::string::npos) << seed.out;
    EXPECT_LT(seed.out.size(), 200u);
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

// A scene with two kinds: only the second one passes exercise 5. `first` is the kind of its first vehicle.
std::string two_kinds(const std::string& first) {
    const std::string brains = "brain]\n";
    return "format = 1\n[kind.slow." + brains + "LM = 0.1\nRM = 0.1\n[kind.striker." + brains +
           "LR = 1.5\nRL = 1.5\nLM = 0.1\nRM = 0.1\n[vehicle.one]\nkind = \"" + first + "\"\n[vehicle.two]\nkind = \"" +
           (first == "slow" ? "striker" : "slow") + "\"\nx = 3\n";
}

// The row of the only graded file, without the file's name.
std::string graded(const std::string& file, const std::string& options = "") {
    const Ran ran = ctl("grade 05-aggressor " + file + " " + options);
    const std::size_t row = ran.out.find("\n" + file + ",");
    return row == std::string::npos ? ran.out : ran.out.substr(row + file.size() + 2);
}

TEST(CtlGrade, TakesTheBrainOfTheFirstVehiclesKindFromAScene) {
    const std::string scene = scratch("two-kinds.toml");
    std::ofstream(scene) << two_kinds("striker");
    EXPECT_TRUE(graded(scene).starts_with("yes,10,10,8,aggressor,kind striker,,yes,")) << graded(scene);
    std::ofstream(scene) << two_kinds("slow");
    EXPECT_TRUE(graded(scene).starts_with("no,0,10,8,")) << graded(scene);
    EXPECT_NE(graded(scene).find(",kind slow,,no,"), std::string::npos) << graded(scene);
    std::filesystem::remove(scene);
}

TEST(CtlGrade, TakesTheBrainOfTheNamedKindOrVehicle) {
    const std::string scene = scratch("named.toml");
    std::ofstream(scene) << two_kinds("slow");
    EXPECT_TRUE(graded(scene, "--kind striker").starts_with("yes,10,10,8,aggressor,kind striker,,yes,"));
    EXPECT_TRUE(graded(scene, "--vehicle two").starts_with("yes,10,10,8,aggressor,vehicle two,,yes,"));
    EXPECT_NE(graded(scene, "--kind striken").find("there is no kind 'striken'; the nearest is 'striker'"),
              std::string::npos);
    EXPECT_NE(graded(scene, "--vehicle tow").find("there is no vehicle 'tow'; known are 'one', 'two'"),
              std::string::npos);
    EXPECT_EQ(ctl("grade 05-aggressor " + scene + " --kind slow --vehicle two").code, 2);
    std::filesystem::remove(scene);
}

// In the run the first vehicle has another brain than its kind.
TEST(CtlGrade, TakesTheBrainThatTheFirstVehicleHasFromASavedRun) {
    const auto scene = parse_scene(two_kinds("slow"), "two-kinds.toml");
    ASSERT_TRUE(scene);
    auto world = World::create(*scene, 1);
    ASSERT_TRUE(world);
    ASSERT_FALSE(world->apply(SetBrain{{.vehicle = 0}, scene->kinds[1].brain}));
    const std::string file = scratch("edited.run");
    std::ofstream(file) << io::write_run({*scene, world->checkpoint()});
    EXPECT_TRUE(graded(file).starts_with("yes,10,10,8,aggressor,vehicle one,,yes,")) << graded(file);
    EXPECT_TRUE(graded(file, "--vehicle 0").starts_with("yes,10,10,8,aggressor,vehicle 0,,yes,"));
    EXPECT_NE(graded(file, "--kind slow").find(",kind slow,,no,"), std::string::npos) << graded(file, "--kind slow");
    EXPECT_NE(graded(file, "--vehicle 7").find("there is no vehicle '7'"), std::string::npos);
    std::filesystem::remove(file);
}

TEST(CtlGrade, TakesTheKindOfAVehicleThatIsGoneFromASavedRun) {
    const std::string scene = scratch("starving.toml"), run = scratch("starving.run");
    std::ofstream(scene) << two_kinds("striker") << "[ecology]\ndrain = 1\n";
    ASSERT_EQ(ctl("run " + scene + " --seconds 2 --save " + run).code, 0);
    EXPECT_TRUE(graded(run).starts_with("yes,10,10,8,aggressor,kind striker,,yes,")) << graded(run);
    EXPECT_NE(graded(run, "--vehicle one").find("the vehicle 'one' is gone; choose another"), std::string::npos);
    std::filesystem::remove(scene), std::filesystem::remove(run);
}

TEST(CtlGrade, TakesTheFirstKindOfAPopulation) {
    EXPECT_NE(graded("predator-prey").find(",kind predator,"), std::string::npos) << graded("predator-prey");
}

TEST(CtlGrade, DoesNotPassABrainThatChangesWhatIsNotOffered) {
    const std::string brain = scratch("outside.toml");
    std::ofstream(brain) << "format = 1\n[brain]\nLR = 1.5\nRL = 1.5\nLM = 0.12\nRM = 0.1\n";
    const std::string why = "it changes 'LM', which the exercise does not offer";
    EXPECT_TRUE(graded(brain).starts_with("no,10,10,8,aggressor,,\"" + why + "\",yes,")) << graded(brain);
    const Ran check = ctl("check 05-aggressor --brain " + brain);
    EXPECT_EQ(check.code, 1);
    EXPECT_NE(check.out.find("10 of 10 starts pass, 8 needed: not passed\n  " + why), std::string::npos) << check.out;
    const Json json = Json::parse(ctl("check 05-aggressor --json --brain " + brain).out);
    EXPECT_EQ(json["good"], false);
    EXPECT_EQ(json["outside_offers"], Json::array({"LM"}));
    EXPECT_EQ(json["too_many_changes"], false);
    std::ofstream(brain) << "format = 1\n[brain]\nLL = -1.2\nRR = -1.2\nLM = 0.6\nRM = 0.6\n";
    const Ran two = ctl("grade 08-overrun " + brain);
    EXPECT_NE(two.out.find("it changes 2 controls; the exercise allows 1"), std::string::npos) << two.out;
    std::filesystem::remove(brain);
}

TEST(CtlGrade, RefusesAnExercise) {
    EXPECT_NE(graded("05-aggressor").find("this is an exercise; give a brain, a scene, a saved run or a hand-in"),
              std::string::npos);
}

TEST(CtlCheck, NamesTheBrainOfAScene) {
    const Ran ran = ctl("check 05-aggressor --brain 2b-aggressor");
    EXPECT_EQ(ran.code, 0) << ran.out;
    EXPECT_TRUE(ran.out.starts_with("brain of kind aggressor in 2b-aggressor\n")) << ran.out;
    EXPECT_EQ(ctl("check 05-aggressor --kind aggressor").code, 2) << "there is no file to take it from";
}

TEST(CtlCheck, EveryShippedExerciseIsSound) {
    const Ran all = ctl("check --all");
    EXPECT_EQ(all.code, 0) << all.out;
    const Ran one = ctl("check 05-aggressor");
    EXPECT_EQ(one.code, 0) << one.out;
    EXPECT_NE(all.out.find(one.out), std::string::npos) << all.out;
}

// What `check` says of the shipped exercise with changed words.
Ran check_changed(const std::vector<std::pair<std::string, std::string>>& changes, const std::string& options = "") {
    std::ifstream shipped(std::string(BRAITENLAB_SOURCE) + "/exercises/guided/05-aggressor.toml");
    std::string text{std::istreambuf_iterator<char>(shipped), {}};
    const auto change = [&](const std::string& from, const std::string& to) {
        ASSERT_NE(text.find(from), std::string::npos) << from;
        text.replace(text.find(from), from.size(), to);
    };
    change("../scenes/", std::string(BRAITENLAB_SOURCE) + "/exercises/scenes/");
    for (const auto& [from, to] : changes) change(from, to);
    const std::string file = scratch("changed.toml");
    std::ofstream(file) << text;
    const Ran ran = ctl("check " + options + file);
    std::filesystem::remove(file);
    return ran;
}

TEST(CtlCheck, AnExerciseWhoseSolutionDoesNotPassIsNotSound) {
    const Ran ran = check_changed({{"[solution]\nLR = 1.5", "[solution]\nLR = 0"}});
    EXPECT_EQ(ran.code, 1) << ran.out;
    EXPECT_NE(ran.out.find("as shipped 0 of 10 starts pass (none should), with its solution 0"), std::string::npos)
        << ran.out;
}

TEST(CtlCheck, AnExerciseThatPassesAsShippedIsNotSound) {
    const Ran ran = check_changed({{"brain.LL\" = 1.5", "brain.LL\" = 0"},
                                   {"brain.LR\" = 0", "brain.LR\" = 1.5"},
                                   {"brain.RL\" = 0", "brain.RL\" = 1.5"},
                                   {"brain.RR\" = 1.5", "brain.RR\" = 0"}});
    EXPECT_EQ(ran.code, 1) << ran.out;
    EXPECT_NE(ran.out.find("as shipped 10 of 10 starts pass (none should), with its solution 10"), std::string::npos)
        << ran.out;
}

TEST(CtlCheck, TheJsonOfAnExerciseSaysWhatItsSolutionChanges) {
    const Json sound = Json::parse(ctl("check 05-aggressor --json").out);
    EXPECT_EQ(sound["solution_outside"], Json::array());
    EXPECT_EQ(sound["too_many_changes"], false);
    const Ran ran = check_changed({{"offers = [\"LL\", \"LR\",", "changes = 1\noffers = [\"LL\","}}, "--json ");
    const Json unsound = Json::parse(ran.out);
    EXPECT_EQ(unsound["solution_outside"], Json::array({"LR"}));
    EXPECT_EQ(unsound["too_many_changes"], true);
}

TEST(CtlCheck, AHintForAWidgetThatDoesNotExistIsAnError) {
    const Ran ran = check_changed({{"anchor = \"slider.LR\"", "anchor = \"slider.LM\""}});
    EXPECT_EQ(ran.code, 2) << ran.out;
    EXPECT_NE(ran.out.find("changed.toml:65: the window has no widget 'slider.LM'"), std::string::npos) << ran.out;
}

TEST(CtlCheck, AWarningHasFileAndLineAndDoesNotMakeAnExerciseUnsound) {
    std::string words = "goal = \"";
    for (int i = 0; i < 40; ++i) words += "again ";
    const Ran ran = check_changed({{"goal = \"", words}});
    EXPECT_EQ(ran.code, 0) << ran.out;
    EXPECT_NE(ran.out.find("changed.toml:5: warning: goal, prediction question and options have"), std::string::npos)
        << ran.out;
    const Json json = Json::parse(check_changed({{"goal = \"", words}}, "--json ").out);
    ASSERT_EQ(json["warnings"].size(), 1u);
    EXPECT_EQ(json["warnings"][0]["line"], 5);
    EXPECT_EQ(ctl("check 05-aggressor").out.find("warning"), std::string::npos);
}

// The exercise in docs/writing-exercises.md: the indented lines from `format = 1` on.
std::string documented_exercise() {
    std::ifstream page(std::string(BRAITENLAB_SOURCE) + "/docs/writing-exercises.md");
    std::string text;
    for (std::string line; std::getline(page, line);) {
        const bool is_indented = line.starts_with("    ");
        if (text.empty() && line != "    format = 1") continue;
        if (!line.empty() && !is_indented) break;
        text += (is_indented ? line.substr(4) : line) + "\n";
    }
    return text;
}

TEST(CtlCheck, TheExerciseOfTheDocumentationIsSoundWithoutAWarning) {
    const std::string file = scratch("documented.toml");
    std::ofstream(file) << documented_exercise();
    const Ran ran = ctl("check " + file), other = ctl("check --seed 1001 " + file);
    std::filesystem::remove(file);
    EXPECT_EQ(ran.code, 0) << ran.out;
    EXPECT_EQ(other.code, 0) << other.out;
    EXPECT_NE(ran.out.find("as shipped 0 of 10 starts pass (none should), with its solution 10"), std::string::npos)
        << ran.out;
    EXPECT_EQ(ran.out.find("warning"), std::string::npos) << ran.out;
}

TEST(CtlCheck, ABrainPassesOrFailsAnExercise) {
    const std::string brain = scratch("brain.toml");
    std::ofstream(brain) << "format = 1\n[brain]\nLR = 1.5\nRL = 1.5\nLM = 0.1\nRM = 0.1\n";
    EXPECT_EQ(ctl("check 05-aggressor --brain " + brain).code, 0);
    std::ofstream(brain) << "format = 1\n[brain]\nLM = 0.2\n";
    EXPECT_EQ(ctl("check 05-aggressor --brain " + brain).code, 1);
    EXPECT_EQ(ctl("check 05-aggressor --brain no-such-file").code, 2);
    EXPECT_EQ(ctl("check no-such-exercise").code, 2);
    std::filesystem::remove(brain);
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

TEST(CtlShow, PrintsTheContentOfASceneAndABrain) {
    const Ran scene = ctl("show 2b-aggressor");
    EXPECT_EQ(scene.code, 0);
    for (const char* part : {"aggressor", "sensor SL: light", "SL → MR"})
        EXPECT_NE(scene.out.find(part), std::string::npos) << part << " in\n" << scene.out;
    const std::string file = scratch("love.toml");
    std::ofstream(file) << "format = 1\n[brain]\nLL = -0.5\nRR = -0.5\nLM = 0.6\nRM = 0.6\n";
    EXPECT_NE(ctl("show " + file).out.find("love"), std::string::npos);
    std::ofstream(file) << "format = 1\n[brain]\nLX = 1\n";
    EXPECT_NE(ctl("show " + file).out.find(file + ":3"), std::string::npos);
    std::filesystem::remove(file);
    EXPECT_EQ(ctl("show no-such-file").code, 2);
}

TEST(CtlGrade, WritesOneRowPerBrain) {
    const std::string good = scratch("good.toml"), poor = scratch("poor.toml"), none = scratch("none.toml"),
                      csv = scratch("class.csv");
    std::ofstream(good) << "format = 1\n[brain]\nLR = 1.5\nRL = 1.5\nLM = 0.1\nRM = 0.1\n";
    std::ofstream(poor) << "format = 1\n[brain]\nLM = 0.2\n";
    std::ofstream(none) << "invalid";
    EXPECT_EQ(ctl("grade 05-aggressor " + good + " " + poor + " --csv " + csv).code, 0);
    std::ifstream rows(csv);
    std::string header, first, second, third;
    std::getline(rows, header), std::getline(rows, first), std::getline(rows, second);
    EXPECT_EQ(header.rfind("brain,passed,starts_passed,starts,needed,character,brain_of,error,start_1,", 0), 0u);
    EXPECT_EQ(first.rfind(good + ",yes,", 0), 0u) << first;
    EXPECT_EQ(second.rfind(poor + ",no,0,", 0), 0u) << second;
    EXPECT_FALSE(std::getline(rows, third));
    const Ran with_a_bad_one = ctl("grade 05-aggressor " + none + " " + good);
    EXPECT_EQ(with_a_bad_one.code, 2);
    EXPECT_NE(with_a_bad_one.out.find(good + ",yes,"), std::string::npos) << "the other brains are graded";
    for (const auto& file : {good, poor, none, csv}) std::filesystem::remove(file);
}

TEST(Braitenctl, NamesExercisesAndStudiesWhereTheyAreWanted) {
    EXPECT_NE(ctl("check 05-agressor.toml")
                  .out.find("no shipped exercise called '05-agressor.toml'; the nearest is "
                            "'05-aggressor'"),
              std::string::npos);
    const std::string grade = ctl("grade nofile.toml x.toml").out;
    EXPECT_NE(grade.find("no shipped exercise called 'nofile.toml'; known are '01-drive', "), std::string::npos)
        << grade;
    EXPECT_EQ(grade.find("2a-coward"), std::string::npos) << "scenes are no exercises";
    const Ran study = ctl("check prey-eyes");
    EXPECT_EQ(study.code, 2);
    EXPECT_NE(study.out.find("this is a study, and 'check' takes an exercise; run it by 'braitenctl study prey-eyes'"),
              std::string::npos)
        << study.out;
    EXPECT_NE(ctl("grade four-numbers x.toml").out.find("this is a lecture, and 'grade' takes an exercise"),
              std::string::npos);
}

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
    const auto fails = [](const std::string& arguments, const std::string& words) {
        const Ran ran = ctl("robustness " + arguments);
        EXPECT_EQ(ran.code, 2) << arguments;
        EXPECT_NE(ran.out.find(words), std::string::npos) << ran.out;
    };
    fails("2b-aggressor --reality 3", "0 (ideal) to 2");
    fails("2b-aggressor --robots 0", "1 to 1000 robots");
    fails("2b-aggressor --vehicle two", "no vehicle 'two'");
    fails("2b-aggressor --brain a.toml", "needs an exercise");
    fails("05-aggressor --set arena.width=9", "this is an exercise");
    fails("2b-agressor", "2b-aggressor");
}

}  // namespace
}  // namespace braitenlab::tests::braitenctl_test

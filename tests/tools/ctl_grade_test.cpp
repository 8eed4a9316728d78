// braitenctl grade: the row of a brain, and which brain of a file it grades.
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "core/io/run_file.h"
#include "core/scene/scene_file.h"
#include "core/world/world.h"
#include "tests/tools/ctl.h"

namespace braitenlab::tests::ctl_grade_test {
namespace {

using namespace ctl_runs;

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

}  // namespace
}  // namespace braitenlab::tests::ctl_grade_test

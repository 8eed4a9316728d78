// braitenctl compare and mystery: brains from the same starts.
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "core/scene/scene_file.h"
#include "tests/tools/ctl.h"

namespace braitenlab::tests::compare_command_test {
namespace {

using ctl_runs::Json;

Ran compare(const std::string& arguments) { return ctl("compare " + arguments); }

TEST(CtlCompare, PrintsTheMeasuresOfBothBrainsAndTheirDifference) {
    const std::string both = "2b-aggressor --a 2b-aggressor --b 2a-coward --seconds 20 --json";
    const Ran ran = compare(both);
    ASSERT_EQ(ran.code, 0) << ran.out;
    EXPECT_EQ(compare(both).out, ran.out) << "the same numbers again";
    const Json json = Json::parse(ran.out);
    const Json& closest = json["measures"]["closest"];
    EXPECT_EQ(closest["unit"], "m");
    EXPECT_LT(closest["a"].get<double>(), 0.8) << "the aggressor touches the lamp";
    EXPECT_NEAR(closest["difference"].get<double>(), closest["b"].get<double>() - closest["a"].get<double>(), 1e-4);
    EXPECT_TRUE(json["measures"]["touch"]["a"].is_number());
    EXPECT_TRUE(json["measures"]["touch"]["b"].is_null()) << "the coward never does";
    EXPECT_TRUE(json["measures"]["touch"]["difference"].is_null());
}

TEST(CtlCompare, PrintsATable) {
    const Ran ran = compare("2b-aggressor --a 2b-aggressor --b 2a-coward");
    EXPECT_EQ(ran.code, 0);
    for (const char* words : {"A", "B-A", "closest (m)", "in_light (s)", "never"})
        EXPECT_NE(ran.out.find(words), std::string::npos) << words;
}

TEST(CtlCompare, NamesWhatIsWrong) {
    const Ran vehicle = compare("2b-aggressor --a 2a-coward --b 2a-coward --vehicle nemo");
    EXPECT_EQ(vehicle.code, 2);
    EXPECT_NE(vehicle.out.find("nemo"), std::string::npos);
    EXPECT_EQ(compare("2b-aggressor --a nowhere.toml --b 2a-coward").code, 2);
    EXPECT_NE(compare("2b-aggressor --a 2a-coward").code, 0) << "one brain";
}

// A scene with a hidden brain, written by hand but for the sealed brain.
struct CtlMystery : testing::Test {
    std::string scene = ctl_runs::scratch("mystery.toml");
    CtlMystery() {
        auto made = load_scene(std::filesystem::path(BRAITENLAB_SOURCE) / "exercises/scenes/2b-aggressor.toml");
        made->kinds[0].hidden = true;
        std::ofstream(scene) << write_scene(*made);
    }
    ~CtlMystery() override { std::filesystem::remove(scene); }
};

TEST_F(CtlMystery, ScoresTheSameBrainWith100AndAnotherWithLess) {
    const Ran same = ctl("mystery " + scene + " --brain 2b-aggressor --json");
    ASSERT_EQ(same.code, 0) << same.out;
    EXPECT_EQ(Json::parse(same.out)["score"], 100);
    EXPECT_EQ(Json::parse(same.out)["starts"].size(), 10u);
    const Ran other = ctl("mystery " + scene + " --brain 2a-coward --json --threads 2");
    EXPECT_LT(Json::parse(other.out)["score"].get<int>(), 70);
    EXPECT_EQ(ctl("mystery " + scene + " --brain 2a-coward --json --threads 1").out, other.out);
}

TEST_F(CtlMystery, NoCommandPrintsTheHiddenBrain) {
    EXPECT_NE(ctl("show " + scene).out.find("hidden"), std::string::npos);
    EXPECT_EQ(ctl("show " + scene).out.find("1.5"), std::string::npos);
    EXPECT_EQ(ctl("mystery " + scene + " --brain " + scene).code, 2);
    EXPECT_EQ(ctl("mystery 2b-aggressor --brain 2a-coward").code, 2) << "nothing is hidden there";
    const std::string run = scene + ".run";
    ASSERT_EQ(ctl("run " + scene + " --seconds 1 --save " + run).code, 0);
    EXPECT_EQ(ctl("run " + run + " --seconds 1").code, 0) << "a run can be saved and continued";
    EXPECT_EQ(ctl("show " + run).out.find("1.5"), std::string::npos);
    for (const std::string& file : {scene, run})
        for (const char* choice : {"", " --vehicle one", " --kind aggressor"}) {
            const Ran refused = ctl("think " + file + choice + " --vectors -");
            EXPECT_EQ(refused.code, 2) << file << choice;
            EXPECT_NE(refused.out.find("is hidden"), std::string::npos) << refused.out;
        }
    std::filesystem::remove(run);
}

}  // namespace
}  // namespace braitenlab::tests::compare_command_test

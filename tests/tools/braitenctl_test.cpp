// The command-line tool: words that it does not know, and the commands picture, hashes and show.
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/tools/ctl.h"

namespace braitenlab::tests::braitenctl_test {
namespace {

using namespace ctl_runs;

TEST(Braitenctl, ExitsWithTwoOnBadInput) {
    EXPECT_EQ(ctl("run no-such-scene").code, 2);
    EXPECT_EQ(ctl("run 2a-coward --seconds minus").code, 2);
    EXPECT_EQ(ctl("").code, 2);
    EXPECT_NE(ctl("run 2a-cowrad").out.find("2a-coward"), std::string::npos);
}

TEST(Braitenctl, TakesAnEmptyFolderOfDataForNone) {
    const Ran ran = shell("BRAITENLAB_DATA= " BRAITENLAB_BINARY "/braitenctl show 2a-coward");
    EXPECT_EQ(ran.code, 0) << ran.out;
}

TEST(Braitenctl, NamesTheNearestCommandAndExplainsASeed) {
    EXPECT_NE(ctl("chekc 05-aggressor").out.find("the nearest is 'check'"), std::string::npos);
    const Ran seed = ctl("run 2a-coward --seed -1");
    EXPECT_EQ(seed.code, 2);
    EXPECT_NE(seed.out.find("a whole number"), std::string::npos) << seed.out;
    EXPECT_LT(seed.out.size(), 200u);
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
    const std::string scene = std::string(BRAITENLAB_SOURCE) + "/exercises/scenes/2a-coward.toml";
    for (const auto& [given, kind] : {std::pair<std::string, const char*>{"prey-eyes", "study"}, {scene, "scene"}}) {
        const Ran other = ctl("check " + given);
        EXPECT_EQ(other.code, 2);
        EXPECT_NE(other.out.find(fmt::format("this is a {}, and 'check' takes an exercise; run it by", kind)),
                  std::string::npos)
            << other.out;
    }
    EXPECT_NE(ctl("grade four-numbers x.toml").out.find("this is a lecture, and 'grade' takes an exercise"),
              std::string::npos);
}

TEST(Braitenctl, RefusesAFileNameOfAnotherFormat) {
    for (const char* arguments : {"map 2b-aggressor --png x.svg", "map 2b-aggressor --svg x.png",
                                  "picture 3a-love --paths x.png", "picture 3a-love --wiring x.pdf"}) {
        const Ran ran = ctl(arguments);
        EXPECT_EQ(ran.code, 2) << arguments;
        EXPECT_NE(ran.out.find(" writes a file ."), std::string::npos) << ran.out;
    }
    EXPECT_EQ(ctl("picture 3a-love --wiring x.pdf").out,
              "braitenctl: x.pdf: --wiring writes a file .svg; end its name "
              "with it\n");
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

}  // namespace
}  // namespace braitenlab::tests::braitenctl_test

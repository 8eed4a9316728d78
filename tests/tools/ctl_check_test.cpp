// braitenctl check: whether an exercise is sound, and whether a brain passes it.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/tools/ctl.h"

namespace braitenlab::tests::ctl_check_test {
namespace {

using namespace ctl_runs;

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

TEST(CtlCheck, TheVerdictSaysThatAWrongAnswerOfThePredictionWouldNotBeNoticed) {
    const std::string sound = ": good\n",
                      doubtful = ": good, but a wrong answer of its prediction would not be noticed\n";
    EXPECT_NE(ctl("check 05-aggressor").out.find(sound), std::string::npos);
    const std::string answer = "answer = \"It turns away from the lamp\"",
                      straight = "answer = \"It drives straight on\"";
    const std::string check = "[[predict.shows]]\noption = \"It turns away from the lamp\"\n",
                      option = "[[predict.shows]]\n";
    const std::string whole = check + "goal = \"turns_away\"\nsource = \"lamp\"\ndegrees = 60\n";
    // No check at all; a check of no option; a check that every brain meets.
    for (const auto& [from, to] :
         {std::pair{whole, std::string()},
          {check, option},
          {whole, "[[predict.shows]]\noption = \"It drives straight on\"\ngoal = \"drives\"\nspeed = 0.01\n"}}) {
        const Ran ran = check_changed({{answer, straight}, {from, to}});
        EXPECT_EQ(ran.code, 0) << ran.out;
        EXPECT_NE(ran.out.find(doubtful), std::string::npos) << ran.out;
        EXPECT_EQ(Json::parse(check_changed({{answer, straight}, {from, to}}, "--json ").out)["prediction_tested"],
                  false);
    }
    EXPECT_EQ(Json::parse(ctl("check 05-aggressor --json").out)["prediction_tested"], true);
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

TEST(CtlCheck, WarnsOfAQuestionWhoseOptionsNeedScrolling) {
    const std::string file = scratch("lecture.toml");
    for (const int options : {3, 6}) {
        std::ofstream out(file);
        out << "format = 1\ntitle = \"T\"\nminutes = 1\n[[page]]\nscene = \"2a-coward\"\nminutes = 1\n[page.question]\n"
            << "options = [";
        for (int i = 0; i < options; ++i) out << "\"" << i << " it turns away from the lamp and slows down\", ";
        out << "]\nanswer = \"0 it turns away from the lamp and slows down\"\n";
        out.close();
        const Ran ran = ctl("check " + file);
        EXPECT_EQ(ran.code, 0) << ran.out;
        EXPECT_EQ(ran.out.find("warning: page 1: ") != std::string::npos, options == 6) << ran.out;
        EXPECT_EQ(Json::parse(ctl("check --json " + file).out)["long_questions"],
                  options == 6 ? Json::array({1}) : Json::array());
    }
    std::filesystem::remove(file);
    for (const char* lecture : {"fitter", "four-numbers", "wheels-to-neurons"})
        EXPECT_EQ(ctl(std::string("check ") + lecture).out.find("warning"), std::string::npos) << lecture;
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

TEST(CtlCheck, TheSensorsOfASceneCountWhereTheExerciseOffersThem) {
    std::ifstream shipped(std::string(BRAITENLAB_SOURCE) + "/exercises/guided/18-prey.toml");
    std::string text{std::istreambuf_iterator<char>(shipped), {}};
    text = "format = 1\ntitle = \"T\"\n" +
           text.substr(text.find("[scene.arena]"), text.find("[predict]") - text.find("[scene.arena]"));
    const auto replace = [&](const std::string& from, const std::string& to) {
        for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
            text.replace(at, from.size(), to);
    };
    replace("[scene.", "[");
    const std::string file = scratch("scene.toml");
    const auto passes = [&] {
        std::ofstream(file) << text;
        return ctl("check 18-prey --kind prey --brain " + file).code;
    };
    EXPECT_EQ(passes(), 1);
    replace("\nangle = 40\nfield = 140", "\nangle = 140\nfield = 140");
    replace("\nangle = -40\nfield = 140", "\nangle = -140\nfield = 140");
    EXPECT_EQ(passes(), 0);
    std::filesystem::remove(file);
}

}  // namespace
}  // namespace braitenlab::tests::ctl_check_test

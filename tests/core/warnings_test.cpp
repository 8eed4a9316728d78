#include "core/lesson/warnings.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>
#include <unistd.h>

#include "core/lesson/exercise_file.h"

namespace braitenlab::tests::warnings_test {
namespace {

namespace fs = std::filesystem;

// An exercise without a warning. The tests find its lines by their text.
const std::string sound = R"(format = 1
title = "Own"
goal = "Reach the lamp."
offers = ["LR", "RL"]

[predict]
question = "Where does it drive?"
options = ["Straight on", "To the lamp"]
answer = "Straight on"
outcome = "Nothing steers it."
after = 2

[[predict.shows]]
option = "Straight on"
goal = "keeps_speed"
from = 0.1
to = 1
earliest = 0.5
hold = 1.4

[[step]]
text = "It reaches the lamp"
goal = "touches"
source = "a"
metres = 0.6

[solution]
LR = 1.5
RL = 1.5
LM = 0.3
RM = 0.3

[scene.arena]
width = 12
height = 12

[scene.kind.car.sensor.SL]
y = 0.2
angle = 30

[scene.kind.car.sensor.SR]
y = -0.2
angle = -30

[scene.kind.car.brain]
LM = 0.3
RM = 0.3

[scene.vehicle.one]
kind = "car"
heading_spread = 5

[scene.source.a]
x = 4
y = 2
)";

// Of its answer.
const std::string checks =
    "[[predict.shows]]\noption = \"Straight on\"\ngoal = \"keeps_speed\"\nfrom = 0.1\nto = 1\nearliest = 0.5\nhold = "
    "1.4\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

// The line of the first place where the file has this text.
int line_with(const std::string& text, const std::string& part) {
    const std::size_t at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

std::vector<Error> warnings(const std::string& toml) {
    const auto exercise = parse_exercise(toml, "own.toml");
    EXPECT_TRUE(exercise) << exercise.error().text();
    return exercise ? warnings_of(*exercise, toml, "own.toml") : std::vector<Error>{};
}

// Expects one warning with these words, at the line (or the table) that has the text `at`.
void expect_warning(const std::string& toml, const std::string& words, const std::string& at) {
    const auto found = warnings(toml);
    ASSERT_EQ(found.size(), 1u) << (found.empty() ? "none" : found.back().text());
    EXPECT_NE(found[0].what.find(words), std::string::npos) << found[0].text();
    EXPECT_EQ(found[0].file, "own.toml");
    EXPECT_NEAR(found[0].line, line_with(toml, at), 1) << found[0].text();
}

TEST(Warnings, ASoundExerciseHasNone) {
    for (const Error& each : warnings(sound)) ADD_FAILURE() << each.text();
}

TEST(Warnings, ALampOutsideTheArena) {
    expect_warning(replaced(sound, "x = 4", "x = 6.5"), "outside the arena of 12 × 12 m", "[scene.source.a]");
}

TEST(Warnings, AVehicleInAnObstacleAtOneOfTheStarts) {
    const std::string box = sound + "\n[scene.obstacle.box]\nx = 1.7\nlength = 1\nwidth = 1\n";
    EXPECT_TRUE(warnings(box).empty());
    expect_warning(replaced(box, "kind = \"car\"", "kind = \"car\"\nplace_spread = 1"),
                   "this vehicle starts in the obstacle 'box'", "[scene.vehicle.one]");
}

TEST(Warnings, AVehicleInTheWallOrInASolidLamp) {
    expect_warning(replaced(sound, "kind = \"car\"", "kind = \"car\"\nx = -5.9"), "starts in the wall",
                   "[scene.vehicle.one]");
    expect_warning(replaced(replaced(sound, "metres = 0.6", "metres = 0.1"), "x = 4\ny = 2", "x = 0.2\nsolid = true"),
                   "starts in the solid 'a'", "[scene.vehicle.one]");
}

TEST(Warnings, ASensorThatNoWireReads) {
    const std::string third = sound + "\n[scene.kind.car.sensor.heat]\nchannel = \"heat\"\n";
    expect_warning(third, "no wire reads the sensor 'heat'", "[scene.kind.car.sensor.heat]");
    EXPECT_TRUE(warnings(replaced(third, "\"RL\"]", "\"RL\", \"wiring\"]")).empty());
    EXPECT_TRUE(warnings(replaced(third, "\"RL\"]", "\"RL\", \"sensors\"]")).empty());
}

TEST(Warnings, AStepThatIsDoneAtTheStart) {
    expect_warning(replaced(sound, "metres = 0.6", "metres = 9"), "done at the start", "[[step]]");
}

TEST(Warnings, StartsThatAreAllAlike) {
    const std::string alike = replaced(sound, "heading_spread = 5\n", "");
    expect_warning(alike, "all 10 starts are alike", "[scene.vehicle.one]");
    EXPECT_TRUE(warnings("starts = 1\nneeded = 1\n" + alike).empty());
}

TEST(Warnings, AnAnswerThatNothingTests) {
    expect_warning(replaced(sound, checks, ""), "[[predict.shows]]", "answer =");
}

TEST(Warnings, AnAnswerThatNothingTestsIsSaidBesideWhatTheRunDoes) {
    const std::string untested = replaced(sound, checks, "");
    expect_warning(untested, "In 2 s of the run with the shipped brain and seed 1 the vehicle drives 1.", "answer =");
    expect_warning(untested, "its distance to 'a' goes from 4.5 m to 3.", "answer =");
    expect_warning(untested, " m straight on; its distance", "answer =");
    const std::string turning =
        replaced(untested, "[scene.kind.car.brain]\nLM = 0.3", "[scene.kind.car.brain]\nLM = 0");
    const auto found = warnings(turning);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].what.find(" turns 0°"), std::string::npos) << found[0].text();
    EXPECT_EQ(found[0].what.find(" turns -"), std::string::npos) << "it turns to the left: " << found[0].text();
    EXPECT_NE(found[0].what.find("° to the left in all"), std::string::npos) << found[0].text();
    expect_warning(replaced(untested, "RM = 0.3\n\n[scene.vehicle.one]", "RM = 0\n\n[scene.vehicle.one]"),
                   "° to the right in all", "answer =");
}

TEST(Warnings, ACheckOfTheAnswerThatEveryBrainMeets) {
    const std::string drives = "[[predict.shows]]\noption = \"Straight on\"\ngoal = \"drives\"\nspeed = 0.1\n";
    const std::string weak = replaced(sound, checks, drives);
    expect_warning(weak, "so they tell no option from another", "[[predict.shows]]");
    const std::string resting = "\n[[wrong]]\nname = \"rests\"\ntext = \"It rests.\"\nLR = 0\n";
    for (const Error& each : warnings(weak + resting))
        EXPECT_EQ(each.what.find("tell no option"), std::string::npos) << "a wrong brain does not meet it";
}

TEST(Warnings, AnAnswerThatIsVisibleAfterTheEndOfAGradedRun) {
    expect_warning(replaced(sound, "offers =", "seconds = 1\noffers ="), "after 2 s, and a graded run lasts 1 s",
                   "after =");
}

TEST(Warnings, AWrongAnswerWithAControlThatIsNotOffered) {
    expect_warning(sound + "\n[[wrong]]\nname = \"no drive\"\ntext = \"It rests.\"\nLR = 1\nLM = 0.3\n", "changes 'RM'",
                   "[[wrong]]");
    EXPECT_TRUE(warnings(sound + "\n[[wrong]]\nname = \"half\"\ntext = \"No.\"\nLR = 1\nLM = 0.3\nRM = 0.3\n").empty());
}

TEST(Warnings, TwoOptionsThatAreTheSame) {
    expect_warning(replaced(sound, "\"To the lamp\"]", "\"To the lamp\", \"To the lamp\"]"),
                   "'To the lamp' is offered twice", "options =");
}

TEST(Warnings, MoreThanFortyWordsBeforeTheFirstAction) {
    std::string words;
    for (int i = 0; i < 28; ++i) words += " word";
    EXPECT_TRUE(warnings(replaced(sound, "the lamp.", "the lamp" + words)).empty());
    words += " word";
    expect_warning(replaced(sound, "the lamp.", "the lamp" + words), "have 41 words", "goal =");
}

TEST(Warnings, AWrongAnswerWithoutATextOrEqualToTheSolution) {
    expect_warning(sound + "\n[[wrong]]\nname = \"blind\"\nLM = 0.3\nRM = 0.3\n", "no 'text'", "[[wrong]]");
    expect_warning(sound + "\n[[wrong]]\nname = \"it\"\ntext = \"No.\"\nLR = 1.5\nRL = 1.5\nLM = 0.3\nRM = 0.3\n",
                   "is the solution", "[[wrong]]");
}

TEST(Warnings, AreThoseOfTheSceneInItsOwnFile) {
    const fs::path folder = fs::temp_directory_path() / ("warnings-test-" + std::to_string(::getpid()));
    fs::create_directories(folder);
    const std::size_t at = sound.find("[scene.arena]");
    std::string scene = "format = 1\n" + replaced(sound.substr(at), "x = 4", "x = 44");
    for (std::size_t found; (found = scene.find("[scene.")) != std::string::npos;) scene.erase(found + 1, 6);
    std::ofstream(folder / "field.toml") << scene;
    const std::string toml = "scene = \"field.toml\"\n" + sound.substr(0, at);
    const auto exercise = parse_exercise(toml, folder / "own.toml");
    ASSERT_TRUE(exercise) << exercise.error().text();
    const auto found = warnings_of(*exercise, toml, folder / "own.toml");
    fs::remove_all(folder);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(fs::path(found[0].file).filename(), "field.toml");
    EXPECT_NEAR(found[0].line, line_with(scene, "[source.a]"), 1);
}

TEST(Warnings, APredictionThatTheRunContradictsIsNamedByItsLine) {
    const std::string toml = replaced(sound, "to = 1", "to = 0.2");
    const auto exercise = parse_exercise(toml, "own.toml");
    ASSERT_TRUE(exercise) << exercise.error().text();
    const auto fault = prediction_fault(*exercise, toml, "own.toml");
    ASSERT_TRUE(fault);
    EXPECT_NEAR(fault->line, line_with(toml, "[[predict.shows]]"), 1);
    EXPECT_NE(fault->what.find("contradicts the answer"), std::string::npos);
}

// The fault of the prediction of this file.
std::optional<Error> fault_of_prediction(const std::string& toml) {
    const auto exercise = parse_exercise(toml, "own.toml");
    EXPECT_TRUE(exercise) << exercise.error().text();
    return exercise ? prediction_fault(*exercise, toml, "own.toml") : std::nullopt;
}

TEST(Warnings, AnAnswerThatTheRunDoesNotShowIsAnError) {
    EXPECT_FALSE(fault_of_prediction(sound));
    const std::string toml = replaced(sound, "answer = \"Straight on\"", "answer = \"To the lamp\"");
    const auto fault = fault_of_prediction(toml);
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->line, line_with(toml, "answer ="));
    EXPECT_NE(fault->what.find("shows “Straight on”, so the answer “To the lamp” is false"), std::string::npos)
        << fault->text();
}

TEST(Warnings, TheChecksOfAnotherOptionMayNotBeMetEither) {
    const std::string lamp = "[[predict.shows]]\noption = \"To the lamp\"\ngoal = \"touches\"\nsource = \"a\"\n";
    EXPECT_FALSE(fault_of_prediction(replaced(sound, "[[step]]", lamp + "metres = 0.6\n\n[[step]]")));
    const std::string near = replaced(sound, "[[step]]", lamp + "metres = 10\n\n[[step]]");
    const auto fault = fault_of_prediction(near);
    ASSERT_TRUE(fault) << "the lamp is never further away";
    EXPECT_EQ(fault->line, line_with(near, "answer ="));
}

TEST(Warnings, ACheckOfNoOptionIsNamed) {
    const std::string option = "option = \"Straight on\"\n";
    expect_warning(replaced(sound, option, ""), "add option = \"Straight on\"", "[[predict.shows]]");
    const std::string unknown = replaced(sound, option, "option = \"Straight off\"\n");
    const auto refused = parse_exercise(unknown, "own.toml");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().line, line_with(unknown, "Straight off"));
    EXPECT_NE(refused.error().what.find("the nearest is 'Straight on'"), std::string::npos) << refused.error().what;
}

TEST(Warnings, NamesTextsWithoutATranslation) {
    const fs::path file = fs::temp_directory_path() / ("warnings-test-" + std::to_string(::getpid()) + ".toml");
    std::ofstream(file) << "format = 1\n[own]\ntitle = \"Eigene\"\ngoal = \"Ziel\"\npredict.question = \"Wo?\"\n"
                           "predict.option.1 = \"Da\"\npredict.outcome = \"So\"\n";
    const auto exercise = parse_exercise(sound, "own.toml");
    ASSERT_TRUE(exercise) << exercise.error().text();
    const auto found = missing_translations(*exercise, sound, "own.toml", file);
    fs::remove(file);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_NE(found[0].what.find("'own.predict.option.2'"), std::string::npos) << found[0].text();
    EXPECT_EQ(found[0].line, line_with(sound, "options ="));
    EXPECT_NE(found[1].what.find("'own.step.1.text'"), std::string::npos);
    EXPECT_EQ(found[1].line, line_with(sound, "It reaches the lamp"));
}

TEST(Warnings, AStepThatDoesNotNeedTheFactorOfTheMedianIsNamedByItsLine) {
    const std::string survival = replaced(sound, "goal = \"touches\"\nsource = \"a\"\nmetres = 0.6",
                                          "goal = \"runs\"\nseconds = 30\n\n[median]\nstep = 1\nfactor = 1");
    for (const auto& [seconds, count] : {std::pair{"seconds = 20\n", 0u}, {"seconds = 30\n", 1u}}) {
        const std::string toml = replaced(survival, "seconds = 30", std::string(seconds));
        const auto exercise = parse_exercise(toml, "own.toml");
        ASSERT_TRUE(exercise) << exercise.error().text();
        EXPECT_FLOAT_EQ(exercise->seconds, 20) << "each run lasts so long";
        std::vector<Error> found;
        for (const Error& each : warnings_of(*exercise, toml, "own.toml"))
            if (each.what.find("median") != std::string::npos) found.push_back(each);
        ASSERT_EQ(found.size(), count) << seconds;
        for (const Error& each : found) EXPECT_NEAR(each.line, line_with(toml, "[[step]]"), 1);
    }
}

TEST(Warnings, CountsWordsAndNoSigns) {
    EXPECT_EQ(word_count("It turns → 90° to the left…"), 6);
    EXPECT_EQ(word_count("Über ¿qué? — nada"), 3);
    EXPECT_EQ(word_count(""), 0);
}

TEST(Warnings, APredictionWithoutAnOutcome) {
    expect_warning(replaced(sound, "outcome = \"Nothing steers it.\"\n", ""), "no 'outcome'", "[predict]");
}

TEST(Warnings, NoEqualStartsInAPopulationAtRandomPlaces) {
    const std::string alike = replaced(sound, "heading_spread = 5\n", "");
    EXPECT_TRUE(warnings(alike + "\n[scene.ecology]\npopulation = 3\n").empty());
}

TEST(Warnings, ASensorThatOnlyTheSolutionReadsIsNotUnused) {
    const std::string third = sound + "\n[scene.kind.car.sensor.heat]\nchannel = \"heat\"\n";
    const std::string solution = "[solution]\nLR = 1.5\nRL = 1.5\nLM = 0.3\nRM = 0.3\n";
    const std::string wired =
        "[solution]\nLR = 1.5\nRL = 1.5\nLM = 0.3\nRM = 0.3\n[[solution.node]]\nname = \"heat\"\nkind = \"sensor\"\n"
        "[[solution.wire]]\nfrom = \"heat\"\nto = \"ML\"\n";
    EXPECT_EQ(warnings(third).size(), 1u);
    EXPECT_TRUE(warnings(replaced(third, solution, wired)).empty());
}

TEST(Warnings, ASensorWhoseOfferedDialsAreOfTheOtherSideIsUnused) {
    const std::string pair =
        "\n[scene.kind.car.sensor.HL]\nchannel = \"heat\"\ny = 0.2\nangle = 30\n"
        "\n[scene.kind.car.sensor.HR]\nchannel = \"heat\"\ny = -0.2\nangle = -30\n";
    EXPECT_TRUE(warnings(sound + pair).empty());
    const std::string from_right = replaced(sound, "offers = [\"LR\", \"RL\"]", "offers = [\"RR\", \"LR\"]");
    expect_warning(from_right + pair, "no wire reads the sensor 'HL'", "[scene.kind.car.sensor.HL]");
}

TEST(Warnings, AStepThatIsDoneByTheFirstTick) {
    expect_warning(
        replaced(sound, "goal = \"touches\"\nsource = \"a\"\nmetres = 0.6", "goal = \"drives\"\nspeed = 0.001"),
        "done at the start", "[[step]]");
}

TEST(Warnings, NoneForAVehicleInALampThatIsNotSolidOrBeyondAnOpenEdge) {
    const std::string near = replaced(sound, "metres = 0.6", "metres = 0.1");
    for (const Error& each : warnings(replaced(near, "x = 4\ny = 2", "x = 0.2"))) ADD_FAILURE() << each.text();
    const std::string open = replaced(sound, "height = 12\n", "height = 12\nedge = \"open\"\n");
    for (const Error& each : warnings(replaced(open, "kind = \"car\"", "kind = \"car\"\nx = -5.9")))
        ADD_FAILURE() << each.text();
}

TEST(Warnings, APredictionIsTestedUntilItsOutcomeOnly) {
    const std::string toml = replaced(sound, "earliest = 0.5", "earliest = 5");
    const auto exercise = parse_exercise(toml, "own.toml");
    ASSERT_TRUE(exercise) << exercise.error().text();
    const auto fault = prediction_fault(*exercise, toml, "own.toml");
    ASSERT_TRUE(fault) << "the outcome is after 2 s";
    EXPECT_NEAR(fault->line, line_with(toml, "[[predict.shows]]"), 1);
}

}  // namespace
}  // namespace braitenlab::tests::warnings_test

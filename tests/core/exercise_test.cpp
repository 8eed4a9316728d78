#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "core/lesson/exercise_file.h"
#include "core/lesson/grade.h"
#include "core/lesson/warnings.h"
#include "core/maths/random.h"
#include "core/scene/toml_reader.h"
#include "tests/tells.h"

namespace braitenlab::tests::exercise_test {
namespace {

namespace fs = std::filesystem;

const fs::path source = BRAITENLAB_SOURCE;
const fs::path guided = source / "exercises" / "guided";

std::string content(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::vector<fs::path> shipped_exercises() {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(guided)) paths.push_back(entry.path());
    return paths;
}

const std::string& aggressor() {
    static const std::string text = content(guided / "05-aggressor.toml");
    return text;
}

// The text with the first `from` in it changed to `to`.
std::string changed(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

int line_of(const std::string& text, const std::string& part) {
    return 1 + static_cast<int>(
                   std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find(part)), '\n'));
}

TEST(Exercise, EveryShippedFileIsRead) {
    ASSERT_FALSE(shipped_exercises().empty());
    for (const fs::path& path : shipped_exercises()) {
        const auto exercise = load_exercise(path);
        ASSERT_TRUE(exercise) << exercise.error().text();
        EXPECT_EQ(exercise->id, path.stem().string());
        EXPECT_FALSE(exercise->why.empty());
        EXPECT_FALSE(exercise->prediction.question.empty());
        EXPECT_GE(exercise->hints.size(), 3u);
    }
}

// One exercise of the course, by the name of its file.
class Course : public testing::TestWithParam<std::string> {
protected:
    Exercise read() const {
        const auto exercise = load_exercise(guided / (GetParam() + ".toml"));
        EXPECT_TRUE(exercise) << exercise.error().text();
        return exercise ? *exercise : Exercise{};
    }
};

TEST_P(Course, FailsAsShippedAndPassesWithItsSolutionFromEveryGradedStart) {
    const Exercise exercise = read();
    ASSERT_GE(exercise.starts, 10);
    EXPECT_EQ(grade(exercise, as_shipped(exercise)).count, 0);
    EXPECT_EQ(grade(exercise, with_solution(exercise)).count, exercise.starts);
}

TEST_P(Course, PassesWithItsSolutionFromEighteenOfTwentyOtherStarts) {
    const Exercise exercise = read();
    int passed = 0;
    for (std::uint64_t seed = 1001; seed <= 1020; ++seed) passed += passes(exercise, with_solution(exercise), seed);
    EXPECT_GE(passed, 18);
}

TEST_P(Course, RejectsItsWrongAnswersAndSaysWhatIsWrong) {
    const Exercise exercise = read();
    EXPECT_GE(exercise.wrong.size(), 3u);
    for (const Answer& wrong : exercise.wrong) {
        EXPECT_FALSE(grade(exercise, wrong.submission).good) << wrong.name;
        EXPECT_FALSE(wrong.name.empty() || wrong.text.empty());
    }
}

TEST_P(Course, TheSolutionKeepsToTheOfferedControls) {
    const Exercise exercise = read();
    EXPECT_EQ(outside_offers(exercise, with_solution(exercise)), std::vector<std::string>{});
    EXPECT_TRUE(keeps_to_offers(exercise, with_solution(exercise)));
}

TEST_P(Course, TheRunShowsWhatThePredictionsAnswerSays) {
    const Exercise exercise = read();
    EXPECT_FALSE(exercise.prediction.shows.empty());
    const auto fault = prediction_fault(exercise, "", "");
    EXPECT_FALSE(fault) << fault->text();
}

TEST_P(Course, NoStepIsDoneAtTheStart) {
    const Exercise exercise = read();
    for (const Submission& submission : {as_shipped(exercise), with_solution(exercise)}) {
        const auto world = World::create(scene_with(exercise, submission), exercise.seed);
        ASSERT_TRUE(world);
        Snapshot start;
        world->capture(start);
        Referee referee(exercise);
        referee.watch(start);
        for (const Verdict& verdict : referee.verdicts()) EXPECT_FALSE(verdict.done);
    }
}

// The texts before the first action are short enough to be read.
TEST_P(Course, TakesFortyWordsBeforeTheFirstAction) {
    const Exercise exercise = read();
    std::string before = exercise.goal + " " + exercise.prediction.question;
    for (const std::string& option : exercise.prediction.options) before += " " + option;
    std::istringstream words(before);
    const auto count = std::distance(std::istream_iterator<std::string>(words), {});
    EXPECT_LE(count, 40) << before;
    EXPECT_GE(exercise.hints.size(), 3u);
    EXPECT_FALSE(exercise.question.empty());
    EXPECT_GE(exercise.chapter, 1);
}

std::vector<std::string> course() {
    std::vector<std::string> names;
    for (const fs::path& path : shipped_exercises()) names.push_back(path.stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

INSTANTIATE_TEST_SUITE_P(Exercises, Course, testing::ValuesIn(course()), [](const auto& each) {
    std::string name = each.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST(Exercise, NoOtherClassicVehiclePassesTheAggressorExercise) {
    const auto exercise = load_exercise(guided / "05-aggressor.toml");
    ASSERT_TRUE(exercise) << exercise.error().text();
    const std::vector<FourNeurons> others{
        {.LL = 1.5f, .RR = 1.5f, .LM = 0.1f, .RM = 0.1f},                              // coward
        {.LL = -1, .RR = -1, .LM = 0.5f, .RM = 0.5f},                                  // love
        {.LR = -1, .RL = -1, .LM = 0.6f, .RM = 0.6f},                                  // explorer
        {.LL = 0.75f, .LR = 0.75f, .RL = 0.75f, .RR = 0.75f, .LM = 0.1f, .RM = 0.1f},  // four equal weights
        {.LM = 1, .RM = 1},                                                            // without wires
    };
    for (const FourNeurons& other : others)
        EXPECT_FALSE(grade(*exercise, with_brain(*exercise, make_graph(other))).good);
}

TEST(Exercise, SettingsOfTheFileAreAppliedBeforeTheGivenOnes) {
    const auto own = load_exercise(guided / "05-aggressor.toml");
    ASSERT_TRUE(own) << own.error().text();
    EXPECT_EQ(read_dials(own->scene.kinds[0].brain).LL, 1.5f);
    EXPECT_EQ(read_dials(own->scene.kinds[0].brain).LR, 0);
    const auto more = load_exercise(guided / "05-aggressor.toml", {{"kind.aggressor.brain.LR", "0.7"}});
    ASSERT_TRUE(more);
    EXPECT_EQ(read_dials(more->scene.kinds[0].brain).LR, 0.7f);
    EXPECT_EQ(own->prediction.answer, 0);
    EXPECT_TRUE(std::holds_alternative<goals::TurnsTo>(own->steps[0].check.goal));
}

TEST(Exercise, SettingsAreReadWithAndWithoutQuotes) {
    const auto text = changed(aggressor(), "\"kind.aggressor.brain.LR\" = 0", "kind.aggressor.brain.LR = 0.25");
    const auto exercise = parse_exercise(text, guided / "x.toml");
    ASSERT_TRUE(exercise) << exercise.error().text();
    EXPECT_EQ(read_dials(exercise->scene.kinds[0].brain).LR, 0.25f);
}

TEST(Exercise, ASettingCanBeTrueOrFalse) {
    const std::string set = "\"kind.aggressor.brain.LR\" = 0\n";
    const auto exercise =
        parse_exercise(changed(aggressor(), set, set + "source.lamp.solid = false\n"), guided / "x.toml");
    ASSERT_TRUE(exercise) << exercise.error().text();
    EXPECT_FALSE(exercise->scene.sources[0].solid);
}

// The shipped exercise with its second step's check replaced.
std::string with_check(const std::string& toml) {
    return changed(aggressor(), "goal = \"touches\"\nsource = \"lamp\"\nmetres = 0.75\n", toml);
}

// Two vehicles, a zone and two obstacles.
const std::string furnished_scene = R"(
[scene.kind.aggressor.sensor.SL]
y = 0.24
[scene.kind.aggressor.sensor.SR]
y = -0.24
[scene.kind.aggressor.brain]
LR = 1.5
[scene.vehicle.one]
kind = "aggressor"
[scene.vehicle.two]
kind = "aggressor"
x = 4
[scene.source.lamp]
x = 3
[scene.zone.bay]
x = -5
[scene.obstacle.a]
y = 4
[scene.obstacle.b]
y = 6
)";

// The errors as "LINE: what is wrong", of a file called x.toml beside the shipped exercises.
std::vector<std::string> errors_in(const std::string& toml) {
    std::vector<std::string> lines;
    for (const Error& each : errors_of_exercise(toml, guided / "x.toml")) {
        EXPECT_EQ(each.file, (guided / "x.toml").string());
        lines.push_back(std::to_string(each.line) + ": " + each.what);
    }
    return lines;
}

TEST(Exercise, EveryIndependentErrorIsReportedWithItsLine) {
    std::string text = aggressor();
    const auto change = [&](const std::string& from, const std::string& to) { text = changed(text, from, to); };
    change("title = \"Aggressor\"\n", "titel = \"Aggressor\"\n");
    change("seconds = 20", "seconds = 6000");
    change("starts = 10", "starts = \"ten\"");
    change("offers = [\"LL\"", "offers = [\"LLL\"");
    change("text = \"It touches the lamp\"\n", "");
    change("source = \"lamp\"\nmetres = 0.75\n\n[[step]]", "source = \"lampp\"\nmetres = 0.75\n\n[[step]]");
    change("goal = \"speeds_up\"", "goal = \"speedsup\"");
    change("anchor = \"slider.LR\"", "anchor = \"slider.XY\"");
    change("[solution]\nLR = 1.5", "[solution]\nLR = 99");
    change("[solution]", "[solution]\nLQ = 1");
    const std::vector<std::string> wanted{"no key 'titel'",
                                          "'LLL' is no control",
                                          "'seconds' is 6000",
                                          "'starts' should be",
                                          "a step needs a text",
                                          "no source called 'lampp'; the nearest is 'lamp'",
                                          "'speedsup'",
                                          "no widget 'slider.XY'; the nearest is",
                                          "'LQ'",
                                          "'LR' is 99"};
    const std::vector<std::string> places{"titel", "offers",   "seconds",   "starts", "[[step]]\ngoal = \"touches\"",
                                          "lampp", "speedsup", "slider.XY", "LQ = 1", "LR = 99"};
    const auto found = errors_in(text);
    ASSERT_EQ(found.size(), wanted.size()) << testing::PrintToString(found);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        EXPECT_NE(found[i].find(wanted[i]), std::string::npos) << found[i];
        const int line = line_of(text, places[i]);  // of a missing key that of its table
        EXPECT_TRUE(found[i].starts_with(std::to_string(line) + ": ")) << found[i] << ", wanted line " << line;
    }
    EXPECT_FALSE(parse_exercise(text, guided / "x.toml"));
}

TEST(Exercise, AnOfferThatIsNoControlNamesTheNearest) {
    const auto told = [](const std::string& offers) {
        std::string all;
        for (const std::string& each : errors_in(changed(aggressor(), "offers = [\"LL\"", "offers = [" + offers)))
            all += each + "\n";
        return all;
    };
    struct Offered {
        std::string offer, nearest;
    };
    for (const auto& [offer, nearest] : {Offered{"L", "LL"}, Offered{"LL=RX", "RL"},
                                         Offered{"tresholdLL", "threshold_LL"}, Offered{"wirring", "wiring"}}) {
        const std::string errors = told("\"" + offer + "\"");
        EXPECT_NE(errors.find("'" + offer + "' is no control; "), std::string::npos) << errors;
        EXPECT_NE(errors.find("; the nearest is '" + nearest + "'\n"), std::string::npos) << errors;
    }
    const std::string two = told("\"XL\", \"curvs\"");
    EXPECT_NE(two.find("'XL' is no control"), std::string::npos) << two;
    EXPECT_NE(two.find("'curvs' is no control"), std::string::npos) << two;
}

TEST(Exercise, AFileWithoutFaultsHasNoErrors) { EXPECT_EQ(errors_in(aggressor()), std::vector<std::string>{}); }

TEST(Exercise, AMisspeltKeyIsReportedOnce) {
    for (const auto& [right, wrong] : {std::pair{"title = \"Agg", "titel = \"Agg"},
                                       {"goal = \"Make", "gaol = \"Make"},
                                       {"[solution]", "[soluton]"},
                                       {"text = \"It touches", "txet = \"It touches"}}) {
        const auto found = errors_in(changed(aggressor(), right, wrong));
        ASSERT_EQ(found.size(), 1u) << wrong << testing::PrintToString(found);
        EXPECT_NE(found[0].find("no key '"), std::string::npos) << found[0];
    }
}

TEST(Exercise, AnErrorThatFollowsFromAnotherIsNotReported) {
    const auto only = [](const std::string& from, const std::string& to, const std::string& told) {
        const auto found = errors_in(changed(aggressor(), from, to));
        ASSERT_EQ(found.size(), 1u) << testing::PrintToString(found);
        EXPECT_NE(found[0].find(told), std::string::npos) << found[0];
    };
    only("goal = \"touches\"\nsource", "goal = \"tuches\"\nsource", "'tuches'");  // whose keys are not known
    only("options = [", "options = [3, ", "'options' should be a list");          // the answer is one of them
    only("factor = 1.5", "faktor = 1.5", "no key 'faktor'");                      // and not: 'factor' is missing
    only("starts = 10", "starts = 5.5", "'starts'");                              // and not: 8 needed
    only("RL = 1.5\nLM = 0.1", "RL = 99\nLM = 0.1", "'RL' is 99");
    only("heading_spread\" = 15", "heading_spread\" = 1500", "1500");
    only("title = \"Aggressor\"", "title = ", "");
}

TEST(Exercise, EveryErrorOfItsSceneIsReportedToo) {
    std::string text = changed(aggressor(), "scene = \"../scenes/2b-aggressor.toml\"\n", "");
    text = changed(text, "chapter = 1", "chaptr = 1") + changed(furnished_scene, "x = -5", "x = \"left\"");
    const auto found = errors_in(changed(text, "y = 6", "y = 6000"));
    ASSERT_EQ(found.size(), 3u) << testing::PrintToString(found);
    EXPECT_NE(found[0].find("no key 'chaptr'"), std::string::npos) << found[0];
    EXPECT_NE(found[1].find("'x' should be"), std::string::npos) << found[1];
    EXPECT_NE(found[2].find("'y' is 6000"), std::string::npos) << found[2];
}

// A wrong value of the scene hides no wrong name.
TEST(Exercise, NamesAreJudgedBesideWrongValuesOfItsScene) {
    std::string text = changed(aggressor(), "\"kind.aggressor.brain.LL\"", "\"kind.agressor.brain.LL\"");
    text =
        changed(text, "source = \"lamp\"\nmetres = 0.75\n\n[[step]]", "source = \"lampp\"\nmetres = 0.75\n\n[[step]]");
    text = changed(text, "anchor = \"slider.LR\"", "anchor = \"slider.XY\"");
    const auto found = errors_in(text);
    ASSERT_EQ(found.size(), 3u) << testing::PrintToString(found);
    EXPECT_NE(found[0].find("'kind.agressor.brain.LL'"), std::string::npos) << found[0];
    EXPECT_NE(found[1].find("'lampp'"), std::string::npos) << found[1];
    EXPECT_NE(found[2].find("'slider.XY'"), std::string::npos) << found[2];
}

TEST(Exercise, EverySyntaxErrorIsReported) {
    std::string text = changed(aggressor(), "seconds = 20", "seconds = ");
    text = changed(text, "metres = 0.75", "metres = 0,75");
    const auto found = errors_in(text);
    ASSERT_EQ(found.size(), 2u) << testing::PrintToString(found);
    EXPECT_TRUE(found[0].starts_with(std::to_string(line_of(text, "seconds = ")) + ": ")) << found[0];
    EXPECT_TRUE(found[1].starts_with(std::to_string(line_of(text, "metres = 0,75")) + ": ")) << found[1];
}

TEST(Exercise, AStepNamesAVehicleAndAHoldTime) {
    const auto exercise = parse_exercise(
        with_check("goal = \"touches\"\nsource = \"lamp\"\nmetres = 0.75\nvehicle = \"one\"\nhold = 5\n"),
        guided / "x.toml");
    ASSERT_TRUE(exercise) << exercise.error().text();
    EXPECT_EQ(exercise->steps[1].check.vehicle, "one");
    EXPECT_EQ(exercise->steps[1].check.hold, 5);
}

TEST(Exercise, AStepCombinesChecks) {
    const auto exercise = parse_exercise(with_check("goal = \"all_of\"\nhold = 2\n"
                                                    "[[step.check]]\ngoal = \"runs\"\nseconds = 3\n"
                                                    "[[step.check]]\ngoal = \"any_of\"\n"
                                                    "[[step.check.check]]\ngoal = \"runs\"\nseconds = 4\n"),
                                         guided / "x.toml");
    ASSERT_TRUE(exercise) << exercise.error().text();
    const auto& all = std::get<goals::AllOf>(exercise->steps[1].check.goal);
    ASSERT_EQ(all.checks.size(), 2u);
    EXPECT_EQ(std::get<goals::Runs>(all.checks[0].goal).seconds, 3);
    EXPECT_EQ(std::get<goals::AnyOf>(all.checks[1].goal).checks.size(), 1u);
    EXPECT_EQ(exercise->steps[1].check.hold, 2);
}

// What reading the exercise says whose second step has this check, in the furnished scene.
std::string error_of(const std::string& check, const std::string& more_of_scene = "") {
    const std::string text = changed(with_check(check), "scene = \"../scenes/2b-aggressor.toml\"\n", "");
    const auto exercise = parse_exercise(text + furnished_scene + more_of_scene, guided / "x.toml");
    return exercise ? std::string("accepted") : exercise.error().text();
}

// Expects the error at the second step of with_check().
void expect_refused(const std::string& check, const std::string& told, const std::string& more_of_scene = "") {
    EXPECT_NE(error_of(check, more_of_scene).find(told), std::string::npos) << error_of(check, more_of_scene);
}

TEST(Exercise, NamesInAGoalAreNotEmptyButTheSource) {
    expect_refused("goal = \"enters\"\nzone = \"\"\n", "'zone' is empty; name one zone of the scene");
    expect_refused("goal = \"drives_through\"\nleft = \"\"\nright = \"b\"\n", "'left' is empty");
    expect_refused("goal = \"drives_through\"\nleft = \"a\"\nright = \"\"\n", "'right' is empty");
    expect_refused("goal = \"population\"\nkind = \"\"\ncount = 1\n", "'kind' is empty");
    expect_refused("goal = \"follows\"\nother = \"\"\nmetres = 1\ndegrees = 9\n", "'other' is empty");
    EXPECT_EQ(error_of("goal = \"touches\"\nsource = \"\"\nmetres = 1\n"), "accepted");
}

TEST(Exercise, AGoalThatFollowsOneSourceNamesItWhereThereAreSeveral) {
    const std::string fire = "[scene.source.fire]\nx = -3\n", nearest = "source = \"\"\n";
    for (const std::string& goal :
         {"goal = \"turns_to\"\ndegrees = 9\n" + nearest, "goal = \"turns_away\"\ndegrees = 9\n" + nearest,
          "goal = \"circles\"\nfrom = 1\nto = 2\nrounds = 1\n" + nearest,
          "goal = \"steady_distance\"\npercent = 9\nseconds = 1\n" + nearest,
          "goal = \"speeds_up\"\nmetres = 1\nfactor = 2\n" + nearest}) {
        EXPECT_EQ(error_of(goal), "accepted");
        expect_refused(goal, "the scene has several sources; name the one", fire);
    }
    EXPECT_EQ(error_of("goal = \"avoids\"\nmetres = 1\n" + nearest, fire), "accepted");
}

TEST(Exercise, AGoalOfAnotherVehicleOrASensorNamesOneThatCanBeMeant) {
    const std::string follows = "goal = \"follows\"\nmetres = 1\ndegrees = 9\n";
    expect_refused(follows + "other = \"one\"\n", "'one' is the vehicle of this check");
    expect_refused(follows + "other = \"two\"\nvehicle = \"two\"\n", "'two' is the vehicle of this check");
    EXPECT_EQ(error_of(follows + "other = \"one\"\nvehicle = \"two\"\n"), "accepted");
    expect_refused("goal = \"all_of\"\nvehicle = \"two\"\n[[step.check]]\n" + follows + "other = \"two\"\n",
                   "'two' is the vehicle of this check");
    expect_refused("goal = \"speed_follows\"\nsensor = \"SM\"\ncorrelation = 0.5\nseconds = 1\n",
                   "has no sensor called 'SM'; the nearest is 'SL'");
    const std::string matches = "goal = \"matches\"\nmetres = 1\nseconds = 9\n";
    EXPECT_EQ(error_of(matches + "vehicle = \"one\"\n"), "accepted");
    expect_refused(matches + "vehicle = \"two\"\n", "'matches' is about the first vehicle, 'one'");
}

TEST(Exercise, ARangeOfAGoalAscends) {
    expect_refused("goal = \"keeps_distance\"\nsource = \"lamp\"\nfrom = 3\nto = 2\n",
                   "'to' should be at least 'from'");
    expect_refused("goal = \"keeps_speed\"\nfrom = 3\nto = 2\n", "'to' should be at least 'from'");
    expect_refused("goal = \"recharges\"\nlow = 0.8\nhigh = 0.5\ncount = 1\n", "'high' should be at least 'low'");
}

TEST(Exercise, TheTimesOfEveryCheckAreChecked) {
    const std::string early = "latest = 1\nearliest = 2\n", run = "goal = \"runs\"\nseconds = 1\n";
    expect_refused(run + early, "'latest' should be more than 'earliest'");
    expect_refused("goal = \"all_of\"\n[[step.check]]\n" + run + early, "'latest' should be more than 'earliest'");
    expect_refused("goal = \"all_of\"\n[[step.check]]\n" + run + "after = 2\n",
                   "'after' should be the number of an earlier step");
    EXPECT_EQ(error_of("goal = \"all_of\"\n[[step.check]]\n" + run + "after = 1\n"), "accepted");
    const std::string shown = "source = \"lamp\"\ndegrees = 60\n";
    const auto shows = parse_exercise(changed(aggressor(), shown, shown + early), guided / "x.toml");
    ASSERT_FALSE(shows);
    EXPECT_TRUE(tells(shows.error(), message_of("more_than", "latest", "earliest")));
}

TEST(Exercise, EveryGoalRequiresItsKeysAndRefusesOtherKeys) {
    EXPECT_NE(error_of("").find("'goal' is missing; it is one of \"runs\""), std::string::npos) << error_of("");
    const std::map<std::string_view, std::string> values{
        {"source", "\"lamp\""}, {"check", "[{goal = \"runs\", seconds = 1}]"},
        {"zone", "\"bay\""},    {"left", "\"a\""},
        {"right", "\"b\""},     {"other", "\"two\""},
        {"sensor", "\"SL\""},   {"kind", "\"aggressor\""}};
    const auto line = [&](std::string_view key) {
        const auto value = values.find(key);
        return std::string(key) + " = " + (value == values.end() ? "1" : value->second) + "\n";
    };
    const auto try_all = [&]<class... Goals>(const std::variant<Goals...>&) {
        std::set<std::string_view> all_keys;
        for (const auto& keys : {key_names<Goals>()...}) all_keys.insert(keys.begin(), keys.end());
        const auto try_goal = [&]<class G>(const G&) {
            const auto own = key_names<G>();
            const std::string word(G::traits.word);
            std::string whole = "goal = \"" + word + "\"\n";
            for (const auto key : own) whole += line(key);
            EXPECT_EQ(error_of(whole), "accepted") << whole;
            for (const auto key : own)
                EXPECT_NE(error_of(changed(whole, line(key), "")).find("'" + word + "' needs '" + std::string(key)),
                          std::string::npos)
                    << word << " without " << key;
            for (const auto key : all_keys) {
                if (std::find(own.begin(), own.end(), key) != own.end()) continue;
                EXPECT_NE(error_of(whole + line(key)).find("'" + word + "' has no '" + std::string(key)),
                          std::string::npos)
                    << word << " with " << key;
            }
        };
        (try_goal(Goals{}), ...);
    };
    try_all(Goal{});
}

struct Mistake {
    std::string from, to;
    std::string at;  // a part of the line that the error must name, after the change; empty: any line
    std::vector<std::string> told;
};

TEST(Exercise, AnErrorNamesTheLineAndTheNearestWord) {
    const std::vector<Mistake> mistakes{
        {"format = 1", "", "", {"format = 1"}},
        {"title = \"Aggressor\"", "", "", {"'title' is missing"}},
        {"title =", "titel =", "titel", {"nearest is 'title'"}},
        {"2b-aggressor.toml", "2b-aggresor.toml", "scene =", {"there is no scene"}},
        {"scene = \"../scenes/2b-aggressor.toml\"", "", "", {"'scene' is missing"}},
        {"brain.LL\" = 1.5", "brain.LX\" = 1.5", "brain.LX", {"nearest is 'kind.aggressor.brain.LL'"}},
        {"brain.LL\" = 1.5", "brain.LL\" = 9", "brain.LL\" = 9", {"'LL' is 9, outside -2 .. 2"}},
        {"brain.LL\" = 1.5", "brain.LL\" = [1]", "brain.LL\" = [1]", {"number, text, true or false"}},
        {"answer = \"It turns away from the lamp\"",
         "answer = \"It turns away from the lump\"",
         "answer =",
         {"nearest is 'It turns away from the lamp'"}},
        {"answer = \"It turns away from the lamp\"", "", "[predict]", {"one of them as its answer"}},
        {"answer = \"It turns away from the lamp\"",
         "answer = \"It turns away from the lamp\"\npath = \"on\"",
         "path = \"on\"",
         {"no vehicle called 'on'", "nearest is 'one'"}},
        {"goal = \"touches\"", "goal = \"touch\"", "goal = \"touch\"", {"nearest is 'touches'"}},
        {"source = \"lamp\"\nmetres = 0.75\n",
         "source = \"lump\"\nmetres = 0.75\n",
         "source = \"lump\"",
         {"nearest is 'lamp'"}},
        {"metres = 0.75\n", "", "[[step]]\ntext = \"It touches", {"'touches' needs 'metres'"}},
        {"metres = 0.75\n", "meters = 0.75\n", "meters =", {"no key 'meters' in [step.2]; the nearest is 'metres'"}},
        {"metres = 0.75\n", "degrees = 3\n", "[[step]]\ntext = \"It touches", {"'touches' needs 'metres'"}},
        {"metres = 0.75\n", "metres = 0.75\nholt = 1\n", "holt =", {"nearest is 'hold'"}},
        {"metres = 0.75\n", "metres = 0.6\ndegrees = 3\n", "degrees = 3", {"'touches' has no 'degrees'"}},
        {"metres = 0.75\n", "metres = 0.75\nvehicle = \"on\"\n", "vehicle = \"on\"", {"nearest is 'one'"}},
        {"goal = \"touches\"\nsource = \"lamp\"\nmetres = 0.75\n",
         "goal = \"any_of\"\ncheck = []\n",
         "[[step]]\ntext = \"It touches",
         {"'any_of' needs at least one check"}},
        {"goal = \"touches\"\nsource = \"lamp\"\nmetres = 0.75\n",
         "goal = \"any_of\"\n[[step.check]]\ngoal = \"touches\"\nmetres = 1\nsource = \"lump\"\n",
         "source = \"lump\"",
         {"nearest is 'lamp'"}},
        {"degrees = 10", "degrees = 200", "degrees = 200", {"outside 0.5 .. 180"}},
        {"needed = 8", "needed = 11", "needed = 11", {"more than the 10 starts"}},
        {"anchor = \"slider.LR\"", "anker = \"slider.LR\"", "anker", {"nearest is 'anchor'"}},
        {"anchor = \"slider.LR\"", "anchor = \"slider.LM\"", "slider.LM", {"no widget 'slider.LM'", "nearest is"}},
        {"[solution]\nLR = 1.5", "[solution]\nLR = 3", "LR = 3", {"outside -2 .. 2"}},
    };
    for (const Mistake& mistake : mistakes) {
        const std::string text = changed(aggressor(), mistake.from, mistake.to);
        const auto exercise = parse_exercise(text, guided / "x.toml");
        ASSERT_FALSE(exercise) << mistake.to;
        const std::string told = exercise.error().text();
        EXPECT_NE(told.find("x.toml"), std::string::npos) << told;
        if (!mistake.at.empty()) {
            EXPECT_EQ(exercise.error().line, line_of(text, mistake.at)) << told;
        }
        for (const std::string& part : mistake.told)
            EXPECT_NE(told.find(part), std::string::npos) << told << "\nexpected: " << part;
    }
}

TEST(Exercise, ASceneWithAVehicleStepsAndASolutionAreRequired) {
    const std::string head = "format = 1\ntitle = \"t\"\ngoal = \"g\"\nscene = \"../scenes/";
    const auto told = [](const std::string& text) {
        const auto exercise = parse_exercise(text, guided / "x.toml");
        return exercise ? std::string("accepted") : exercise.error().text();
    };
    EXPECT_NE(told(head + "2b-aggressor.toml\"\n[solution]\n").find("no [[step]]"), std::string::npos);
    EXPECT_NE(told(head + "2b-aggressor.toml\"\n[[step]]\n").find("no [solution]"), std::string::npos);
    EXPECT_NE(told(head + "predator-prey.toml\"\n[[step]]\ntext = \"t\"\ngoal = \"runs\"\nseconds = 1\n[solution]\n")
                  .find("x.toml:4: this scene places no vehicle"),
              std::string::npos);
}

void survive(const std::string& text) {
    const auto exercise = parse_exercise(text, guided / "x.toml");
    EXPECT_TRUE(exercise || !exercise.error().what.empty());
}

TEST(Exercise, ATruncatedOrChangedFileGivesAnErrorOrAnExercise) {
    maths::Random chance(3, 3);
    const std::string bits = "\"'[]{}=.,#\\\n-+09eLR\xff";
    for (std::size_t i = 0; i < 300; ++i) {
        const std::string cut = aggressor().substr(0, aggressor().size() * i / 300);
        survive(cut);
        std::string text = aggressor();
        text[chance.next() % text.size()] = bits[chance.next() % bits.size()];
        survive(text);
    }
}

// Set BRAITENLAB_WRITE_DOCS=1 to write the tables into the page after a change of the fields.
TEST(Exercise, TheFormatPageHasTheGeneratedTables) {
    const fs::path page = source / "docs" / "exercise-format.md";
    std::string text = content(page);
    if (std::getenv("BRAITENLAB_WRITE_DOCS")) {
        text = text.substr(0, text.find("\n## The top of the file")) + describe_exercise_format();
        std::ofstream(page, std::ios::binary) << text;
    }
    EXPECT_NE(text.find(describe_exercise_format()), std::string::npos);
}

TEST(Exercise, APredictionThatIsDrawnOnlyNeedsNoOptions) {
    std::string text = aggressor();
    for (const char* line : {"\noptions = ", "\nanswer = "}) {
        const std::size_t at = text.find(line, text.find("[predict]"));
        ASSERT_NE(at, text.npos) << line;
        text.erase(at, text.find('\n', at + 1) - at);
    }
    EXPECT_FALSE(parse_exercise(text, guided / "x.toml")) << "neither options nor a path";
    const auto drawn = parse_exercise(changed(text, "[predict]", "[predict]\npath = \"one\""), guided / "x.toml");
    ASSERT_TRUE(drawn) << drawn.error().text();
    EXPECT_EQ(drawn->prediction.path_of, "one");
}

}  // namespace
}  // namespace braitenlab::tests::exercise_test

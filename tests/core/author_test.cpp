#include "core/lesson/author.h"

#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "core/lesson/exercise_file.h"
#include "core/lesson/grade.h"
#include "core/lesson/write_exercise.h"
#include "core/maths/angle.h"
#include "tests/tells.h"

namespace braitenlab::tests::author_test {
namespace {

Scene shipped(const std::string& name) {
    auto scene = load_scene(std::filesystem::path(BRAITENLAB_SOURCE) / "exercises" / "scenes" / (name + ".toml"));
    EXPECT_TRUE(scene) << scene.error().text();
    return scene ? *scene : Scene{};
}

// The coward's scene, and the same with crossed wires.
struct Author : testing::Test {
    Scene file = shipped("2a-coward");
    Scene now = file;
    ExerciseDraft draft{.title = "Strike", .goal = "Touch the lamp."};
    Author() {
        now.kinds[0].brain = make_graph({.LR = 1.5f, .RL = 1.5f, .LM = 0.1f, .RM = 0.1f});
        draft.hints = {"Watch the wheels.", "Cross the wires."};
        draft.offers = {"LL", "LR", "RL", "RR"};
        for (const Goal& goal : goals_for(now, now.starts[0].name))
            if (word_of(goal) == "touches") draft.steps = {{"It touches the lamp", {goal}}};
    }
    Exercise made() const {
        auto exercise = make_exercise(draft, "strike", now, file);
        EXPECT_TRUE(exercise) << exercise.error().text();
        if (!exercise) return {};
        auto read = parse_exercise(write_exercise(*exercise), "strike.toml");
        EXPECT_TRUE(read) << read.error().text();
        return read ? *read : Exercise{};
    }
};

TEST_F(Author, TheBrainOfTheFileShipsAndTheOneInTheWindowIsTheSolution) {
    const Exercise exercise = made();
    EXPECT_EQ(as_shipped(exercise).brain, file.kinds[0].brain);
    EXPECT_EQ(with_solution(exercise).brain, now.kinds[0].brain);
    EXPECT_EQ(exercise.title, "Strike");
    ASSERT_EQ(exercise.hints.size(), 2u);
    EXPECT_EQ(exercise.hints[1].text, "Cross the wires.");
    EXPECT_EQ(exercise.offers, draft.offers);
    EXPECT_EQ(exercise.needed, 8);
    EXPECT_FLOAT_EQ(exercise.scene.starts[0].heading_spread, 15 * maths::pi / 180);
    EXPECT_EQ(exercise.scene.sources, now.sources);
}

TEST_F(Author, ABrainWithoutWiresCanShipWithItsDrives) {
    draft.ships = ShippedBrain::without_wires;
    now = file;  // the scene as it was saved
    now.kinds[0].brain = make_graph({.LL = 1.5f, .RR = 1.5f, .threshold_RR = 0.2f, .LM = 0.1f, .RM = 0.3f});
    const Exercise exercise = made();
    EXPECT_TRUE(as_shipped(exercise).brain == make_graph({.LM = 0.1f, .RM = 0.3f}));
    EXPECT_EQ(with_solution(exercise).brain, now.kinds[0].brain);
    Node neuron;
    neuron.id = 9, neuron.name = "N1";
    now.kinds[0].brain.nodes.push_back(neuron);
    now.kinds[0].brain.wires.push_back({0, 9});
    const BrainGraph shipped = as_shipped(made()).brain;
    EXPECT_TRUE(shipped.wires.empty());
    EXPECT_EQ(find_node(shipped, "MR")->bias, 0.3f);
}

TEST_F(Author, RefusesASceneWithoutASolutionOrAVehicle) {
    const auto same = make_exercise(draft, "strike", file, file);
    ASSERT_FALSE(same);
    EXPECT_TRUE(tells(same.error(), message_of("exercise_solved")));
    Scene empty = now;
    empty.starts.clear();
    EXPECT_FALSE(make_exercise(draft, "strike", empty, file));
}

TEST_F(Author, WrongAnswersAndWhatTheRunShowsAreInTheFile) {
    const BrainGraph half = make_graph({.LR = 0.1f, .LM = 0.1f, .RM = 0.1f});
    draft.wrong = {{"Half a wire", half}, {"No wires", make_graph(FourNeurons{})}};
    draft.prediction = {"What will it do?", {"Flee", "Strike"}, 0, "It flees.", 4};
    for (const Goal& goal : goals_for(now, now.starts[0].name))
        if (word_of(goal) == "turns_away") draft.prediction.shows = {{.option = {}, .check = {goal}}};
    const Exercise exercise = made();
    ASSERT_EQ(exercise.wrong.size(), 2u);
    EXPECT_EQ(exercise.wrong[0].name, "Half a wire");
    EXPECT_EQ(exercise.wrong[0].submission.brain, half);
    EXPECT_EQ(exercise.wrong[1].submission.brain, make_graph(FourNeurons{}));
    EXPECT_EQ(exercise.prediction.after, 4);
    ASSERT_EQ(exercise.prediction.shows.size(), 1u);
    EXPECT_EQ(word_of(exercise.prediction.shows[0].check.goal), "turns_away");
    EXPECT_EQ(exercise.prediction.shows[0].option, "Flee") << "the check names the answer";
}

TEST_F(Author, RefusesAWrongAnswerThatIsTheSolution) {
    draft.wrong = {{"Crossed", now.kinds[0].brain}};
    const auto refused = make_exercise(draft, "strike", now, file);
    ASSERT_FALSE(refused);
    EXPECT_TRUE(tells(refused.error(), message_of("exercise_wrong_is_solution", "Crossed")));
}

TEST_F(Author, ABrainOfOneVehicleAloneBecomesThatOfItsKindAndOthersKeepTheirs) {
    now = file;
    now.starts.push_back(now.starts[0]);
    now.starts[1].name = "other", now.starts[1].x += 3;
    const BrainGraph own = make_graph({.LR = 1.5f, .RL = 1.5f, .LM = 0.1f, .RM = 0.1f});
    now.starts[1].brain = own;
    draft.vehicle = "other";
    const Exercise exercise = made();
    ASSERT_EQ(exercise.scene.starts.size(), 2u);
    EXPECT_EQ(exercise.scene.starts[0].name, "other");
    EXPECT_FALSE(exercise.scene.starts[0].brain);
    EXPECT_EQ(with_solution(exercise).brain, own);
    ASSERT_TRUE(exercise.scene.starts[1].brain) << "the other vehicle drives as before";
    EXPECT_EQ(*exercise.scene.starts[1].brain, file.kinds[0].brain);
}

TEST_F(Author, ListsTheGoalsThatTheSceneCanMeetWithItsNearestLamp) {
    std::set<std::string> words;
    now.sources.push_back({.name = "near", .x = now.starts[0].x + 0.5f, .y = now.starts[0].y});
    std::vector<Goal> goals = goals_for(now, now.starts[0].name);
    for (Goal& goal : goals) {
        words.emplace(word_of(goal));
        for (const GoalValue& value : values_of(goal)) {
            const double number = value.number ? double{*value.number} : value.count ? *value.count : 0;
            EXPECT_TRUE(value.name || value.range.holds(number)) << word_of(goal) << "." << value.key;
            EXPECT_TRUE(value.key != "source" || *value.name == "near") << word_of(goal);
        }
    }
    for (const char* listed : {"touches", "avoids", "circles", "rests", "speed_follows"})
        EXPECT_TRUE(words.count(listed)) << listed;
    for (const char* missing : {"all_of", "enters", "drives_through", "follows", "captures", "recharges"})
        EXPECT_FALSE(words.count(missing)) << missing;
}

TEST_F(Author, TheUsualDistanceToASolidLampCanBeReached) {
    const auto distance = [&] {
        for (const Goal& goal : goals_for(now, now.starts[0].name))
            if (const auto* touches = std::get_if<goals::Touches>(&goal)) return touches->metres;
        return 0.0f;
    };
    now.sources[0].solid = false;
    EXPECT_EQ(distance(), 0.5f);
    now.sources[0].solid = true;
    EXPECT_GT(distance(), solid_source_radius + now.kinds[0].body.length / 2);
    EXPECT_LT(distance(), 1.2f);
}

TEST_F(Author, EveryListedGoalIsWrittenAndRead) {
    now.starts.push_back(now.starts[0]);
    now.starts[1].name = "other", now.starts[1].x += 3;
    now.obstacles = {{.name = "p1", .x = 2, .y = 7}, {.name = "p2", .x = 5, .y = 7}};
    now.zones = {{.name = "bay", .x = -6, .y = -6, .surface = Surface::tape, .recharge = 1}};
    const std::vector<Goal> goals = goals_for(now, now.starts[0].name);
    EXPECT_GE(goals.size(), 20u);
    for (const Goal& goal : goals) {
        draft.steps = {{"It does", {goal}}};
        EXPECT_EQ(word_of(made().steps.at(0).check.goal), word_of(goal));
    }
}

TEST_F(Author, TheValuesOfTheDraftAreThoseOfTheExerciseAndTheSceneHasNoTitle) {
    draft.seconds = 33, draft.starts = 5, draft.heading_spread = 90;
    draft.prediction = {.question = "Where to?", .options = {"Left", "Right"}, .answer = 1, .outcome = "It turns."};
    now.title = "The one that strikes", now.story = "It hits the lamp.";
    const auto exercise = make_exercise(draft, "strike", now, file);
    ASSERT_TRUE(exercise) << exercise.error().text();
    EXPECT_EQ(exercise->seconds, 33);
    EXPECT_EQ(exercise->starts, 5);
    EXPECT_EQ(exercise->needed, 4);
    EXPECT_FLOAT_EQ(exercise->scene.starts[0].heading_spread, maths::pi / 2);
    EXPECT_EQ(exercise->prediction.question, "Where to?");
    EXPECT_EQ(exercise->prediction.options, draft.prediction.options);
    EXPECT_EQ(exercise->prediction.answer, 1);
    EXPECT_EQ(exercise->prediction.outcome, "It turns.");
    EXPECT_EQ(exercise->scene.title, "") << "it tells the outcome";
    EXPECT_EQ(exercise->scene.story, "");
}

TEST_F(Author, AMemberOfThePopulationKeepsTheBrainOfItsKind) {
    now = file;
    now.ecology.population = 1;
    now.members = {{.name = "0", .kind = now.kinds[0].name}};
    now.starts[0].brain = make_graph({.LR = 1.5f, .RL = 1.5f, .LM = 0.1f, .RM = 0.1f});
    const auto exercise = make_exercise(draft, "strike", now, file);
    ASSERT_TRUE(exercise) << exercise.error().text();
    ASSERT_EQ(exercise->scene.members.size(), 1u);
    ASSERT_TRUE(exercise->scene.members[0].brain);
    EXPECT_EQ(*exercise->scene.members[0].brain, file.kinds[0].brain);
}

TEST_F(Author, AGateHasTwoPosts) {
    now.obstacles = {{.name = "p1", .x = 2, .y = 7}, {.name = "p2", .x = 5, .y = 7}};
    std::set<std::string> posts;
    for (Goal& goal : goals_for(now, now.starts[0].name))
        if (word_of(goal) == "drives_through")
            for (const GoalValue& value : values_of(goal))
                if (value.name) posts.insert(*value.name);
    EXPECT_EQ(posts, (std::set<std::string>{"p1", "p2"}));
}

TEST_F(Author, ABrainWithItsNodesAtOtherPlacesIsNoSolution) {
    now = file;
    for (Node& node : now.kinds[0].brain.nodes) node.place = {3, 4};
    EXPECT_FALSE(make_exercise(draft, "strike", now, file));
}

TEST_F(Author, ASceneWithoutLampsHasNoneToVisit) {
    const auto has_visits = [&] {
        for (const Goal& goal : goals_for(now, now.starts[0].name))
            if (word_of(goal) == "visits") return true;
        return false;
    };
    EXPECT_TRUE(has_visits());
    now.sources.clear();
    EXPECT_FALSE(has_visits());
}

TEST_F(Author, SensorsOfOneVehicleAloneBecomeThoseOfItsKindAndOthersKeepTheirs) {
    now.starts.push_back(now.starts[0]);
    now.starts[1].name = "other", now.starts[1].x += 3;
    std::vector<Sensor> own = now.kinds[0].sensors;
    own[0].angle += 0.1f;
    now.starts[0].sensors = own;
    const auto exercise = make_exercise(draft, "strike", now, file);
    ASSERT_TRUE(exercise) << exercise.error().text();
    EXPECT_EQ(with_solution(*exercise).sensors, own);
    EXPECT_EQ(as_shipped(*exercise).sensors, own);
    ASSERT_TRUE(exercise->scene.starts[1].sensors) << "the other vehicle drives as before";
    EXPECT_EQ(*exercise->scene.starts[1].sensors, file.kinds[0].sensors);
}

}  // namespace
}  // namespace braitenlab::tests::author_test

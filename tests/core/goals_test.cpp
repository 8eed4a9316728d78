#include "core/lesson/goals.h"

#include <set>

#include <gtest/gtest.h>

#include "core/brain/brain.h"
#include "core/lesson/exercise.h"
#include "core/lesson/referee.h"

namespace braitenlab::tests::goals_test {
namespace {

Exercise with(Check check) {
    Exercise exercise;
    exercise.scene.sources.resize(2);
    exercise.scene.sources[0].name = "lamp";
    exercise.scene.sources[1].name = "fire";
    exercise.scene.sources[1].x = 10;
    exercise.scene.kinds.emplace_back().name = "kind";
    exercise.scene.starts.resize(2);
    exercise.scene.starts[0] = {"one", "kind", 3, 0, 0, {}, 0, 0};
    exercise.scene.starts[1] = {"two", "kind", 5, 0, 0, {}, 0, 0};
    exercise.steps.push_back({"", std::move(check)});
    return exercise;
}

// Vehicle `one` at (x1, 0) and `two` at (x2, 0); the lamp is at (0, 0) and the fire at (10, 0).
Snapshot at(const Exercise& exercise, std::uint64_t tick, float x1, float x2 = 50) {
    Snapshot now;
    now.tick = tick;
    now.seconds = static_cast<double>(tick) / 60;
    now.scene = std::make_shared<const Scene>(exercise.scene);
    now.sources = {{0, Channel::light, 0, 0, 1}, {1, Channel::light, 10, 0, 1}};
    for (const float x : {x1, x2}) {
        VehicleView& vehicle = now.vehicles.emplace_back();
        vehicle.id = vehicle.start = static_cast<int>(now.vehicles.size()) - 1;
        vehicle.x = x;
    }
    return now;
}

bool done_by(const Exercise& exercise, const std::vector<std::pair<float, float>>& positions) {
    Referee referee(exercise);
    for (std::size_t tick = 0; tick < positions.size(); ++tick)
        referee.watch(at(exercise, tick, positions[tick].first, positions[tick].second));
    return referee.passed();
}

const Goal near_lamp = goals::Touches{"lamp", 1}, near_fire = goals::Touches{"fire", 1};

TEST(Goals, EveryGoalHasAUniqueWord) {
    std::set<std::string_view> words;
    const auto insert = [&]<class... Goals>(const std::variant<Goals...>&) {
        (words.insert(Goals::traits.word), ...);
        EXPECT_EQ(words.size(), sizeof...(Goals));
        EXPECT_TRUE((!Goals::traits.meaning.empty() && ...));
    };
    insert(Goal{});
}

TEST(Goals, TheStateOfAGoalHasTheIndexOfTheGoal) {
    const auto expect = []<class... Goals>(const std::variant<Goals...>&) {
        for (const Goal& goal : {Goal(Goals{})...}) EXPECT_EQ(initial_state(Check{goal}).goal.index(), goal.index());
    };
    expect(Goal{});
}

TEST(Goals, ACheckAppliesToTheNamedVehicleOrToTheFirst) {
    EXPECT_TRUE(done_by(with({near_lamp}), {{0, 5}}));
    EXPECT_FALSE(done_by(with({near_lamp}), {{5, 0}}));
    EXPECT_TRUE(done_by(with({near_lamp, "two"}), {{5, 0}}));
    EXPECT_FALSE(done_by(with({near_lamp, "two"}), {{0, 5}}));
}

TEST(Goals, AHeldGoalRequiresContinuousTime) {
    const Exercise exercise = with({near_lamp, "", 0.1f});  // 6 ticks
    const auto positions = [](int near, int away, int again) {
        std::vector<std::pair<float, float>> all(static_cast<std::size_t>(near), {0, 50});
        all.insert(all.end(), static_cast<std::size_t>(away), {5, 50});
        all.insert(all.end(), static_cast<std::size_t>(again), {0, 50});
        return all;
    };
    EXPECT_FALSE(done_by(exercise, positions(6, 0, 0)));
    EXPECT_TRUE(done_by(exercise, positions(7, 0, 0)));
    EXPECT_FALSE(done_by(exercise, positions(6, 1, 6)));
    EXPECT_TRUE(done_by(exercise, positions(6, 1, 7)));
}

TEST(Goals, AHeldGoalShowsItsPresentValueAndItsTime) {
    const Exercise exercise = with({near_lamp, "", 0.5f});
    Referee referee(exercise);
    for (std::uint64_t tick = 0; tick < 13; ++tick) referee.watch(at(exercise, tick, 0.25f));
    EXPECT_EQ(referee.verdicts()[0].measures,
              (std::vector<Measure>{{0.25f, 1, "m", true, false, {}, {}, "lamp", true},
                                    {12 * tick_seconds, 0.5f, "s", false, false, {}, "hold"}}));
    referee.watch(at(exercise, 13, 2));
    EXPECT_EQ(referee.verdicts()[0].measures, (std::vector<Measure>{{2, 1, "m", true, false, {}, {}, "lamp"},
                                                                    {0, 0.5f, "s", false, false, {}, "hold"}}));
}

TEST(Goals, AllOfRequiresItsChecksAtTheSameTick) {
    const Exercise exercise = with({goals::AllOf{{{near_lamp}, {near_fire, "two"}}}});
    EXPECT_FALSE(done_by(exercise, {{0, 5}, {5, 10}}));
    EXPECT_TRUE(done_by(exercise, {{0, 5}, {0, 10}}));
}

TEST(Goals, AnyOfRequiresOneOfItsChecks) {
    const Exercise exercise = with({goals::AnyOf{{{near_lamp}, {near_fire}}}});
    EXPECT_FALSE(done_by(exercise, {{5, 0}}));
    EXPECT_TRUE(done_by(exercise, {{0, 0}}));
    EXPECT_TRUE(done_by(exercise, {{10, 0}}));
}

TEST(Goals, ACombinationIsHeldAsAWhole) {
    const Exercise exercise = with({goals::AnyOf{{{near_lamp}, {near_fire}}}, "", 2.0f / 60});
    EXPECT_TRUE(done_by(exercise, {{0, 0}, {10, 0}, {0, 0}})) << "one after the other, without a break";
    EXPECT_FALSE(done_by(exercise, {{0, 0}, {5, 0}, {0, 0}}));
}

TEST(Goals, ACombinationGivesItsVehicleToChecksWithoutOne) {
    const Exercise exercise = with({goals::AllOf{{{near_lamp}, {near_fire, "one"}}}, "two"});
    EXPECT_TRUE(done_by(exercise, {{10, 0}}));
    EXPECT_FALSE(done_by(exercise, {{0, 10}}));
}

TEST(Goals, ACombinationShowsTheValuesOfItsChecks) {
    const Exercise exercise = with({goals::AllOf{{{near_lamp}, {goals::Runs{1}}}}});
    Referee referee(exercise);
    referee.watch(at(exercise, 0, 2));
    EXPECT_EQ(referee.verdicts()[0].measures,
              (std::vector<Measure>{{2, 1, "m", true, false, {}, {}, "lamp"}, {0, 1, "s"}}));
}

TEST(Goals, ASpeedUpStaysDecidedAsPartOfACombination) {
    const Exercise exercise = with({goals::AllOf{{{goals::SpeedsUp{"lamp", 1, 1.5f}}, {goals::Runs{2}}}}});
    Referee referee(exercise);
    const auto watch = [&](std::uint64_t tick, float x, float speed) {
        Snapshot now = at(exercise, tick, x);
        now.vehicles[0].speed = speed;
        referee.watch(now);
    };
    watch(0, 3, 0), watch(60, 3, 1), watch(70, 0.5f, 2), watch(71, 3, 0.1f);
    EXPECT_FALSE(referee.passed());
    watch(120, 3, 0);
    EXPECT_TRUE(referee.passed());
}

TEST(Goals, NoneOfIsLostWhenOneOfItsChecksIsMet) {
    const Exercise exercise = with({goals::AllOf{{{goals::Runs{0.05f}}, {goals::NoneOf{{{near_lamp}}}}}}});
    EXPECT_TRUE(done_by(exercise, {{5, 0}, {5, 0}, {5, 0}, {5, 0}}));
    EXPECT_FALSE(done_by(exercise, {{5, 0}, {0, 0}, {5, 0}, {5, 0}}));
    Referee referee(exercise);
    referee.watch(at(exercise, 0, 0));
    EXPECT_TRUE(referee.lost());
}

// The first vehicle is gone at the second tick, at which the other one is at the lamp.
bool done_without_the_first(const Check& check) {
    const Exercise exercise = with(check);
    Referee referee(exercise);
    referee.watch(at(exercise, 0, 3, 5));
    Snapshot later = at(exercise, 1, 0, 0);
    later.vehicles.erase(later.vehicles.begin());
    later.events.captures = 1;
    referee.watch(later);
    return referee.passed();
}

TEST(Goals, AMissingVehicleStopsOnlyTheChecksThatAreAboutIt) {
    EXPECT_TRUE(done_without_the_first({near_lamp, "two"}));
    EXPECT_TRUE(done_without_the_first({goals::Captures{1}}));
    EXPECT_TRUE(done_without_the_first({goals::AllOf{{{goals::Population{"kind", 1}}, {goals::Captures{1}}}}}));
    EXPECT_FALSE(done_without_the_first({goals::Population{"kind", 3}}));
    EXPECT_FALSE(done_without_the_first({near_lamp}));
}

TEST(Goals, NoneOfIsNotMetWithoutAVehicleOfItsChecks) {
    const float one_tick = 1.0f / 60;
    EXPECT_FALSE(done_without_the_first({goals::NoneOf{{{near_fire}}}, "", one_tick}));
    EXPECT_TRUE(done_without_the_first({goals::NoneOf{{{near_fire, "two"}}}, "", one_tick}));
    EXPECT_TRUE(done_without_the_first({goals::NoneOf{{{goals::Captures{2}}}}, "", one_tick}));
}

TEST(Goals, NoneOfShowsTheOppositeOfWhatItsChecksNeed) {
    const auto shown = [](const Goal& goal, const std::vector<float>& positions) {
        const Exercise exercise = with({goals::NoneOf{{{goal}}}, "", 5});
        Referee referee(exercise);
        for (std::size_t tick = 0; tick < positions.size(); ++tick) referee.watch(at(exercise, tick, positions[tick]));
        return referee.verdicts()[0].measures.front();
    };
    EXPECT_EQ(shown(near_lamp, {2, 3}), (Measure{3, 1, "m", false, false, {}, {}, "lamp", true}))
        << "the present distance, at least 1";
    EXPECT_EQ(shown(goals::Captures{2}, {2}), (Measure{0, 1, "captures", true, false, {}, {}, {}, true}))
        << "fewer than 2";
    EXPECT_EQ(shown(goals::Runs{1}, {2}), (Measure{0, 1, "s", true, false, {}, {}, {}, true}));
    EXPECT_EQ(shown(goals::KeepsDistance{"lamp", 4, 6}, {3}), (Measure{3, 4, "m", true, false, {}, {}, "lamp", true}));
    EXPECT_EQ(shown(goals::KeepsDistance{"lamp", 4, 6}, {7}), (Measure{7, 6, "m", false, false, {}, {}, "lamp", true}));
}

TEST(Goals, MeasuresTellWhichValuesAreAsNeeded) {
    Check check{goals::AllOf{{{near_lamp}, {goals::Runs{60}}}}};
    check.hold = 2 / 60.0f;
    const Exercise exercise = with(check);
    Referee referee(exercise);
    const auto met = [&] {
        std::vector<bool> all;
        const std::vector<Verdict> verdicts = referee.verdicts();
        for (const Measure& each : verdicts[0].measures) all.push_back(each.met);
        return all;
    };
    referee.watch(at(exercise, 0, 3));
    EXPECT_EQ(met(), (std::vector<bool>{false, false, false}));
    referee.watch(at(exercise, 1, 0));
    EXPECT_EQ(met(), (std::vector<bool>{true, false, false})) << "at the lamp, too early";
}

TEST(Goals, ADistanceToAnotherVehicleNamesBoth) {
    const auto source_of = [](const Check& check) { return measures(check, initial_state(check)).front().source; };
    EXPECT_EQ(source_of({goals::Follows{"two", 1, 9}, "one"}), "one → two");
    EXPECT_EQ(source_of({goals::Follows{"two", 1, 9}}), "two") << "by the first one";
}

TEST(Goals, ACheckIsJudgedOnlyInItsTime) {
    Check check{near_lamp};
    check.earliest = 1, check.latest = 2;
    const Exercise exercise = with(check);
    const auto verdict = [&](std::vector<std::pair<std::uint64_t, float>> run) {
        Referee referee(exercise);
        for (const auto& [tick, x] : run) referee.watch(at(exercise, tick, x));
        return referee.verdicts().front();
    };
    EXPECT_FALSE(verdict({{0, 0}, {59, 0}}).done);
    EXPECT_TRUE(verdict({{0, 5}, {60, 0}}).done);
    EXPECT_TRUE(verdict({{0, 5}, {120, 0}}).done);
    EXPECT_FALSE(verdict({{0, 5}, {121, 0}}).done);
    EXPECT_FALSE(verdict({{0, 5}, {120, 5}}).lost);
    EXPECT_TRUE(verdict({{0, 5}, {121, 0}}).lost);
}

TEST(Goals, ACheckWaitsForTheStepBeforeIt) {
    Exercise exercise = with({near_fire});
    Check second{near_lamp};
    second.after = 1;
    exercise.steps.push_back({"", second});
    EXPECT_TRUE(done_by(exercise, {{10, 0}, {0, 0}}));
    EXPECT_FALSE(done_by(exercise, {{0, 0}, {10, 0}}));
    EXPECT_TRUE(done_by(exercise, {{0, 0}, {10, 0}, {0, 0}}));
}

TEST(Goals, TheStateOfEveryGoalIsReadBackFromJson) {
    const auto read_back = [&]<class... Goals>(const std::variant<Goals...>&) {
        for (const Goal& goal : {Goal(Goals{})...}) {
            const Exercise exercise = with({goal});
            Referee referee(exercise);
            referee.watch(at(exercise, 0, 3));
            referee.watch(at(exercise, 1, 3));
            const std::string text = write_referee_state(referee.state());
            const auto state = read_referee_state(text, exercise);
            ASSERT_TRUE(state) << text;
            EXPECT_EQ(write_referee_state(*state), text);
        }
    };
    read_back(Goal{});
}

}  // namespace
}  // namespace braitenlab::tests::goals_test

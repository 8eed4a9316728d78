// The values of the steps on the exercise card: numbers, names and signs.
#include <algorithm>
#include <cmath>

#include "desk.h"

namespace braitenlab::tests::exercise_steps_test {

using namespace ui;

namespace {

// An exercise that has run.
struct ExerciseSteps : testing::Test {
    Desk desk{1280, 1000, 1, true};

    ExerciseSteps() {
        desk.open_exercise();
        desk.lesson.has_run = true;
    }
};

}  // namespace

TEST_F(ExerciseSteps, ARangeShowsBothEnds) {
    desk.lesson.verdicts[0] = {false, {{4.2f, 1, "m", false, false, 3.0f}}, true};
    desk.lesson.verdicts[1] = {true, {{2, 1, "m", false, false, 3.0f}}};
    desk.frame(3);
    EXPECT_TRUE(desk.says("now 4.20\u00a0m, need 1.00\u00a0…\u00a03.00\u00a0m"));
    EXPECT_TRUE(desk.says("reached 2.00\u00a0m (1.00\u00a0…\u00a03.00\u00a0m)"));
    EXPECT_TRUE(desk.says("Not possible any more"));
    desk.lesson.verdicts[0] = {false, {{2, 1, "s", false, false, 3.25f}}};
    desk.frame(3);
    EXPECT_TRUE(desk.says("now 2.00\u00a0s, need 1.00\u00a0…\u00a03.25\u00a0s"));
    desk.lesson.verdicts[0] = {false, {{0.42f, 0.95f, "correlation"}}};
    desk.lesson.verdicts[1] = {false, {{1, 3, ""}}};
    desk.lesson.verdicts[2] = {false, {{0.1f, 0.15f, "m/s", true}}};
    desk.frame(3);
    EXPECT_TRUE(desk.says("Correlation now 0.42, need ≥\u00a00.95"));
    EXPECT_TRUE(desk.says("now 1, need ≥\u00a03"));
    desk.lesson.verdicts[1] = {true, {{150 * (1 / 60.0f), 2.5f, "s"}}};
    desk.frame(3);
    EXPECT_TRUE(desk.says("reached 2.5\u00a0s, needed 2.5\u00a0s or more"));
    EXPECT_TRUE(desk.says("now 0.10\u00a0m/s, need ≤\u00a00.15\u00a0m/s"));
}

TEST_F(ExerciseSteps, ValuesHaveEnoughDigitsToShowIfAStepIsDone) {
    desk.lesson.verdicts[0] = {false, {{10.4f, 10, "°", true, true}}};
    desk.lesson.verdicts[1] = {true, {{0.5972f, 0.6f, "m", true, true}}};
    desk.lesson.verdicts[2] = {false, {{1.2f, 1.5f, "×"}}};
    desk.frame(3);
    EXPECT_TRUE(desk.says("best 10.4°, need ≤\u00a010.0°"));
    EXPECT_TRUE(desk.says("reached 0.60\u00a0m, needed 0.60\u00a0m or less"));
    EXPECT_TRUE(desk.says("now 1.20\u00a0×, need ≥\u00a01.50\u00a0×")) << "the present value, not the best so far";
    desk.lesson.verdicts[0] = {true, {{9, 10, "°", true, true}}};
    desk.frame(3);
    EXPECT_TRUE(desk.says("reached 9°, needed 10° or less"));
}

TEST_F(ExerciseSteps, AReachedDistanceOfZeroIsNotOneToGo) {
    desk.lesson.verdicts[0] = {false, {{0.4f, 0, "m", true}}};
    desk.lesson.verdicts[1] = {true, {{0, 0, "m", true}}};
    desk.frame(3);
    EXPECT_TRUE(desk.says("0.40\u00a0m to go"));
    EXPECT_FALSE(desk.says("≤\u00a00.00\u00a0m")) << "the check mark says it";
}

TEST_F(ExerciseSteps, AHeldStepShowsItsPresentValueAndItsTime) {
    desk.lesson.verdicts[0] = {false, {{1.25f, 1, "m", true, false}, {2, 5, "s"}}};
    desk.frame(3);
    EXPECT_TRUE(desk.says("now 1.25\u00a0m, need ≤\u00a01.00\u00a0m"));
    EXPECT_TRUE(desk.says("now 2.0\u00a0s, need ≥\u00a05.0\u00a0s"));
}

TEST_F(ExerciseSteps, NamesTheSourceOfADistanceAndTheSmallestOne) {
    const Check near{goals::Touches{"dim", 0.5f}}, away{goals::Avoids{"red_lamp", 0.8f}};
    desk.lesson.verdicts[0] = {false, measures(near, initial_state(near))};
    desk.lesson.verdicts[1] = {false, measures(away, initial_state(away))};
    desk.lesson.verdicts[0].measures[0].value = 2, desk.lesson.verdicts[1].measures[0].value = 0.5f;
    desk.frame(3);
    EXPECT_TRUE(desk.says("Distance (dim) best 2.00\u00a0m"));
    EXPECT_TRUE(desk.says("Smallest distance (red lamp) now 0.50\u00a0m, need ≥\u00a00.80\u00a0m"));
}

TEST_F(ExerciseSteps, NamesTimesAndDistancesThatTheUnitDoesNotTellApart) {
    const auto shown_of = [](const Check& check) { return measures(check, initial_state(check)); };
    Check runs{goals::Runs{60}}, rests{goals::KeepsMoving{0.1f, 5}}, matches{goals::Matches{0.55f, 20}};
    runs.hold = 2;
    desk.lesson.verdicts[0] = {false, shown_of(runs)};
    desk.lesson.verdicts[1] = {false, shown_of(rests)};
    desk.lesson.verdicts[2] = {false, shown_of(matches)};
    desk.lesson.verdicts[2].measures[0].value = 2;  // not measured yet
    desk.frame(3);
    EXPECT_TRUE(desk.says("Time now 0.0\u00a0s, need ≥\u00a060.0\u00a0s"));
    EXPECT_TRUE(desk.says("Time held now 0.0\u00a0s, need ≥\u00a02.0\u00a0s"));
    EXPECT_TRUE(desk.says("Longest rest now 0.0\u00a0s, need ≤\u00a05.0\u00a0s"));
    EXPECT_TRUE(desk.says("Distance of the paths now 2.00\u00a0m, need ≤\u00a00.55\u00a0m"));
}

TEST_F(ExerciseSteps, NamesBothVehiclesOfADistanceAndTheTimeThatADistanceIsSteady) {
    Check follows{goals::Follows{"2", 6, 20}, "1"};
    const Check steady{goals::SteadyDistance{"lamp", 10, 30}};
    desk.lesson.verdicts[0] = {false, measures(follows, initial_state(follows))};
    desk.lesson.verdicts[0].measures[0].value = 4;
    desk.lesson.verdicts[1] = {false, measures(steady, initial_state(steady))};
    desk.frame(3);
    EXPECT_TRUE(desk.says("Distance (1 → 2) best 4.00\u00a0m"));
    EXPECT_TRUE(desk.says("Steady time now 0.0\u00a0s, need ≥\u00a030.0\u00a0s"));
}

TEST_F(ExerciseSteps, MarksTheValuesOfAnOpenStepThatAreAsNeeded) {
    Measure steady{46, 30, "s"}, far{2.3f, 3, "m", false, false, 4.0f};
    steady.met = true;
    desk.lesson.verdicts[0] = {false, {steady, far}};
    desk.frame(3);
    const auto signs_beside = [&](std::string_view words) {
        const auto at = std::find_if(desk.written.begin(), desk.written.end(),
                                     [&](const Written& each) { return each.words.find(words) != std::string::npos; });
        return at == desk.written.end()
                   ? -1
                   : std::count_if(desk.written.begin(), desk.written.end(), [&](const Written& w) {
                         return w.words == icon::check && w.rect.x < at->rect.x &&
                                std::fabs(w.rect.y - at->rect.y) < at->rect.h / 2;
                     });
    };
    EXPECT_EQ(signs_beside("now 46.0"), 1);
    EXPECT_EQ(signs_beside("now 2.30"), 0) << "this is what is missing";
    desk.lesson.verdicts[0].done = true;
    desk.frame(3);
    EXPECT_EQ(signs_beside("reached 46.0"), 0) << "the sign of the step says it";
}

}  // namespace braitenlab::tests::exercise_steps_test

// The values of the steps on the exercise card: numbers, names and signs.
#include <algorithm>
#include <cmath>

#include "desk.h"
#include "ui/panels/course/lesson_text.h"

namespace braitenlab::tests::exercise_steps_test {

using namespace ui;

namespace {

// An exercise that has run.
struct ExerciseSteps : testing::Test {
    Desk desk{1280, 1000, 1, true};

    ExerciseSteps() {
        desk.open_exercise();
        desk.lesson.attempt.work.has_run = true;
    }
};

}  // namespace

TEST_F(ExerciseSteps, ARangeShowsBothEnds) {
    desk.lesson.verdicts[0] = {false, {{4.2f, 1, "m", false, false, 3.0f}}, true};
    desk.lesson.verdicts[1] = {true, {{2, 1, "m", false, false, 3.0f}}};
    desk.frame(3);
    EXPECT_TRUE(desk.says("4.20\u00a0m,\u00a0goal\u00a01.00\u00a0to\u00a03.00"));
    EXPECT_TRUE(desk.says("2.00\u00a0m,\u00a0goal\u00a01.00\u00a0to\u00a03.00"));
    EXPECT_TRUE(desk.says("Failed in this run"));
    desk.lesson.verdicts[0] = {false, {{2, 1, "s", false, false, 3.25f}}};
    desk.frame(3);
    EXPECT_TRUE(desk.says("2.00\u00a0s,\u00a0goal\u00a01.00\u00a0to\u00a03.25"));
    desk.lesson.verdicts[0] = {false, {{0.42f, 0.95f, "correlation"}}};
    desk.lesson.verdicts[1] = {false, {{1, 3, ""}}};
    desk.lesson.verdicts[2] = {false, {{0.1f, 0.15f, "m/s", true}}};
    desk.frame(3);
    EXPECT_TRUE(desk.says("Match\n0.42\u00a0of\u00a00.95"));
    EXPECT_TRUE(desk.says("1\u00a0of\u00a03"));
    desk.lesson.verdicts[1] = {true, {{150 * (1 / 60.0f), 2.5f, "s"}}};
    desk.frame(3);
    EXPECT_TRUE(desk.says("2.5\u00a0of\u00a02.5\u00a0s"));
    EXPECT_TRUE(desk.says("0.10\u00a0m/s,\u00a0goal\u00a0≤\u00a00.15"));
}

TEST_F(ExerciseSteps, ValuesHaveEnoughDigitsToShowIfAStepIsDone) {
    desk.lesson.verdicts[0] = {false, {{10.4f, 10, "°", true, true}}};
    desk.lesson.verdicts[1] = {true, {{0.5972f, 0.6f, "m", true, true}}};
    desk.lesson.verdicts[2] = {false, {{1.2f, 1.5f, "×"}}};
    desk.frame(3);
    EXPECT_TRUE(desk.says("best\u00a010.4°,\u00a0goal\u00a0≤\u00a010.0°"));
    EXPECT_TRUE(desk.says("0.60\u00a0m,\u00a0goal\u00a0≤\u00a00.60"));
    EXPECT_TRUE(desk.says("1.20\u00a0of\u00a01.50\u00a0×")) << "the present value, not the best so far";
    desk.lesson.verdicts[0] = {true, {{9, 10, "°", true, true}}};
    desk.frame(3);
    EXPECT_TRUE(desk.says("9°,\u00a0goal\u00a0≤\u00a010"));
}

TEST_F(ExerciseSteps, AReachedDistanceOfZeroIsNotOneToGo) {
    desk.lesson.verdicts[0] = {false, {{0.4f, 0, "m", true}}};
    desk.lesson.verdicts[1] = {true, {{0, 0, "m", true}}};
    desk.frame(3);
    EXPECT_TRUE(desk.says("0.40\u00a0m\u00a0to\u00a0go"));
    EXPECT_FALSE(desk.says("0.00\u00a0m")) << "the check mark says it";
}

TEST_F(ExerciseSteps, AHeldStepShowsItsPresentValueAndItsTime) {
    desk.lesson.verdicts[0] = {false, {{1.25f, 1, "m", true, false}, {2, 5, "s"}}};
    desk.frame(3);
    EXPECT_TRUE(desk.says("1.25\u00a0m,\u00a0goal\u00a0≤\u00a01.00"));
    EXPECT_TRUE(desk.says("2.0\u00a0of\u00a05.0\u00a0s"));
}

TEST_F(ExerciseSteps, NamesTheSourceOfADistanceAndTheSmallestOne) {
    const Check near{goals::Touches{"dim", 0.5f}}, away{goals::Avoids{"red_lamp", 0.8f}};
    desk.lesson.verdicts[0] = {false, measures(near, initial_state(near))};
    desk.lesson.verdicts[1] = {false, measures(away, initial_state(away))};
    desk.lesson.verdicts[0].measures[0].value = 2, desk.lesson.verdicts[1].measures[0].value = 0.5f;
    desk.frame(3);
    EXPECT_TRUE(desk.says("Distance (dim)\nbest\u00a02.00\u00a0m"));
    EXPECT_TRUE(desk.says("Smallest distance (red lamp)\n0.50\u00a0m,\u00a0goal\u00a0≥\u00a00.80"));
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
    EXPECT_TRUE(desk.says("Time\n0.0\u00a0of\u00a060.0\u00a0s"));
    EXPECT_TRUE(desk.says("Held for\n0.0\u00a0of\u00a02.0\u00a0s"));
    EXPECT_TRUE(desk.says("Longest rest\n0.0\u00a0s,\u00a0goal\u00a0≤\u00a05.0"));
    EXPECT_TRUE(desk.says("Distance of the paths\n2.00\u00a0m,\u00a0goal\u00a0≤\u00a00.55"));
}

TEST_F(ExerciseSteps, NamesBothVehiclesOfADistanceAndTheTimeThatADistanceIsSteady) {
    Check follows{goals::Follows{"2", 6, 20}, "1"};
    const Check steady{goals::SteadyDistance{"lamp", 10, 30}};
    desk.lesson.verdicts[0] = {false, measures(follows, initial_state(follows))};
    desk.lesson.verdicts[0].measures[0].value = 4;
    desk.lesson.verdicts[1] = {false, measures(steady, initial_state(steady))};
    desk.frame(3);
    EXPECT_TRUE(desk.says("Distance (1 → 2)\nbest\u00a04.00\u00a0m"));
    EXPECT_TRUE(desk.says("Steady for\n0.0\u00a0of\u00a030.0\u00a0s"));
}

TEST_F(ExerciseSteps, MarksTheValuesOfAnOpenStepThatAreAsNeeded) {
    Measure steady{46, 30, "s"}, far{2.3f, 3, "m", false, false, 4.0f};
    steady.met = true;
    desk.lesson.verdicts[0] = {false, {steady, far}};
    desk.lesson.at_start = false;
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
    EXPECT_EQ(signs_beside("46.0\u00a0of"), 1);
    EXPECT_EQ(signs_beside("2.30\u00a0m"), 0) << "this is what is missing";
    desk.lesson.at_start = true;
    desk.frame(3);
    EXPECT_EQ(signs_beside("46.0\u00a0of"), 0) << "nothing has run yet";
    desk.lesson.at_start = false;
    desk.lesson.verdicts[0].done = true;
    desk.frame(3);
    EXPECT_EQ(signs_beside("46.0\u00a0of"), 0) << "the sign of the step says it";
}

TEST_F(ExerciseSteps, AGaugeShowsWhatIsNeededAndTheValueInOrOutsideIt) {
    const auto expect_gauge = [](const Measure& measure, float from, float to, float value) {
        const Gauge gauge = gauge_of(measure);
        EXPECT_NEAR(gauge.from, from, 1e-4f);
        EXPECT_NEAR(gauge.to, to, 1e-4f);
        EXPECT_NEAR(gauge.value, value, 1e-4f);
    };
    expect_gauge({2, 4, "s"}, 0.8f, 1, 0.4f);
    expect_gauge({9, 4, "s"}, 0.8f, 1, 1);
    expect_gauge({2, 1, "m", true}, 0, 1 / 3.0f, 2 / 3.0f);
    expect_gauge({2, 1, "m", false, false, 2.0f}, 1 / 3.0f, 2 / 3.0f, 2 / 3.0f);
    expect_gauge({-0.4f, 0.9f, "correlation"}, 0.8f, 1, 0);
}

TEST(ExerciseValues, AreOneLineWithTheirNeedInsideTheCard) {
    for (const std::string& language : shipped_codes()) {
        Desk low(1024, 768, 1, true);
        low.strings = speaking(language);
        low.open_exercise();
        low.lesson.attempt.work.has_run = true;
        Measure far{10.44f, 0.25f, "m", true, true}, between{11.25f, 10.25f, "m", false, false, 12.25f};
        low.lesson.verdicts[0] = {false, {far, between}};
        low.frame(4);
        const Rect card = low.where("card.exercise");
        int lines = 0;
        for (const Written& each : low.written)
            if (each.words.find("0.25") != std::string::npos || each.words.find("0,25") != std::string::npos) {
                ++lines;
                EXPECT_EQ(each.words.find('\n'), std::string::npos) << each.words;
                EXPECT_LE(each.rect.x + each.rect.w, card.x + card.w - 12) << each.words;
            }
        EXPECT_EQ(lines, 2) << language;
    }
}

}  // namespace braitenlab::tests::exercise_steps_test

// The card of the open exercise.
#include <algorithm>
#include <cmath>
#include <utility>

#include "desk.h"
#include "ui/panels/course/pages.h"

namespace braitenlab::tests::exercise_card_test {

using namespace ui;

namespace {

bool inside(Rect inner, Rect outer) {
    return inner.x >= outer.x && inner.y >= outer.y && inner.x + inner.w <= outer.x + outer.w + 0.5f &&
           inner.y + inner.h <= outer.y + outer.h + 0.5f;
}

bool says(const Desk& desk, std::string_view words) {
    std::string all;
    for (const Written& written : desk.written) all += written.words + "\n";
    return all.find(words) != std::string::npos;
}

// The text of the last frame, or the first line of it; null: it has not been written.
const Written* written(const Desk& desk, std::string_view words) {
    for (const Written& each : desk.written)
        if (each.words.size() > 6 && words.starts_with(each.words)) return &each;
    return nullptr;
}

// An exercise that is passed: every step is done, and every start passes.
void pass(Desk& desk) {
    desk.open_exercise();
    desk.lesson.prediction = 1;
    desk.lesson.has_run = true;
    for (Verdict& verdict : desk.lesson.verdicts) verdict.done = true;
    desk.lesson.grade = graded(std::vector<bool>(10, true), true);
}

}  // namespace

TEST(ExerciseCard, APredictionIsMadeUntilTheOutcomeIsKnown) {
    Desk desk;
    desk.open_exercise();
    desk.frame(3);
    desk.click("exercise.predict.2");
    ASSERT_EQ(desk.all.size(), 1u);
    EXPECT_EQ(std::get<PredictRequest>(desk.all[0]).option, 1);
    desk.lesson.has_run = true;
    desk.frame(3);
    desk.click("exercise.predict.1");
    ASSERT_EQ(desk.all.size(), 2u);
    EXPECT_EQ(std::get<PredictRequest>(desk.all[1]).option, 0) << "Space alone does not end it";
    desk.lesson.prediction = 1;
    desk.lesson.outcome_known = true;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("exercise.predict.2")) << "a prediction cannot be changed";
    desk.lesson.prediction = -1;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("exercise.predict.2")) << "and not be made";
}

TEST(ExerciseCard, ItsHeadingTellsExercisesOfOneNumberApart) {
    Desk desk;
    desk.open_exercise();
    desk.frame(3);
    const std::string number = std::to_string(desk.opened.number);
    EXPECT_TRUE(says(desk, "EXERCISE " + number + "\n"));
    const CatalogueEntry open{.name = desk.opened.id, .number = desk.opened.number};
    CatalogueEntry earlier = open;
    earlier.name = "0";
    const std::vector<CatalogueEntry> both{earlier, open};
    desk.view.catalogue = &both;
    desk.frame(3);
    EXPECT_TRUE(says(desk, "EXERCISE " + number + "b\n"));
}

TEST(ExerciseCard, APageOfTheManualThatItNamesHasAButton) {
    Desk desk;
    desk.open_exercise();
    desk.opened.why = "docs/robots.md shows how to build one.";
    desk.lesson.outcome_known = true;
    desk.frame(3);
    desk.panels.why_open = true;
    desk.frame(3);
    desk.click("exercise.page");
    ASSERT_TRUE(desk.last<PageRequest>());
    EXPECT_EQ(desk.last<PageRequest>()->page, "docs/robots.md");
}

TEST(ExerciseCard, ATextNamesPagesOfTheManualAlone) {
    using Pages = std::vector<std::string>;
    EXPECT_EQ(pages_in("docs/robots.md, docs/teaching.md and docs/robots.md"),
              (Pages{"docs/robots.md", "docs/teaching.md"}));
    for (const char* text :
         {"", "docs/", "docs/.md", "docs/../secret.md", "docs/a/b.md", "docs/robots.txt", "robots.md"})
        EXPECT_EQ(pages_in(text), Pages{}) << text;
}

TEST(ExerciseCard, ItsButtonsRequestAHintAndAReset) {
    Desk desk;
    desk.open_exercise();
    desk.frame(3);
    desk.click("exercise.hint");
    desk.click("exercise.reset");
    EXPECT_EQ(desk.actions(), (std::vector{Action::hint, Action::exercise_reset}));
    desk.all.clear();
    desk.lesson.hint_ready = false;
    desk.click("exercise.hint");
    EXPECT_TRUE(desk.all.empty());
}

TEST(ExerciseCard, ANoteIsShownWhenARunDoesNotCount) {
    Desk desk;
    desk.open_exercise();
    const auto said = [&] {
        desk.frame(3);
        std::string all;
        for (const Written& w : desk.written) all += w.words + " ";
        return all.find("moved or steered") != std::string::npos;
    };
    EXPECT_FALSE(said());
    desk.lesson.by_hand = true;
    EXPECT_TRUE(said());
    for (Verdict& verdict : desk.lesson.verdicts) verdict.done = true;
    EXPECT_FALSE(said()) << "no start is left to test";
}

TEST(ExerciseCard, CountsTheTestedStartsUntilTheGradeIsComplete) {
    Desk desk;
    pass(desk);
    desk.lesson.grade.reset();
    desk.lesson.starts_tested = 4;
    desk.frame(3);
    EXPECT_TRUE(says(desk, "Testing the starts: 4 of 10"));
    EXPECT_FALSE(desk.anchors.find("exercise.grade"));
    pass(desk);
    desk.lesson.starts_tested.reset();
    desk.frame(3);
    EXPECT_FALSE(says(desk, "Testing"));
    EXPECT_TRUE(desk.anchors.find("exercise.grade"));
}

TEST(ExerciseCard, ItsButtonsStayVisibleWhenTheCardIsLong) {
    Desk desk(1024, 768, 1, true);
    desk.open_exercise();
    desk.lesson.has_run = true;
    desk.lesson.hints_shown = 3;
    desk.panels.why_open = true;
    desk.lesson.grade = graded({true, false, true}, false);
    desk.frame(5);
    EXPECT_TRUE(inside(desk.where("exercise.show_me"), desk.where("card.exercise")));
    EXPECT_TRUE(inside(desk.where("exercise.reset"), desk.where("card.exercise")));
    EXPECT_TRUE(desk.anchors.find("exercise.grade"));
}

TEST(ExerciseCard, ItsFootDoesNotScroll) {
    for (const auto& [width, height] : {std::pair{1024.0f, 768.0f}, {1280.0f, 800.0f}})
        for (const char* language : {"en", "de", "es"})
            for (const bool passed : {false, true}) {
                Desk desk(width, height, 1, true);
                desk.strings = speaking(language);
                pass(desk);
                if (!passed) desk.lesson.grade.reset();
                for (int i = 0; i < 8; ++i) desk.opened.hints.push_back(desk.opened.hints.front());
                desk.lesson.hints_shown = 11;
                desk.lesson.notes = "Two wires.";
                desk.panels.why_open = desk.panels.hand_in.asks = true;
                desk.frame(6);
                const Rect card = desk.where("card.exercise");
                for (const Shown& shown : desk.shown)
                    for (const char* id : {"exercise.show_me", "exercise.next", "exercise.reset", "exercise.note",
                                           "exercise.hand_in", "exercise.lab_record", "exercise.student"})
                        EXPECT_TRUE(shown.id != id || inside(shown.rect, card))
                            << id << ", " << language << ", " << width;
                for (const char* id :
                     {"exercise.reset", "exercise.note", "exercise.hand_in", "exercise.lab_record", "exercise.student"})
                    EXPECT_TRUE(desk.anchors.find(id)) << id << ", " << language << ", " << width;
            }
}

TEST(ExerciseCard, TheNoteFieldIsInSightOnceItIsUnfolded) {
    Desk desk(1024, 768, 1, true);
    desk.open_exercise();
    for (int i = 0; i < 12; ++i) desk.opened.hints.push_back(desk.opened.hints.front());
    desk.lesson.hints_shown = 15;
    desk.panels.why_open = true;
    desk.frame(5);
    desk.click("exercise.note");
    desk.frame(4);
    EXPECT_TRUE(desk.panels.note.active);
    EXPECT_GT(desk.where("exercise.note.text").h, 80);
}

TEST(ExerciseCard, EnterOpensTheNextExerciseOnceItIsPassed) {
    Desk desk;
    const std::vector<CatalogueEntry> more{{"06-love", "6.toml", "Love", "", 6}};
    desk.view.catalogue = &more;
    pass(desk);
    desk.panels.keyboard.focus = "slider.LL";
    desk.panels.keyboard.shown = false;
    desk.frame(3);
    const auto grade = std::exchange(desk.lesson.grade, std::nullopt);
    desk.key({key::enter});
    desk.frame(2);
    EXPECT_FALSE(desk.last<OpenRequest>()) << "not passed";
    EXPECT_EQ(desk.panels.sliders.typed, "slider.LL");
    desk.key({key::escape});
    desk.frame(2);
    desk.lesson.grade = grade;
    desk.panels.keyboard.focus = "exercise.reset";
    desk.panels.keyboard.shown = true;
    desk.frame(2);
    desk.key({key::enter});
    desk.frame(2);
    EXPECT_FALSE(desk.last<OpenRequest>()) << "the focused button has Enter";
    EXPECT_EQ(desk.actions(), std::vector{Action::exercise_reset});
    desk.panels.keyboard.focus = "slider.LL";
    desk.panels.keyboard.shown = false;
    desk.key({key::enter});
    desk.frame(2);
    ASSERT_TRUE(desk.last<OpenRequest>()) << "a focus without a ring";
    EXPECT_TRUE(desk.last<OpenRequest>()->next_exercise);
    EXPECT_TRUE(desk.panels.sliders.typed.empty());
}

TEST(ExerciseCard, TellsNothingOfTheOutcomeBeforeThePrediction) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    desk.frame(3);
    EXPECT_FALSE(says(desk, "Aggressor"));
    EXPECT_FALSE(desk.anchors.find("exercise.why"));
    EXPECT_FALSE(desk.anchors.find("equations"));
    EXPECT_TRUE(says(desk, "predict first"));
    EXPECT_TRUE(desk.anchors.find("brain.picture"));
    desk.opened.prediction.hides_brain = true;
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("brain.picture"));
    desk.lesson.prediction = 0;
    desk.frame(3);
    EXPECT_TRUE(says(desk, "Aggressor"));
    for (const char* id : {"exercise.why", "equations", "brain.picture"}) EXPECT_TRUE(desk.anchors.find(id)) << id;
    EXPECT_FALSE(says(desk, "predict first"));
}

TEST(ExerciseCard, ShowsTheSolutionAfterTheLastHint) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    desk.lesson.has_run = true;
    desk.lesson.hints_shown = 2;
    desk.frame(3);
    EXPECT_TRUE(desk.anchors.find("exercise.hint"));
    EXPECT_FALSE(desk.anchors.find("exercise.show_me"));
    desk.lesson.hints_shown = 3;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("exercise.hint"));
    desk.click("exercise.show_me");
    EXPECT_TRUE(desk.last<ShowMeRequest>());
}

TEST(ExerciseCard, AStartsPictureReplaysIt) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    desk.lesson.has_run = true;
    desk.lesson.grade = graded({true, false, true}, false);
    desk.lesson.grade->starts[1].verdicts = {Verdict{true, {}}, Verdict{false, {{1.25f, 0.6f, "m", true, true}}}};
    desk.frame(5);
    desk.click("exercise.start.2");
    const auto* seed = desk.last<SeedRequest>();
    ASSERT_TRUE(seed);
    EXPECT_EQ(seed->seed, 2u);
    desk.point("exercise.reset");
    desk.frame(2);
    desk.point("exercise.start.2");
    desk.frame(60);
    EXPECT_TRUE(says(desk, "Start 2 fails: Touch the lamp"));
    EXPECT_TRUE(says(desk, "now 1.25\u00a0m") || says(desk, "best 1.25\u00a0m"));
}

TEST(ExerciseCard, TheReasonIsFoldedInTheNextExercise) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    desk.lesson.prediction = 0;
    desk.frame(2);
    desk.panels.why_open = true;
    desk.frame(2);
    EXPECT_TRUE(desk.panels.why_open);
    desk.opened.id = "06-love";
    desk.frame(2);
    EXPECT_FALSE(desk.panels.why_open);
}

TEST(ExerciseCard, SaysThatThePassedSolutionWasShown) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    desk.lesson.has_run = true;
    desk.lesson.grade = graded(std::vector<bool>(10, true), true);
    desk.frame(3);
    EXPECT_TRUE(says(desk, "Well done"));
    desk.lesson.solution_shown = true;
    desk.frame(3);
    EXPECT_FALSE(says(desk, "Well done"));
    EXPECT_TRUE(says(desk, "do it yourself"));
}

TEST(ExerciseCard, AMadePredictionIsFixedOnceTheVehicleHasRun) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    desk.frame(3);
    desk.click("exercise.predict.1");
    EXPECT_TRUE(desk.last<PredictRequest>());
    desk.lesson.prediction = 0;
    desk.lesson.has_run = true;
    desk.panels.keyboard.focus = "exercise.predict.1";
    desk.all.clear();
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("exercise.predict.2")) << "the steps need its room";
    EXPECT_TRUE(says(desk, "You predicted")) << "the chosen answer stays";
    EXPECT_EQ(desk.panels.keyboard.focus, "") << "the focus is on no row that is gone";
    desk.key({'2'});
    EXPECT_FALSE(desk.last<PredictRequest>());
}

TEST(ExerciseCard, ASecretBrainIsNotShown) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    desk.lesson.prediction = 0;
    desk.opened.hides = {desk.now.scene->kinds[static_cast<std::size_t>(desk.now.vehicles[0].kind)].name};
    desk.frame(3);
    for (const char* id : {"slider.LL", "equations", "brain.picture"}) EXPECT_FALSE(desk.anchors.find(id)) << id;
    desk.view.mode = Mode::wiring;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("wire.LL"));
    EXPECT_TRUE(says(desk, "brain is hidden"));
}

TEST(ExerciseCard, ARangeShowsBothEnds) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    desk.lesson.has_run = true;
    desk.lesson.verdicts[0] = {false, {{4.2f, 1, "m", false, false, 3.0f}}, true};
    desk.lesson.verdicts[1] = {true, {{2, 1, "m", false, false, 3.0f}}};
    desk.frame(3);
    EXPECT_TRUE(says(desk, "now 4.20\u00a0m, need 1.00\u00a0…\u00a03.00\u00a0m"));
    EXPECT_TRUE(says(desk, "reached 2.00\u00a0m (1.00\u00a0…\u00a03.00\u00a0m)"));
    EXPECT_TRUE(says(desk, "Not possible any more"));
    desk.lesson.verdicts[0] = {false, {{2, 1, "s", false, false, 3.25f}}};
    desk.frame(3);
    EXPECT_TRUE(says(desk, "now 2.00\u00a0s, need 1.00\u00a0…\u00a03.25\u00a0s"));
    desk.lesson.verdicts[0] = {false, {{0.42f, 0.95f, "correlation"}}};
    desk.lesson.verdicts[1] = {false, {{1, 3, ""}}};
    desk.lesson.verdicts[2] = {false, {{0.1f, 0.15f, "m/s", true}}};
    desk.frame(3);
    EXPECT_TRUE(says(desk, "Correlation now 0.42, need ≥\u00a00.95"));
    EXPECT_TRUE(says(desk, "now 1, need ≥\u00a03"));
    desk.lesson.verdicts[1] = {true, {{150 * (1 / 60.0f), 2.5f, "s"}}};
    desk.frame(3);
    EXPECT_TRUE(says(desk, "reached 2.5\u00a0s, needed 2.5\u00a0s or more"));
    EXPECT_TRUE(says(desk, "now 0.10\u00a0m/s, need ≤\u00a00.15\u00a0m/s"));
}

TEST(ExerciseCard, ValuesHaveEnoughDigitsToShowIfAStepIsDone) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    desk.lesson.has_run = true;
    desk.lesson.verdicts[0] = {false, {{10.4f, 10, "°", true, true}}};
    desk.lesson.verdicts[1] = {true, {{0.5972f, 0.6f, "m", true, true}}};
    desk.lesson.verdicts[2] = {false, {{1.2f, 1.5f, "×"}}};
    desk.frame(3);
    EXPECT_TRUE(says(desk, "best 10.4°, need ≤\u00a010.0°"));
    EXPECT_TRUE(says(desk, "reached 0.60\u00a0m, needed 0.60\u00a0m or less"));
    EXPECT_TRUE(says(desk, "now 1.20\u00a0×, need ≥\u00a01.50\u00a0×")) << "the present value, not the best so far";
    desk.lesson.verdicts[0] = {true, {{9, 10, "°", true, true}}};
    desk.frame(3);
    EXPECT_TRUE(says(desk, "reached 9°, needed 10° or less"));
}

TEST(ExerciseCard, AHeldStepShowsItsPresentValueAndItsTime) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    desk.lesson.has_run = true;
    desk.lesson.verdicts[0] = {false, {{1.25f, 1, "m", true, false}, {2, 5, "s"}}};
    desk.frame(3);
    EXPECT_TRUE(says(desk, "now 1.25\u00a0m, need ≤\u00a01.00\u00a0m"));
    EXPECT_TRUE(says(desk, "now 2.0\u00a0s, need ≥\u00a05.0\u00a0s"));
}

TEST(ExerciseCard, NamesTheSourceOfADistanceAndTheSmallestOne) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    desk.lesson.has_run = true;
    const Check near{goals::Touches{"dim", 0.5f}}, away{goals::Avoids{"red_lamp", 0.8f}};
    desk.lesson.verdicts[0] = {false, measures(near, initial_state(near))};
    desk.lesson.verdicts[1] = {false, measures(away, initial_state(away))};
    desk.lesson.verdicts[0].measures[0].value = 2, desk.lesson.verdicts[1].measures[0].value = 0.5f;
    desk.frame(3);
    EXPECT_TRUE(says(desk, "Distance (dim) best 2.00\u00a0m"));
    EXPECT_TRUE(says(desk, "Smallest distance (red lamp) now 0.50\u00a0m, need ≥\u00a00.80\u00a0m"));
}

TEST(ExerciseCard, NamesTimesAndDistancesThatTheUnitDoesNotTellApart) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    desk.lesson.has_run = true;
    const auto shown_of = [](const Check& check) { return measures(check, initial_state(check)); };
    Check runs{goals::Runs{60}}, rests{goals::KeepsMoving{0.1f, 5}}, matches{goals::Matches{0.55f, 20}};
    runs.hold = 2;
    desk.lesson.verdicts[0] = {false, shown_of(runs)};
    desk.lesson.verdicts[1] = {false, shown_of(rests)};
    desk.lesson.verdicts[2] = {false, shown_of(matches)};
    desk.lesson.verdicts[2].measures[0].value = 2;  // not measured yet
    desk.frame(3);
    EXPECT_TRUE(says(desk, "Time now 0.0\u00a0s, need ≥\u00a060.0\u00a0s"));
    EXPECT_TRUE(says(desk, "Time held now 0.0\u00a0s, need ≥\u00a02.0\u00a0s"));
    EXPECT_TRUE(says(desk, "Longest rest now 0.0\u00a0s, need ≤\u00a05.0\u00a0s"));
    EXPECT_TRUE(says(desk, "Distance of the paths now 2.00\u00a0m, need ≤\u00a00.55\u00a0m"));
}

TEST(ExerciseCard, NamesBothVehiclesOfADistanceAndTheTimeThatADistanceIsSteady) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    desk.lesson.has_run = true;
    Check follows{goals::Follows{"2", 6, 20}, "1"};
    const Check steady{goals::SteadyDistance{"lamp", 10, 30}};
    desk.lesson.verdicts[0] = {false, measures(follows, initial_state(follows))};
    desk.lesson.verdicts[0].measures[0].value = 4;
    desk.lesson.verdicts[1] = {false, measures(steady, initial_state(steady))};
    desk.frame(3);
    EXPECT_TRUE(says(desk, "Distance (1 → 2) best 4.00\u00a0m"));
    EXPECT_TRUE(says(desk, "Steady time now 0.0\u00a0s, need ≥\u00a030.0\u00a0s"));
}

TEST(ExerciseCard, MarksTheValuesOfAnOpenStepThatAreAsNeeded) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    desk.lesson.has_run = true;
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

TEST(ExerciseCard, TheOutcomeIsShownAsSoonAsItIsKnownAndInTheVisiblePartOfTheCard) {
    for (const bool passed : {false, true}) {
        Desk desk(1024, 768, 1, true);
        desk.open_exercise();
        desk.panels.why_open = true;
        desk.lesson.hints_shown = 3;
        if (passed) pass(desk);
        desk.lesson.prediction = 0;
        desk.frame(4);
        EXPECT_FALSE(says(desk, "What happened"));
        desk.lesson.outcome_known = true;
        desk.frame(4);
        bool visible = false;
        for (const Written& w : desk.written)
            visible |= w.words.starts_with("What happened: It turned away") && inside(w.rect, w.clip);
        EXPECT_TRUE(visible) << passed;
    }
}

TEST(ExerciseCard, SaysThatTheOutcomeIsOlderThanTheChangesOfTheBrain) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    desk.lesson.prediction = 0;
    desk.lesson.has_run = true;
    desk.lesson.outcome_known = true;
    desk.frame(3);
    EXPECT_TRUE(says(desk, "What happened: It turned away."));
    desk.lesson.as_given = false;
    desk.frame(3);
    EXPECT_TRUE(says(desk, "Without your changes: It turned away."));
}

TEST(ExerciseCard, TellsNoneSomeAndAllOfTheStartsApart) {
    Desk desk(1280, 1000, 1, true);
    pass(desk);
    desk.frame(3);
    EXPECT_TRUE(says(desk, "It works from every start."));
    desk.lesson.grade = graded({true, true, false}, true);
    desk.frame(3);
    EXPECT_TRUE(says(desk, "It works from other starts too."));
    desk.lesson.grade = graded({true, false, false}, false);
    desk.frame(3);
    EXPECT_TRUE(says(desk, "It works from some places only"));
    desk.lesson.grade = graded({false, false, false}, false);
    desk.frame(3);
    EXPECT_FALSE(says(desk, "It works from some places only"));
    EXPECT_TRUE(says(desk, "works from none of them"));
}

TEST(ExerciseCard, SaysWhichRunTheTicksAreOf) {
    Desk desk(1280, 1000, 1, true);
    pass(desk);
    desk.frame(3);
    EXPECT_FALSE(says(desk, "The ticks are of the present run"));
    desk.lesson.verdicts[0].done = false;  // after a reset
    desk.frame(3);
    EXPECT_TRUE(says(desk, "The ticks are of the present run"));
    desk.lesson.changed_since_done = true;
    desk.frame(3);
    EXPECT_TRUE(says(desk, "The brain has changed since these ticks"));
}

TEST(ExerciseCard, KeepsTheNextButtonOnceItWasPassed) {
    for (const char* language : {"en", "de", "es"}) {
        Desk desk(1024, 768, 1, true);
        desk.strings = speaking(language);
        pass(desk);
        desk.lesson.grade.reset();  // the brain is another one now
        desk.frame(3);
        EXPECT_FALSE(desk.anchors.find("exercise.next"));
        desk.lesson.passed_before = true;
        desk.frame(3);
        EXPECT_TRUE(inside(desk.where("exercise.next"), desk.where("card.exercise"))) << language;
        EXPECT_TRUE(inside(desk.where("exercise.hint"), desk.where("card.exercise"))) << language;
        EXPECT_TRUE(inside(desk.where("exercise.reset"), desk.where("card.exercise"))) << language;
    }
}

TEST(ExerciseCard, EveryStepAndTheNextButtonAreVisibleOnceItIsPassed) {
    for (const char* language : {"en", "de", "es"}) {
        Desk desk(1024, 768, 1, true);
        desk.strings = speaking(language);
        pass(desk);
        desk.panels.why_open = true;
        desk.lesson.hints_shown = 3;
        desk.frame(5);
        const Rect card = desk.where("card.exercise"), buttons = desk.where("exercise.next");
        EXPECT_TRUE(inside(buttons, card)) << language;
        for (const char* step : {"exercise.step.1", "exercise.step.2", "exercise.step.3"}) {
            const Rect r = desk.where(step);
            EXPECT_GT(r.h, 30) << language << ": " << step << " is cut";
            EXPECT_LT(r.y + r.h, buttons.y + 1) << language;
        }
    }
}

TEST(ExerciseCard, ItsNextButtonOpensTheNextExerciseOrTheListOfFiles) {
    Desk desk;
    const std::vector<CatalogueEntry> more{{"05-aggressor", "5.toml", "Aggressor", "", 5},
                                           {"08-overrun", "8.toml", "Overrun", "", 8},
                                           {"06-love", "6.toml", "Love", "", 6},
                                           {"2a-coward", "2a.toml", "Coward", "It turns away."}};
    pass(desk);
    desk.view.catalogue = &more;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("exercise.hint")) << "a passed exercise needs no hint";
    desk.click("exercise.next");
    ASSERT_EQ(desk.all.size(), 1u);
    EXPECT_EQ(std::get<OpenRequest>(desk.all[0]).path, "6.toml");
    EXPECT_TRUE(std::get<OpenRequest>(desk.all[0]).next_exercise);
    desk.opened.number = 0;
    desk.click("exercise.next");
    EXPECT_EQ(desk.all.size(), 1u) << "an exercise of one's own is in no order: the list opens";
    EXPECT_EQ(desk.panels.sheet, Sheet::files);
    desk.opened.number = 5;
    desk.panels.sheet = Sheet::none;
    const std::vector<CatalogueEntry> last{more[0], more[3]};
    desk.view.catalogue = &last;
    desk.click("exercise.next");
    EXPECT_EQ(desk.panels.sheet, Sheet::files);
}

TEST(ExerciseCard, HandInAsksForANameOnceAndIsThereAfterARun) {
    Desk desk;
    desk.open_exercise();
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("exercise.hand_in")) << "before the first run";
    desk.lesson.has_run = true;
    desk.frame(3);
    desk.click("exercise.hand_in");
    desk.frame(3);
    EXPECT_TRUE(desk.all.empty()) << "there is no name";
    ASSERT_TRUE(desk.anchors.find("exercise.student"));
    desk.type("Ana P ");
    desk.frame(2);
    desk.key({key::enter});
    desk.frame(3);
    ASSERT_EQ(desk.all.size(), 1u);
    EXPECT_EQ(std::get<HandInRequest>(desk.all[0]).student, "Ana P");
    EXPECT_FALSE(desk.anchors.find("exercise.student"));
    desk.click("exercise.hand_in");
    ASSERT_EQ(desk.all.size(), 2u) << "the name is known";
    desk.click("exercise.lab_record");
    ASSERT_EQ(desk.all.size(), 3u);
    EXPECT_TRUE(std::holds_alternative<LabRecordRequest>(desk.all[2]));
}

TEST(ExerciseCard, ANameTypedAtHandInBecomesTheNameOfTheStudent) {
    Desk desk;
    desk.open_exercise();
    desk.lesson.has_run = true;
    StudentBook book;
    book.all.push_back({"Bo", {}});
    desk.view.students = &book;
    desk.frame(3);
    desk.click("exercise.hand_in");
    desk.frame(3);
    desk.type("Ana");
    desk.frame(2);
    desk.key({key::enter});
    desk.frame(3);
    ASSERT_EQ(desk.all.size(), 2u);
    ASSERT_TRUE(std::holds_alternative<StudentRequest>(desk.all[0]));
    EXPECT_EQ(std::get<StudentRequest>(desk.all[0]).edit, StudentEdit::rename);
    EXPECT_EQ(std::get<StudentRequest>(desk.all[0]).name, "Ana");
    EXPECT_EQ(std::get<HandInRequest>(desk.all[1]).student, "Ana");

    desk.all.clear();
    book.all.push_back({"Ana", {}});
    desk.click("exercise.hand_in");
    ASSERT_EQ(desk.all.size(), 1u) << "a name is not taken from another student";
    EXPECT_TRUE(std::holds_alternative<HandInRequest>(desk.all[0]));
}

TEST(ExerciseCard, TheFileHandedInIsNamedAndItsPathCanBeCopied) {
    Desk desk(1024, 768, 1, true);
    desk.open_exercise();
    desk.lesson.has_run = true;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("exercise.copy_path"));
    desk.lesson.written = "/home/ana/Documents/Braitenlab/05-ana.toml";
    desk.frame(3);
    EXPECT_TRUE(says(desk, "05-ana.toml"));
    desk.click("exercise.copy_path");
    EXPECT_STREQ(ImGui::GetClipboardText(), desk.lesson.written.c_str());
}

TEST(ExerciseCard, HandInUsesTheNameOfTheNamedStudent) {
    Desk desk;
    desk.open_exercise();
    desk.lesson.has_run = true;
    desk.view.student = "Bo";
    desk.frame(3);
    desk.click("exercise.hand_in");
    ASSERT_EQ(desk.all.size(), 1u);
    EXPECT_EQ(std::get<HandInRequest>(desk.all[0]).student, "Bo");
}

TEST(ExerciseCard, ShowsTheStepsAboveTheOutcomeAlsoWhenTheBrainIsChanged) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    desk.lesson.has_run = desk.lesson.outcome_known = true;
    desk.lesson.prediction = 0;
    desk.lesson.outcome_known = false;
    desk.frame(3);
    EXPECT_LT(desk.where("exercise.predict").y, desk.where("exercise.step.1").y) << "first the question";
    desk.lesson.outcome_known = true;
    desk.frame(3);
    EXPECT_GT(desk.where("exercise.predict").y, desk.where("exercise.step.1").y);
    desk.lesson.as_given = false;
    desk.frame(3);
    EXPECT_GT(desk.where("exercise.predict").y, desk.where("exercise.step.1").y);
}

TEST(ExerciseCard, HasNoNumberForAnExerciseOutsideTheCourse) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    desk.opened.number = 0;
    desk.frame(3);
    const auto writes = [&](std::string_view words) {
        return std::any_of(desk.written.begin(), desk.written.end(),
                           [&](const Written& written) { return written.words == words; });
    };
    EXPECT_TRUE(writes("EXERCISE"));
    EXPECT_FALSE(writes("EXERCISE 0"));
}

TEST(ExerciseCard, AReachedDistanceOfZeroIsNotOneToGo) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    desk.lesson.has_run = true;
    desk.lesson.verdicts[0] = {false, {{0.4f, 0, "m", true}}};
    desk.lesson.verdicts[1] = {true, {{0, 0, "m", true}}};
    desk.frame(3);
    EXPECT_TRUE(says(desk, "0.40\u00a0m to go"));
    EXPECT_FALSE(says(desk, "≤\u00a00.00\u00a0m")) << "the check mark says it";
}

TEST(ExerciseCard, TitleAndGoalStayInSightAndTheNewestHintIsBelowThemInTheWiringEditor) {
    for (const char* language : {"en", "de", "es"}) {
        Desk desk(1024, 768, 1, true);
        desk.strings = speaking(language);
        desk.open_exercise();
        desk.opened.offers = {"wiring"};
        desk.lesson.prediction = 1;
        desk.lesson.has_run = desk.lesson.outcome_known = true;
        desk.frame(6);
        for (const Mode mode : {Mode::paused, Mode::wiring}) {
            desk.view.mode = mode;
            desk.lesson.hints_shown = 0;
            desk.frame(6);
            for (int hint = 1; hint <= 3; ++hint) {
                desk.lesson.hints_shown = hint;
                desk.frame(6);
                const Written* goal = written(desk, desk.opened.goal);
                const Written* newest = written(desk, desk.opened.hints[static_cast<std::size_t>(hint - 1)].text);
                ASSERT_TRUE(written(desk, "Aggressor") && goal && newest) << language << hint;
                EXPECT_TRUE(inside(goal->rect, goal->clip)) << language;
                EXPECT_TRUE(inside(newest->rect, newest->clip)) << language << ": hint " << hint << " is cut";
                EXPECT_GE(newest->rect.y, goal->rect.y + goal->rect.h) << language;
                if (mode == Mode::wiring) {
                    EXPECT_LT(newest->rect.y, goal->rect.y + 130) << language;
                }
            }
        }
    }
}

}  // namespace braitenlab::tests::exercise_card_test

// The prediction on the exercise card, the path drawn on the floor, and the run with the solution.
#include "ui/panels/course/prediction.h"

#include <algorithm>
#include <functional>

#include "exercise_on_desk.h"
#include "scene_on_desk.h"

namespace braitenlab::tests::prediction_test {

using namespace ui;
using maths::vec2;

namespace {

// An exercise that asks for the path of the first vehicle, which is at (0, 0).
struct PathPrediction : SceneOnDesk {
    PathPrediction() {
        desk.open_exercise();
        auto scene = std::make_shared<Scene>(*desk.now.scene);
        desk.opened.scene.starts.resize(1);
        desk.opened.scene.starts[0].name = "one";
        desk.opened.prediction.path_of = "one";
        scene->starts = desk.opened.scene.starts;
        desk.now.scene = scene;
        desk.now.vehicles[0].start = 0;
        desk.view.camera_view = &camera_view;
        desk.frame(3);
    }
    Found<PredictPathRequest> drawn() const { return requests<PredictPathRequest>(); }
};

}  // namespace

TEST_F(PathPrediction, ADragDrawsFromTheVehicle) {
    desk.click("exercise.draw");
    EXPECT_TRUE(desk.anchors.find("stage.path"));
    hold({0.2f, 0}, {4, 3});
    release();
    ASSERT_EQ(drawn().size(), 1u);
    const std::vector<vec2> path = drawn()[0].path;
    EXPECT_EQ(path.front(), (vec2{desk.now.vehicles[0].x, desk.now.vehicles[0].y}));
    EXPECT_NEAR(path.back().x, 4, 2 * a_pixel);
    EXPECT_NEAR(path.back().y, 3, 2 * a_pixel);
    for (std::size_t i = 1; i < path.size(); ++i)
        EXPECT_LE(maths::distance(path[i - 1], path[i]), 1.01f) << "also where the pointer was fast";
    EXPECT_TRUE(desk.edits().empty()) << "the vehicle is not moved";
    EXPECT_FALSE(scene_input().path.on);
}

TEST_F(PathPrediction, APressOnAnotherVehicleIsRefusedAndTheHintNamesTheRightOne) {
    VehicleView other = desk.now.vehicles[0];
    other.id = 1, other.start = -1, other.x = 3;
    desk.now.vehicles.push_back(other);
    desk.click("exercise.draw");
    EXPECT_TRUE(desk.says("Press on vehicle 1, drag"));
    hold({3, 0}, {5, 3});
    release();
    EXPECT_TRUE(drawn().empty());
    ASSERT_TRUE(desk.last<NoticeRequest>());
    EXPECT_EQ(desk.last<NoticeRequest>()->key, "notice.draw_from_vehicle");
    EXPECT_TRUE(scene_input().path.on) << "the next drag draws";
}

TEST_F(PathPrediction, AShortPathIsDiscardedAndEscapeEndsTheDrawing) {
    desk.click("exercise.draw");
    hold({0, 0}, {0.1f, 0});
    release();
    EXPECT_TRUE(drawn().empty());
    EXPECT_TRUE(scene_input().path.on) << "the next drag draws";
    desk.key({key::escape});
    EXPECT_FALSE(scene_input().path.on);
    hold({0, 0}, {3, 2});
    release();
    EXPECT_TRUE(drawn().empty());
}

TEST_F(PathPrediction, ItIsDrawnAtTheStartOfARunOnly) {
    desk.lesson.at_start = false;
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("exercise.draw"));
    desk.lesson.at_start = true;
    desk.frame(2);
    desk.click("exercise.draw");
    EXPECT_TRUE(scene_input().path.on);
    desk.lesson.at_start = false;
    desk.frame(2);
    EXPECT_FALSE(scene_input().path.on) << "the run has begun";
}

TEST_F(PathPrediction, ArrowKeysDrawFromTheVehicleAndEnterMakesItThePrediction) {
    desk.click("exercise.draw");
    for (const int way : {key::right, key::right, key::up, key::up}) desk.key({way});
    desk.key({key::backspace});
    desk.frame(2);
    EXPECT_TRUE(drawn().empty());
    desk.key({key::enter});
    ASSERT_EQ(drawn().size(), 1u);
    const std::vector<vec2> path = drawn()[0].path;
    const vec2 start{desk.now.vehicles[0].x, desk.now.vehicles[0].y};
    ASSERT_EQ(path.size(), 4u) << "Backspace takes one step back";
    EXPECT_EQ(path.front(), start);
    EXPECT_NEAR(maths::distance(path.back(), start), std::hypot(0.5f, 0.25f), 1e-3f);
    EXPECT_FALSE(scene_input().path.on);
    EXPECT_TRUE(desk.edits().empty()) << "the vehicle is not moved";
}

TEST_F(PathPrediction, ADrawnPathIsAPrediction) {
    desk.follow_disclosure();
    EXPECT_TRUE(hides_outcome(desk.view));
    desk.lesson.attempt.answers.drawn_path = {{0, 0}, {1, 0}};
    desk.follow_disclosure();
    EXPECT_TRUE(hides_outcome(desk.view)) << "it can still be changed";
    EXPECT_TRUE(desk.view.may.open_prediction);
    begin_run(desk);
    desk.follow_disclosure();
    EXPECT_FALSE(hides_outcome(desk.view));
    EXPECT_FALSE(desk.view.may.open_prediction);
}

TEST(PredictionPart, SaysWhetherTheChosenOptionCameTrueAndHowFarAPathIsOff) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    predict_and_run(desk, 1);
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("exercise.came_true")) << "the outcome is not known";
    desk.lesson.attempt.work.outcome_known = true;
    desk.frame(3);
    EXPECT_TRUE(desk.says("Your prediction came true."));
    desk.lesson.attempt.answers.prediction = 0;
    desk.frame(3);
    EXPECT_TRUE(desk.says("Your prediction did not come true."));
    EXPECT_FALSE(desk.says("on average"));
    desk.lesson.attempt.answers.prediction = -1;
    desk.lesson.attempt.answers.drawn_path = desk.lesson.attempt.work.real_path = {{0, 0}, {1, 0}};
    desk.lesson.attempt.work.path_difference = 0.62f;
    desk.frame(3);
    EXPECT_TRUE(desk.says("differ by 0.6\u00a0m on average"));
    EXPECT_TRUE(desk.says("the vehicle is 1.0\u00a0m long")) << "what the number means";
    EXPECT_FALSE(desk.says("the other way round"));
    desk.lesson.attempt.work.path_reversed = true;
    desk.frame(3);
    EXPECT_TRUE(desk.says("the other way round"));
    EXPECT_FALSE(desk.anchors.find("exercise.came_true")) << "no option was chosen";
}

TEST(PredictionPart, AsksForARunOfTheSceneAsGivenOnceTheStudentHasChangedIt) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("exercise.as_given"));
    desk.lesson.as_given = false;
    desk.frame(3);
    EXPECT_TRUE(desk.anchors.find("exercise.as_given"));
    predict_and_run(desk, 1);
    desk.frame(3);
    EXPECT_TRUE(desk.says("Start over, then Play"));
    EXPECT_FALSE(desk.anchors.find("exercise.came_true"));
    desk.lesson.attempt.work.outcome_known = true;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("exercise.as_given"));
}

TEST(PredictionPart, ShowsTheWayBackToTheSceneAsGivenInCardAndBrain) {
    for (const std::string& language : shipped_codes()) {
        Desk desk(1024, 600, 1, true);  // low, but with both cards beside the scene
        desk.strings = speaking(language);
        desk.open_exercise();
        desk.opened.prediction.hides_brain = true;
        const auto says = [&](std::string_view key) {
            desk.follow_disclosure();
            desk.frame(6);
            EXPECT_EQ(way_to_brain(desk.view), key);
            const std::string words(desk.strings(key));
            return desk.says(words.substr(0, words.find(' ')));
        };
        EXPECT_TRUE(says("wiring.answer_first")) << language;
        EXPECT_FALSE(desk.anchors.find("exercise.reset")) << "folded below “…”, " << language;
        desk.lesson.as_given = false;  // a slider was turned before the answer
        EXPECT_TRUE(says("wiring.answer_after_start_over")) << language;
        const Rect* way = desk.anchors.find("exercise.reset");
        ASSERT_TRUE(way) << language;
        EXPECT_TRUE(inside(*way, desk.where("card.exercise"))) << language;
        EXPECT_FALSE(desk.anchors.find("exercise.note")) << "alone, " << language;
        const std::string& pulsing = desk.panels.prompts.highlight.anchor;
        EXPECT_EQ(pulsing, "exercise.reset") << language;
        desk.view.undo_depth = 1;
        desk.click("exercise.reset");
        desk.frame(2);
        EXPECT_EQ(pulsing, "exercise.reset_yes") << "it asks, " << language;
        desk.click("exercise.reset_no");
        desk.view.undo_depth = 0;
        desk.lesson.as_given = true;
        begin_run(desk);
        EXPECT_TRUE(says("wiring.answer_after_reset")) << language;
    }
}

TEST(PredictionPart, TheFirstPlayPointsToTheQuestionAndTheSecondSkipsIt) {
    for (const KeyPress key : {KeyPress{' '}, KeyPress{'.'}}) {
        Desk desk(1024, 768, 1, true);
        desk.open_exercise();
        desk.panels.card(Card::exercise).folded = true;
        desk.frame(3);
        desk.key(key);
        desk.frame(2);
        EXPECT_TRUE(desk.actions().empty());
        EXPECT_TRUE(desk.says("Answer first"));
        EXPECT_TRUE(desk.says("Answer the question of the exercise first"));
        ASSERT_TRUE(desk.anchors.find("exercise.answer_first"));
        EXPECT_GT(desk.where("exercise.predict.3").h, 30) << "the whole question is in sight";
        desk.key(key);
        EXPECT_EQ(desk.actions().size(), 1u);
        desk.lesson.attempt.work.has_run = true;
        desk.frame(2);
        EXPECT_FALSE(desk.anchors.find("exercise.answer_first"));
        desk.key(key);
        EXPECT_EQ(desk.actions().size(), 2u) << "it is skipped";
    }
}

TEST(PredictionPart, ItsAnswersStayInPlaceWhenPlayPointsToTheQuestion) {
    Desk desk(1280, 800, 1, true);
    desk.open_exercise();
    desk.frame(30);
    const Rect before = desk.where("exercise.predict.1");
    desk.key({' '});
    desk.frame(30);
    ASSERT_TRUE(desk.anchors.find("exercise.answer_first"));
    EXPECT_EQ(desk.where("exercise.predict.1").y, before.y);
}

TEST(PredictionPart, PlayOfTheToolbarAsksOnceToo) {
    Desk desk;
    desk.open_exercise();
    desk.frame(3);
    desk.click("button.play");
    EXPECT_TRUE(desk.actions().empty());
    desk.key({'2'});
    desk.lesson.attempt.answers.prediction = 1;
    desk.frame(2);
    desk.click("button.play");
    EXPECT_EQ(desk.actions(), std::vector{Action::play_pause}) << "it is answered";
    desk.all.clear();
    desk.lesson.attempt.answers.prediction = -1;
    desk.frame(2);
    desk.click("button.play");
    EXPECT_TRUE(desk.actions().empty());
    ++desk.view.run_id;
    desk.frame(2);
    desk.click("button.play");
    EXPECT_TRUE(desk.actions().empty()) << "another document asks again";
    desk.click("button.play");
    EXPECT_EQ(desk.actions(), std::vector{Action::play_pause});
}

TEST(PredictionPart, PlayDoesNotWaitInALectureInFreePlayAndWithoutAnExercise) {
    const auto plays = [](const std::function<void(Desk&)>& prepare) {
        Desk desk;
        desk.open_exercise();
        prepare(desk);
        desk.frame(3);
        desk.key({' '});
        return desk.actions() == std::vector{Action::play_pause};
    };
    EXPECT_FALSE(plays([](Desk&) {}));
    EXPECT_TRUE(plays([](Desk& desk) { desk.view.lecture = true; }));
    EXPECT_TRUE(plays([](Desk& desk) { desk.lesson.attempt.work.free_play = true; }));
    EXPECT_TRUE(plays([](Desk& desk) { desk.view.lesson = nullptr; }));
    EXPECT_TRUE(plays([](Desk& desk) { desk.opened.prediction = {}; }));
}

TEST_F(PathPrediction, TheFirstPlayPointsToTheDrawing) {
    desk.opened.prediction.options.clear();
    desk.frame(2);
    desk.key({' '});
    desk.frame(2);
    EXPECT_TRUE(desk.says("Draw the path first"));
    EXPECT_EQ(desk.panels.keyboard.focus, "exercise.draw");
    desk.key({key::enter});
    desk.frame(2);
    EXPECT_TRUE(scene_input().path.on) << "Enter begins the drawing";
    desk.key({' '});
    EXPECT_EQ(desk.actions(), std::vector{Action::play_pause}) << "Space skips it";
}

TEST(PredictionPart, OffersToCompareAfterThePredictionOnceTheFirstRunHasEnded) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("exercise.compare"));
    begin_run(desk);
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("exercise.compare")) << "before the prediction";
    predict_and_run(desk, 0);
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("exercise.compare")) << "in the first run";
    desk.lesson.attempt.work.runs = 2;
    desk.frame(3);
    desk.click("exercise.compare");
    ASSERT_TRUE(desk.last<CompareRequest>());
    EXPECT_TRUE(desk.last<CompareRequest>()->on);
    desk.lesson.attempt.work.compares = true;
    desk.frame(3);
    EXPECT_TRUE(desk.says("Dashed outline"));
    desk.lesson.by_hand = true;
    desk.frame(3);
    EXPECT_TRUE(desk.says("changed by hand"));
    desk.click("exercise.compare");
    EXPECT_FALSE(desk.last<CompareRequest>()->on);
}

TEST(PredictionPart, ItsTicksAndItsWordsAreInTheRowOfTheStepsForAFinger) {
    Desk desk(512, 1024, 1, true);
    desk.view.program.touch = true, desk.view.program.finger = 44;
    desk.open_exercise();
    predict_and_run(desk, 1);
    desk.lesson.attempt.work.runs = 2;
    desk.lesson.verdicts[0].done = true;
    desk.frame(4);
    const auto heading = std::find_if(desk.written.begin(), desk.written.end(), [&](const ui::Written& each) {
        return each.words == desk.strings("exercise.steps");
    });
    ASSERT_NE(heading, desk.written.end());
    const auto middle = [](const Rect& rect) { return rect.y + rect.h / 2; };
    EXPECT_NEAR(middle(desk.where("exercise.step.1")), middle(heading->rect), 2);
    EXPECT_TRUE(desk.says(std::string(desk.strings("exercise.compare"))));
}

TEST_F(PathPrediction, TheGhostIsDrawnAndCannotBeSelected) {
    ReferencePath path(200, Pose{3, -3, 0});
    desk.lesson.attempt.answers.prediction = 0;
    desk.view.features.ghost = GhostView{path.back(), 1, 0.7f, &path, path.size()};
    desk.frame(2);
    ASSERT_TRUE(desk.anchors.find("stage.ghost"));
    const Rect at = desk.where("stage.ghost");
    EXPECT_NEAR(at.x + at.w / 2, pixel({3, -3}).x, 1);
    click({3, -3});
    EXPECT_TRUE(desk.edits().empty());
    for (const SelectRequest& request : requests<SelectRequest>()) EXPECT_EQ(request.vehicle, no_vehicle);
}

}  // namespace braitenlab::tests::prediction_test

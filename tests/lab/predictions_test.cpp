// The predicted path of the selected vehicle while something is dragged or pointed at.
#include "app/features/predictions.h"

#include <chrono>

#include <gtest/gtest.h>

#include "app/lab_requests.h"
#include "app/playback.h"
#include "core/brain/presets.h"
#include "tests/lab/opened_lab.h"

namespace braitenlab::tests::predictions_test {
namespace {

struct Predictions : testing::Test {
    Jobs jobs{0};
    Lab lab = opened_lab("2a-coward");

    const Snapshot& now() const { return lab.document.session.snapshot(); }
    VehicleId selected() const { return lab.view.selection.vehicle; }
    void turn() {
        update_predictions(lab.predictions, lab, jobs), jobs.finish(), update_predictions(lab.predictions, lab, jobs);
    }
    void drag(float value) {
        note_press(lab.predictions, lab, true);
        handle(lab, EditRequest{TurnDial{{.vehicle = selected()}, Dial::LM, value}, 7});
        turn();
    }
    void release() { note_press(lab.predictions, lab, false), turn(); }
    std::optional<PredictionView> shown() const { return view_of(lab).features.prediction; }
    void run(int ticks) {
        for (int i = 0; i < ticks; ++i) tick(lab);
    }
    Pose place() const {
        const VehicleView* vehicle = find_vehicle(now(), selected());
        return {vehicle->x, vehicle->y, vehicle->heading};
    }
};

TEST_F(Predictions, IsShownDuringADragBesideThePathBeforeIt) {
    run(90);
    turn();
    EXPECT_FALSE(shown());
    note_press(lab.predictions, lab, true);
    turn();
    EXPECT_FALSE(shown()) << "nothing has changed yet";
    drag(0.9f);
    ASSERT_TRUE(shown());
    EXPECT_EQ(shown()->path->size(), 481u) << "8 s";
    ASSERT_TRUE(shown()->before);
    EXPECT_EQ(shown()->path->front(), shown()->before->front());
    EXPECT_NE(shown()->path->back(), shown()->before->back());
    const std::vector<Pose> first = *shown()->path;
    drag(-0.4f);
    EXPECT_NE(*shown()->path, first) << "the path of the newest value";
}

TEST_F(Predictions, IsShownForEditsByKeysToo) {
    run(90);
    const auto nudge = [&](float value, std::uint64_t gesture) {
        note_press(lab.predictions, lab, false, gesture);
        handle(lab, EditRequest{TurnDial{{.vehicle = selected()}, Dial::LM, value}, gesture});
        turn();
    };
    nudge(0.35f, 7);
    ASSERT_TRUE(shown());
    ASSERT_TRUE(shown()->before);
    EXPECT_NE(shown()->path->back(), shown()->before->back());
    const Pose before = shown()->before->back();
    nudge(0.4f, 7);
    EXPECT_EQ(shown()->before->back(), before) << "of one gesture: the path before its first key";
    release();
    ASSERT_TRUE(shown()) << "it stays after the last key";
    const Pose last = shown()->path->back();
    nudge(0.45f, 8);
    ASSERT_TRUE(shown()->before);
    EXPECT_EQ(shown()->before->back(), last) << "another gesture begins with the path of the last one";
}

TEST_F(Predictions, ComesTrueAfterTheDrag) {
    run(130);
    drag(0.2f);
    drag(0.8f);
    release();
    ASSERT_TRUE(shown());
    const std::vector<Pose> path = *shown()->path;
    for (std::size_t i = 1; i < path.size(); ++i) {
        run(1);
        ASSERT_EQ(place(), path[i]) << "tick " << i;
        if (i == 100) {
            turn();
            EXPECT_TRUE(shown()) << "it stays until it is driven";
        }
    }
    run(1);
    turn();
    EXPECT_FALSE(shown());
}

TEST_F(Predictions, FollowsTheTimeWhilePlaying) {
    drag(0.9f);
    run(5);
    turn();
    EXPECT_EQ(shown()->tick, 0u) << "the same path still";
    run(5);
    turn();
    EXPECT_EQ(shown()->tick, 10u);
}

TEST_F(Predictions, IsShownForAPresetUnderThePointerAndOnlyThen) {
    run(60);
    lab.predictions.what_if = {SetBrain{{.vehicle = selected()}, find_preset("2b-aggressor")->brain}};
    const std::uint64_t hash = lab.document.session.hash();
    turn();
    ASSERT_TRUE(shown());
    ASSERT_TRUE(shown()->before);
    EXPECT_NE(shown()->path->back(), shown()->before->back());
    EXPECT_EQ(lab.document.session.hash(), hash);
    lab.predictions.what_if = {SetBrain{{.vehicle = selected()}, {}}};
    turn();
    ASSERT_TRUE(shown());
    const Pose first = shown()->path->front(), last = shown()->path->back();
    EXPECT_LT(std::hypot(last.x - first.x, last.y - first.y), 1) << "without a brain it stops";
    lab.predictions.what_if.clear();
    turn();
    EXPECT_FALSE(shown());
}

TEST_F(Predictions, IsShownInTheWiringEditorForAWireUnderThePointerAndOnlyThen) {
    handle(lab, Action::wiring);
    ASSERT_EQ(lab.playback.mode, Mode::wiring);
    turn();
    EXPECT_FALSE(shown());
    lab.predictions.what_if = {SetBrain{{.vehicle = selected()}, find_preset("2b-aggressor")->brain}};
    turn();
    ASSERT_TRUE(shown());
    EXPECT_NE(shown()->path->back(), shown()->before->back());
    lab.predictions.what_if.clear();
    turn();
    EXPECT_FALSE(shown());
}

TEST_F(Predictions, IsShownForAnEditInTheWiringEditorUntilItIsDriven) {
    handle(lab, Action::wiring);
    drag(0.9f);
    ASSERT_TRUE(shown());
    ASSERT_TRUE(shown()->before);
    EXPECT_NE(shown()->path->back(), shown()->before->back());
    release();
    EXPECT_TRUE(shown());
    handle(lab, Action::wiring);
    turn();
    EXPECT_TRUE(shown()) << "it stays in the scene";
}

TEST_F(Predictions, HasAFanWhereThereIsNoise) {
    drag(0.5f);
    EXPECT_TRUE(shown()->fan->empty());
    release();
    std::vector<Sensor> sensors = now().scene->kinds[0].sensors;
    sensors[0].noise = 0.1f;
    handle(lab, EditRequest{SetSensors{{.kind = 0}, sensors}});
    drag(0.6f);
    ASSERT_EQ(shown()->fan->size(), 8u);
    EXPECT_NE(shown()->fan->front(), shown()->fan->back());
    EXPECT_EQ(shown()->fan->front().size(), shown()->path->size());
}

TEST_F(Predictions, ShowsThePathBeforeItsFanAndKeepsTheFanOfTheEditBeforeForAMoment) {
    std::vector<Sensor> sensors = now().scene->kinds[0].sensors;
    sensors[0].noise = 0.1f;
    handle(lab, EditRequest{SetSensors{{.kind = 0}, sensors}});
    drag(0.5f);
    const std::vector<std::vector<Pose>> old_fan = *shown()->fan;
    const std::vector<Pose> old_path = *shown()->path;
    ASSERT_EQ(old_fan.size(), 8u);
    handle(lab, EditRequest{TurnDial{{.vehicle = selected()}, Dial::LM, 0.9f}, 7});
    const auto turn_with_one_step = [&] {
        update_predictions(lab.predictions, lab, jobs), jobs.deliver(std::chrono::nanoseconds(0));
    };
    for (int steps = 0; *shown()->path == old_path && steps < 100; ++steps) turn_with_one_step();
    update_predictions(lab.predictions, lab, jobs);
    ASSERT_NE(*shown()->path, old_path);
    EXPECT_TRUE(is_computing(lab.predictions)) << "the fan comes after the path";
    EXPECT_EQ(*shown()->fan, old_fan) << "a drag does not flicker";
    lab.wall_seconds += 0.1;
    update_predictions(lab.predictions, lab, jobs);
    EXPECT_TRUE(shown()->fan->empty()) << "an old fan does not stay";
    turn();
    EXPECT_EQ(shown()->fan->size(), 8u);
    EXPECT_NE(*shown()->fan, old_fan);
    EXPECT_FALSE(is_computing(lab.predictions));
}

TEST_F(Predictions, ANewerEditWaitsForAFanOnlyAMoment) {
    std::vector<Sensor> sensors = now().scene->kinds[0].sensors;
    sensors[0].noise = 0.1f;
    handle(lab, EditRequest{SetSensors{{.kind = 0}, sensors}});
    drag(0.5f);
    const auto edit = [&](float value) {
        handle(lab, EditRequest{TurnDial{{.vehicle = selected()}, Dial::LM, value}, 7});
    };
    const auto path_is_known = [&] {
        for (int steps = 0; lab.predictions.path.is_computing() && steps < 100; ++steps)
            jobs.deliver(std::chrono::nanoseconds(0)), update_predictions(lab.predictions, lab, jobs);
        return !lab.predictions.path.is_computing() && lab.predictions.fan.is_computing();
    };
    edit(0.6f), update_predictions(lab.predictions, lab, jobs);
    ASSERT_TRUE(path_is_known());
    edit(0.7f), update_predictions(lab.predictions, lab, jobs);
    EXPECT_FALSE(lab.predictions.path.is_computing()) << "the fan of 0.6 comes first";
    lab.wall_seconds += 0.1;
    update_predictions(lab.predictions, lab, jobs);
    EXPECT_TRUE(lab.predictions.path.is_computing()) << "the path of 0.7";
}

TEST_F(Predictions, HasTheLengthOfTheViewAndCanBeSwitchedOff) {
    lab.view.overlays.prediction = 3;
    drag(0.5f);
    EXPECT_EQ(shown()->path->size(), 181u);
    lab.view.overlays.prediction = 0;
    drag(0.6f);
    EXPECT_FALSE(shown());
}

TEST_F(Predictions, IsHiddenWhileThePredictionOfAnExerciseIsOpen) {
    lab = opened_lab("05-aggressor");
    ASSERT_TRUE(is_asked(lab.document.lesson->exercise->prediction));
    drag(0.5f);
    EXPECT_FALSE(shown());
    release();
    handle(lab, PredictRequest{0});
    drag(0.6f);
    EXPECT_FALSE(shown()) << "it can be changed until the first run";
    release();
    run(1);
    turn();
    drag(0.7f);
    EXPECT_TRUE(shown());
}

}  // namespace
}  // namespace braitenlab::tests::predictions_test

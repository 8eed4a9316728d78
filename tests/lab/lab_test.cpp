// The lab without its window: what requests do to time, selection and exercise.
#include "app/lab.h"

#include <gtest/gtest.h>

#include "app/files/data.h"
#include "app/files/safe_file.h"
#include "app/lab_requests.h"
#include "app/lab_selection.h"
#include "core/io/run_file.h"
#include "tests/folder.h"

namespace braitenlab::tests::lab_test {
namespace {

Lab open(const std::string& name) {
    const auto path = find_shipped(name);
    EXPECT_TRUE(path);
    auto lab = open_lab(*path, std::nullopt, {});
    EXPECT_TRUE(lab) << lab.error().text();
    return std::move(*lab);
}

TEST(Time, PassesOnlyWhilePlayingAndAtTheSpeedAskedFor) {
    Lab lab = open("2a-coward");
    for (int i = 0; i < 10; ++i) advance(lab, 0.1);
    EXPECT_EQ(lab.document.session.snapshot().tick, 0u);
    handle(lab, Action::play_pause);
    for (int i = 0; i < 10; ++i) advance(lab, 0.1);
    EXPECT_NEAR(static_cast<double>(lab.document.session.snapshot().tick), 60, 1);
    handle(lab, SpeedRequest{0.125f});
    for (int i = 0; i < 80; ++i) advance(lab, 0.1);
    EXPECT_NEAR(static_cast<double>(lab.document.session.snapshot().tick), 120, 2);
}

TEST(Time, DropsWhatItCannotKeepUpWith) {
    Lab lab = open("predator-prey");
    handle(lab, Action::play_pause);
    handle(lab, SpeedRequest{16});
    advance(lab, 3600);
    EXPECT_EQ(lab.playback.debt, 0);
    EXPECT_LT(lab.document.session.snapshot().seconds, 3600);
}

TEST(Time, GoesBackAndOnAgainExactly) {
    Lab lab = open("predator-prey");
    for (int i = 0; i < 700; ++i) tick(lab);
    const auto hash = lab.document.session.hash();
    handle(lab, SeekRequest{400, true});
    EXPECT_EQ(lab.document.session.snapshot().tick, 400u);
    handle(lab, Action::play_pause);
    advance(lab, 0.5);
    EXPECT_EQ(lab.document.session.snapshot().tick, 400u) << "the playhead is still held";
    handle(lab, SeekRequest{400, false});
    for (int i = 0; i < 300; ++i) tick(lab);
    EXPECT_EQ(lab.document.session.hash(), hash);
    handle(lab, Action::rewind);
    EXPECT_EQ(lab.document.session.snapshot().tick, 400u);
    handle(lab, Action::step_back);
    EXPECT_EQ(lab.document.session.snapshot().tick, 399u);
    EXPECT_EQ(lab.playback.mode, Mode::paused);
    handle(lab, Action::fast_forward), handle(lab, Action::fast_forward);
    EXPECT_EQ(lab.document.session.snapshot().tick, 700u) << "no farther than recorded";
    EXPECT_EQ(lab.document.session.hash(), hash);
}

TEST(Time, SaysWhatAnEditInThePastForgetsAndWhatUndoBringsBack) {
    Lab lab = open("predator-prey");
    for (int i = 0; i < 700; ++i) tick(lab);
    handle(lab, SeekRequest{400, false});
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LL, 1}});
    EXPECT_EQ(lab.notice.key, "notice.forgotten");
    EXPECT_EQ(lab.notice.words, "6.7");
    EXPECT_EQ(lab.document.session.latest(), 400u);
    handle(lab, Action::undo);
    EXPECT_EQ(lab.notice.key, "notice.time_back");
    EXPECT_EQ(lab.document.session.latest(), 700u);
    handle(lab, Action::add);
    EXPECT_EQ(lab.notice.key, "notice.forgotten");
    tick(lab);
    lab.notice = {};
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LL, 1}});
    EXPECT_TRUE(lab.notice.empty()) << "at the front there is nothing to forget";
}

TEST(Time, TellsHowFastItPassesWhereItFallsBehind) {
    Lab lab = open("2a-coward");
    handle(lab, Action::play_pause);
    for (int i = 0; i < 70; ++i) advance(lab, 1.0 / 60);
    EXPECT_FALSE(view_of(lab).pace) << "one vehicle is no work";
    lab.playback.time_scale = 1e6f;
    lab.playback.pace = {};
    for (int i = 0; i < 70; ++i) advance(lab, 1.0 / 60);
    const auto pace = view_of(lab).pace;
    ASSERT_TRUE(pace);
    EXPECT_GT(*pace, 0.0f);
    EXPECT_LT(*pace, 1e5f) << "what is reached, not what was asked for";
    handle(lab, Action::slower);
    EXPECT_FALSE(view_of(lab).pace) << "measured anew";
}

TEST(Time, TakesTheJudgeBackWithIt) {
    Lab lab = open("05-aggressor");
    handle(lab, EditRequest{SetBrain{{.kind = 0}, make_graph(lab.document.lesson->exercise->solution)}});
    std::vector<std::vector<bool>> done;
    const auto ticks_now = [&] {
        std::vector<bool> all;
        for (const Verdict& verdict : lab.document.lesson->view.verdicts) all.push_back(verdict.done);
        return all;
    };
    for (int i = 0; i < 600; ++i) done.push_back(ticks_now()), tick(lab);
    ASSERT_NE(done.front(), done.back());
    for (const std::uint64_t at : {std::uint64_t{3}, std::uint64_t{599}, std::uint64_t{200}, std::uint64_t{61}}) {
        handle(lab, SeekRequest{at});
        EXPECT_EQ(ticks_now(), done[at]) << "at tick " << at;
        for (std::uint64_t more = at + 1; more < std::min<std::uint64_t>(at + 50, 600); ++more) {
            tick(lab);
            ASSERT_EQ(ticks_now(), done[more]) << "at tick " << more;
        }
    }
}

TEST(Bookmarks, BringTheirMomentBackAndCanBeRemoved) {
    Lab lab = open("predator-prey");
    for (int i = 0; i < 130; ++i) tick(lab);
    const auto hash = lab.document.session.hash();
    handle(lab, Action::set_bookmark);
    handle(lab, Action::set_bookmark);
    EXPECT_EQ(lab.playback.bookmarks.size(), 1u) << "one a moment";
    handle(lab, Action::reset);
    for (int i = 0; i < 10; ++i) tick(lab);
    handle(lab, Action::last_bookmark);
    EXPECT_EQ(lab.document.session.hash(), hash);
    handle(lab, BookmarkRequest{0, true});
    EXPECT_TRUE(lab.playback.bookmarks.empty());
    handle(lab, Action::last_bookmark);  // there is none: nothing happens
    EXPECT_EQ(lab.document.session.hash(), hash);
}

TEST(SavedRun, OpensWhereItStood) {
    Lab lab = open("predator-prey");
    for (int i = 0; i < 400; ++i) tick(lab);
    const tests::Folder folder;
    const auto file = folder / "hunt.run";
    ASSERT_FALSE(write_whole(file, io::write_run(lab.document.session.save())));
    auto again = open_lab(file, std::nullopt, {});
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_EQ(again->document.session.hash(), lab.document.session.hash());
    EXPECT_NE(again->view.selection.vehicle, no_vehicle);
}

TEST(Mode, CountsChangesBetweenPlayingAndNot) {
    Lab lab = open("2a-coward");
    handle(lab, Action::play_pause);
    handle(lab, Action::wiring);
    EXPECT_EQ(lab.playback.mode, Mode::wiring);
    handle(lab, Action::cancel);
    EXPECT_EQ(lab.playback.mode, Mode::paused);
    EXPECT_EQ(lab.playback.toggles, 2);
}

TEST(Camera, ComesHomeFromEverywhereWithOneKey) {
    Lab lab = open("predator-prey");
    for (const Action way : {Action::follow, Action::birds_eye, Action::drivers_eye}) {
        lab.view.camera.pan = {5, 5}, lab.view.camera.zoom = 3, lab.view.camera.azimuth = 1;
        handle(lab, way);
        EXPECT_NE(lab.view.camera.mode, CameraMode::overview);
        handle(lab, Action::home);
        EXPECT_EQ(lab.view.camera, Camera{});
    }
}

TEST(Camera, LeavesAWayOfLookingByTheSameKey) {
    Lab lab = open("predator-prey");
    handle(lab, Action::drivers_eye);
    handle(lab, Action::birds_eye);
    EXPECT_EQ(lab.view.camera.mode, CameraMode::birds_eye);
    handle(lab, Action::birds_eye);
    EXPECT_EQ(lab.view.camera.mode, CameraMode::overview);
}

TEST(Driving, TakesTheArrowKeysToTheWheelsUntilTheyAreLetGo) {
    Lab lab = open("2a-coward");
    EXPECT_FALSE(steer_by_keys(lab, 0, 1)) << "while its brain drives, the keys are the camera's";
    handle(lab, Action::drive);
    const auto moved_in_a_second = [&] {
        for (int i = 0; i < 60; ++i) tick(lab);
        return lab.document.session.snapshot().vehicles[0].motor;
    };
    EXPECT_TRUE(steer_by_keys(lab, 0, 1));
    EXPECT_EQ(moved_in_a_second(), (std::array{1.0f, 1.0f}));
    steer_by_keys(lab, 1, 0);
    const auto turning = moved_in_a_second();
    EXPECT_GT(turning[0], 0) << "to the right";
    EXPECT_FLOAT_EQ(turning[1], -turning[0]);
    steer_by_keys(lab, 0, 0);
    EXPECT_EQ(moved_in_a_second(), (std::array{0.0f, 0.0f}));
    handle(lab, Action::drive);
    EXPECT_EQ(lab.document.session.snapshot().vehicles[0].driver, Driver::brain);
    EXPECT_NE(moved_in_a_second(), (std::array{0.0f, 0.0f})) << "and the brain goes on";
}

TEST(Driving, LetsGoOfAVehicleThatIsNoLongerSelected) {
    Lab lab = open("predator-prey");
    handle(lab, Action::drive);
    steer_by_keys(lab, 0, 1);
    handle(lab, Action::next_vehicle);
    EXPECT_FALSE(steer_by_keys(lab, 0, 1));
    tick(lab);
    EXPECT_EQ(lab.document.session.snapshot().vehicles[0].motor, (std::array{0.0f, 0.0f}));
}

TEST(Selection, MovesOnWhenItsVehicleLeaves) {
    Lab lab = open("predator-prey");
    EXPECT_EQ(lab.view.selection.vehicle, 0);
    handle(lab, EditRequest{RemoveVehicle{0}});
    EXPECT_EQ(lab.view.selection.vehicle, 1);
    handle(lab, Action::previous_vehicle);
    EXPECT_EQ(lab.view.selection.vehicle, 9);
    handle(lab, Action::next_vehicle);
    EXPECT_EQ(lab.view.selection.vehicle, 1);
}

TEST(Selection, TakesWhatWasAddedByHandAndLeavesWhatCameByItself) {
    Lab lab = open("2a-coward");
    handle(lab, EditRequest{AddVehicle{0, Pose{1, 1, 0}}});
    EXPECT_EQ(lab.view.selection.vehicle, 1);
    handle(lab, Action::add);
    EXPECT_EQ(lab.view.selection.vehicle, 1);
    const auto sources = static_cast<int>(lab.document.session.snapshot().sources.size());
    handle(lab, EditRequest{AddSource{Source{.x = 2}}});
    EXPECT_EQ(lab.view.selection.object, (SceneObject{SceneObjectKind::source, sources}));
    EXPECT_EQ(lab.view.selection.vehicle, 1) << "its brain stays in sight";
}

TEST(Selection, KnowsALampByItsNameWhenOthersGo) {
    Lab lab = open("2a-coward");
    handle(lab, EditRequest{AddSource{Source{.name = "mine", .x = 2}}});
    const int index = lab.view.selection.object.index;
    ASSERT_GT(index, 0);
    handle(lab, EditRequest{RemoveSource{0}});
    EXPECT_EQ(lab.view.selection.object.index, index - 1);
    handle(lab, Action::erase);
    EXPECT_FALSE(lab.view.selection.object);
    EXPECT_EQ(find_source(*lab.document.session.snapshot().scene, "mine"), -1);
}

TEST(Selection, IsWhatIsErasedAndDuplicated) {
    Lab lab = open("2a-coward");
    handle(lab, EditRequest{AddObstacle{Obstacle{.x = 2, .length = 3}}});
    handle(lab, Action::duplicate);
    ASSERT_EQ(lab.document.session.snapshot().scene->obstacles.size(), 2u);
    const Obstacle& copy = lab.document.session.snapshot().scene->obstacles[1];
    EXPECT_EQ(copy.length, 3);
    EXPECT_NE(copy.x, 2) << "beside it, not in it";
    EXPECT_EQ(lab.view.selection.object, (SceneObject{SceneObjectKind::obstacle, 1}));
    handle(lab, Action::erase);
    EXPECT_EQ(lab.document.session.snapshot().scene->obstacles.size(), 1u);
    EXPECT_EQ(lab.document.session.snapshot().vehicles.size(), 1u) << "the vehicle was not meant";
    handle(lab, Action::duplicate);
    EXPECT_EQ(lab.document.session.snapshot().vehicles.size(), 2u);
    handle(lab, Action::wiring);
    handle(lab, Action::erase);
    EXPECT_EQ(lab.document.session.snapshot().vehicles.size(), 2u) << "Del is the canvas's there";
}

TEST(Selection, GivesACopyTheBrainOfTheOriginal) {
    Lab lab = open("2a-coward");
    handle(lab, EditRequest{TurnDial{{.vehicle = 0}, Dial::LR, 1.25f}});
    handle(lab, Action::duplicate);
    const Snapshot& now = lab.document.session.snapshot();
    ASSERT_EQ(now.vehicles.size(), 2u);
    EXPECT_EQ(read_dials(*now.brains[static_cast<std::size_t>(now.vehicles[1].brain)]).LR, 1.25f);
}

TEST(Refusal, IsSaidAndGoesAwayAgain) {
    Lab lab = open("2a-coward");
    handle(lab, Action::remove);
    handle(lab, Action::remove);
    EXPECT_NE(lab.notice.words, "");
    EXPECT_EQ(lab.notice.kind, NoticeKind::failure);
    advance(lab, 60);
    EXPECT_TRUE(lab.notice.empty());
}

TEST(Lesson, TicksItsStepsLive) {
    Lab lab = open("05-aggressor");
    handle(lab, PredictRequest{1});
    EXPECT_EQ(lab.document.lesson->view.prediction, 1);
    handle(lab, EditRequest{SetBrain{{.kind = 0}, make_graph(lab.document.lesson->exercise->solution)}});
    handle(lab, Action::play_pause);
    for (int i = 0; i < 60 * 20 && !lab.document.lesson->referee.passed(); ++i) tick(lab);
    for (const Verdict& verdict : lab.document.lesson->view.verdicts) EXPECT_TRUE(verdict.done);
}

TEST(Lesson, AsksForThePredictionBeforeTheFirstRunOnly) {
    Lab lab = open("05-aggressor");
    handle(lab, Action::step);
    handle(lab, PredictRequest{0});
    EXPECT_EQ(lab.document.lesson->view.prediction, -1);
}

TEST(Lesson, OpensEachHintAfterARunOrHalfAMinute) {
    Lab lab = open("05-aggressor");
    handle(lab, Action::hint);
    EXPECT_EQ(lab.document.lesson->view.hints_shown, 1);
    handle(lab, Action::hint);
    EXPECT_EQ(lab.document.lesson->view.hints_shown, 1);
    advance(lab, 31);
    handle(lab, Action::hint);
    EXPECT_EQ(lab.document.lesson->view.hints_shown, 2);
    handle(lab, Action::reset);
    handle(lab, Action::play_pause);
    tick(lab);
    handle(lab, Action::hint);
    EXPECT_EQ(lab.document.lesson->view.hints_shown, 3);
}

TEST(Lesson, ResetBringsBackTheVeryStartAndTheShippedBrainWhichUndoTakesBack) {
    Lab lab = open("05-aggressor");
    const auto start = lab.document.session.hash();
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 2}});
    handle(lab, Action::play_pause);
    for (int i = 0; i < 100; ++i) tick(lab);
    handle(lab, Action::exercise_reset);
    EXPECT_EQ(lab.document.session.hash(), start);
    EXPECT_EQ(lab.playback.mode, Mode::paused);
    handle(lab, Action::undo);
    EXPECT_EQ(read_dials(*lab.document.session.snapshot().kind_brains[0]).LR, 2);
}

bool any_done(const Lab& lab) {
    const auto& verdicts = lab.document.lesson->view.verdicts;
    return std::any_of(verdicts.begin(), verdicts.end(), [](const Verdict& v) { return v.done; });
}

TEST(Lesson, IsNotPassedByCarryingTheLampToAVehicleThatDidNotChange) {
    for (const int before : {0, 30}) {
        Lab lab = open("05-aggressor");
        for (int i = 0; i < before; ++i) tick(lab);
        for (int i = 0; i < 300; ++i) {
            const VehicleView& coward = lab.document.session.snapshot().vehicles[0];
            handle(lab, EditRequest{MoveSource{0, coward.x + 0.4f * std::cos(coward.heading),
                                               coward.y + 0.4f * std::sin(coward.heading)}});
            tick(lab);
        }
        EXPECT_FALSE(any_done(lab)) << before;
        EXPECT_TRUE(lab.document.lesson->view.by_hand);
        handle(lab, Action::reset);
        EXPECT_FALSE(lab.document.lesson->view.by_hand);
    }
}

TEST(Lesson, CountsAgainOnceWhatWasMovedBeforeTheStartIsPutBack) {
    Lab lab = open("05-aggressor");
    handle(lab, EditRequest{MoveSource{0, 1, 1}});
    EXPECT_TRUE(lab.document.lesson->view.by_hand);
    handle(lab, Action::undo);
    EXPECT_FALSE(lab.document.lesson->view.by_hand);
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 2}});
    tick(lab);
    EXPECT_FALSE(lab.document.lesson->view.by_hand) << "to change the brain is what is asked for";
}

TEST(Lesson, CountsUpToTheMomentOfADisturbanceThatIsGoneBackTo) {
    Lab lab = open("05-aggressor");
    for (int i = 0; i < 100; ++i) tick(lab);
    handle(lab, EditRequest{MoveVehicle{lab.view.selection.vehicle, 0, 0, 0}});
    for (int i = 0; i < 100; ++i) tick(lab);
    handle(lab, SeekRequest{104});
    EXPECT_TRUE(lab.document.lesson->view.by_hand);
    handle(lab, SeekRequest{50});
    EXPECT_FALSE(lab.document.lesson->view.by_hand);
    handle(lab, SeekRequest{199});
    EXPECT_TRUE(lab.document.lesson->view.by_hand);
}

TEST(Lesson, StartsOverWithTheShippedBrainInAVehicleThatHadOneOfItsOwn) {
    Lab lab = open("05-aggressor");
    handle(lab, EditRequest{TurnDial{{.vehicle = lab.view.selection.vehicle}, Dial::LR, 2}});
    handle(lab, Action::exercise_reset);
    const Snapshot& now = lab.document.session.snapshot();
    EXPECT_EQ(*now.brains[static_cast<std::size_t>(now.vehicles[0].brain)],
              lab.document.lesson->exercise->scene.kinds[0].brain);
    handle(lab, Action::undo);
    const Snapshot& then = lab.document.session.snapshot();
    EXPECT_EQ(read_dials(*then.brains[static_cast<std::size_t>(then.vehicles[0].brain)]).LR, 2);
}

TEST(Reset, KeepsTheStudentsBrain) {
    Lab lab = open("05-aggressor");
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 2}});
    for (int i = 0; i < 100; ++i) tick(lab);
    handle(lab, Action::reset);
    EXPECT_EQ(lab.document.session.snapshot().tick, 0u);
    EXPECT_EQ(read_dials(*lab.document.session.snapshot().kind_brains[0]).LR, 2);
}

TEST(Selection, GoesToTheNextOfItsKindWhenTheSelectedOneDiesAndSaysSo) {
    Lab lab = open("predator-prey");
    const auto prey = [&] {
        for (const VehicleView& v : lab.document.session.snapshot().vehicles)
            if (v.role == Role::prey) return v.id;
        return no_vehicle;
    };
    handle(lab, SelectRequest{prey()});
    const VehicleId first = lab.view.selection.vehicle;
    for (int i = 0; i < 60 * 120 && lab.view.selection.vehicle == first; ++i) tick(lab);
    ASSERT_NE(lab.view.selection.vehicle, first) << "nobody has eaten it in two minutes";
    EXPECT_EQ(find_vehicle(lab.document.session.snapshot(), lab.view.selection.vehicle)->role, Role::prey);
    EXPECT_TRUE(lab.notice.key == "notice.eaten_prey" || lab.notice.key == "notice.starved_prey") << lab.notice.key;
    EXPECT_EQ(lab.notice.words, std::to_string(first + 1));
    EXPECT_EQ(lab.notice.more, std::to_string(lab.view.selection.vehicle + 1));
    EXPECT_EQ(lab.notice.kind, NoticeKind::notice);
}

TEST(View, WalksThroughTheFieldsOfTheSceneAndBackToNone) {
    Lab lab = open("2b-aggressor");
    EXPECT_FALSE(lab.view.overlays.field);
    handle(lab, Action::next_field);
    EXPECT_EQ(lab.view.overlays.field, Channel::light);
    handle(lab, Action::next_field);
    EXPECT_FALSE(lab.view.overlays.field);
    handle(lab, OverlaysRequest{{.labels = false, .field = Channel::light}});
    EXPECT_FALSE(view_of(lab).settings.overlays.labels);
    EXPECT_EQ(view_of(lab).settings.overlays.field, Channel::light);
}

TEST(View, SwitchesEachPictureOffAndOn) {
    Lab lab = open("2b-aggressor");
    const Overlays before = lab.view.overlays;
    for (const Action action : {Action::trails, Action::surfaces, Action::memory, Action::labels}) {
        handle(lab, action);
        EXPECT_NE(lab.view.overlays, before);
        handle(lab, action);
        EXPECT_EQ(lab.view.overlays, before);
    }
}

}  // namespace
}  // namespace braitenlab::tests::lab_test

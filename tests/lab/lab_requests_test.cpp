// What requests change in the view.
#include "app/lab_requests.h"

#include <gtest/gtest.h>

#include "app/lab_selection.h"
#include "tests/lab/opened_lab.h"

namespace braitenlab::tests::lab_requests_test {
namespace {

TEST(LabRequests, WatchTheWiringWhilePlaying) {
    Lab lab = opened_lab("5-logic");
    handle(lab, Action::play_pause);
    handle(lab, Action::watch);
    EXPECT_TRUE(lab.view.watching);
    EXPECT_EQ(lab.playback.mode, Mode::playing);
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LL, 0.5f}, gestures::panels + 1});
    EXPECT_EQ(lab.playback.mode, Mode::playing) << "a slider does not pause";
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LL, 0.7f}, gestures::canvas + 1});
    EXPECT_EQ(lab.playback.mode, Mode::paused) << "an edit in the diagram does";
    EXPECT_TRUE(lab.view.watching);
    handle(lab, Action::wiring);
    handle(lab, Action::watch);
    EXPECT_EQ(lab.playback.mode, Mode::paused) << "from the editor to the watched diagram";
    EXPECT_TRUE(lab.view.watching);
    handle(lab, Action::watch);
    EXPECT_FALSE(lab.view.watching);
}

TEST(LabRequests, AnotherExerciseBeginsWithoutTheDiagramBesideIt) {
    Lab lab = opened_lab("5-logic");
    lab.view.watching = true;
    replace_document(
        lab, std::move(*open_document(std::string(BRAITENLAB_SOURCE) + "/exercises/guided/05-aggressor.toml", {}, {})));
    EXPECT_FALSE(lab.view.watching);
    lab.view.watching = true;
    replace_document(
        lab, std::move(*open_document(std::string(BRAITENLAB_SOURCE) + "/exercises/scenes/5-logic.toml", {}, {})));
    EXPECT_TRUE(lab.view.watching) << "a scene keeps it";
}

TEST(LabRequests, RestartWithTheNextOrAGivenSeed) {
    Lab lab = opened_lab("predator-prey");
    const std::uint64_t seed = lab.document.session.seed();
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LL, 0.5f}});
    handle(lab, Action::step);
    handle(lab, Action::another_start);
    EXPECT_EQ(lab.document.session.seed(), seed + 1);
    EXPECT_EQ(lab.document.session.snapshot().tick, 0u);
    EXPECT_EQ(lab.document.session.undo_depth(), 1) << "edits stay";
    handle(lab, SeedRequest{42});
    handle(lab, Action::reset);
    EXPECT_EQ(lab.document.session.seed(), 42u) << "the same start";
}

TEST(LabRequests, ResetPausesARunThatPlays) {
    Lab lab = opened_lab("predator-prey");
    handle(lab, Action::play_pause);
    tick(lab);
    ASSERT_EQ(lab.playback.mode, Mode::playing);
    handle(lab, Action::reset);
    EXPECT_EQ(lab.playback.mode, Mode::paused);
    EXPECT_EQ(lab.document.session.snapshot().tick, 0u);
}

TEST(LabRequests, KeepTheSelectedVehiclesInAResetThatRenumbersThem) {
    Lab lab = opened_lab("predator-prey");
    const auto last = lab.document.session.snapshot().vehicles.back().id;
    handle(lab, Action::duplicate);
    const VehicleId copy = last + 1;
    ASSERT_EQ(lab.view.selection.vehicle, copy);
    handle(lab, SelectObjectsRequest{{vehicle_object(copy), vehicle_object(3), vehicle_object(5)}});
    handle(lab, Action::reset);
    EXPECT_EQ(lab.view.selection.vehicle, 0) << "vehicles with a start have the smallest ids";
    EXPECT_EQ(lab.view.selection.more, (std::vector{vehicle_object(4), vehicle_object(6)}));
}

TEST(LabRequests, DriveOnByAHeldKeyAfterAReset) {
    Lab lab = opened_lab("2a-coward");
    handle(lab, Action::drive);
    ASSERT_TRUE(steer_by_keys(lab, 0, 1));
    tick(lab);
    handle(lab, Action::reset);
    ASSERT_TRUE(steer_by_keys(lab, 0, 1));
    tick(lab);
    EXPECT_GT(lab.document.session.snapshot().vehicles.at(0).motor[0], 0);
}

TEST(LabRequests, TellThatAnUndoIsRefused) {
    Lab lab = opened_lab("predator-prey");
    Kind kind = lab.document.session.snapshot().scene->kinds[0];
    kind.share = 1000;
    handle(lab, EditRequest{AddKind{kind}});
    handle(lab, Action::new_population);
    ASSERT_TRUE(lab.notice.empty());
    handle(lab, Action::undo);
    EXPECT_EQ(lab.notice.kind, NoticeKind::failure);
    EXPECT_FALSE(lab.notice.empty());
}

TEST(LabRequests, RestartAnExerciseAfterItsKindsChanged) {
    Lab lab = opened_lab("05-aggressor");
    handle(lab, EditRequest{AddKind{lab.document.session.snapshot().scene->kinds[0], 0}});
    EXPECT_TRUE(lesson_view_of(lab).by_hand);
    handle(lab, Action::another_start);
    EXPECT_FALSE(lesson_view_of(lab).by_hand) << "a reset restores the exercise's scene";
    handle(lab, EditRequest{EditArena{Arena{.width = 12}}});
    EXPECT_TRUE(lesson_view_of(lab).by_hand);
    handle(lab, Action::exercise_reset);
    EXPECT_FALSE(lesson_view_of(lab).by_hand);
    const BrainGraph shipped = *lab.document.session.snapshot().kind_brains[0];
    handle(lab, EditRequest{AddKind{lab.document.session.snapshot().scene->kinds[0], 0}});
    handle(lab, EditRequest{TurnDial{{.kind = 1}, Dial::LL, 1.25f}});
    handle(lab, Action::exercise_reset);
    EXPECT_EQ(*lab.document.session.snapshot().kind_brains[0], shipped);
}

TEST(LabRequests, EditADuplicateAloneInAColourOfItsOwn) {
    Lab lab = opened_lab("predator-prey");
    ASSERT_TRUE(lab.view.selection.whole_kind);
    handle(lab, Action::duplicate);
    EXPECT_FALSE(lab.view.selection.whole_kind);
    const Scene first = *lab.document.session.snapshot().scene;
    ASSERT_FALSE(first.starts.empty());
    EXPECT_FALSE(first.starts.back().colour.empty());
    handle(lab, Action::duplicate);
    EXPECT_NE(lab.document.session.snapshot().scene->starts.back().colour, first.starts.back().colour);
    handle(lab, Action::next_vehicle);
    EXPECT_FALSE(lab.view.selection.whole_kind) << "another selection keeps the scope";
    replace_document(lab, opened_lab("predator-prey").document);
    EXPECT_FALSE(lab.view.selection.whole_kind) << "so does another scene";
}

TEST(LabRequests, LimitTheShareOfTheWatchedWiring) {
    Lab lab = opened_lab("2a-coward");
    handle(lab, CanvasShareRequest{2});
    EXPECT_EQ(lab.view.canvas_share, largest_canvas_share);
    handle(lab, CanvasShareRequest{-1});
    EXPECT_EQ(lab.view.canvas_share, least_canvas_share);
}

TEST(LabRequests, ResetTheCameraByHome) {
    Lab lab = opened_lab("predator-prey");
    for (const Action way : {Action::follow, Action::birds_eye, Action::drivers_eye}) {
        lab.view.camera.pan = {5, 5}, lab.view.camera.zoom = 3, lab.view.camera.azimuth = 1;
        handle(lab, way);
        EXPECT_NE(lab.view.camera.mode, CameraMode::overview);
        handle(lab, Action::home);
        EXPECT_EQ(lab.view.camera, Camera{});
    }
}

TEST(LabRequests, ToggleACameraModeByTheSameAction) {
    Lab lab = opened_lab("predator-prey");
    handle(lab, Action::drivers_eye);
    handle(lab, Action::birds_eye);
    EXPECT_EQ(lab.view.camera.mode, CameraMode::birds_eye);
    handle(lab, Action::birds_eye);
    EXPECT_EQ(lab.view.camera.mode, CameraMode::overview);
}

TEST(LabRequests, RefuseACameraThatRidesWithoutAVehicle) {
    for (const Action way : {Action::follow, Action::drivers_eye}) {
        Lab lab = opened_lab("2a-coward");
        handle(lab, EditRequest{RemoveVehicle{0}});
        handle(lab, way);
        EXPECT_EQ(lab.notice.key, "unavailable.no_vehicles");
        handle(lab, Action::undo);
        ASSERT_EQ(lab.view.selection.vehicle, 0);
        EXPECT_EQ(lab.view.camera.mode, CameraMode::overview) << "the key does not act later";
        handle(lab, way);
        EXPECT_NE(lab.view.camera.mode, CameraMode::overview);
    }
}

TEST(LabRequests, ShowAFailureForSomeSeconds) {
    Lab lab = opened_lab("2a-coward");
    handle(lab, Action::remove);
    handle(lab, Action::remove);
    EXPECT_NE(lab.notice.words, "");
    EXPECT_EQ(lab.notice.kind, NoticeKind::failure);
    advance(lab, 60);
    EXPECT_TRUE(lab.notice.empty());
}

TEST(LabRequests, CycleThroughTheIntensityFieldsOfTheScene) {
    Lab lab = opened_lab("2b-aggressor");
    EXPECT_FALSE(lab.view.overlays.field);
    handle(lab, Action::next_field);
    EXPECT_EQ(lab.view.overlays.field, Channel::light);
    handle(lab, Action::next_field);
    EXPECT_FALSE(lab.view.overlays.field);
    handle(lab, OverlaysRequest{{.labels = false, .field = Channel::light}});
    EXPECT_FALSE(view_of(lab).settings.overlays.labels);
    EXPECT_EQ(view_of(lab).settings.overlays.field, Channel::light);
}

TEST(LabRequests, SwitchEachOverlayOffAndOn) {
    Lab lab = opened_lab("2b-aggressor");
    const Overlays before = lab.view.overlays;
    for (const Action action : {Action::trails, Action::surfaces, Action::memory, Action::labels}) {
        handle(lab, action);
        EXPECT_NE(lab.view.overlays, before);
        handle(lab, action);
        EXPECT_EQ(lab.view.overlays, before);
    }
}

TEST(LabRequests, MovesOfOneGestureAreOneCommandAFrame) {
    Lab lab = opened_lab("empty");
    for (int i = 0; i < 3; ++i) handle(lab, EditRequest{AddSource{{.x = static_cast<float>(i)}}});
    const int depth = lab.document.session.undo_depth();
    const std::size_t logged = lab.document.session.save().checkpoint.commands.size();
    for (const float y : {1.0f, 2.0f}) {
        Outbox frame;
        for (int i = 0; i < 3; ++i) frame.push_back(EditRequest{MoveSource{i, static_cast<float>(i), y}, 77});
        frame.push_back(EditRequest{TurnDial{{.kind = 0}, Dial::LL, y}});
        handle_all(lab, frame);
    }
    EXPECT_EQ(lab.document.session.save().checkpoint.commands.size(), logged + 4);
    for (const SourceView& source : lab.document.session.snapshot().sources) EXPECT_EQ(source.y, 2);
    handle(lab, Action::undo), handle(lab, Action::undo);
    EXPECT_EQ(lab.document.session.snapshot().sources[0].y, 1) << "the dial ended the first drag";
    handle(lab, Action::undo), handle(lab, Action::undo);
    EXPECT_EQ(lab.document.session.snapshot().sources[0].y, 0);
    EXPECT_EQ(lab.document.session.undo_depth(), depth);
}

}  // namespace
}  // namespace braitenlab::tests::lab_requests_test

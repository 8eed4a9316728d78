// Lecture mode in the lab: what it changes, and what leaving restores.
#include <gtest/gtest.h>

#include "app/course/lab_lecture.h"
#include "app/files/data.h"
#include "app/lab_requests.h"

namespace braitenlab::tests::lecture_test {
namespace {

struct LabLecture : testing::Test {
    Lab lab = open();

    static Lab open() {
        auto opened = open_lab(*find_shipped("predator-prey"), std::nullopt, {});
        return std::move(*opened);
    }
};

TEST_F(LabLecture, TypeIsLargeAndColoursAreLight) {
    lab.preferences.type_size = 1.25f;
    handle(lab, Action::lecture);
    EXPECT_TRUE(view_of(lab).lecture);
    EXPECT_FLOAT_EQ(lab.preferences.type_size, 1.75f) << "1.4 times: body text of 22 pixels at type size 1";
    EXPECT_EQ(view_of(lab).program.theme, Theme::light);
}

TEST_F(LabLecture, BeginsByTellingHowToLeaveIt) {
    handle(lab, Action::lecture);
    EXPECT_EQ(lab.notice.key, "notice.projector_view");
    handle(lab, Action::lecture);
    EXPECT_TRUE(lab.notice.empty());
}

TEST_F(LabLecture, LeavingRestoresPreferencesAndCamera) {
    const Preferences mine{Theme::dark, "es", 1.25f, true};
    lab.preferences = mine;
    lab.view.outlines = true;
    lab.view.camera.zoom = 2;
    const Camera camera = lab.view.camera;
    handle(lab, Action::lecture);
    for (const Action action : {Action::theme, Action::larger, Action::larger, Action::sensors, Action::outlines,
                                Action::follow, Action::birds_eye})
        handle(lab, action);
    EXPECT_EQ(own_preferences(lab), mine) << "the preferences that are stored meanwhile";
    handle(lab, Action::lecture);
    EXPECT_FALSE(view_of(lab).lecture);
    EXPECT_EQ(lab.preferences, mine);
    EXPECT_EQ(lab.view.camera, camera);
    EXPECT_TRUE(lab.view.sensors);
    EXPECT_TRUE(lab.view.outlines);
}

TEST_F(LabLecture, KeepsItsThemeForTheNextLecture) {
    lab.preferences.theme = Theme::light;
    handle(lab, Action::lecture);
    handle(lab, Action::theme);
    EXPECT_EQ(lab.preferences.theme, Theme::dark);
    handle(lab, Action::lecture);
    EXPECT_EQ(lab.preferences.theme, Theme::light) << "one's own";
    handle(lab, Action::theme), handle(lab, Action::theme);
    handle(lab, Action::lecture);
    EXPECT_EQ(lab.preferences.theme, Theme::dark);
}

TEST_F(LabLecture, LeavingRestoresTheViewSettingsButTheSelection) {
    const ViewSettings before = lab.view;
    handle(lab, Action::lecture);
    for (const Action action : {Action::trails, Action::surfaces, Action::memory, Action::labels, Action::next_field,
                                Action::sensors, Action::outlines, Action::follow, Action::next_vehicle})
        handle(lab, action);
    const Selection selection = lab.view.selection;
    ASSERT_NE(lab.view.overlays, before.overlays);
    ASSERT_NE(selection, before.selection);
    handle(lab, Action::lecture);
    ViewSettings expected = before;
    expected.selection = selection;
    EXPECT_EQ(lab.view, expected);
}

TEST_F(LabLecture, LeavingDoesNotRestoreTheCameraOfAnotherScene) {
    lab.view.camera.zoom = 3;
    handle(lab, Action::lecture);
    replace_document(lab, std::move(*open_document(*find_shipped("2a-coward"), std::nullopt, {})));
    handle(lab, Action::lecture);
    EXPECT_EQ(lab.view.camera, Camera{});
}

TEST(LectureGrowth, ALargeWindowHasLargerTypeAndASmallOneNotSmaller) {
    EXPECT_EQ(lecture_growth({0, 0, 1280, 800}, 1), 1);
    EXPECT_EQ(lecture_growth({0, 0, 1024, 768}, 1), 1);
    EXPECT_EQ(lecture_growth({0, 0, 1920, 1080}, 1), 1.25f) << "in steps of an eighth";
    EXPECT_EQ(lecture_growth({0, 0, 3840, 2160}, 2), 1.25f) << "a dense display of the same size";
    EXPECT_EQ(lecture_growth({0, 0, 3840, 800}, 1), 1) << "a wide window";
}

TEST_F(LabLecture, KeepsEditsAndTheRun) {
    handle(lab, Action::lecture);
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 1}});
    tick(lab);
    handle(lab, Action::lecture);
    EXPECT_EQ(read_dials(*lab.document.session.snapshot().kind_brains[0]).LR, 1);
    EXPECT_EQ(lab.document.session.snapshot().tick, 1u);
}

}  // namespace
}  // namespace braitenlab::tests::lecture_test

#include "app/remembered.h"

#include <gtest/gtest.h>

#include "app/lab_requests.h"
#include "tests/lab/opened_lab.h"

namespace braitenlab::tests::remembered_test {
namespace {

using ui::Card;

TEST(Remembered, IsRestoredByTheNextStart) {
    Lab lab = opened_lab("predator-prey");
    ui::PanelState panels;
    for (const Action action : {Action::trails, Action::sensors, Action::outlines, Action::birds_eye, Action::faster})
        handle(lab, action);
    handle(lab, ScopeRequest{false});
    panels.card(Card::brain).folded = true;
    panels.card(Card::sensors).folded = false;
    panels.prompts.followed.wiring = true;
    panels.charts.strips = {"SL", "N1"};
    panels.sheets.breeding.may = {.weights = true, .biases = false, .thresholds = true, .eyes = false};
    const StoredView stored = view_to_store(lab, panels);

    Lab next = opened_lab("2a-coward");
    ui::PanelState next_panels;
    restore_view(next, next_panels, stored);
    EXPECT_FALSE(next.view.overlays.trails);
    EXPECT_FALSE(next.view.sensors);
    EXPECT_TRUE(next.view.outlines);
    EXPECT_EQ(next.view.camera.mode, CameraMode::birds_eye);
    EXPECT_FALSE(next.view.selection.whole_kind);
    EXPECT_EQ(next.playback.time_scale, 1) << "a run at 16 × would be over at once";
    EXPECT_TRUE(next_panels.card(Card::brain).folded);
    EXPECT_FALSE(next_panels.card(Card::sensors).folded);
    EXPECT_TRUE(next_panels.prompts.followed.wiring);
    EXPECT_EQ(next_panels.charts.strips, panels.charts.strips);
    EXPECT_EQ(next_panels.sheets.breeding.may, panels.sheets.breeding.may);
    EXPECT_EQ(view_to_store(next, next_panels), stored);
}

TEST(Remembered, KeepsEverySwitchOfTheViewButTheCardOfTheValues) {
    Lab lab = opened_lab("2a-coward"), next = opened_lab("2a-coward");
    ui::PanelState panels;
#define LAB_ACTION(id, ...)
#define UI_ACTION(id, ...)
#define VIEW_SWITCH(id, ...) handle(lab, Action::id);
#include "ui/actions.def"
    StoredState state;
    state.view = view_to_store(lab, panels);
    const auto read = parse_state(write_state(state), "s");
    ASSERT_TRUE(read);
    restore_view(next, panels, read->view);
#define LAB_ACTION(id, ...)
#define UI_ACTION(id, ...)
#define VIEW_SWITCH(id, keys, flag, ...) \
    EXPECT_EQ(next.view.flag == lab.view.flag, Action::id != Action::values) << #id;
#include "ui/actions.def"
}

TEST(Remembered, NamesTheSwitchesThatAPersonHasLeftOff) {
    Lab lab = opened_lab("2a-coward"), next = opened_lab("2a-coward");
    ui::PanelState panels;
    EXPECT_EQ(switched_off(lab.view), std::vector<Action>{});
    for (const Action action : {Action::trails, Action::sensors, Action::outlines, Action::values}) handle(lab, action);
    restore_view(next, panels, view_to_store(lab, panels));
    EXPECT_EQ(switched_off(next.view), (std::vector{Action::sensors, Action::trails}))
        << "outlines are off at the first start, too";
}

TEST(Remembered, DoesNotKeepTheWatchedDiagram) {
    Lab lab = opened_lab("2a-coward");
    const ui::PanelState panels;
    handle(lab, Action::watch);
    ASSERT_TRUE(lab.view.watching);
    StoredState state;
    state.view = view_to_store(lab, panels);
    const auto read = parse_state(write_state(state), "s");
    ASSERT_TRUE(read);
    Lab next = opened_lab("2a-coward");
    ui::PanelState next_panels;
    restore_view(next, next_panels, read->view);
    EXPECT_FALSE(next.view.watching);
}

TEST(Remembered, KeepsTheColourOfTrailsButNotASensor) {
    Lab lab = opened_lab("2b-aggressor");
    const ui::PanelState panels;
    lab.view.overlays.trail_colour = {TrailValue::wheels};
    EXPECT_EQ(view_to_store(lab, panels).settings.overlays.trail_colour, TrailColour{TrailValue::wheels});
    lab.view.overlays.trail_colour = {TrailValue::reading, "SL"};
    EXPECT_EQ(view_to_store(lab, panels).settings.overlays.trail_colour, TrailColour{});
}

TEST(Remembered, IsTheInitialStateAtTheFirstStart) {
    Lab lab = opened_lab("2a-coward");
    const ViewSettings before = lab.view;
    ui::PanelState panels;
    restore_view(lab, panels, {});
    EXPECT_EQ(lab.view, before);
    EXPECT_TRUE(panels.card(Card::sensors).folded);
    EXPECT_FALSE(panels.card(Card::brain).folded);
}

TEST(Remembered, IsOfTheTimeBeforeALecture) {
    Lab lab = opened_lab("2a-coward");
    ui::PanelState panels;
    const StoredView before = view_to_store(lab, panels);
    handle(lab, Action::lecture);
    handle(lab, Action::trails);
    panels.lecture.before = ui::BeforeLecture{panels.cards, {}};
    panels.card(Card::brain).folded = true;
    EXPECT_EQ(view_to_store(lab, panels), before);
}

TEST(Remembered, DoesNotFollowWithoutAVehicle) {
    Lab lab = opened_lab("2a-coward");
    handle(lab, EditRequest{RemoveVehicle{}});
    ui::PanelState panels;
    StoredView stored;
    stored.settings.camera.mode = CameraMode::follow;
    restore_view(lab, panels, stored);
    EXPECT_EQ(lab.view.camera.mode, CameraMode::overview);
}

}  // namespace
}  // namespace braitenlab::tests::remembered_test

// Time in the lab: speed, pace and mode.
#include "app/playback.h"

#include <gtest/gtest.h>

#include "app/lab_requests.h"
#include "tests/lab/opened_lab.h"
#include "ui/window.h"

namespace braitenlab::tests::playback_test {
namespace {

TEST(Playback, AdvancesOnlyWhilePlayingAndAtTheSetSpeed) {
    Lab lab = opened_lab("2a-coward");
    for (int i = 0; i < 10; ++i) advance(lab, 0.1);
    EXPECT_EQ(lab.document.session.snapshot().tick, 0u);
    handle(lab, Action::play_pause);
    for (int i = 0; i < 10; ++i) advance(lab, 0.1);
    EXPECT_NEAR(static_cast<double>(lab.document.session.snapshot().tick), 60, 1);
    handle(lab, SpeedRequest{0.125f});
    for (int i = 0; i < 80; ++i) advance(lab, 0.1);
    EXPECT_NEAR(static_cast<double>(lab.document.session.snapshot().tick), 120, 2);
}

TEST(Playback, DropsTicksThatDoNotFitIntoAFrame) {
    Lab lab = opened_lab("predator-prey");
    handle(lab, Action::play_pause);
    handle(lab, SpeedRequest{16});
    advance(lab, 3600);
    EXPECT_EQ(lab.playback.debt, 0);
    EXPECT_LT(lab.document.session.snapshot().seconds, 3600);
}

TEST(Playback, ReportsThePaceThatItReaches) {
    Lab lab = opened_lab("2a-coward");
    handle(lab, Action::play_pause);
    for (int i = 0; i < 70; ++i) advance(lab, 1.0 / 60);
    EXPECT_FALSE(view_of(lab).pace) << "one vehicle is fast enough";
    lab.playback.time_scale = 1e6f;
    lab.playback.pace = {};
    for (int i = 0; i < 70; ++i) advance(lab, 1.0 / 60);
    const auto pace = view_of(lab).pace;
    ASSERT_TRUE(pace);
    EXPECT_GT(*pace, 0.0f);
    EXPECT_LT(*pace, 1e5f) << "the pace that is reached";
    handle(lab, Action::slower);
    EXPECT_FALSE(view_of(lab).pace) << "measured again";
}

TEST(Playback, WaitsWhileASheetIsOpenAndThenContinuesInTheSameMode) {
    Lab lab = opened_lab("2a-coward");
    ui::PanelState panels;
    const auto tick_after = [&](int frames) {
        for (int i = 0; i < frames; ++i) {
            lab.sheet_open = panels.sheet != ui::Sheet::none;
            advance(lab, 0.1);
        }
        return lab.document.session.snapshot().tick;
    };
    const auto press = [&](KeyPress key) {
        Outbox outbox;
        ui::press_key(view_of(lab), panels, key, outbox);
        for (const Request& request : outbox) handle(lab, request);
    };
    press({' '});
    const auto before = tick_after(5);
    ASSERT_GT(before, 0u);
    const float between = between_ticks(lab);
    press({key::f1});
    ASSERT_EQ(panels.sheet, ui::Sheet::keys);
    EXPECT_EQ(tick_after(5), before);
    EXPECT_EQ(between_ticks(lab), between) << "the picture does not move";
    for (const char key : {' ', '.', ',', 'R', 'N', 'A', 'G'}) press({key});
    EXPECT_EQ(tick_after(5), before) << "keys of the lab do nothing";
    EXPECT_EQ(lab.document.edits, 0);
    press({key::escape});
    ASSERT_EQ(panels.sheet, ui::Sheet::none);
    EXPECT_NEAR(static_cast<double>(tick_after(10) - before), 60, 1) << "without the ticks of the time in between";
    press({' '});
    const auto paused = tick_after(1);
    press({key::f1});
    press({' '});
    press({key::escape});
    EXPECT_EQ(tick_after(5), paused) << "a paused run stays paused";
}

TEST(Playback, CountsChangesBetweenPlayingAndNotPlaying) {
    Lab lab = opened_lab("2a-coward");
    handle(lab, Action::play_pause);
    handle(lab, Action::wiring);
    EXPECT_EQ(lab.playback.mode, Mode::wiring);
    handle(lab, Action::cancel);
    EXPECT_EQ(lab.playback.mode, Mode::paused);
    EXPECT_EQ(lab.playback.toggles, 2);
}

}  // namespace
}  // namespace braitenlab::tests::playback_test

// Time in the lab: speed, pace, mode, going back and bookmarks.
#include "app/playback.h"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "app/lab_requests.h"
#include "app/platform/platform.h"
#include "tests/lab/opened_lab.h"
#include "ui/window.h"
#include "ui/window_keys.h"

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

TEST(Playback, PausesWhereTicksTakeSoLongThatKeysHaveToWait) {
    Lab lab = opened_lab("2a-coward");
    handle(lab, Action::play_pause);
    const auto play = [&](int frames, int milliseconds) {
        const auto take_time = [&](const Snapshot&) {
            const auto end = std::clock() + milliseconds * CLOCKS_PER_SEC / 1000;
            while (std::clock() < end) continue;
        };
        for (int i = 0; i < frames; ++i) advance(lab, 0.017, take_time);
    };
    play(1, 260), play(1, 0);
    EXPECT_EQ(lab.playback.mode, Mode::playing) << "one may be an exception";
    play(6, 260);
    EXPECT_EQ(lab.playback.mode, Mode::paused);
    EXPECT_EQ(lab.notice.key, "notice.slow_ticks");
    EXPECT_GT(std::stod(lab.notice.words), 0.2);
    handle(lab, Action::play_pause);
    play(4, 260);
    EXPECT_EQ(lab.playback.mode, Mode::playing) << "the person has gone on";
    play(1, 0);
    EXPECT_TRUE(lab.notice.empty()) << "ticks are fast again";
    play(6, 260);
    EXPECT_EQ(lab.playback.mode, Mode::paused) << "slow anew";
}

TEST(Playback, PausesAfterHalfASecondInTicksOfMoreThanATenthEachAndNotForFasterOnes) {
    for (const auto& [frames, milliseconds, mode] :
         {std::tuple(3, 130, Mode::playing), {5, 130, Mode::paused}, {8, 80, Mode::playing}}) {
        Lab lab = opened_lab("2a-coward");
        handle(lab, Action::play_pause);
        for (int i = 0; i < frames; ++i)
            advance(lab, 0.017, [spent = milliseconds * 1e-3](const Snapshot&) {
                const double end = thread_time() + spent;
                while (thread_time() < end) continue;
            });
        EXPECT_EQ(lab.playback.mode, mode) << frames << " ticks of " << milliseconds << " ms";
    }
}

TEST(Playback, DoesNotPauseForTheWorkOfOtherThreadsAndPrograms) {
    Lab lab = opened_lab("2a-coward");
    handle(lab, Action::play_pause);
    std::atomic<bool> ends = false;
    std::thread other([&] {
        while (!ends) continue;
    });
    for (int i = 0; i < 6; ++i)
        advance(lab, 0.017, [](const Snapshot&) { std::this_thread::sleep_for(std::chrono::milliseconds(260)); });
    ends = true;
    other.join();
    EXPECT_EQ(lab.playback.mode, Mode::playing);
    EXPECT_TRUE(lab.notice.empty()) << lab.notice.key;
}

TEST(Playback, ShowsEachTickOfAFastRun) {
    Lab lab = opened_lab("2a-coward");
    handle(lab, Action::play_pause);
    handle(lab, SpeedRequest{4});
    std::vector<std::uint64_t> seen;
    for (int i = 0; i < 5; ++i) advance(lab, 0.05, [&](const Snapshot& now) { seen.push_back(now.tick); });
    ASSERT_GT(seen.size(), 20u);
    for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_EQ(seen[i], i + 1);
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

TEST(Playback, AResetStaysInTheWiringEditorAndPlayKeepsTheDiagramBesideTheScene) {
    Lab lab = opened_lab("2a-coward");
    for (int i = 0; i < 60; ++i) tick(lab);
    handle(lab, Action::wiring);
    handle(lab, Action::reset);
    EXPECT_EQ(lab.playback.mode, Mode::wiring);
    EXPECT_EQ(lab.document.session.snapshot().tick, 0u);
    lab.notice = {};
    handle(lab, Action::play_pause);
    EXPECT_EQ(lab.playback.mode, Mode::playing);
    EXPECT_TRUE(lab.view.watching);
    EXPECT_EQ(lab.notice.key, "notice.left_wiring");
    lab.notice = {};
    handle(lab, Action::play_pause), handle(lab, Action::play_pause);
    EXPECT_TRUE(lab.notice.empty()) << "from the scene it leaves nothing";
    handle(lab, Action::reset);
    EXPECT_EQ(lab.playback.mode, Mode::paused);
}

TEST(Playback, GoesBackAndForwardExactly) {
    Lab lab = opened_lab("predator-prey");
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

TEST(Playback, ADragBackInTimePauses) {
    Lab lab = opened_lab("2a-coward");
    for (int i = 0; i < 300; ++i) tick(lab);
    handle(lab, Action::play_pause);
    handle(lab, SeekRequest{lab.document.session.latest(), true});
    EXPECT_EQ(lab.playback.mode, Mode::playing) << "a press at the end of the track";
    handle(lab, SeekRequest{120, true});
    handle(lab, SeekRequest{120, false});
    advance(lab, 0.5);
    EXPECT_EQ(lab.document.session.snapshot().tick, 120u) << "a change takes effect where the playhead was let go";
    handle(lab, Action::play_pause);
    advance(lab, 0.1);
    EXPECT_GT(lab.document.session.snapshot().tick, 120u);
}

TEST(Playback, GoesBackInPartsWithManyVehicles) {
    Lab lab = opened_lab("predator-prey");
    for (const int kind : {0, 1}) handle(lab, EditRequest{SetPopulation{kind, 160}});
    ASSERT_EQ(lab.document.session.snapshot().vehicles.size(), 320u) << lab.notice.words;
    std::vector<std::uint64_t> hashes;
    for (int i = 0; i < 250; ++i) hashes.push_back(lab.document.session.hash()), tick(lab);
    const auto arrive_at = [&](std::uint64_t wanted) {
        int frames = 0;
        for (; lab.playback.seeks && frames < 1000; ++frames) advance(lab, 1.0 / 60);
        EXPECT_EQ(lab.document.session.snapshot().tick, wanted);
        EXPECT_EQ(lab.document.session.hash(), hashes[wanted]);
        return frames;
    };
    handle(lab, SeekRequest{200, false});
    EXPECT_EQ(lab.document.session.snapshot().tick, 0u) << "the keyframe; no tick is repeated yet";
    EXPECT_GT(arrive_at(200), 0);
    handle(lab, Action::step_back);
    arrive_at(199);
    handle(lab, SeekRequest{240, false});
    EXPECT_EQ(lab.document.session.snapshot().tick, 199u) << "it goes on from here";
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LL, 1}});
    advance(lab, 1.0 / 60);
    EXPECT_EQ(lab.document.session.snapshot().tick, 199u) << "an edit ends the way";
    EXPECT_FALSE(lab.playback.seeks);
}

TEST(Playback, ReportsTheFutureThatAnEditDropsAndUndoRestores) {
    Lab lab = opened_lab("predator-prey");
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
    EXPECT_TRUE(lab.notice.empty()) << "no recorded future exists";
}

TEST(Playback, RestoresTheRefereeAtEachTick) {
    Lab lab = opened_lab("05-aggressor");
    handle(lab, EditRequest{SetBrain{{.kind = 0}, lab.document.lesson->exercise->solution.submission.brain}});
    std::vector<std::vector<bool>> done;
    const auto ticks_now = [&] {
        std::vector<bool> all;
        for (const Verdict& verdict : lesson_view_of(lab).verdicts) all.push_back(verdict.done);
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

TEST(Playback, RestoresAndRemovesABookmark) {
    Lab lab = opened_lab("predator-prey");
    for (int i = 0; i < 130; ++i) tick(lab);
    const auto hash = lab.document.session.hash();
    handle(lab, Action::set_bookmark);
    handle(lab, Action::set_bookmark);
    EXPECT_EQ(lab.playback.bookmarks.size(), 1u) << "one per tick";
    handle(lab, Action::reset);
    for (int i = 0; i < 10; ++i) tick(lab);
    handle(lab, Action::last_bookmark);
    EXPECT_EQ(lab.document.session.hash(), hash);
    handle(lab, BookmarkRequest{0, true});
    EXPECT_TRUE(lab.playback.bookmarks.empty());
    handle(lab, Action::last_bookmark);  // there is none
    EXPECT_EQ(lab.document.session.hash(), hash);
}

}  // namespace
}  // namespace braitenlab::tests::playback_test

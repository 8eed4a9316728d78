// Going back in time and bookmarks.
#include "app/past.h"

#include <gtest/gtest.h>

#include "app/lab_requests.h"
#include "tests/lab/opened_lab.h"

namespace braitenlab::tests::past_test {
namespace {

TEST(Past, GoesBackAndForwardExactly) {
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

TEST(Past, ReportsTheFutureThatAnEditDropsAndUndoRestores) {
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

TEST(Past, RestoresTheRefereeAtEachTick) {
    Lab lab = opened_lab("05-aggressor");
    handle(lab, EditRequest{SetBrain{{.kind = 0}, lab.document.lesson->exercise->solution.submission.brain}});
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

TEST(Past, RestoresAndRemovesABookmark) {
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
}  // namespace braitenlab::tests::past_test

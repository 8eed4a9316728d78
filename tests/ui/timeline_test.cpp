#include "desk.h"

namespace braitenlab::tests::timeline_test {

using namespace ui;

struct Timeline : testing::Test {
    Desk desk;

    Timeline() {
        desk.now.tick = 1800;
        desk.view.timeline = {0, 3600, {600, 2400}};
        desk.frame(2);
    }
    template <class Wanted>
    Found<Wanted> asked() const {
        Found<Wanted> found;
        for (const Request& request : desk.all)
            if (const auto* wanted = std::get_if<Wanted>(&request)) found.push_back(*wanted);
        return found;
    }
};

TEST_F(Timeline, SeeksToTheDraggedPlayhead) {
    desk.point("timeline.track", 0.25f);
    desk.frame(2);
    desk.button(0, true);
    desk.frame(2);
    desk.point("timeline.track", 0.75f);
    desk.frame(2);
    ASSERT_FALSE(asked<SeekRequest>().empty());
    EXPECT_NEAR(static_cast<double>(asked<SeekRequest>().front().tick), 900, 60);
    EXPECT_NEAR(static_cast<double>(asked<SeekRequest>().back().tick), 2700, 60);
    for (const SeekRequest& request : asked<SeekRequest>()) EXPECT_TRUE(request.held);
    desk.button(0, false);
    desk.frame(2);
    EXPECT_FALSE(asked<SeekRequest>().back().held);
    const std::size_t count = asked<SeekRequest>().size();
    desk.frame(5);
    EXPECT_EQ(asked<SeekRequest>().size(), count) << "released once";
}

TEST_F(Timeline, SeeksOnlyWithinTheRecording) {
    desk.view.timeline = {1200, 2400, {}};
    desk.click("timeline.track", 0, 0.05f);
    EXPECT_EQ(asked<SeekRequest>().back().tick, 1200u);
    desk.click("timeline.track", 0, 0.95f);
    EXPECT_EQ(asked<SeekRequest>().back().tick, 2400u);
}

TEST_F(Timeline, SeeksToABookmarkOnAClickAndRemovesItOnARightClick) {
    desk.click("bookmark.2");
    ASSERT_EQ(asked<BookmarkRequest>().size(), 1u);
    EXPECT_EQ(asked<BookmarkRequest>()[0].index, 1);
    EXPECT_FALSE(asked<BookmarkRequest>()[0].remove);
    desk.click("bookmark.1", 1);
    ASSERT_EQ(asked<BookmarkRequest>().size(), 2u);
    EXPECT_EQ(asked<BookmarkRequest>()[1].index, 0);
    EXPECT_TRUE(asked<BookmarkRequest>()[1].remove);
    EXPECT_TRUE(asked<SeekRequest>().empty());
}

TEST_F(Timeline, SeeksByArrowKeysWhileItHasTheFocus) {
    desk.panels.keyboard.focus = "timeline.track";
    desk.frame(2);
    desk.key({key::left});
    desk.frame(2);
    desk.key({key::right});
    desk.frame(2);
    ASSERT_EQ(asked<SeekRequest>().size(), 2u);
    EXPECT_EQ(asked<SeekRequest>()[0].tick, 1740u);
    EXPECT_EQ(asked<SeekRequest>()[1].tick, 1860u);
}

TEST_F(Timeline, ScrollsOnceTheRunIsLongerThanAMinute) {
    desk.now.tick = 9000;
    desk.view.timeline = {5400, 9000, {}};
    desk.frame(2);
    desk.click("timeline.track", 0, 0.5f);
    EXPECT_NEAR(static_cast<double>(asked<SeekRequest>().back().tick), 7200, 60);
}

}  // namespace braitenlab::tests::timeline_test

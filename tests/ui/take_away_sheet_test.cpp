// The sheet for pictures and clips (ui/panels/files/take_away_sheet.cpp).
#include <algorithm>
#include <string>

#include "desk.h"

namespace braitenlab::tests::take_away_sheet_test {

using namespace ui;

namespace {

struct TakeAwayDesk : testing::Test {
    Desk desk;

    TakeAwayDesk() {
        desk.view.timeline = {.earliest = 600, .latest = 2400};
        desk.panels.sheet = Sheet::take;
        desk.frame(3);
    }
    std::optional<TakeAway> taken() {
        const auto* request = desk.last<TakeAwayRequest>();
        return request ? std::optional(request->what) : std::nullopt;
    }
    bool is_written(std::string_view words) const {
        return std::any_of(desk.written.begin(), desk.written.end(),
                           [&](const Written& each) { return each.words.find(words) != std::string::npos; });
    }
    bool can_save() const {
        const auto found = std::find_if(desk.shown.begin(), desk.shown.end(),
                                        [](const Shown& each) { return each.id == "button.clip"; });
        return found != desk.shown.end() && found->enabled;
    }
};

TEST_F(TakeAwayDesk, IsOpenedByTheFileMenu) {
    desk.panels.sheet = Sheet::none;
    desk.panels.menu_bar.open = "file";
    desk.frame(3);
    desk.click("menu.file.take_away");
    desk.frame(2);
    EXPECT_EQ(desk.panels.sheet, Sheet::take);
}

TEST_F(TakeAwayDesk, SavesTheSceneAsItIsSeenUnlessAnotherPictureIsChosen) {
    desk.click("button.clip");
    EXPECT_EQ(taken(), (TakeAway{TakeKind::scene}));
    EXPECT_EQ(desk.panels.sheet, Sheet::none);
    desk.panels.sheet = Sheet::take;
    desk.frame(2);
    desk.click("take.shows.2");
    desk.click("take.size.4");
    desk.click("button.clip");
    EXPECT_EQ(taken(), (TakeAway{TakeKind::window, 3840, 2160}));
}

TEST_F(TakeAwayDesk, SavesTheDiagramAndThePathsUnlessTheBrainIsHidden) {
    desk.view.settings.selection.vehicle = desk.now.vehicles[0].id;
    desk.now.tick = 600;
    desk.click("take.shows.3");
    EXPECT_FALSE(desk.anchors.find("take.size.1")) << "an SVG file has no pixels";
    desk.view.settings.revealed.brain = false;
    desk.frame(2);
    EXPECT_FALSE(can_save());
    desk.view.settings.revealed.brain = true;
    desk.frame(2);
    EXPECT_TRUE(can_save());
    desk.click("button.clip");
    EXPECT_EQ(taken(), (TakeAway{TakeKind::wiring}));
    desk.panels.sheet = Sheet::take;
    desk.frame(2);
    desk.click("take.shows.4");
    desk.click("button.clip");
    EXPECT_EQ(taken(), (TakeAway{TakeKind::paths}));
}

TEST_F(TakeAwayDesk, OffersTheLastTenSecondsAsAGif) {
    desk.click("take.page.2");
    EXPECT_FALSE(desk.anchors.find("take.format.2")) << "ffmpeg is missing";
    EXPECT_TRUE(is_written("ffmpeg"));
    desk.click("button.clip");
    EXPECT_EQ(taken(), (TakeAway{TakeKind::gif, 640, 400, 1800, 2400}));
    EXPECT_EQ(desk.panels.sheet, Sheet::take) << "until it is written";
}

TEST_F(TakeAwayDesk, OffersVideosWhereFfmpegIs) {
    desk.view.program.has_ffmpeg = true;
    desk.click("take.page.2");
    desk.click("take.format.3");
    desk.click("take.size.2");
    desk.click("button.clip");
    EXPECT_EQ(taken(), (TakeAway{TakeKind::webm, 960, 600, 1800, 2400}));
    EXPECT_FALSE(is_written("ffmpeg"));
}

TEST_F(TakeAwayDesk, TakesTheTimeFromTheSliders) {
    desk.click("take.page.2");
    const Rect from = *desk.anchors.find("take.from");
    desk.panels.sheets.take.from = 12.5f;
    desk.panels.sheets.take.to = 31;
    desk.frame(2);
    EXPECT_GT(from.w, 200);
    desk.click("button.clip");
    EXPECT_EQ(taken(), (TakeAway{TakeKind::gif, 640, 400, 750, 1860}));
}

TEST_F(TakeAwayDesk, SaysWhyThereCanBeNoClip) {
    desk.click("take.page.2");
    EXPECT_TRUE(can_save());
    desk.panels.sheets.take.to = desk.panels.sheets.take.from;
    desk.frame(2);
    EXPECT_FALSE(can_save());
    EXPECT_TRUE(is_written(desk.strings("take.no_time")));
    desk.panels.sheet = Sheet::none;
    desk.frame(2);
    desk.view.timeline = {};
    desk.panels.sheet = Sheet::take;
    desk.frame(2);
    EXPECT_FALSE(can_save());
    EXPECT_TRUE(is_written(desk.strings("take.no_run")));
    EXPECT_FALSE(desk.anchors.find("take.from"));
    desk.click("take.page.1");
    EXPECT_TRUE(can_save()) << "a picture needs no run";
}

TEST_F(TakeAwayDesk, ShowsTheProgressAndClosesWhenTheClipIsWritten) {
    desk.view.program.clip_progress = 0.375f;
    desk.frame(2);
    EXPECT_TRUE(is_written("37 %"));
    EXPECT_FALSE(desk.anchors.find("button.clip"));
    desk.view.program.clip_progress.reset();
    desk.frame(2);
    EXPECT_EQ(desk.panels.sheet, Sheet::none);
    EXPECT_FALSE(desk.last<CancelClipRequest>());
}

TEST_F(TakeAwayDesk, CancelsTheClipByTheButtonAndByEscape) {
    desk.view.program.clip_progress = 0.5f;
    desk.frame(2);
    desk.click("take.cancel");
    desk.frame(1);
    EXPECT_TRUE(desk.last<CancelClipRequest>());
    desk.all.clear();
    desk.panels.sheet = Sheet::take;
    desk.frame(2);
    desk.key({key::escape});
    desk.frame(2);
    EXPECT_TRUE(desk.last<CancelClipRequest>());
}

}  // namespace
}  // namespace braitenlab::tests::take_away_sheet_test

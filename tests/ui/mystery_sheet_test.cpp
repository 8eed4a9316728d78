// The sheet of the mystery brain: what it offers, the score and the pictures of the starts.
#include "scene_on_desk.h"

namespace braitenlab::tests::mystery_sheet_test {

using namespace ui;

namespace {

struct MysterySheet : SceneOnDesk {
    insight::MysteryScore score{.score = 72, .gap = 0.6f, .random_gap = 2.15f};
    MysterySheet() {
        for (int i = 0; i < 10; ++i)
            score.starts.push_back({{{0, 0, 0}, {1, 1, 0}}, {{0, 0, 0}, {1, 0, 0}}, 0.6f, 2.1f});
        desk.view.features.mystery.rebuilt = 0;
        desk.panels.sheet = Sheet::mystery;
        desk.frame(3);
    }
    std::vector<MysteryEdit> asked() const {
        std::vector<MysteryEdit> all;
        for (const MysteryRequest& each : requests<MysteryRequest>()) all.push_back(each.edit);
        return all;
    }
};

}  // namespace

TEST_F(MysterySheet, FirstOffersToHideABrain) {
    desk.click("mystery.hide");
    EXPECT_EQ(asked(), std::vector{MysteryEdit::hide});
    EXPECT_FALSE(desk.anchors.find("mystery.compare"));
}

TEST_F(MysterySheet, WithAHiddenBrainOffersToRebuildAndToCompare) {
    desk.view.features.mystery.hidden = 1;
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("mystery.hide"));
    desk.click("mystery.compare");
    desk.click("mystery.reveal");
    desk.click("mystery.rebuild");
    EXPECT_EQ(asked(), (std::vector{MysteryEdit::score, MysteryEdit::reveal, MysteryEdit::rebuild}));
    EXPECT_EQ(desk.panels.sheet, Sheet::none) << "the new vehicle is to be seen";
}

TEST_F(MysterySheet, AnExerciseOffersToCompareOnly) {
    desk.open_exercise();
    desk.view.features.mystery.hidden = 0;
    desk.frame(2);
    EXPECT_TRUE(desk.anchors.find("mystery.compare"));
    for (const char* none : {"mystery.hide", "mystery.reveal", "mystery.rebuild"})
        EXPECT_FALSE(desk.anchors.find(none));
}

TEST_F(MysterySheet, ShowsTheScoreAndBothPathsOfEachStart) {
    desk.view.features.mystery.hidden = 1;
    desk.view.features.mystery.score = &score, desk.view.features.mystery.scene = desk.now.scene.get();
    desk.frame(3);
    EXPECT_TRUE(desk.says("72 of 100"));
    EXPECT_TRUE(desk.says("0.60 m"));
    EXPECT_TRUE(desk.says("2.15 m"));
    for (int i = 1; i <= 10; ++i) EXPECT_TRUE(desk.anchors.find("mystery.start." + std::to_string(i))) << i;
    desk.view.features.mystery.is_computing = true;
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("mystery.score")) << "an outdated score";
}

}  // namespace braitenlab::tests::mystery_sheet_test

// The card of slots A and B, their keys, and their runs over the scene.
#include <cmath>

#include "scene_on_desk.h"
#include "ui/scene_input/draw_insight.h"

namespace braitenlab::tests::slots_card_test {

using namespace ui;
using insight::CompareNumbers;

namespace {

struct SlotsCard : SceneOnDesk {
    insight::Design design;
    CompareNumbers of_a{0.4f, 5.3f, 0.5f, 7, 3}, of_b{3.1f, INFINITY, 9.5f, 12, NAN};
    std::vector<Pose> path_a, path_b;

    SlotsCard() {
        desk.now = snapshot(0);
        design.brain = *desk.now.brains[0];
        desk.view.features.slots.slots[0] = {.design = &design, .kind = "vehicle", .character = Character::aggressor};
    }
    void fill_both() {
        desk.view.features.slots.slots[1] = {.design = &design, .kind = "vehicle", .character = Character::coward};
    }
    void compared() {
        fill_both();
        desk.view.features.slots.seconds = 30;
        desk.view.features.slots.slots[0].numbers = &of_a, desk.view.features.slots.slots[1].numbers = &of_b;
    }
};

}  // namespace

TEST_F(SlotsCard, CanBeClosed) {
    fill_both();
    desk.frame(4);
    desk.click("slots.close");
    EXPECT_TRUE(desk.last<EmptySlotsRequest>());
    EXPECT_FALSE(desk.panels.card(Card::slots).folded);
}

TEST_F(SlotsCard, IsThereOnceABrainIsStored) {
    desk.frame(4);
    EXPECT_TRUE(desk.anchors.find("card.slots"));
    EXPECT_TRUE(desk.says("aggressor"));
    EXPECT_TRUE(desk.says("empty"));
    desk.view.features.slots = {};
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("card.slots"));
}

TEST(SlotsCardInALecture, TellsInLargerTypeHowTheRunsAreMeasured) {
    const auto size_of_note = [](bool lecture) {
        const insight::Design design;
        const CompareNumbers of_a{0.4f, 5.3f, 0.5f, 7, 3};
        Desk desk(1280, 800, 1, true);
        for (auto& slot : desk.view.features.slots.slots)
            slot = {.design = &design, .kind = "vehicle", .numbers = &of_a};
        desk.view.features.slots.seconds = 30;
        desk.view.lecture = lecture;
        desk.frame(4);
        float size = 0;
        for (const Written& w : desk.written)
            if (w.words.rfind("Both runs", 0) == 0) size = w.size;
        return size;
    };
    ASSERT_GT(size_of_note(false), 0);
    EXPECT_GT(size_of_note(true), 1.1f * size_of_note(false));
}

TEST_F(SlotsCard, ALetterPutsItsBrainAndAnEmptyOneStores) {
    desk.frame(4);
    desk.click("slot.a");
    ASSERT_EQ(requests<SlotRequest>().size(), 1u);
    EXPECT_EQ(requests<SlotRequest>()[0].slot, 0u);
    EXPECT_FALSE(requests<SlotRequest>()[0].store);
    desk.click("slot.b");
    ASSERT_EQ(requests<SlotRequest>().size(), 2u);
    EXPECT_EQ(requests<SlotRequest>()[1].slot, 1u);
    EXPECT_TRUE(requests<SlotRequest>()[1].store);
    desk.click("slot.a.store");
    ASSERT_EQ(requests<SlotRequest>().size(), 3u);
    EXPECT_EQ(requests<SlotRequest>()[2].slot, 0u);
    EXPECT_TRUE(requests<SlotRequest>()[2].store);
}

TEST_F(SlotsCard, ComparesOnlyTwoBrains) {
    desk.frame(4);
    desk.click("button.compare");
    EXPECT_EQ(desk.actions(), std::vector<Action>{});
    fill_both();
    desk.click("button.compare");
    EXPECT_EQ(desk.actions(), std::vector{Action::compare});
}

TEST_F(SlotsCard, ShowsTheNumbersOfBothRunsAndTheirDifference) {
    compared();
    desk.frame(4);
    for (const char* words : {"0.4 m", "3.1 m", "+2.7 m", "5.3 s", "never", "+5.0 m", "30 s"})
        EXPECT_TRUE(desk.says(words)) << words;
    EXPECT_TRUE(desk.says("3.0 s"));
    EXPECT_TRUE(desk.anchors.find("slots.in_light"));
}

TEST_F(SlotsCard, HidesWhatTheBrainsDoBeforeThePrediction) {
    desk.view.settings.revealed.character = false;
    desk.frame(4);
    EXPECT_FALSE(desk.says("aggressor"));
    EXPECT_TRUE(desk.says("stored"));
}

TEST_F(SlotsCard, BothPathsAndTheVehicleOfBAreOverTheScene) {
    compared();
    desk.now.tick = 60;
    for (int i = 0; i <= 480; ++i) {
        path_a.push_back({-6 + 0.02f * static_cast<float>(i), -3, 0});
        path_b.push_back({-6 + 0.02f * static_cast<float>(i), 3, 0});
    }
    desk.view.features.slots.a = GhostView{path_a[60], 1, 0.7f, &path_a, 61};
    desk.view.features.slots.b = GhostView{path_b[60], 1, 0.7f, &path_b, 61};
    desk.frame(2);
    const Rect a = desk.where("stage.slot_a"), b = desk.where("stage.slot_b");
    EXPECT_NEAR(a.x + a.w / 2, pixel({path_a[60].x, -3}).x, 1);
    EXPECT_NEAR(b.x + b.w / 2, pixel({path_b[60].x, 3}).x, 1);
    EXPECT_GT(a.y, b.y);
    desk.view.features.slots.a.reset(), desk.view.features.slots.b.reset();
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("stage.slot_a"));
    EXPECT_FALSE(desk.anchors.find("stage.slot_b"));
}

TEST_F(SlotsCard, TheCardIsBesideTheSceneOfALecture) {
    compared();
    desk.view.lecture = true;
    desk.frame(4);
    const Rect card = desk.where("card.slots");
    EXPECT_LE(card.x + card.w, desk.layout.scene.x);
    EXPECT_TRUE(desk.says("+2.7 m"));
}

TEST_F(SlotsCard, KeysStoreAndCompare) {
    fill_both();
    desk.frame(2);
    desk.key({'Q'});
    desk.key({'Q', false, true});
    desk.frame(2);
    EXPECT_EQ(desk.actions(), (std::vector{Action::slot, Action::compare}));
}

}  // namespace braitenlab::tests::slots_card_test

// Two brains from the same start, on a page of a lecture.
#include <string>

#include "lecture_on_desk.h"

namespace braitenlab::tests::lecture_comparison_test {

using namespace ui;

namespace {

constexpr int call_four_numbers = 6, two_slides_on = 8;  // pages

struct LectureComparison : LectureOnDesk {
    insight::Design design;
    insight::CompareNumbers of_a{0.4f, 5.3f, 0.5f, 7, 3}, of_b{3.1f, 4.2f, 9.5f, 12, 2};
    std::vector<Pose> path{{0, 0, 0}, {1, 0, 0}};

    LectureComparison() {
        design.brain = *desk.now.brains[0];
        show(call_four_numbers, 0);
    }
    void store() {
        for (SlotView& slot : desk.view.features.slots.slots) slot = {.design = &design, .kind = "vehicle"};
        desk.frame(4);
    }
    void compare() {
        desk.view.features.slots.seconds = 30;
        desk.view.features.slots.slots[0].numbers = &of_a, desk.view.features.slots.slots[1].numbers = &of_b;
        desk.view.features.slots.a = desk.view.features.slots.b = GhostView{.path = &path, .count = 2};
        desk.frame(4);
    }
    void end_runs() {
        desk.view.features.slots.a.reset(), desk.view.features.slots.b.reset();
        desk.frame(4);
    }
    float width_of_scene() const { return desk.where("viewport").w / desk.layout.window.w; }
};

}  // namespace

TEST_F(LectureComparison, HasTheRoomOfTheCards) {
    ASSERT_TRUE(desk.anchors.find("slider.LL"));
    store();
    EXPECT_TRUE(desk.anchors.find("button.compare"));
    EXPECT_LT(width_of_scene(), 0.5f);
    compare();
    EXPECT_FALSE(desk.anchors.find("card.brain")) << "the brain";
    EXPECT_FALSE(desk.anchors.find("slots.closest")) << "the numbers, which tell how it ends";
    EXPECT_GT(width_of_scene(), 0.95f);
    EXPECT_LT(desk.where("card.slots").w, 0.3f * desk.layout.window.w);
}

TEST_F(LectureComparison, ShowsItsNumbersAfterTheRuns) {
    store();
    compare();
    desk.click("card.slots.fold");
    desk.rest();
    EXPECT_TRUE(desk.anchors.find("button.compare")) << "or when the lecturer opens them";
    desk.click("card.slots.fold");
    end_runs();
    const Rect numbers = desk.where("slots.final");
    EXPECT_TRUE(is_inside(numbers, desk.where("card.slots")));
    EXPECT_FALSE(overlap(desk.where("card.slots"), desk.where("viewport")));
}

TEST_F(LectureComparison, UnfoldsItsNumbersAtTheEndBesideBothVehicles) {
    store();
    compare();
    EXPECT_TRUE(desk.panels.card(Card::slots).folded) << "not before the end";
    desk.now.seconds = desk.view.features.slots.seconds;
    desk.frame(4);
    EXPECT_FALSE(desk.panels.card(Card::slots).folded);
    EXPECT_TRUE(desk.anchors.find("slots.closest"));
}

TEST_F(LectureComparison, TheBarSaysWhoseBrainsDriveAndNotTheTitleOfTheScene) {
    desk.view.pages = nullptr;
    desk.view.settings.selection.vehicle = desk.now.vehicles.front().id;
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    scene->title = "Vehicle 2a: Coward";
    desk.now.scene = scene;
    store();
    SlotsView& slots = desk.view.features.slots;
    slots.slots[0].character = Character::aggressor, slots.slots[1].character = Character::coward;
    slots.slots[0].is_in_vehicle = true;
    desk.frame(2);
    EXPECT_TRUE(desk.says("Vehicle 2a: Coward with brain A"));
    compare();
    EXPECT_TRUE(desk.says("A: aggressor, B: coward"));
    EXPECT_FALSE(desk.says("Vehicle 2a: Coward"));
    desk.view.settings.revealed.character = false;
    desk.frame(2);
    EXPECT_FALSE(desk.says("A: aggressor, B: coward"));
    desk.view.settings.revealed.title = false;
    desk.frame(2);
    EXPECT_FALSE(desk.says("Vehicle 2a"));
}

TEST_F(LectureComparison, TakesThePlaceOfAnAnsweredQuestion) {
    pages = opened_lecture("wheels-to-neurons");
    show(5, 3);
    store();
    compare();
    EXPECT_FALSE(desk.anchors.find("lecture.question"));
    EXPECT_GT(width_of_scene(), 0.95f);
}

TEST_F(LectureComparison, NoCardOfTheSceneOrTheExerciseIsBesideIt) {
    desk.open_exercise();
    store();
    EXPECT_FALSE(desk.anchors.find("card.exercise"));
    desk.view.lesson = nullptr;
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("card.scene"));
}

TEST_F(LectureComparison, AnotherPageUnfoldsTheCardForTheNextBrains) {
    store();
    desk.panels.card(Card::slots).folded = true;
    show(two_slides_on, 0);
    EXPECT_FALSE(desk.panels.card(Card::slots).folded);
}

TEST_F(LectureComparison, LeavesTheCardsAsTheyWereBeforeTheLecture) {
    store();
    compare();
    desk.view.lecture = false, desk.view.pages = nullptr;
    ImGui::GetIO().DisplaySize = {1434, 1076};  // as many layout pixels as without the type of a lecture
    desk.frame(2);
    EXPECT_FALSE(desk.panels.card(Card::brain).folded);
    EXPECT_FALSE(desk.panels.card(Card::slots).folded);
    EXPECT_FALSE(desk.panels.lecture.before);
}

}  // namespace braitenlab::tests::lecture_comparison_test

// The card of real robots: the slider, the share, a dot for each robot, replays.
#include "scene_on_desk.h"

namespace braitenlab::tests::reality_card_test {

using namespace ui;
using insight::Behaviour;
using insight::RobotResult;
using insight::RobotsReport;

namespace {

struct RealityCard : SceneOnDesk {
    RobotsReport report;
    RealityCard() {
        desk.now = snapshot(0);
        desk.view.settings.reality = true;
        std::vector<RobotResult> robots(10);
        for (std::size_t i = 0; i < robots.size(); ++i) {
            robots[i].outcome = {.behaviour = i == 6 ? Behaviour::passes : Behaviour::touches,
                                 .closest = i == 6 ? 2.5f : 0.1f};
            robots[i].path = {{0, 0, 0}, {1, 0.1f * static_cast<float>(i), 0}};
        }
        RobotResult ideal;
        ideal.outcome = {.behaviour = Behaviour::touches, .closest = 0};
        report = insight::report_of(std::move(ideal), std::move(robots), false);
        desk.view.features.robots = RobotsView{.count = 10, .figures = insight::typical_robot, .is_typical = true};
        desk.frame(4);
    }
    void tried() {
        desk.view.features.robots->is_on = true, desk.view.features.robots->report = &report;
        desk.frame(4);
    }
};

}  // namespace

TEST_F(RealityCard, BeginsATrial) {
    EXPECT_TRUE(desk.says("gain\u00a0±20\u00a0%, noise\u00a00.010, 40\u00a0ms\u00a0late")) << "breaks at commas only";
    EXPECT_TRUE(desk.says("Wheels: speed\u00a0±10\u00a0%"));
    EXPECT_TRUE(desk.says("every 20 ms, 10 bit"));
    EXPECT_FALSE(desk.says("robots do"));
    desk.click("reality.try");
    ASSERT_TRUE(desk.last<RobotsRequest>());
    EXPECT_EQ(desk.last<RobotsRequest>()->tries, true);
}

TEST_F(RealityCard, TellsTheShareAndNamesTheWeakest) {
    tried();
    EXPECT_TRUE(desk.says("90 %"));
    EXPECT_TRUE(desk.says("9 of 10"));
    EXPECT_TRUE(desk.says("Robot 7, the weakest"));
    EXPECT_TRUE(desk.says("2.5 m"));
}

TEST_F(RealityCard, HasADotForEachRobotFromTheBestToTheWeakest) {
    tried();
    for (int i = 1; i <= 10; ++i) EXPECT_TRUE(desk.anchors.find("reality.robot." + std::to_string(i))) << i;
    EXPECT_GT(desk.where("reality.robot.7").x, desk.where("reality.robot.10").x);
    desk.point("reality.robot.3");
    desk.frame(2);
    EXPECT_EQ(desk.panels.reality.hovered, 2);
    EXPECT_TRUE(desk.says("Robot 3: "));
}

TEST_F(RealityCard, ReplaysARobotTheWeakestOrAll) {
    tried();
    const auto asked = [&] { return desk.last<RobotsRequest>()->replays; };
    desk.click("reality.robot.3");
    EXPECT_EQ(asked(), std::optional<int>(2));
    desk.point("reality.slider");  // the words below the dots are those of the weakest again
    desk.rest();
    desk.click("reality.weakest");
    EXPECT_EQ(asked(), std::optional<int>(6));
    desk.rest();
    desk.click("reality.all");
    EXPECT_EQ(asked(), std::optional<int>(every_robot));
    desk.view.features.robots->replayed = 6;
    desk.frame(4);
    EXPECT_TRUE(desk.says("Replay of robot 7"));
    desk.click("reality.back");
    ASSERT_TRUE(asked());
    EXPECT_FALSE(*asked());
}

TEST_F(RealityCard, SetsTheRealityByItsSlider) {
    tried();
    const Rect r = desk.where("reality.slider");
    desk.point(r.x + r.w * 0.5f, r.y + r.h / 2);
    desk.frame(2);
    desk.button(0, true), desk.frame(2);
    desk.point(r.x + r.w * 0.3f, r.y + r.h / 2);
    desk.frame(2);
    desk.button(0, false), desk.frame(2);
    ASSERT_TRUE(desk.last<RobotsRequest>());
    ASSERT_TRUE(desk.last<RobotsRequest>()->reality);
    EXPECT_LT(*desk.last<RobotsRequest>()->reality, 1);
}

}  // namespace braitenlab::tests::reality_card_test

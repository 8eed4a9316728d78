// The card of a selected lamp, obstacle or zone.
#include <algorithm>

#include "core/maths/angle.h"
#include "scene_on_desk.h"
#include "ui/panels/panels.h"

namespace braitenlab::tests::scene_cards_test {

using namespace ui;
namespace {

using maths::vec2;

using SceneCards = SceneOnDesk;

TEST_F(SceneCards, EditAZone) {
    take(pond);
    desk.frame(2);
    desk.click("thing.surface.sand");
    EXPECT_EQ(commands<EditZone>().back().to.surface, Surface::sand);
    EXPECT_EQ(commands<EditZone>().back().to.length, 3);
    desk.click("thing.shape.2");
    EXPECT_TRUE(commands<EditZone>().back().to.round);
    const auto edits = commands<EditZone>().size();
    for (const char* slider : {"thing.length", "thing.width", "thing.heading", "thing.recharge", "thing.wind_x",
                               "thing.wind_y", "thing.slope", "thing.pull"})
        EXPECT_TRUE(desk.anchors.find(slider)) << slider;
    desk.click("thing.shape.3");
    EXPECT_EQ(scene_input().tool, SceneInputTool::polygon);
    for (const vec2 corner : {vec2{-1, 2}, vec2{2, 2}, vec2{2, 4}}) click(corner);
    desk.key({key::enter});
    ASSERT_EQ(commands<EditZone>().size(), edits + 1);
    EXPECT_EQ(commands<EditZone>().back().index, 0);
    EXPECT_EQ(commands<EditZone>().back().to.corners.size(), 3u);
    EXPECT_TRUE(commands<AddObstacle>().empty()) << "the outline is that of the zone";
}

TEST_F(SceneCards, ShowTheGoalOfAScene) {
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("scene.goal"));
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    scene->goal = {.role = Role::prey, .count = 3, .seconds = 2};
    desk.now.scene = scene;
    const auto says = [&](std::string_view words) {
        return std::any_of(desk.written.begin(), desk.written.end(),
                           [&](const Written& written) { return written.words.find(words) != std::string::npos; });
    };
    desk.frame(2);
    EXPECT_TRUE(desk.anchors.find("scene.goal"));
    EXPECT_TRUE(says(fill(desk.strings("scene.goal_prey"), {"3", "2"})));
    EXPECT_FALSE(says("longest time so far"));
    for (int second = 1; second <= 2; ++second) desk.now.tick += 60, desk.frame();
    desk.frame();
    EXPECT_TRUE(says("longest time so far 2 s"));
}

TEST_F(SceneCards, ChangeTheValuesOfALampWithOneGesturePerDrag) {
    take(lamp);
    desk.frame(2);
    desk.point("thing.strength", 0.5f);
    desk.frame(2);
    press();
    desk.point("thing.strength", 0.45f);
    desk.frame();
    desk.point("thing.strength", 0.4f);
    desk.frame();
    release();
    const auto edits = commands<EditSource>();
    ASSERT_GE(edits.size(), 2u);
    EXPECT_LT(edits.back().to.strength, edits.front().to.strength);
    EXPECT_EQ(desk.edits().front().gesture, desk.edits().back().gesture);
    EXPECT_EQ(edits.back().to.x, -3) << "other values are unchanged";
    desk.click("thing.channel.heat");
    EXPECT_EQ(commands<EditSource>().back().to.channel, Channel::heat);
    desk.click("thing.solid.2");
    EXPECT_TRUE(commands<EditSource>().back().to.solid);
}

TEST_F(SceneCards, EditAnObstacleAtItsPresentPosition) {
    desk.now.obstacles[0] = {4, 5, 0};  // pushed
    take(box);
    desk.frame(2);
    desk.click("thing.length", 0, 0.6f);
    const auto edits = commands<EditObstacle>();
    ASSERT_GE(edits.size(), 1u);
    EXPECT_NE(edits.back().to.length, 2);
    EXPECT_EQ(edits.back().to.x, 4);
    desk.click("thing.erase");
    ASSERT_EQ(desk.actions().size(), 1u);
    EXPECT_EQ(desk.actions()[0], Action::erase);
}

}  // namespace
}  // namespace braitenlab::tests::scene_cards_test

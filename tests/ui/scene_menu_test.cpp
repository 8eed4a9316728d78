// The menu that the right button opens in the scene.
#include "core/maths/angle.h"
#include "scene_on_desk.h"
#include "ui/panels/panels.h"

namespace braitenlab::tests::scene_menu_test {

using namespace ui;
namespace {

using maths::vec2;

using SceneMenu = SceneOnDesk;

TEST_F(SceneMenu, OffersAZoneItsOwnMenuAndWhatCanBeAddedOnIt) {
    click({6, -7}, 1);
    EXPECT_EQ(scene_input().menu.object, pond);
    desk.click("menu.add.light");
    EXPECT_NEAR(commands<AddSource>().back().object.x, 6, a_pixel);
    click({6, -7}, 1);
    desk.click("menu.erase");
    EXPECT_EQ(commands<RemoveZone>().size(), 1u);
    click({6, -7}, 1);
    desk.click("menu.duplicate");
    EXPECT_EQ(commands<AddZone>().back().object.surface, Surface::ice);
    click({0, 3}, 1);
    desk.click("menu.add.zone");
    EXPECT_NEAR(commands<AddZone>().back().object.y, 3, a_pixel);
}

TEST_F(SceneMenu, OpensTheMenuOfTheFloorInTheMiddleOfTheViewByAKey) {
    desk.key({'H'});
    desk.frame(2);
    ASSERT_TRUE(scene_input().menu.open);
    EXPECT_FALSE(scene_input().menu.object);
    EXPECT_LT(maths::length(scene_input().menu.place), 4);
    desk.key({key::down});  // past the first kind
    EXPECT_EQ(desk.panels.keyboard.focus, "menu.add.vehicle.1");
    desk.key({key::enter});
    desk.frame(2);
    EXPECT_EQ(commands<AddVehicle>().size(), 1u);
}

TEST_F(SceneMenu, IgnoresTheClickThatClosesAMenu) {
    click({0, 3}, 1);
    ASSERT_TRUE(scene_input().menu.open);
    desk.all.clear();
    click({-3, 6});  // a lamp
    EXPECT_FALSE(scene_input().menu.open);
    EXPECT_TRUE(desk.all.empty());
    desk.key({'E'});
    desk.frame(3);
    ASSERT_EQ(desk.panels.menu_bar.open, "view");
    click({-3, 6});
    EXPECT_EQ(desk.panels.menu_bar.open, "");
    EXPECT_TRUE(desk.all.empty());
    click({-3, 6});
    EXPECT_FALSE(desk.all.empty());
}

TEST_F(SceneMenu, AddsObjectsAtThePositionOfTheMenu) {
    click({1, 3}, 1);
    desk.click("menu.add.vehicle.1");
    const auto added = commands<AddVehicle>();
    ASSERT_EQ(added.size(), 1u);
    EXPECT_EQ(added[0].kind, 1);
    EXPECT_NEAR(added[0].at->x, 1, a_pixel);
    EXPECT_FALSE(scene_input().menu.open);
    click({1, 3}, 1);
    desk.click("menu.add.smell");
    EXPECT_EQ(commands<AddSource>().back().object.channel, Channel::smell);
    click({1, 3}, 1);
    desk.click("menu.add.polygon");
    EXPECT_EQ(scene_input().tool, SceneInputTool::polygon);
    EXPECT_EQ(scene_input().corners.size(), 1u);
}

TEST_F(SceneMenu, ExecutesTheMenuOfAVehicle) {
    click({-4.5f, 0}, 1);
    EXPECT_EQ(scene_input().menu.object, vehicle_object(1));
    desk.click("menu.drive");
    EXPECT_EQ(requests<SelectRequest>().back().vehicle, 1);
    EXPECT_EQ(desk.actions().back(), Action::drive);
    click({-4.5f, 0}, 1);
    desk.click("menu.duplicate");
    EXPECT_EQ(commands<AddVehicle>().back().kind, desk.now.vehicles[1].kind);
    click({-4.5f, 0}, 1);
    desk.click("menu.erase");
    EXPECT_EQ(commands<RemoveVehicle>().back().vehicle, 1);
    click({-4.5f, 0}, 1);
    desk.click("menu.brains");
    desk.frame(2);
    bool says_whose = false;
    for (const Written& w : desk.written) says_whose |= w.words.ends_with("2  ·  Another brain");
    EXPECT_TRUE(says_whose);
    desk.click("menu.brain.2a-coward");
    EXPECT_EQ(commands<SetBrain>().back().target, (Target{1, -1}));
}

TEST_F(SceneMenu, TriesABrainUnderThePointerOutForTheSelectedVehicle) {
    const auto point_at_brain = [&](VehicleId selected) {
        desk.view.settings.selection.vehicle = selected;
        click({-4.5f, 0}, 1);
        desk.click("menu.brains");
        desk.frame(2);
        desk.point("menu.brain.2a-coward");
        desk.frame(2);
    };
    point_at_brain(desk.now.vehicles[1].id);
    ASSERT_EQ(desk.panels.brain.what_if.size(), 1u);
    EXPECT_EQ(std::get<SetBrain>(desk.panels.brain.what_if.front()).target, (Target{1, -1}));
    EXPECT_TRUE(commands<SetBrain>().empty()) << "nothing is changed";
    desk.key({key::escape});
    desk.frame(3);
    EXPECT_TRUE(desk.panels.brain.what_if.empty());
    point_at_brain(desk.now.vehicles[0].id);
    EXPECT_TRUE(desk.panels.brain.what_if.empty()) << "the path of another vehicle is shown";
}

TEST_F(SceneMenu, CanBeUsedByKeysAlone) {
    desk.key({key::menu});
    desk.frame(3);
    ASSERT_TRUE(scene_input().menu.open);
    EXPECT_EQ(desk.panels.keyboard.focus, "menu.brains");
    desk.key({key::up});
    EXPECT_EQ(desk.panels.keyboard.focus, "menu.erase");
    desk.key({key::enter});
    desk.frame(2);
    EXPECT_EQ(commands<RemoveVehicle>().size(), 1u);
    EXPECT_FALSE(scene_input().menu.open);
    desk.key({key::menu});
    desk.frame(3);
    desk.key({key::escape});
    desk.frame(2);
    EXPECT_FALSE(scene_input().menu.open);
}

}  // namespace
}  // namespace braitenlab::tests::scene_menu_test

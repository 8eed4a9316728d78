#include <algorithm>
#include <memory>
#include <optional>

#include "desk.h"

namespace braitenlab::tests::view_menu_test {

using namespace ui;

struct ViewMenu : testing::Test {
    Desk desk;
    ViewMenu() {
        desk.now.sources.push_back({0, Channel::smell, 0, 0, 1});
        desk.frame(2);
    }
    std::optional<Overlays> wanted() const {
        std::optional<Overlays> last;
        for (const Request& request : desk.all)
            if (const auto* r = std::get_if<OverlaysRequest>(&request)) last = r->overlays;
        return last;
    }
};

TEST_F(ViewMenu, SwitchesOverlaysAndStaysOpen) {
    desk.click("button.view");
    desk.frame(2);
    for (const auto& [row, action] : {std::pair{"view.trails", Action::trails},
                                      {"view.surfaces", Action::surfaces},
                                      {"view.memory", Action::memory},
                                      {"view.labels", Action::labels},
                                      {"view.sensors", Action::sensors},
                                      {"view.outlines", Action::outlines}}) {
        desk.all.clear();
        desk.click(row);
        EXPECT_EQ(desk.actions(), std::vector{action}) << row;
        desk.frame(1);
    }
    EXPECT_TRUE(desk.anchors.find("card.view"));
}

TEST_F(ViewMenu, OffersTheFieldsOfTheChannelsInTheScene) {
    desk.click("button.view");
    desk.frame(2);
    EXPECT_TRUE(desk.anchors.find("view.smell"));
    EXPECT_FALSE(desk.anchors.find("view.heat"));
    desk.click("view.smell");
    ASSERT_TRUE(wanted());
    EXPECT_EQ(wanted()->field, Channel::smell);
    desk.view.settings.overlays.field = Channel::smell;
    desk.frame(1);
    desk.click("view.none");
    EXPECT_EQ(wanted()->field, std::nullopt);
}

TEST_F(ViewMenu, ConsumesTheClickThatClosesIt) {
    desk.click("button.view");
    desk.frame(2);
    ASSERT_TRUE(desk.anchors.find("card.view"));
    desk.click("button.play");
    EXPECT_FALSE(desk.anchors.find("card.view"));
    EXPECT_TRUE(desk.actions().empty());
    desk.click("button.play");
    EXPECT_EQ(desk.actions(), std::vector{Action::play_pause});
    desk.click("button.view");
    desk.frame(2);
    desk.click("button.view");
    EXPECT_FALSE(desk.anchors.find("card.view")) << "its button closes it too";
}

TEST(PresetsMenu, ConsumesTheClickThatClosesIt) {
    Desk desk;
    desk.frame(2);
    desk.click("button.presets");
    desk.frame(2);
    ASSERT_TRUE(desk.panels.presets_open);
    desk.click("button.play");
    EXPECT_FALSE(desk.panels.presets_open);
    EXPECT_TRUE(desk.actions().empty());
}

TEST_F(ViewMenu, OpensByOneClickWhileThePresetsAreOpenAndTheReverse) {
    desk.click("button.presets");
    ASSERT_TRUE(desk.panels.presets_open);
    desk.click("button.view");
    EXPECT_FALSE(desk.panels.presets_open);
    EXPECT_TRUE(desk.anchors.find("card.view"));
    desk.rest();
    desk.click("button.presets");
    EXPECT_TRUE(desk.panels.presets_open);
    EXPECT_FALSE(desk.anchors.find("card.view"));
    EXPECT_TRUE(desk.all.empty()) << "the clicks do nothing else";
}

TEST_F(ViewMenu, GivesWayToTheMenuOfTheSceneOnARightClick) {
    const CameraView camera_view =
        look(Camera{}, desk.now.scene->arena, nullptr, {0, 0, 1280, 800}, {300, 60, 600, 600});
    desk.view.camera_view = &camera_view;
    const auto right_click = [&] {
        desk.point(640, 640);
        desk.frame(2);
        desk.button(1, true);
        desk.frame(2);
        desk.button(1, false);
        desk.frame(3);
    };
    desk.click("button.view");
    ASSERT_TRUE(desk.anchors.find("card.view"));
    right_click();
    EXPECT_FALSE(desk.anchors.find("card.view"));
    EXPECT_TRUE(desk.panels.scene_input.menu.open);
    desk.rest();
    desk.click("button.presets");
    EXPECT_TRUE(desk.panels.presets_open);
    EXPECT_FALSE(desk.panels.scene_input.menu.open);
    right_click();
    EXPECT_FALSE(desk.panels.presets_open);
    EXPECT_TRUE(desk.panels.scene_input.menu.open);
    desk.rest();
    desk.click("button.view");
    EXPECT_FALSE(desk.panels.scene_input.menu.open);
    EXPECT_TRUE(desk.anchors.find("card.view"));
}

TEST_F(ViewMenu, CanBeUsedByKeysAlone) {
    desk.key({'E'});
    desk.frame(2);
    EXPECT_EQ(desk.panels.keyboard.focus, "view.sensors");
    desk.key({key::down});
    desk.frame(1);
    desk.key({key::down});
    desk.frame(1);
    EXPECT_EQ(desk.panels.keyboard.focus, "view.trails");
    desk.key({key::enter});
    desk.frame(2);
    EXPECT_EQ(desk.actions(), std::vector{Action::trails});
    desk.key({key::escape});
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("card.view"));
}

}  // namespace braitenlab::tests::view_menu_test

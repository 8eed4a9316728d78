#include "ui/panels/actions.h"

#include <set>
#include <tuple>

#include "desk.h"

namespace braitenlab::tests::actions_test {

using namespace ui;

TEST(Actions, HaveAPlaceOfTheirOwnInAMenu) {
    std::set<std::tuple<Menu, int, int>> taken;
    for (int i = 0; i <= static_cast<int>(last_action); ++i) {
        const auto [menu, section, row, stays_open] = traits(static_cast<Action>(i)).menu;
        if (menu == Menu::none) continue;
        EXPECT_TRUE(taken.insert({menu, section, row}).second) << name(static_cast<Action>(i));
    }
}

TEST(Actions, AreSwitchedOnAsTheirFlagIs) {
    Desk desk;
    desk.view.settings.overlays.labels = false;
    EXPECT_EQ(switched_on(desk.view, desk.panels, Action::labels), std::optional(false));
    desk.view.settings.overlays.labels = true;
    EXPECT_EQ(switched_on(desk.view, desk.panels, Action::labels), std::optional(true));
    EXPECT_EQ(switched_on(desk.view, desk.panels, Action::play_pause), std::nullopt);
}

}  // namespace braitenlab::tests::actions_test

#include "ui/widgets/finger_scroll.h"

#include "desk.h"

namespace braitenlab::tests::finger_scroll_test {

namespace {

struct OnGlass : Desk {
    OnGlass() : Desk(1024, 768, 1, true) {
        view.program.touch = true, view.program.finger = 44;
        frame(3);
        panels.menu_bar.open = "view";  // higher than the window
        frame(3);
    }

    // Moves a finger up from the middle of the menu.
    void swipe(float x, float y, float way) {
        point(x, y);
        frame(2);
        button(0, true);
        frame(2);
        for (int i = 1; i <= 8; ++i) point(x, y - way * static_cast<float>(i) / 8), frame();
        button(0, false);
        frame(2);
    }
};

}  // namespace

TEST(FingerScroll, MovesTheRowsOfAMenuAndChoosesNone) {
    OnGlass desk;
    const Rect rows = desk.where("menu.rows");
    const float before = desk.where("menu.view.next_field").y;
    desk.swipe(rows.x + rows.w / 2, rows.y + rows.h * 0.7f, 120);
    EXPECT_NEAR(desk.where("menu.view.next_field").y, before - 120, 15);
    EXPECT_EQ(desk.panels.menu_bar.open, "view");
    EXPECT_TRUE(desk.actions().empty());
}

TEST(FingerScroll, LeavesATapToTheRow) {
    OnGlass desk;
    const Rect rows = desk.where("menu.rows");
    desk.swipe(rows.x + rows.w / 2, rows.y + rows.h * 0.4f, 4);
    EXPECT_FALSE(desk.actions().empty());
}

TEST(FingerScroll, LeavesTheMouseAlone) {
    Desk desk(1024, 400, 1, true);
    desk.frame(3);
    desk.panels.menu_bar.open = "view";
    desk.frame(3);
    ASSERT_FALSE(desk.anchors.find("menu.view.smaller")) << "the rows can be scrolled";
    const Rect row = desk.where("menu.view.surfaces");
    desk.point("menu.view.surfaces");
    desk.frame(2);
    desk.button(0, true);
    desk.frame(2);
    for (int i = 1; i <= 8; ++i) desk.point(row.x + row.w / 2, row.y - 5 * static_cast<float>(i)), desk.frame();
    EXPECT_EQ(desk.where("menu.view.surfaces").y, row.y);
}

}  // namespace braitenlab::tests::finger_scroll_test

// What the table of sheets gives to each of them.
#include "ui/panels/sheets.h"

#include <set>
#include <string_view>

#include "desk.h"

namespace braitenlab::tests::sheets_test {

using namespace ui;

TEST(Sheets, ScrollTheirOwnBodyByPages) {
    for (const SheetTraits& row : sheets()) {
        Desk desk;
        desk.panels.sheet = row.sheet;
        desk.key({key::page_down});
        for (const SheetTraits& other : sheets())
            EXPECT_EQ(desk.panels.state_of(other.sheet).scroll, other.sheet == row.sheet ? 1 : 0)
                << other.anchor << " while " << row.anchor << " is open";
        desk.key({key::page_up});
        EXPECT_EQ(desk.panels.state_of(row.sheet).scroll, 0) << row.anchor;
    }
}

TEST(Sheets, CloseByEscape) {
    for (const SheetTraits& row : sheets()) {
        Desk desk;
        desk.panels.sheet = row.sheet;
        desk.key({key::escape});
        EXPECT_EQ(desk.panels.sheet, Sheet::none) << row.anchor;
    }
}

// A click at a place that a frame shows must find the same widget in the next one. A pixel is rounding.
TEST(Sheets, AreShownOnlyAtTheirFinalPlaceAlsoAfterAnotherContent) {
    for (const SheetTraits& row : sheets()) {
        Desk desk;
        desk.frame(4);  // the cards settle
        SheetState& sheet = desk.panels.state_of(row.sheet);
        sheet.content = 333;  // of an earlier use
        desk.panels.sheet = row.sheet;
        desk.frame(1);
        for (int i = 0; i < 5; ++i) {
            const bool is_shown = !desk.panels.is_unsettled;
            const Rect before = sheet.rect;
            desk.frame(1);
            if (!is_shown) continue;
            EXPECT_NEAR(sheet.rect.y, before.y, 1) << row.anchor;
            EXPECT_NEAR(sheet.rect.h, before.h, 1) << row.anchor;
        }
        EXPECT_FALSE(desk.panels.is_unsettled) << row.anchor;
    }
}

TEST(Sheets, HaveAnchorsOfTheirOwn) {
    std::set<std::string_view> anchors;
    for (const SheetTraits& row : sheets()) EXPECT_TRUE(anchors.insert(row.anchor).second) << row.anchor;
}

TEST(Sheets, LeaveTheFirstTermAboveInALowWindowByPageDown) {
    Desk desk(1024, 420);
    desk.panels.sheet = Sheet::glossary;
    desk.frame(3);
    ASSERT_TRUE(desk.anchors.find("glossary.sensor"));
    desk.key({key::page_down});
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("glossary.sensor"));
}

}  // namespace braitenlab::tests::sheets_test

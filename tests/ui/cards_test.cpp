#include "ui/panels/cards.h"

#include <set>

#include "desk.h"

namespace braitenlab::tests::cards_test {

using namespace ui;

TEST(Cards, HaveOneRowWithAUniqueAnchorPerCard) {
    std::set<std::string_view> anchors;
    for (const CardTraits& row : cards()) {
        EXPECT_EQ(&traits(row.card), &row);
        EXPECT_TRUE(anchors.insert(row.anchor).second) << row.anchor;
        EXPECT_EQ(row.column != Column::none, row.draw && row.shown) << row.anchor;
    }
    EXPECT_EQ(anchors.size(), card_count);
}

TEST(Cards, AreDrawnWithTheAnchorOfTheirRow) {
    std::set<std::string_view> drawn;
    const auto note = [&](const Desk& desk) {
        for (const CardTraits& row : cards())
            if (desk.anchors.find(row.anchor)) drawn.insert(row.anchor);
    };
    Desk desk(1280, 1400);
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    scene->sources.resize(1);
    desk.now.scene = scene;
    desk.now.sources.resize(1);
    desk.view.settings.selection.object = {SceneObjectKind::source, 0};
    desk.panels.charts_open = true;
    desk.view.settings.values = desk.view.settings.map = desk.view.settings.reality = true;
    const insight::Design design;
    desk.view.slots.slots[0].design = &design;
    desk.frame(3);
    note(desk);
    desk.open_exercise();
    desk.view.settings.selection.object = {};
    desk.frame(3);
    note(desk);
    desk.view.mode = Mode::wiring;
    desk.frame(3);
    note(desk);
    for (const CardTraits& row : cards()) EXPECT_TRUE(drawn.count(row.anchor)) << row.anchor;
}

TEST(Cards, AreInTheColumnOfTheirRowInTheOrderOfTheTable) {
    Desk desk(1280, 1400);
    desk.frame(3);
    for (const Column column : {Column::left, Column::right}) {
        const Rect area = column == Column::left ? desk.layout.left : desk.layout.right;
        float end = area.y;
        for (const CardTraits& row : cards()) {
            const Rect* card = row.column == column ? desk.anchors.find(row.anchor) : nullptr;
            if (!card) continue;
            EXPECT_FLOAT_EQ(card->x, area.x) << row.anchor;
            EXPECT_GE(card->y, end) << row.anchor;
            end = card->y + card->h;
        }
        EXPECT_GT(end, area.y);
        EXPECT_LE(end, area.y + area.h + 0.5f);
    }
}

TEST(Cards, AreOpenAtFirstOnlyForTheStoryAndTheBrain) {
    Desk desk(1920, 1200, 1, true);
    desk.frame(5);
    for (const CardTraits& row : cards()) {
        const Rect* card = desk.anchors.find(row.anchor);
        if (!card) continue;
        const bool opens = row.card == Card::scene || row.card == Card::brain;
        EXPECT_EQ(card->h > 60, opens) << row.anchor;
    }
}

TEST(Cards, FoldInALowColumnUntilTheUserOpensThem) {
    Desk desk(1280, 640, 1, true);
    desk.panels.card(Card::information).folded = false;  // as remembered from a higher window
    desk.frame(5);
    ASSERT_TRUE(traits(Card::information).folds_when_cramped);
    ASSERT_LT(desk.where("card.information").h, 60) << "there is no room for both cards";
    EXPECT_FALSE(desk.panels.card(Card::information).folded) << "only folded while it is drawn";
    desk.click("card.information.fold");
    desk.frame(3);
    EXPECT_TRUE(desk.panels.card(Card::information).opened_by_user);
    EXPECT_GT(desk.where("card.information").h, 100);
}

}  // namespace braitenlab::tests::cards_test

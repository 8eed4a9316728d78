#include <set>

#include "tests/ui/wiring_fixture.h"
#include "ui/wiring/menu.h"

namespace braitenlab::tests::wiring_menu_test {

using namespace ui;
using namespace wiring;

namespace {

using WiringMenu = CanvasFixture;

TEST_F(WiringMenu, OfTheEmptyCanvasHasAHeadingForItsNeurons) {
    right_click({470, 600});
    EXPECT_EQ(state.menu.heading, "wiring.add_neuron");
    EXPECT_EQ(state.menu.note, "wiring.add_how");
    const Rect first = row_rect(state.menu, 0), last = row_rect(state.menu, state.menu.rows.size() - 1);
    EXPECT_GE(first.y, state.menu.rect.y + heading_height(state.menu));
    EXPECT_GT(heading_height(state.menu), 40);
    EXPECT_LE(last.y + last.h, state.menu.rect.y + state.menu.rect.h);
    key(Action::cancel);
    right_click(middle("wire.LR"));
    EXPECT_EQ(state.menu.heading, "") << "the menu of a wire has no heading";
}

TEST_F(WiringMenu, IsWholeInTheWindowHoweverLowTheCanvasIs) {
    for (const float height : {120.0f, 200.0f, 290.0f}) {
        area = {20, 30, 500, height};
        frames(3);
        right_click({470, 30 + height - 10});
        ASSERT_TRUE(state.menu.open()) << height;
        EXPECT_GE(state.menu.rect.y, 0) << height;
        EXPECT_LE(state.menu.rect.y + state.menu.rect.h, 700) << height;
        EXPECT_EQ(state.menu.row_height, 28) << "rows of the usual height";
        // The last row is below the canvas: it is drawn there, and a click on it is not one beside the menu.
        const Rect last = row_rect(state.menu, state.menu.rows.size() - 1);
        EXPECT_GT(last.y, area.y + area.h) << height;
        ASSERT_TRUE(anchors.find("menu.fit"));
        state.camera.by_user = true;
        click({last.x + last.w / 2, last.y + last.h / 2});
        EXPECT_FALSE(state.menu.open());
        EXPECT_FALSE(state.camera.by_user) << "the row fits the brain";
    }
}

TEST_F(WiringMenu, HasLowerRowsInALowWindow) {
    ImGui::GetIO().DisplaySize = {1000, 320};
    area.h = 290;
    right_click({470, 200});
    EXPECT_GE(state.menu.rect.y, 0);
    EXPECT_LE(state.menu.rect.y + state.menu.rect.h, 320);
    EXPECT_GE(state.menu.row_height, 20);
    EXPECT_LT(state.menu.row_height, 28);
}

TEST_F(WiringMenu, OffersEveryKindOfNeuronAtTheEndOfADroppedWire) {
    std::set<std::string_view> offered;
    for (const MenuRow& row : drop_rows()) offered.insert(row.words);
    EXPECT_EQ(offered.size(), neuron_kinds.size());
    for (const NeuronKind& kind : neuron_kinds)
        EXPECT_EQ(offered.count("wiring.kind." + std::string(kind.word)), 1u) << kind.word;
}

}  // namespace
}  // namespace braitenlab::tests::wiring_menu_test

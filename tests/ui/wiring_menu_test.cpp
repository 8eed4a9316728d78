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

TEST_F(WiringMenu, HasLowerRowsInALowCanvasSoThatAllAreInside) {
    area.h = 290;
    right_click({470, 200});
    EXPECT_GE(state.menu.rect.y, area.y);
    EXPECT_LE(state.menu.rect.y + state.menu.rect.h, area.y + area.h);
    EXPECT_GE(state.menu.row_height, 20);
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

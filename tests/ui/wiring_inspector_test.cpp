// The card below the canvas: what it shows of a selection and what it asks for.
#include "tests/ui/desk.h"

namespace braitenlab::tests {
namespace {

constexpr NodeId SL = 0, SR = 1, ML = 2;

struct Inspector : testing::Test {
    Inspector() {
        desk.view.mode = Mode::wiring;
        desk.frame(4);
    }
    void select(Caught chosen) {
        desk.panels.canvas.selection = std::move(chosen);
        desk.frame(3);
    }
    BrainGraph asked() const { return std::get<SetBrain>(desk.edits().back().command).brain; }
    bool shows(std::string_view anchor) const { return desk.anchors.find(anchor) != nullptr; }

    Desk desk{1280, 800};
};

TEST_F(Inspector, ShowsNumbersOfWhatIsSelectedAlone) {
    EXPECT_TRUE(shows("card.inspector"));
    EXPECT_FALSE(shows("inspector.weight"));
    select({{}, {{SR, ML}}});
    EXPECT_TRUE(shows("inspector.weight") && shows("inspector.learning") && shows("inspector.decay"));
    EXPECT_FALSE(shows("inspector.bias"));
    EXPECT_FALSE(shows("inspector.peak")) << "a linear wire has none";
    select({{ML}, {}});
    EXPECT_TRUE(shows("inspector.bias") && shows("inspector.memory"));
    EXPECT_FALSE(shows("inspector.weight"));
    select({{ML, SL, SR}, {}});
    EXPECT_FALSE(shows("inspector.bias"));
    EXPECT_TRUE(shows("inspector.column"));
}

TEST_F(Inspector, TurnsTheSlidersOwnNumberForADirectWireAndAMotor) {
    select({{}, {{SR, ML}}});
    desk.click("inspector.weight", 1);  // a right click brings 0
    ASSERT_FALSE(desk.edits().empty());
    EXPECT_EQ(turned(desk.edits().back()).dial, Dial::LR);
    EXPECT_EQ(turned(desk.edits().back()).value, 0);
    select({{ML}, {}});
    desk.click("inspector.bias", 1);
    EXPECT_EQ(turned(desk.edits().back()).dial, Dial::LM);
}

TEST_F(Inspector, GivesANodeACurveThatWasChosen) {
    select({{ML}, {}});
    desk.click("inspector.kind.5");
    ASSERT_FALSE(desk.edits().empty());
    EXPECT_EQ(find_node(asked(), ML)->curve.response, Response::hump);
}

TEST_F(Inspector, CutsAWireAndSilencesANode) {
    select({{}, {{SR, ML}}});
    desk.click("inspector.lesion");
    ASSERT_EQ(desk.edits().size(), 1u);
    EXPECT_TRUE(find_wire(asked(), SR, ML)->cut);
    select({{SL}, {}});
    desk.click("inspector.lesion");
    EXPECT_TRUE(find_node(asked(), SL)->silenced);
}

TEST_F(Inspector, PutsNodesInOrder) {
    select({{ML, SL}, {}});
    desk.click("inspector.column");
    ASSERT_EQ(desk.edits().size(), 1u);
    const auto places = std::get<PlaceNodes>(desk.edits()[0].command).places;
    EXPECT_EQ(places[SL].at->x, places[ML].at->x);
    EXPECT_NE(places[SL].at->x, places[SR].at->x);
}

TEST_F(Inspector, LeavesItsRoomToTheCanvasWhenFolded) {
    const float before = desk.where("canvas").h;
    desk.click("card.inspector.fold");
    desk.frame(2);
    EXPECT_GT(desk.where("canvas").h, before + 60);
}

TEST_F(Inspector, TakesTheKeyboardWhenAskedForItsNumbers) {
    select({{}, {{SR, ML}}});
    desk.panels.canvas.focus = {Part::label, 0, {SR, ML}};
    desk.key({key::enter});
    desk.frame(2);
    ASSERT_TRUE(shows("menu.edit_numbers"));
    desk.key({key::enter});
    desk.frame(3);
    EXPECT_EQ(desk.panels.keyboard.focus, "inspector.weight");
    desk.key({key::right});
    desk.frame(2);
    EXPECT_EQ(turned(desk.edits().back()).dial, Dial::LR);
}

}  // namespace
}  // namespace braitenlab::tests

#include <algorithm>

#include "tests/ui/desk.h"
#include "ui/wiring/inspector.h"
#include "ui/wiring/node_text.h"

namespace braitenlab::tests::wiring_inspector_test {

using namespace ui;
using namespace wiring;

namespace {

using namespace four_neuron_ids;

struct WiringInspector : testing::Test {
    WiringInspector() {
        desk.view.mode = Mode::wiring;
        desk.frame(4);
    }
    void select(CanvasSelection chosen) {
        desk.panels.canvas.selection = std::move(chosen);
        desk.frame(3);
    }
    BrainGraph asked() const { return std::get<SetBrain>(desk.edits().back().command).brain; }
    bool shows(std::string_view anchor) const { return desk.anchors.find(anchor) != nullptr; }
    bool writes(std::string_view words) const {
        return std::any_of(desk.written.begin(), desk.written.end(),
                           [&](const Written& w) { return w.words == words; });
    }

    Desk desk{1280, 800};
};

TEST_F(WiringInspector, ShowsTheParametersOfASingleSelection) {
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

namespace {

// The wiring editor of an exercise in this language, with a selected wire.
void show_wire(Desk& desk, const std::string& language, float finger = 0) {
    desk.view.program.touch = finger > 0, desk.view.program.finger = finger;
    desk.strings = speaking(language);
    desk.open_exercise();
    desk.view.mode = Mode::wiring;
    desk.frame(4);
    desk.panels.canvas.selection = {{}, {{SR, ML}}};
    desk.frame(3);
}

}  // namespace

TEST(WiringInspectorWidth, GivesSlidersOneColumnWhereTwoWouldBeShort) {
    for (const std::string& language : shipped_codes())
        for (const float width : {1024.0f, 1280.0f, 2400.0f}) {
            Desk desk(width, 800, 1, true);
            show_wire(desk, language);
            const Rect weight = desk.where("inspector.weight"), threshold = desk.where("inspector.threshold");
            EXPECT_GT(weight.w, 220) << language << width << ": words, a track and a number";
            EXPECT_EQ(weight.y == threshold.y, width > 2000) << language << width;
        }
}

TEST(WiringInspectorWidth, AllNumbersOfAWireAreInSight) {
    for (const std::string& language : shipped_codes())
        for (const auto& [width, height] : {std::pair{1024.0f, 768.0f}, {1280.0f, 800.0f}, {2400.0f, 800.0f}}) {
            Desk desk(width, height, 1, true);
            show_wire(desk, language);
            for (const char* id :
                 {"inspector.weight", "inspector.threshold", "inspector.learning", "inspector.decay"}) {
                const Rect* slider = desk.anchors.find(id);
                ASSERT_TRUE(slider) << id << ", " << language << width;
                EXPECT_GE(slider->h, 28) << id << " is cut, " << language << width;
            }
        }
}

TEST(WiringInspectorWidth, AllNumbersOfAWireAreInSightForAFinger) {
    for (const std::string& language : shipped_codes())
        for (const auto& [width, height] : {std::pair{1024.0f, 768.0f}, {1280.0f, 800.0f}}) {
            Desk desk(width, height, 1, true);
            show_wire(desk, language, 44);
            for (const char* id : {"inspector.weight", "inspector.decay", "inspector.lesion"}) {
                const Rect* row = desk.anchors.find(id);
                EXPECT_GE(row ? row->h : 0, 44) << id << " is cut, " << language << width;
            }
        }
}

TEST_F(WiringInspector, SetsTheNumberOfTheSliderForADirectWireAndAMotor) {
    select({{}, {{SR, ML}}});
    desk.click("inspector.weight", 1);  // a right click sets 0
    ASSERT_FALSE(desk.edits().empty());
    EXPECT_EQ(turned(desk.edits().back()).dial, Dial::LR);
    EXPECT_EQ(turned(desk.edits().back()).value, 0);
    select({{ML}, {}});
    desk.click("inspector.bias", 1);
    EXPECT_EQ(turned(desk.edits().back()).dial, Dial::LM);
}

TEST_F(WiringInspector, SetsAChosenCurve) {
    select({{ML}, {}});
    desk.click("inspector.kind.5");
    ASSERT_FALSE(desk.edits().empty());
    EXPECT_EQ(find_node(asked(), ML)->curve.response, Response::hump);
}

TEST_F(WiringInspector, OffersEveryResponseInsideItsCard) {
    select({{ML}, {}});
    const Rect card = desk.where("card.inspector"), lesion = desk.where("inspector.lesion");
    EXPECT_LE(lesion.y + lesion.h, card.y + card.h);
    for (std::size_t i = 0; i < responses.size(); ++i) {
        const Rect button = desk.where("inspector.kind." + std::to_string(i + 1));
        EXPECT_TRUE(card.contains(button.x, button.y)) << responses[i].word;
        EXPECT_LE(button.y + button.h, lesion.y) << responses[i].word;
    }
}

TEST_F(WiringInspector, CutsAWireAndSilencesANode) {
    select({{}, {{SR, ML}}});
    desk.click("inspector.lesion");
    ASSERT_EQ(desk.edits().size(), 1u);
    EXPECT_TRUE(find_wire(asked(), SR, ML)->cut);
    select({{SL}, {}});
    desk.click("inspector.lesion");
    EXPECT_TRUE(find_node(asked(), SL)->silenced);
}

TEST_F(WiringInspector, ArrangesSeveralNodes) {
    select({{ML, SL}, {}});
    desk.click("inspector.column");
    ASSERT_EQ(desk.edits().size(), 1u);
    const auto places = std::get<PlaceNodes>(desk.edits()[0].command).places;
    EXPECT_EQ(places[SL].at->x, places[ML].at->x);
    EXPECT_NE(places[SL].at->x, places[SR].at->x);
}

TEST_F(WiringInspector, NamesThePeakAfterTheCurve) {
    const auto said = [&](Response response) {
        BrainGraph graph = *desk.now.brains[0];
        find_node(graph, "ML")->curve.response = response;
        desk.now.brains[0] = std::make_shared<BrainGraph>(graph);
        select({{ML}, {}});
        std::string found;
        for (const char* words : {"threshold", "middle", "peak"})
            if (writes(words)) found += words;
        return found;
    };
    EXPECT_EQ(said(Response::linear), "");
    EXPECT_EQ(said(Response::step), "threshold");
    EXPECT_EQ(said(Response::sigmoid), "middle");
    EXPECT_EQ(said(Response::hump), "peak");
    BrainGraph graph = *desk.now.brains[0];
    find_wire(graph, SR, ML)->curve.response = Response::step;
    desk.now.brains[0] = std::make_shared<BrainGraph>(graph);
    select({{}, {{SR, ML}}});
    EXPECT_TRUE(writes("threshold") && writes("step at")) << "a wire also has a threshold";
}

TEST_F(WiringInspector, UsesTheSingularForOne) {
    BrainGraph graph = *desk.now.brains[0];
    graph.nodes.push_back({.id = 4, .name = "N1"});
    desk.now.brains[0] = std::make_shared<BrainGraph>(graph);
    desk.now.neurons.push_back(0);
    desk.now.vehicles[0].neuron_count = 3;
    select({});
    EXPECT_TRUE(writes("2 sensors  ·  1 neuron  ·  2 motors  ·  2 wires"));
    select({{4, SL}, {{SR, ML}}});
    EXPECT_TRUE(writes("Selected: 2 nodes  ·  1 wire"));
}

TEST_F(WiringInspector, DescribesASensorBesideItsName) {
    Scene scene = *desk.now.scene;
    scene.kinds[0].sensors[0].name = "OL";
    scene.kinds[0].sensors[0].channel = Channel::smell;
    desk.now.scene = std::make_shared<Scene>(scene);
    BrainGraph graph = *desk.now.brains[0];
    graph.nodes[0].name = "OL";
    desk.now.brains[0] = std::make_shared<BrainGraph>(graph);
    select({{SL}, {}});
    const std::string as_in_the_diagram = short_name(scene.kinds[0].sensors, "OL");
    EXPECT_NE(as_in_the_diagram, "OL");
    EXPECT_TRUE(writes(as_in_the_diagram + "  ·  smells  ·  value 0.40"));
}

TEST_F(WiringInspector, IgnoresClicksOnAnOpenMenu) {
    const Rect canvas = desk.where("canvas");
    desk.point(canvas.x + 40, canvas.y + canvas.h - 60);
    for (const bool down : {true, false}) desk.button(1, down), desk.frame(2);
    ASSERT_TRUE(desk.panels.canvas.menu.open());
    EXPECT_TRUE(writes("Add a neuron"));
    desk.frame(2);
    desk.click("card.inspector.fold");
    EXPECT_FALSE(desk.panels.canvas.menu.open());
    EXPECT_FALSE(desk.panels.canvas.inspector.folded) << "the click only closed the menu";
    desk.click("card.inspector.fold");
    EXPECT_TRUE(desk.panels.canvas.inspector.folded);
}

TEST_F(WiringInspector, LeavesItsSpaceToTheCanvasWhenFolded) {
    const float before = desk.where("canvas").h;
    desk.click("card.inspector.fold");
    desk.frame(2);
    EXPECT_GT(desk.where("canvas").h, before + 60);
}

TEST_F(WiringInspector, TakesTheFocusForEditingItsNumbers) {
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
}  // namespace braitenlab::tests::wiring_inspector_test

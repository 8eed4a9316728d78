#include <cmath>

#include "tests/ui/wiring_fixture.h"
#include "ui/wiring/draw.h"

namespace braitenlab::tests::wiring_draw_test {

using namespace ui;
using namespace wiring;

namespace {

using WiringDraw = CanvasFixture;

int vertices() { return ImGui::GetDrawData()->TotalVtxCount; }

TEST_F(WiringDraw, KeepsTheStepOrThePeakInsideTheGlyph) {
    for (const ResponseTraits& row : responses)
        for (const float peak : {-2.0f, -0.5f, 0.0f, 0.8f, 1.5f, 2.0f}) {
            const float reach = glyph_reach({row.value, peak});
            EXPECT_GE(reach, 1);
            EXPECT_TRUE(!row.has_peak || std::fabs(peak) < 0.9f * reach) << row.word << peak;
        }
}

TEST_F(WiringDraw, OmitsInvisibleParts) {
    show(large_brain(200, 800));
    const int whole = vertices();
    state.camera.by_user = true;
    state.camera.zoom = 1;
    state.camera.middle = {1e5f, 1e5f};
    frames();
    EXPECT_LT(vertices(), whole / 20);
}

TEST_F(WiringDraw, DrawsFewerVerticesPerWireInALargeBrain) {
    show(large_brain(20, 40));
    const int few = vertices();
    show(large_brain(200, 800));
    EXPECT_LT(vertices(), few * 800 / 40 / 2);
}

TEST_F(WiringDraw, DescribesANodeUnderARestingPointerIfItsCardIsTooSmall) {
    state.camera.zoom = 0.5f;
    state.camera.by_user = true;
    frames();
    move(middle("node.SR"));
    EXPECT_EQ(anchors.find("says.SR"), nullptr) << "the pointer does not rest yet";
    frames(30);
    EXPECT_NE(anchors.find("says.SR"), nullptr);
    state.camera.zoom = 1;
    frames();
    move(middle("node.SR"));
    frames(30);
    EXPECT_EQ(anchors.find("says.SR"), nullptr) << "the card is large enough";
}

TEST_F(WiringDraw, LeavesThePinsFreeOfALongNameAndShowsItUnderARestingPointer) {
    constexpr const char* long_name = "remembers_the_bright_light";
    BrainGraph graph = make_graph({.LR = 1.5f, .RL = 1.5f});
    for (const auto& [id, name] : {std::pair{40, long_name}, std::pair{41, "N2"}}) {
        Node node;
        node.id = id, node.kind = NodeKind::neuron, node.name = name;
        graph.nodes.push_back(node);
    }
    show(graph);
    view.mode = Mode::paused;
    state.camera.by_user = true;
    for (const float zoom : {0.3f, 0.5f, 1.0f}) {
        SCOPED_TRACE(zoom);
        state.camera.zoom = zoom;
        frames(2);
        for (const std::string name : {long_name, "N2"}) {
            const Rect* shown = anchors.find("name." + name);
            ASSERT_NE(shown, nullptr) << name;
            if (name == "N2" && zoom < 0.4f) continue;  // a few letters may cover the pins of a small card
            EXPECT_GT(shown->x, middle("pin." + name + ".in").x) << name;
            EXPECT_LT(shown->x + shown->w, middle("pin." + name + ".out").x) << name;
        }
        for (const std::string name : {long_name, "N2"}) {
            move(middle("node." + name));
            frames(40);
            EXPECT_EQ(anchors.find("says." + name) != nullptr, name == long_name) << name;
        }
    }
}

TEST_F(WiringDraw, TheSumOfANodeNeverCoversItsCard) {
    for (const float height : {300.0f, 400.0f, 640.0f})
        for (const NodeId node : {ML, MR}) {
            area.h = height;
            ImGui::GetIO().DisplaySize.y = height + 60;  // fits the brain again
            state.camera.by_user = false;
            state.selection = {{node}, {}};
            frames(3);
            const Rect *card = anchors.find(node == ML ? "node.ML" : "node.MR"), *sum = anchors.find("canvas.sum");
            ASSERT_TRUE(card && sum) << height;
            const bool apart = sum->x >= card->x + card->w || sum->x + sum->w <= card->x ||
                               sum->y >= card->y + card->h || sum->y + sum->h <= card->y;
            EXPECT_TRUE(apart) << height;
        }
}

TEST_F(WiringDraw, TheSumOfANodeCoversNoOtherCardAndNoButton) {
    BrainGraph graph = make_graph({.LL = 1, .LR = 1.5f, .RL = 1.5f, .RR = 1});
    for (int i = 0; i < 6; ++i) {
        Node neuron;
        neuron.id = static_cast<NodeId>(40 + i), neuron.kind = NodeKind::neuron, neuron.name = "N" + std::to_string(i);
        graph.nodes.push_back(neuron);
        for (const WireEnds ends : {WireEnds{SL, neuron.id}, {SR, neuron.id}, {neuron.id, ML}, {neuron.id, MR}})
            graph.wires.push_back({.from = ends.from, .to = ends.to, .weight = 1});
    }
    show(graph);
    int shown = 0;
    for (const float height : {180.0f, 260.0f, 340.0f, 640.0f})
        for (const Node& node : graph.nodes) {
            area.h = height;
            ImGui::GetIO().DisplaySize.y = height + 60;  // fits the brain again
            state.camera.by_user = false;
            state.selection = {{node.id}, {}};
            frames(3);
            const Rect* sum = anchors.find("canvas.sum");
            if (!sum) continue;
            ++shown;
            for (const char* button : {"canvas.fit", "canvas.arrange"})
                EXPECT_FALSE(sum->overlaps(*anchors.find(button))) << height << ": " << node.name << " over " << button;
            const View shown_by = view_of(state.camera, area, 1);
            for (const WireShape& wire : state.layout.get(now.brains[0], {}).wires) {
                const vec2 low = shown_by.to_window(wire.label - wire.label_size / 2),
                           high = shown_by.to_window(wire.label + wire.label_size / 2);
                if (wire.label_size.x == 0) continue;
                EXPECT_FALSE(sum->overlaps({low.x, low.y, high.x - low.x, high.y - low.y}))
                    << height << ": " << node.name << " over a weight";
            }
            for (const Node& other : graph.nodes) {
                const Rect* card = anchors.find("node." + other.name);
                if (!card) continue;
                EXPECT_FALSE(sum->overlaps(*card)) << height << ": " << node.name << " over " << other.name;
            }
        }
    EXPECT_GT(shown, 12) << "of 32";
}

TEST_F(WiringDraw, DotsMoveOnlyWithTicks) {
    EXPECT_EQ(first_dot(100), first_dot(100));
    for (std::uint64_t tick = 0; tick < 100; ++tick) {
        const float moved = first_dot(tick + 1) - first_dot(tick);
        EXPECT_GT(std::fmod(moved + dot_gap, dot_gap), 1) << tick;
        EXPECT_LT(std::fmod(moved + dot_gap, dot_gap), dot_gap / 2) << "faster dots look as if they moved backwards";
    }
}

}  // namespace
TEST_F(WiringDraw, TheSumOfANodeCoversNoWireWhereThereIsRoom) {
    BrainGraph graph = make_graph({.LL = 1, .LR = 1.5f, .RL = 1.5f, .RR = 1});
    Node neuron;
    neuron.id = 40, neuron.kind = NodeKind::neuron, neuron.name = "N1";
    graph.nodes.push_back(neuron);
    for (const WireEnds ends : {WireEnds{SL, 40}, {SR, 40}, {40, ML}, {40, MR}})
        graph.wires.push_back({.from = ends.from, .to = ends.to, .weight = 1});
    show(graph);
    for (const NodeId node : {NodeId{40}, ML, MR}) {
        state.selection = {{node}, {}};
        frames(3);
        const Rect* sum = anchors.find("canvas.sum");
        ASSERT_TRUE(sum) << node;
        for (const Wire& wire : graph.wires)
            for (int i = 0; i <= 20; ++i) {
                const vec2 at = on_wire({wire.from, wire.to}, static_cast<float>(i) / 20);
                EXPECT_FALSE(sum->contains(at.x, at.y)) << node << ": " << wire.from << " to " << wire.to;
            }
    }
}

}  // namespace braitenlab::tests::wiring_draw_test

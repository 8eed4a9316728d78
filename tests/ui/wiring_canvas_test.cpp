#include <algorithm>

#include "tests/ui/wiring_fixture.h"
#include "ui/wiring/canvas.h"

namespace braitenlab::tests::wiring_canvas_test {

using namespace ui;
using namespace wiring;

namespace {

using WiringCanvas = CanvasFixture;

TEST_F(WiringCanvas, RecordsPinsAndLabelsInsideItsArea) {
    for (const char* id : {"pin.SL.out", "pin.SR.out", "pin.ML.in", "pin.MR.in", "wire.LL", "wire.LR", "wire.RL",
                           "wire.RR", "node.SL", "canvas.fit", "canvas.arrange"}) {
        const Rect* r = anchors.find(id);
        ASSERT_NE(r, nullptr) << id;
        EXPECT_TRUE(area.contains(r->x, r->y) && area.contains(r->x + r->w, r->y + r->h)) << id;
    }
    EXPECT_EQ(*anchors.find("canvas"), area);
    EXPECT_EQ(anchors.find("pin.SL.in"), nullptr);
}

TEST_F(WiringCanvas, KeepsItsViewWhileABrainIsEditedAndACardOpensBelow) {
    const vec2 eye = middle("node.SL"), motor = middle("node.MR");
    const auto expect_still = [&](const char* after) {
        EXPECT_LT(maths::distance(middle("node.SL"), eye), 0.1f) << after;
        EXPECT_LT(maths::distance(middle("node.MR"), motor), 0.1f) << after;
    };
    right_click({470, 600});
    choose("step");
    expect_still("adding");
    drag(middle("pin.SL.out"), middle("pin.N1.in"));
    expect_still("joining");
    area.h -= 200;  // a card opens below, over the lower half
    frames(2);
    EXPECT_LT(maths::distance(middle("node.SL"), eye), 0.1f);
    EXPECT_EQ(anchors.find("node.MR"), nullptr);
    click(middle("wire.RL"));
    key(Action::erase);
    EXPECT_LT(maths::distance(middle("node.SL"), eye), 0.1f) << "an edit while nodes are covered";
    area.h += 200;
    frames(2);
    expect_still("a card that folds");
    now.brains[0] = std::make_shared<BrainGraph>(make_graph({.LR = 1.5f, .RL = 1.5f}));
    frames(2);
    EXPECT_LT(maths::distance(middle("node.SL"), eye), 0.1f) << "an undo";
}

TEST_F(WiringCanvas, FitsANewBrainUnlessTheUserHasMovedTheCamera) {
    const auto give = [&](int nodes) {
        const VehicleId id = view.settings.selection.vehicle;
        now = snapshot_with(large_brain(nodes, 90));
        now.vehicles[0].id = id;
        frames(2);
        return std::all_of(brain().nodes.begin(), brain().nodes.end(),
                           [&](const Node& node) { return anchors.find("node." + node.name) != nullptr; });
    };
    EXPECT_TRUE(give(40));
    state.camera.by_user = true;
    EXPECT_FALSE(give(200));
    now.vehicles[0].kind = 0;
    ++view.run_id;  // another scene
    frames(2);
    EXPECT_FALSE(state.camera.by_user);
    EXPECT_NE(anchors.find("node.MR"), nullptr);
}

TEST_F(WiringCanvas, FitsABrainOfHundredsOfNodes) {
    for (const int nodes : {302, 1000}) {
        SCOPED_TRACE(nodes);
        ++view.run_id;
        show(large_brain(nodes, 4 * nodes));
        const auto inside = [&](const Node& node) {
            const Rect* at = anchors.find("node." + node.name);
            return at && at->x >= area.x && at->x + at->w <= area.x + area.w && at->y >= area.y &&
                   at->y + at->h <= area.y + area.h;
        };
        EXPECT_TRUE(std::all_of(brain().nodes.begin(), brain().nodes.end(), inside));
    }
}

TEST_F(WiringCanvas, FitsAgainWhenTheWindowChangesItsSize) {
    area.w = 700;
    ImGui::GetIO().DisplaySize = {800, 700};
    frames(2);
    const Rect motor = *anchors.find("node.MR"), eye = *anchors.find("node.SL");
    EXPECT_LE(motor.x + motor.w, area.x + area.w);
    EXPECT_GE(eye.x, area.x);
}

TEST_F(WiringCanvas, CancelsADragWhenTheCanvasIsHidden) {
    move(middle("pin.SL.out"));
    button(true);
    move(middle("pin.ML.in"));
    ImGui::NewFrame();
    ImGui::Render();
    frames(2);
    button(false);
    EXPECT_TRUE(edits.empty());
}

TEST_F(WiringCanvas, DrawsWithoutAVehicleAndABrainWithoutNodes) {
    view.settings.selection.vehicle = no_vehicle;
    frames(2);
    view.settings.selection.vehicle = 7;
    now.brains[0] = std::make_shared<BrainGraph>();
    frames(2);
    click({400, 300});
    EXPECT_TRUE(edits.empty());
}

TEST(WiringReadings, EqualThoseOfTheSnapshot) {
    BrainGraph graph = large_brain(30, 100);
    std::reverse(graph.nodes.begin(), graph.nodes.end());
    graph.wires[5].learning_rate = graph.wires[50].learning_rate = graph.wires[7].learning_rate = 1;
    graph.wires[20].cut = true;
    graph.wires[21].threshold = 0.3f;
    Snapshot now = snapshot_with(graph);
    now.neurons.insert(now.neurons.end(), {0.11f, 0.22f, 0.33f});
    const VehicleView& vehicle = now.vehicles[0];
    const Layout layout = lay_out(graph, {});
    Readings readings;
    update(readings, now, vehicle, graph, layout);
    ASSERT_EQ(readings.nodes.size(), layout.nodes.size());
    for (std::size_t i = 0; i < layout.nodes.size(); ++i)
        EXPECT_EQ(readings.nodes[i], node_value(now, vehicle, layout.nodes[i].id));
    ASSERT_EQ(readings.carried.size(), layout.wires.size());
    for (std::size_t i = 0; i < layout.wires.size(); ++i) {
        const auto [from, to] = layout.wires[i].ends;
        EXPECT_EQ(readings.learned[i], learned(now, vehicle, from, to));
        const Wire* wire = find_wire(graph, from, to);
        const float expected = wire ? signal(*wire, node_value(now, vehicle, from), readings.learned[i]) : 0;
        EXPECT_EQ(readings.carried[i], expected) << from << " " << to;
    }
}

}  // namespace
}  // namespace braitenlab::tests::wiring_canvas_test

// What the canvas draws of a brain, and how much.
#include "tests/ui/large_brain.h"
#include "tests/ui/wiring_hand.h"
#include "ui/wiring/draw.h"

namespace braitenlab::tests::wiring_picture_test {
namespace {

struct WiringPicture : WiringCanvas {
    void show(const BrainGraph& graph) {
        const VehicleId id = view.selected;
        now = moment_with(graph);
        now.vehicles[0].id = id;
        frames(3);
    }
    int corners() const { return ImGui::GetDrawData()->TotalVtxCount; }
};

TEST_F(WiringPicture, LeavesOutWhatIsOutOfSight) {
    show(large_brain(200, 800));
    const int whole = corners();
    state.own_view = true;
    state.zoom = 1;
    state.middle = {1e5f, 1e5f};
    frames();
    EXPECT_LT(corners(), whole / 20);
}

TEST_F(WiringPicture, DrawsLessOfEachWireWhenManyAreSeenFromAfar) {
    show(large_brain(20, 40));
    const int few = corners();
    show(large_brain(200, 800));
    EXPECT_LT(corners(), few * 800 / 40 / 2);
}

TEST(SignalDots, MoveWithEveryTickAndStandBetweenTicks) {
    EXPECT_EQ(first_dot(100), first_dot(100));
    for (std::uint64_t tick = 0; tick < 100; ++tick) {
        const float moved = first_dot(tick + 1) - first_dot(tick);
        EXPECT_GT(std::fmod(moved + dot_gap, dot_gap), 1) << tick;
        EXPECT_LT(std::fmod(moved + dot_gap, dot_gap), dot_gap / 2) << "or they seem to run backwards";
    }
}

TEST(CanvasMoment, SaysTheSameAsTheSnapshot) {
    BrainGraph graph = large_brain(30, 100);
    std::reverse(graph.nodes.begin(), graph.nodes.end());
    graph.wires[5].learning_rate = graph.wires[50].learning_rate = graph.wires[7].learning_rate = 1;
    graph.wires[20].cut = true;
    graph.wires[21].threshold = 0.3f;
    Snapshot now = moment_with(graph);
    now.neurons.insert(now.neurons.end(), {0.11f, 0.22f, 0.33f});
    const VehicleView& vehicle = now.vehicles[0];
    const Layout layout = lay_out(graph, {});
    CanvasMoment moment;
    read(moment, now, vehicle, graph, layout);
    ASSERT_EQ(moment.nodes.size(), layout.nodes.size());
    for (std::size_t i = 0; i < layout.nodes.size(); ++i)
        EXPECT_EQ(moment.nodes[i], node_value(now, vehicle, layout.nodes[i].id));
    ASSERT_EQ(moment.carried.size(), layout.wires.size());
    for (std::size_t i = 0; i < layout.wires.size(); ++i) {
        const auto [from, to] = layout.wires[i].ends;
        EXPECT_EQ(moment.learned[i], learned(now, vehicle, from, to));
        const Wire* wire = find_wire(graph, from, to);
        const float expected = wire ? signal(*wire, node_value(now, vehicle, from), moment.learned[i]) : 0;
        EXPECT_EQ(moment.carried[i], expected) << from << " " << to;
    }
}

}  // namespace
}  // namespace braitenlab::tests::wiring_picture_test

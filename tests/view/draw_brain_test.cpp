// The brain on the deck and the arrows beside the wheels, in the draw list.
#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "render/view/draw_list.h"
#include "tests/view/drawn.h"
#include "tests/view/hand_made.h"

namespace braitenlab::tests::draw_brain_test {
namespace {

using namespace render;

// One vehicle: left eye → neuron 5 → right motor, inhibiting.
Snapshot with_neuron(float seen, float neuron) {
    auto scene = hand_made::scene();
    BrainGraph brain = hand_made::wired(0, 0, 0, 0);
    brain.wires.clear();
    Node node;
    node.id = 5, node.name = "N";
    brain.nodes.push_back(node);
    for (const auto& [from, to, weight] : {std::tuple{1, 5, 1.0f}, {5, 4, -0.5f}}) {
        Wire wire;
        wire.from = from, wire.to = to, wire.weight = weight;
        brain.wires.push_back(wire);
    }
    scene->kinds[0].brain = brain;
    Snapshot now = hand_made::empty(scene);
    hand_made::add(now, 0, 0, 0, 0, seen, 0);
    now.neurons = {neuron, 0, 0};  // hidden, left motor, right motor
    now.vehicles[0].neuron_count = 3;
    return now;
}

TEST(DrawVehicles, MarkEachDriverByASignOfItsOwn) {
    std::set<std::vector<float>> signs;
    for (const auto& driver : driver_table) {
        Snapshot now = with_neuron(0, 0);
        now.vehicles[0].driver = driver.value;
        std::vector<float> shape;
        for (const WireInstance& stroke : drawn(now).wires) {
            if (driver.value != Driver::brain) {
                EXPECT_GE(stroke.colour.w, 0) << "no wire";
                EXPECT_LT(std::hypot(stroke.ends.x, stroke.ends.y), 0.5f) << "on the deck";
            }
            shape.insert(shape.end(), {stroke.ends.x, stroke.ends.y, stroke.ends.z, stroke.ends.w});
        }
        EXPECT_FALSE(shape.empty()) << driver.word;
        EXPECT_EQ(drawn(now).neurons.size(), 1u) << "the neuron of the brain, else the disc of the sign";
        EXPECT_TRUE(signs.insert(shape).second) << driver.word;
    }
}

TEST(DrawVehicles, TintTheBodyInTheColourOfItsKind) {
    Snapshot now = with_neuron(0, 0);
    auto scene = std::make_shared<Scene>(*now.scene);
    scene->kinds[0].colour = "#0000ff";
    now.scene = scene;
    const auto hull = [&] {
        const DrawList list = drawn(now);
        for (const auto& bodies : list.bodies)
            if (!bodies.empty()) return bodies[0].colour;
        return maths::vec4{};
    };
    EXPECT_GT(hull().z, 0.9f);
    EXPECT_LT(hull().x, 0.1f);
    auto own = std::make_shared<Scene>(*scene);
    own->starts = {{.name = "red", .kind = own->kinds[0].name, .colour = "#ff0000"}};
    now.scene = own;
    now.vehicles[0].start = 0;
    EXPECT_GT(hull().x, 0.9f) << "a colour of its own takes precedence";
}

TEST(DrawBrain, DrawsWiresThroughNeuronsWithTheirSignals) {
    const DrawList list = drawn(with_neuron(0.6f, 0.8f));
    const auto wires = wires_of(list);
    ASSERT_EQ(wires.size(), 2U);
    ASSERT_EQ(list.neurons.size(), 1U);
    EXPECT_NEAR(wires[0].signal.x, 0.6f, 1e-5);
    EXPECT_NEAR(wires[1].signal.x, 0.4f, 1e-5);
    EXPECT_EQ(wires[0].colour.w, 1);
    EXPECT_EQ(wires[1].colour.w, -1);
    EXPECT_NEAR(list.neurons[0].colour.w, 0.8f, 1e-5);
    EXPECT_NEAR(wires[1].ends.x, list.neurons[0].place.x, 1e-4);  // begins at the neuron
    EXPECT_NEAR(wires[1].ends.y, list.neurons[0].place.y, 1e-4);
    EXPECT_LT(wires[1].ends.w, 0);  // and ends on the right
}

TEST(DrawBrain, ColoursANeuronByItsSign) {
    const Palette p = palette(Theme::dark);
    EXPECT_EQ(drawn(with_neuron(0, 0.5f)).neurons[0].colour.x, p.excites.r);
    EXPECT_EQ(drawn(with_neuron(0, -0.5f)).neurons[0].colour.x, p.inhibits.r);
}

TEST(DrawBrain, ShowsACutWireWithAGapAndWithoutASignal) {
    Snapshot now = with_neuron(0.6f, 0.8f);
    auto brain = std::make_shared<BrainGraph>(*now.brains[0]);
    brain->wires[1].cut = true;
    now.brains[0] = brain;
    const auto wires = wires_of(drawn(now));
    EXPECT_EQ(wires[0].signal.y, 0);
    EXPECT_EQ(wires[1].signal.y, 1);
    EXPECT_EQ(wires[1].signal.x, 0);
}

TEST(DrawBrain, FollowsAnEditOfTheBrain) {
    Snapshot now = with_neuron(0.6f, 0.8f);
    DrawList list;
    fill(list, now, {}, Trails{});
    auto brain = std::make_shared<BrainGraph>(*now.brains[0]);
    brain->wires.pop_back();
    now.brains[0] = brain;
    fill(list, now, {}, Trails{});
    EXPECT_EQ(wires_of(list).size(), 1U);
}

TEST(DrawBrain, ShowsNoWiresOfAManuallyDrivenVehicle) {
    Snapshot now = with_neuron(0.6f, 0.8f);
    now.vehicles[0].driver = Driver::manual;
    for (const WireInstance& stroke : drawn(now).wires) EXPECT_EQ(stroke.colour.w, 0) << "strokes of the sign only";
}

std::vector<MarkInstance> arrows(const DrawList& list) {
    std::vector<MarkInstance> found;
    for (const MarkInstance& mark : list.rings)
        if (mark.shape.w == static_cast<float>(MarkKind::arrow)) found.push_back(mark);
    return found;
}

TEST(DrawBrain, PointsAnArrowPerWheelAsLongAsItsSpeedForTheSelectedVehicle) {
    Snapshot now = hand_made::empty(hand_made::scene());
    const VehicleId chosen = hand_made::add(now, 0, 0, 0, 0);
    now.vehicles[0].motor = {0.8f, -0.4f};
    EXPECT_TRUE(arrows(drawn(now)).empty());
    Picture picture;
    picture.settings.selection.vehicle = chosen;
    const auto found = arrows(drawn(now, picture));
    ASSERT_EQ(found.size(), 2U);
    const MarkInstance left = found[0].place.y > 0 ? found[0] : found[1];
    const MarkInstance right = found[0].place.y > 0 ? found[1] : found[0];
    EXPECT_GT(left.place.z, 0.9f);    // ahead
    EXPECT_LT(right.place.z, -0.9f);  // backwards
    EXPECT_NEAR(left.shape.x, 2 * right.shape.x, 1e-5);
    now.vehicles[0].motor = {0.04f, 0.04f};
    for (const MarkInstance& arrow : arrows(drawn(now, picture)))
        EXPECT_LE(arrow.shape.y, arrow.shape.x) << "no needle";
    now.vehicles[0].motor = {0, 0};
    EXPECT_TRUE(arrows(drawn(now, picture)).empty());
}

}  // namespace
}  // namespace braitenlab::tests::draw_brain_test

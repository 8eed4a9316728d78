// Commands that edit brains of a running world.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/scene/scene_file.h"
#include "core/world/world.h"
#include "tests/core/scenes.h"

namespace braitenlab::tests::brain_commands_test {
namespace {

// A vehicle in front of a lamp with a Hebbian wire from its left eye to its left motor.
Scene learner() {
    Scene scene = tests::alone({.LM = 0.3f});
    scene.sources.push_back({.name = "lamp", .x = 2, .y = 0.5f});
    find_wire(scene.kinds[0].brain, 0, 2)->learning_rate = 2;
    return scene;
}

Snapshot captured(const World& world) {
    Snapshot now;
    world.capture(now);
    return now;
}

float learned_by_it(const World& world) {
    const Snapshot now = captured(world);
    return learned(now, now.vehicles.front(), 0, 2);
}

World run(const Scene& scene, int ticks) {
    auto world = World::create(scene, 1);
    EXPECT_TRUE(world) << world.error().text();
    for (int t = 0; t < ticks; ++t) world->step();
    return std::move(*world);
}

TEST(Snapshot, ShowsAgreeingValuesOfNeuronsInARowAfterAnEdit) {
    Scene scene = tests::alone({});
    BrainGraph brain = scene.kinds[0].brain;
    const Curve step{.response = Response::step, .peak = 0.5f};
    brain.nodes.push_back({.id = 20, .kind = NodeKind::neuron, .name = "N", .curve = step});
    brain.nodes.push_back({.id = 21, .kind = NodeKind::neuron, .name = "NOT", .curve = step, .bias = 1});
    brain.wires.push_back({.from = 20, .to = 21, .weight = -1});
    World world = run(scene, 10);
    ASSERT_FALSE(world.apply(SetBrain{{.kind = 0}, brain}));
    const auto value = [&](NodeId id) {
        const Snapshot now = captured(world);
        return node_value(now, now.vehicles.front(), id);
    };
    EXPECT_EQ(value(20), 0);
    EXPECT_EQ(value(21), 1);
    find_node(brain, "N")->bias = 1;
    ASSERT_FALSE(world.apply(SetBrain{{.kind = 0}, brain}));
    EXPECT_EQ(value(20), 1);
    EXPECT_EQ(value(21), 0) << "not a tick behind";
}

TEST(Snapshot, ShowsTheLearnedPartOfAWire) {
    Scene dark = learner();
    dark.sources.clear();
    EXPECT_EQ(learned_by_it(run(dark, 60)), 0);
    EXPECT_GT(learned_by_it(run(learner(), 60)), 0.1f);
}

TEST(Command, SetBrainKeepsTheLearnedPartThroughALesionAndADial) {
    World world = run(learner(), 15);
    const float before = learned_by_it(world);
    BrainGraph hurt = learner().kinds[0].brain;
    find_wire(hurt, 0, 2)->cut = true;
    ASSERT_FALSE(world.apply(SetBrain{{0}, hurt}));
    world.step();
    EXPECT_EQ(learned_by_it(world), before);
    ASSERT_FALSE(world.apply(SetBrain{{0}, learner().kinds[0].brain}));
    ASSERT_FALSE(world.apply(TurnDial{{0}, Dial::RM, 0.2f}));
    world.step();
    EXPECT_GT(learned_by_it(world), before);
}

TEST(Command, SetBrainDropsTheLearnedPartWhenOtherWiresLearn) {
    World world = run(learner(), 60);
    BrainGraph other = learner().kinds[0].brain;
    find_wire(other, 1, 2)->learning_rate = 1;
    ASSERT_FALSE(world.apply(SetBrain{{0}, other}));
    EXPECT_EQ(learned_by_it(world), 0);
}

TEST(World, RestoreKeepsTheLearnedPart) {
    World world = run(learner(), 90);
    World again = World::restore(world.checkpoint());
    for (int t = 0; t < 400; ++t) world.step(), again.step();
    EXPECT_EQ(world.hash(), again.hash());
    EXPECT_EQ(learned_by_it(world), learned_by_it(again));
}

TEST(Snapshot, ShowsZeroForSilencedSensorsAndMotors) {
    Scene scene = learner();
    for (Node& node : scene.kinds[0].brain.nodes) node.silenced = node.name != "SR";
    const World world = run(scene, 30);
    const Snapshot now = captured(world);
    const VehicleView& it = now.vehicles.front();
    EXPECT_EQ(node_value(now, it, 0), 0);
    EXPECT_GT(now.sensed[0], 0.1f);  // the sensor itself still reads the lamp
    EXPECT_EQ(it.motor, (std::array{0.0f, 0.0f}));
    EXPECT_EQ(it.x, 0);
}

// Every edit that changes what a brain computes changes the hash.
TEST(World, TheHashChangesWithEveryEditThatChangesWhatABrainComputes) {
    const std::uint64_t plain = run(tests::alone({.LL = 1, .LM = 0.2f}), 0).hash();
    const auto edited = [](auto edit) {
        Scene scene = tests::alone({.LL = 1, .LM = 0.2f});
        edit(scene.kinds[0].brain);
        return run(scene, 0).hash();
    };
    EXPECT_EQ(edited([](BrainGraph&) {}), plain);
    EXPECT_NE(edited([](BrainGraph& g) { g.nodes[2].silenced = true; }), plain);
    EXPECT_NE(edited([](BrainGraph& g) { g.nodes[2].curve.response = Response::step; }), plain);
    EXPECT_NE(edited([](BrainGraph& g) { g.nodes[2].time_constant = 1; }), plain);
    EXPECT_NE(edited([](BrainGraph& g) { g.wires[0].cut = true; }), plain);
    EXPECT_NE(edited([](BrainGraph& g) { g.wires[0].curve.peak = 0.1f; }), plain);
    EXPECT_NE(edited([](BrainGraph& g) { g.wires[0].curve.width = 0.1f; }), plain);
    EXPECT_NE(edited([](BrainGraph& g) { g.wires[0].decay = 1; }), plain);
    EXPECT_EQ(edited([](BrainGraph& g) {
                  g.nodes[0].place = {7, 7};
              }),
              plain)
        << "positions on the canvas do not change the run";
}

TEST(Command, RefusesEveryNumberThatIsNotFinite) {
    World world = run(learner(), 10);
    const std::uint64_t before = world.hash();
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        EXPECT_TRUE(world.apply(TurnDial{{0}, Dial::LL, bad}));
        EXPECT_TRUE(world.apply(Steer{0, bad, 0}));
        EXPECT_TRUE(world.apply(MoveVehicle{0, 0, 0, bad}));
        EXPECT_TRUE(world.apply(MoveSource{0, bad, 0}));
        EXPECT_TRUE(world.apply(EditSource{0, {.name = "lamp", .strength = bad}}));
        EXPECT_TRUE(world.apply(AddVehicle{.energy = bad}));
        EXPECT_TRUE(world.apply(AddVehicle{.at = Pose{bad, 0, 0}}));
        for (float Wire::*number : {&Wire::weight, &Wire::threshold, &Wire::learning_rate, &Wire::decay}) {
            BrainGraph brain = make_graph({});
            brain.wires[0].*number = bad;
            EXPECT_TRUE(world.apply(SetBrain{{0}, brain}));
            EXPECT_TRUE(world.apply(SetBrain{{.kind = 0}, brain}));
            EXPECT_TRUE(world.apply(AddVehicle{.brain = brain}));
        }
        Sensor eye = learner().kinds[0].sensors[0];
        eye.range = bad;
        EXPECT_TRUE(world.apply(SetSensors{{.kind = 0}, {eye}}));
    }
    EXPECT_EQ(world.hash(), before);
}

TEST(SceneFile, RefusesNumbersOfABrainThatAreNotFiniteOrOutOfRange) {
    const auto refusal = [](const std::string& line) {
        const auto scene = parse_scene("format = 1\n[kind.k.brain]\nLL = 1\n[[kind.k.brain.node]]\nname = \"N\"\n" +
                                           std::string("[[kind.k.brain.wire]]\nfrom = \"SL\"\nto = \"N\"\n") + line,
                                       "test.toml");
        return scene ? "" : scene.error().text();
    };
    EXPECT_EQ(refusal("weight = 2\n"), "");
    for (const char* key : {"weight", "threshold", "peak", "width", "learning_rate", "decay"})
        for (const char* bad : {"nan", "inf", "-inf", "1e300", "-3.0"})
            EXPECT_NE(refusal(key + std::string(" = ") + bad + "\n").find("test.toml:9: "), std::string::npos)
                << key << " = " << bad << ": " << refusal(key + std::string(" = ") + bad + "\n");
}

}  // namespace
}  // namespace braitenlab::tests::brain_commands_test

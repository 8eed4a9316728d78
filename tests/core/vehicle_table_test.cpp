#include "core/io/vehicle_table.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <set>

#include <gtest/gtest.h>

#include "core/world/world.h"
#include "scenes.h"

namespace braitenlab::tests::vehicle_table_test {
namespace {

using io::ColumnGroup;

const std::set<ColumnGroup> all_groups{ColumnGroup::sensors, ColumnGroup::neurons, ColumnGroup::learned,
                                       ColumnGroup::distances};

// A vehicle of kind `tester` in front of a lamp: its left eye drives the neuron N, and the wire from N to ML learns.
// A vehicle of kind `plain` has neither.
Scene learner() {
    Scene scene = alone({.LM = 0.3f, .RM = 0.3f});
    Kind plain = scene.kinds[0];
    plain.name = "plain";
    plain.sensors.clear();
    scene.kinds.push_back(plain);
    scene.starts.push_back({.name = "other", .kind = "plain", .y = 5});
    BrainGraph& brain = scene.kinds[0].brain;
    brain.nodes.push_back({.id = 10, .kind = NodeKind::neuron, .name = "N"});
    brain.wires.push_back({.from = find_node(brain, "SL")->id, .to = 10, .weight = 1});
    brain.wires.push_back({.from = 10, .to = find_node(brain, "ML")->id, .weight = 0.1f, .learning_rate = 2});
    scene.sources.push_back({.name = "lamp", .x = 3, .y = 4});
    return scene;
}

Snapshot after(const Scene& scene, int ticks) {
    auto world = World::create(scene, 1);
    if (!world) throw std::runtime_error(world.error().text());
    for (int i = 0; i < ticks; ++i) world->step();
    Snapshot now;
    world->capture(now);
    return now;
}

double number(const Snapshot& now, std::size_t vehicle, const std::string& name) {
    for (const io::VehicleColumn& column : io::vehicle_columns(now, all_groups))
        if (column.name == name) return std::get<double>(column.value({now, now.vehicles[vehicle]}));
    throw std::runtime_error("no column " + name);
}

std::string header(const Snapshot& now, const std::set<ColumnGroup>& groups) {
    return io::csv_header(io::vehicle_columns(now, groups));
}

const std::string basic = "seconds,id,kind,role,x_m,y_m,heading_rad,speed_m_s,energy,left,right";

TEST(VehicleTable, ListsTheNeuronsAndLearnedWeightsOfAVehicle) {
    const Snapshot now = after(learner(), 60);
    const auto neurons = io::neuron_values(now, now.vehicles[0]);
    ASSERT_EQ(neurons.size(), 1u);
    EXPECT_EQ(neurons[0].name, "N");
    EXPECT_EQ(neurons[0].value, number(now, 0, "neuron_N"));
    EXPECT_GT(neurons[0].value, 0);
    const auto wires = io::learned_values(now, now.vehicles[0]);
    ASSERT_EQ(wires.size(), 1u);
    EXPECT_EQ(wires[0].name, "N>ML");
    EXPECT_EQ(wires[0].value, number(now, 0, "learned_N>ML"));
    EXPECT_GT(wires[0].value, 0);
}

TEST(VehicleTable, ListsEachLearnedWeightWithItsWire) {
    Scene scene = learner();
    BrainGraph& brain = scene.kinds[0].brain;
    float rate = 0;
    for (Wire& wire : brain.wires) wire.weight = 0.2f, wire.learning_rate = rate += 0.25f;
    std::reverse(brain.wires.begin(), brain.wires.end());  // not the order of the values in the snapshot
    const Snapshot now = after(scene, 60);
    const auto wires = io::learned_values(now, now.vehicles[0]);
    ASSERT_EQ(wires.size(), brain.wires.size());
    std::set<double> different;
    for (const io::BrainValue& wire : wires) different.insert(wire.value);
    EXPECT_GE(different.size(), 3u);
    for (const io::BrainValue& wire : wires) EXPECT_EQ(wire.value, number(now, 0, "learned_" + wire.name)) << wire.name;
}

TEST(VehicleTable, HasOnlyTheBasicColumnsUnlessMoreAreAskedFor) {
    EXPECT_EQ(header(after(learner(), 0), {}), basic + "\n");
}

TEST(VehicleTable, AddsOneColumnPerNameInTheOrderOfTheGroups) {
    const Snapshot now = after(learner(), 0);
    EXPECT_EQ(header(now, {ColumnGroup::distances, ColumnGroup::sensors}),
              basic + ",sensor_SL,sensor_SR,distance_lamp_m\n");
    EXPECT_EQ(header(now, {ColumnGroup::learned, ColumnGroup::neurons}), basic + ",neuron_N,learned_N>ML\n");
    EXPECT_EQ(header(after(crowd(4), 0), {ColumnGroup::sensors}), basic + ",sensor_SL,sensor_SR\n")
        << "two kinds have these sensors";
}

TEST(VehicleTable, HasTheValuesOfTheSnapshot) {
    const Snapshot now = after(learner(), 30);
    const VehicleView& v = now.vehicles[0];
    EXPECT_EQ(number(now, 0, "seconds"), 0.5);
    EXPECT_EQ(number(now, 0, "x_m"), v.x);
    EXPECT_EQ(number(now, 0, "speed_m_s"), v.speed);
    EXPECT_EQ(number(now, 0, "right"), v.motor[1]);
    EXPECT_GT(number(now, 0, "sensor_SL"), 0.1);
    EXPECT_EQ(number(now, 0, "sensor_SL"), now.sensed[static_cast<std::size_t>(v.first_sensed)]);
    EXPECT_EQ(number(now, 0, "sensor_SR"), now.sensed[static_cast<std::size_t>(v.first_sensed) + 1]);
    EXPECT_GT(number(now, 0, "neuron_N"), 0.1);
    EXPECT_EQ(number(now, 0, "neuron_N"), node_value(now, v, 10));
    EXPECT_GT(number(now, 0, "learned_N>ML"), 0.001);
    EXPECT_EQ(number(now, 0, "learned_N>ML"), learned(now, v, 10, find_node(*brain_of(now, v), "ML")->id));
}

TEST(VehicleTable, HasNoValueForAVehicleWithoutTheSensorNeuronOrWire) {
    const Snapshot now = after(learner(), 0);
    for (const char* name : {"sensor_SL", "neuron_N", "learned_N>ML"}) {
        EXPECT_TRUE(std::isnan(number(now, 1, name))) << name;
        EXPECT_FALSE(std::isnan(number(now, 0, name))) << name;
    }
}

TEST(VehicleTable, AWireThatDoesNotLearnHasNoLearnedPart) {
    Scene scene = learner();
    scene.kinds[1].brain = scene.kinds[0].brain;
    for (Wire& wire : scene.kinds[1].brain.wires) wire.learning_rate = 0;
    const Snapshot now = after(scene, 0);
    EXPECT_TRUE(std::isnan(number(now, 1, "learned_N>ML")));
    EXPECT_FALSE(std::isnan(number(now, 1, "neuron_N")));
}

TEST(VehicleTable, ASilencedSensorNodeReadsZero) {
    Scene scene = learner();
    find_node(scene.kinds[0].brain, "SL")->silenced = true;
    const Snapshot now = after(scene, 1);
    EXPECT_GT(now.sensed[static_cast<std::size_t>(now.vehicles[0].first_sensed)], 0.1f);
    EXPECT_EQ(number(now, 0, "sensor_SL"), 0);
}

TEST(VehicleTable, MeasuresADistanceAcrossTheSeamOfATorusOnly) {
    EXPECT_NEAR(number(after(learner(), 0), 0, "distance_lamp_m"), 5, 1e-4);
    Scene scene = alone({}, -99);
    scene.sources.push_back({.name = "lamp", .x = 99});
    EXPECT_NEAR(number(after(scene, 0), 0, "distance_lamp_m"), 198, 1e-3);
    scene.arena.edge = Boundary::torus;
    EXPECT_NEAR(number(after(scene, 0), 0, "distance_lamp_m"), 2, 1e-3);
}

TEST(VehicleTable, EveryColumnAndGroupIsOnTheCommandLinePage) {
    std::ifstream file(std::string(BRAITENLAB_SOURCE) + "/docs/command-line.md");
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    for (const io::VehicleColumn& column : io::vehicle_columns())
        EXPECT_NE(page.find("`" + column.name + "`"), std::string::npos) << column.name;
    for (const auto& group : io::column_group_table)
        EXPECT_NE(page.find("| `" + std::string(group.word) + "` |"), std::string::npos) << group.word;
}

}  // namespace
}  // namespace braitenlab::tests::vehicle_table_test

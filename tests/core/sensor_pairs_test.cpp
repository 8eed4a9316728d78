#include "core/scene/sensor_pairs.h"

#include <gtest/gtest.h>

namespace braitenlab::tests::sensor_pairs_test {
namespace {

Sensor sensor(const char* name, Channel channel, float y, float angle) {
    Sensor made;
    made.name = name, made.channel = channel, made.y = y, made.angle = angle;
    return made;
}

TEST(SensorPairs, AreTheMirroredSensorsOfOneChannelInTheirOrder) {
    Kind kind;
    kind.sensors = {sensor("R", Channel::heat, -0.2f, -0.5f), sensor("E", Channel::energy, 0, 0),
                    sensor("SL", Channel::light, 0.2f, 0.5f), sensor("L", Channel::heat, 0.2f, 0.5f),
                    sensor("SR", Channel::light, -0.2f, -0.5f)};
    const auto pairs = sensor_pairs(kind);
    ASSERT_EQ(pairs.size(), 2u);
    EXPECT_EQ(pairs[0], (KindPair{"heat", Channel::heat, {"L", "R"}})) << "left is the sensor with the larger y";
    EXPECT_EQ(pairs[1], (KindPair{"light", Channel::light, {"SL", "SR"}}));
}

TEST(SensorPairs, ExcludeSensorsThatAreNoMirrorImages) {
    Kind kind;
    kind.sensors = {sensor("A", Channel::light, 0.2f, 0.5f), sensor("B", Channel::light, -0.2f, -0.4f),
                    sensor("C", Channel::light, 0, 0), sensor("D", Channel::light, 0, 0)};
    EXPECT_TRUE(sensor_pairs(kind).empty()) << "other angle; on the axis";
    kind.sensors[1].angle = -0.5f, kind.sensors[1].range = 3;
    EXPECT_TRUE(sensor_pairs(kind).empty()) << "other range";
}

TEST(SensorPairs, NumberFurtherPairsOfOneChannel) {
    Kind kind;
    for (const float angle : {0.3f, 0.9f}) {
        kind.sensors.push_back(sensor(angle < 0.5f ? "A" : "C", Channel::light, 0.2f, angle));
        kind.sensors.push_back(sensor(angle < 0.5f ? "B" : "D", Channel::light, -0.2f, -angle));
    }
    const auto pairs = sensor_pairs(kind);
    ASSERT_EQ(pairs.size(), 2u);
    EXPECT_EQ(pairs[0].name, "light");
    EXPECT_EQ(pairs[1].name, "light 2");
    EXPECT_EQ(pairs[1].sensors, (SensorPair{"C", "D"}));
}

TEST(ChosenPair, IsTheNamedOneElseTheEyesElseTheFirst) {
    Kind kind;
    kind.sensors = {sensor("HL", Channel::heat, 0.2f, 0.5f), sensor("HR", Channel::heat, -0.2f, -0.5f)};
    EXPECT_EQ(chosen_pair(kind, ""), (SensorPair{"HL", "HR"}));
    kind.sensors.push_back(sensor("SL", Channel::light, 0.2f, 0.5f));
    kind.sensors.push_back(sensor("SR", Channel::light, -0.2f, -0.5f));
    EXPECT_EQ(chosen_pair(kind, ""), SensorPair{});
    EXPECT_EQ(chosen_pair(kind, "heat"), (SensorPair{"HL", "HR"}));
    EXPECT_EQ(chosen_pair(Kind{}, "heat"), SensorPair{});
}

}  // namespace
}  // namespace braitenlab::tests::sensor_pairs_test

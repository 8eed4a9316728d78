// What a sensor reads: the source or the vehicle that adds most to its reading.
#include "core/insight/origin.h"

#include <gtest/gtest.h>

#include "tests/core/runs.h"
#include "tests/core/scenes.h"

namespace braitenlab::tests::origin_test {
namespace {

using insight::main_origin;
using insight::Origin;

// The origin of the first vehicle's sensor at the start.
std::optional<Origin> at_start(const Scene& scene, const std::string& sensor) {
    World world = make(scene);
    Snapshot now;
    world.capture(now);
    const VehicleView& vehicle = now.vehicles.front();
    for (const Sensor& s : kind_of(now, vehicle).sensors)
        if (s.name == sensor) return main_origin(now, vehicle, s);
    ADD_FAILURE() << sensor;
    return std::nullopt;
}

TEST(Origin, IsTheSourceThatAddsMoreThanHalfOfTheReading) {
    Scene scene = alone({.LL = 1});
    scene.sources = {{.name = "far", .x = 6, .y = 3}, {.name = "near", .x = 2, .y = 1.5f}};
    EXPECT_EQ(at_start(scene, "SL"), (Origin{.source = 1}));
    scene.sources[0] = {.name = "same", .x = 2, .y = 1.5f};
    EXPECT_EQ(at_start(scene, "SL"), std::nullopt) << "two lamps at one place add half each";
}

TEST(Origin, IsNoneWhereTheSensorReadsNothing) {
    Scene scene = alone({.LL = 1});
    scene.sources = {{.name = "behind", .x = -4, .y = 0}};
    EXPECT_EQ(at_start(scene, "SL"), std::nullopt);
    scene.sources = {{.name = "heat", .channel = Channel::heat, .x = 3, .y = 1}};
    EXPECT_EQ(at_start(scene, "SL"), std::nullopt) << "an eye does not sense heat";
}

TEST(Origin, IsNoSourceThatAnObstacleHides) {
    Scene scene = alone({.LL = 1});
    scene.sources = {{.name = "hidden", .x = 4, .y = 1}, {.name = "in_sight", .x = 5, .y = 5}};
    ASSERT_EQ(at_start(scene, "SL"), (Origin{.source = 0}));
    scene.obstacles = {{.name = "wall", .x = 2.5f, .y = 0.6f, .length = 0.2f, .width = 1.4f}};
    EXPECT_EQ(at_start(scene, "SL"), (Origin{.source = 1}));
}

TEST(Origin, OfAPredatorsEyeIsThePreyAhead) {
    const Scene scene = shipped_scene("predator-prey");
    World world = make(scene);
    Snapshot now;
    world.capture(now);
    int found = 0;
    for (const VehicleView& vehicle : now.vehicles)
        for (const Sensor& sensor : kind_of(now, vehicle).sensors) {
            const auto origin = main_origin(now, vehicle, sensor);
            if (!origin) continue;
            ++found;
            const VehicleView* other = find_vehicle(now, origin->vehicle);
            ASSERT_TRUE(other);
            EXPECT_NE(other->id, vehicle.id);
            EXPECT_EQ(other->role, sensor.channel == Channel::prey ? Role::prey : Role::predator);
        }
    EXPECT_GT(found, 0);
}

}  // namespace
}  // namespace braitenlab::tests::origin_test

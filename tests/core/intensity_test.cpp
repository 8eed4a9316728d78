#include "core/sensing/intensity.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "core/world/world.h"
#include "tests/view/hand_made.h"

namespace braitenlab::tests::intensity_test {
namespace {

// The value of the nearest sample to a position.
float at(const sensing::IntensityMap& map, const Arena& arena, float x, float y) {
    const sensing::Intensity& grid = map.grid();
    const auto index = [](float across, int count) {
        return static_cast<std::size_t>(std::lround((across + 0.5f) * static_cast<float>(count - 1)));
    };
    return grid.values[index(y / arena.height, grid.rows) * static_cast<std::size_t>(grid.columns) +
                       index(x / arena.width, grid.columns)];
}

float felt(const Snapshot& now, Channel channel, float x, float y, VehicleId asking = no_vehicle) {
    sensing::IntensityMap map;
    map.update(intensity_input(now, channel, asking));
    return at(map, now.scene->arena, x, y);
}

TEST(Intensity, EqualsTheReadingOfAnEyeThatFacesTheSource) {
    auto scene = hand_made::scene();
    scene->sources.push_back({.name = "lamp", .x = 3, .y = 1, .strength = 0.9f});
    Sensor eye = scene->kinds[0].sensors[0];
    eye.x = eye.y = eye.angle = 0, eye.half_distance = 2, eye.range = 10;
    scene->kinds[0].sensors = {eye};
    scene->kinds[0].name = "plain";
    for (const auto& [x, y] : {std::pair{-2.0f, 1.0f}, {3.0f, -4.0f}, {1.0f, 1.0f}}) {
        scene->starts = {{.name = "one", .kind = "plain", .x = x, .y = y, .facing = "lamp"}};
        auto world = World::create(*scene, 1);
        ASSERT_TRUE(world) << world.error().text();
        Snapshot now;
        world->capture(now);
        ASSERT_EQ(now.sensed.size(), 1U);
        EXPECT_NEAR(felt(now, Channel::light, x, y, now.vehicles[0].id), now.sensed[0], 0.03f) << x;
    }
}

TEST(Intensity, AddsUpAndSaturates) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add_source(now, Channel::heat, -1, 0, 0.8f);
    const float one = felt(now, Channel::heat, 0, 0);
    hand_made::add_source(now, Channel::heat, 1, 0, 0.8f);
    EXPECT_NEAR(felt(now, Channel::heat, 0, 0), std::min(1.0f, 2 * one), 1e-4);
    for (int i = 0; i < 5; ++i) hand_made::add_source(now, Channel::heat, 0, 0);
    EXPECT_EQ(felt(now, Channel::heat, 0, 0), 1);
    EXPECT_EQ(felt(now, Channel::smell, 0, 0), 0);
}

TEST(Intensity, IsDarkBehindAnObstacleForLightButNotForSmell) {
    auto scene = hand_made::scene();
    scene->obstacles.push_back({.name = "screen", .x = 0, .length = 0.4f, .width = 4});
    Snapshot now = hand_made::empty(scene);
    hand_made::add_source(now, Channel::light, -3, 0);
    hand_made::add_source(now, Channel::smell, -3, 0);
    EXPECT_EQ(felt(now, Channel::light, 3, 0), 0);
    EXPECT_GT(felt(now, Channel::light, 3, 8), 0);  // beside its shadow
    EXPECT_GT(felt(now, Channel::smell, 3, 0), 0);
    now.obstacles = {{0, 8, 0}};  // pushed away
    EXPECT_GT(felt(now, Channel::light, 3, 0), 0);
}

TEST(Intensity, ExcludesTheSensingVehicle) {
    Snapshot now = hand_made::empty(hand_made::scene());
    const VehicleId self = hand_made::add(now, 2, 0, 0, 0), other = hand_made::add(now, 2, 4, 0, 0);
    EXPECT_LT(felt(now, Channel::prey, 0, 0, self), 0.5f);
    EXPECT_GT(felt(now, Channel::prey, 0, 0, other), 0.9f);
    EXPECT_EQ(felt(now, Channel::predator, 0, 0), 0);
}

TEST(Intensity, OfMemoryUsesOnlyTheMarksOfTheSensingVehicle) {
    Snapshot now = hand_made::empty(hand_made::scene());
    now.marks = {{7, 2, 2, 0.6f}};
    EXPECT_GT(felt(now, Channel::memory, 2, 2, 7), 0.5f);
    EXPECT_EQ(felt(now, Channel::memory, 2, 2, 8), 0);
}

TEST(Intensity, OfObstaclesIncreasesTowardsWallsAndBoxes) {
    auto scene = hand_made::scene();
    scene->obstacles.push_back({.name = "box", .x = 4, .length = 1, .width = 1});
    const Snapshot now = hand_made::empty(scene);
    EXPECT_GT(felt(now, Channel::obstacle, 9.8f, 0), felt(now, Channel::obstacle, 7, 0));
    EXPECT_GT(felt(now, Channel::obstacle, 3.4f, 0), 0.9f);
}

TEST(Intensity, OfTheFloorIsItsReflectance) {
    auto scene = hand_made::scene();
    scene->zones.push_back({.name = "line", .length = 4, .width = 4, .surface = Surface::tape});
    const Snapshot now = hand_made::empty(scene);
    EXPECT_LT(felt(now, Channel::floor, 0, 0), 0.1f);
    EXPECT_NEAR(felt(now, Channel::floor, 5, 5), scene->arena.reflectance, 1e-5);
}

TEST(Intensity, ContinuesAcrossTheSeamOfATorus) {
    auto scene = hand_made::scene();
    Snapshot walled = hand_made::empty(scene);
    hand_made::add_source(walled, Channel::heat, 9.5f, 0);
    auto round = std::make_shared<Scene>(*scene);
    round->arena.edge = Boundary::torus;
    Snapshot torus = walled;
    torus.scene = round;
    EXPECT_GT(felt(torus, Channel::heat, -9, 0), 0.5f);
    EXPECT_LT(felt(walled, Channel::heat, -9, 0), 0.1f);
}

TEST(Intensity, IsComputedAgainOnlyAfterAChange) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add_source(now, Channel::light, 0, 0);
    sensing::IntensityMap map;
    EXPECT_TRUE(map.update(intensity_input(now, Channel::light, no_vehicle)));
    ++now.tick;
    EXPECT_FALSE(map.update(intensity_input(now, Channel::light, no_vehicle)));
    now.sources[0].x = 1;
    EXPECT_TRUE(map.update(intensity_input(now, Channel::light, no_vehicle)));
    EXPECT_TRUE(map.update(intensity_input(now, Channel::heat, no_vehicle)));
}

TEST(Intensity, HasACoarserGridForManyStimuli) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add_source(now, Channel::light, 0, 0);
    sensing::IntensityMap map;
    map.update(intensity_input(now, Channel::light, no_vehicle));
    EXPECT_EQ(map.grid().columns, sensing::Intensity::most_columns);
    for (int i = 0; i < 500; ++i) hand_made::add(now, 1, static_cast<float>(i % 20) - 10, 0, 0);
    map.update(intensity_input(now, Channel::predator, no_vehicle));
    EXPECT_LE(map.grid().columns * map.grid().rows * 500, 400000);
}

TEST(Intensity, IsOfferedForTheChannelsInTheScene) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add_source(now, Channel::smell, 0, 0);
    const auto offered = channels_with_intensity(now);
    const auto has = [&](Channel c) { return std::find(offered.begin(), offered.end(), c) != offered.end(); };
    EXPECT_TRUE(has(Channel::smell) && has(Channel::light) && has(Channel::prey) && has(Channel::predator));
    EXPECT_FALSE(has(Channel::heat) || has(Channel::red) || has(Channel::touch) || has(Channel::energy));
}

}  // namespace
}  // namespace braitenlab::tests::intensity_test

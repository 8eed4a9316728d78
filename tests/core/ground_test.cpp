#include "core/sensing/ground.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/maths/angle.h"
#include "core/maths/random.h"

namespace braitenlab::tests::ground_test {
namespace {

using namespace sensing;
// Computed directly from the zone, without cells.
bool covers(const Zone& zone, maths::vec2 place) {
    const maths::vec2 ahead = maths::direction(zone.heading);
    const maths::vec2 p = maths::rotate(place - maths::vec2{zone.x, zone.y}, {ahead.x, -ahead.y});
    for (std::size_t i = 0; i < zone.corners.size(); ++i) {
        const PolygonCorner &a = zone.corners[i], &b = zone.corners[(i + 1) % zone.corners.size()];
        if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) < 0) return false;
    }
    if (!zone.corners.empty()) return true;
    const float along = p.x / (zone.length / 2), across = p.y / (zone.width / 2);
    if (zone.round) return along * along + across * across <= 1;
    return std::fabs(along) <= 1 && std::fabs(across) <= 1;
}

using maths::vec2;

TEST(Ground, IsThePlainFloorOutsideZones) {
    Scene scene;
    scene.arena.friction = 17;
    const Ground ground(scene);
    EXPECT_EQ(ground.floor_at({1, 2}).friction, 17);
    EXPECT_EQ(ground.push_at({1, 2}, 10), vec2{});
    EXPECT_EQ(ground.recharge_at({1, 2}), 0);
    EXPECT_FALSE(ground.has_surfaces || ground.pushes || ground.recharges);
}

TEST(Ground, UsesTheLastSurfaceOfOverlappingZonesAndAddsTheOtherEffects) {
    Scene scene;
    scene.zones = {{.name = "a", .length = 4, .width = 4, .surface = Surface::ice, .recharge = 0.5f, .wind_x = 1},
                   {.name = "b", .length = 2, .width = 2, .surface = Surface::sand, .wind_x = 2, .wind_y = 3},
                   {.name = "c", .length = 1, .width = 1, .recharge = 0.25f}};
    const Ground ground(scene);
    EXPECT_EQ(ground.floor_at({0, 0}).friction, floor_constants(scene.arena, Surface::sand).friction);
    EXPECT_EQ(ground.floor_at({1.5f, 0}).friction, floor_constants(scene.arena, Surface::ice).friction);
    EXPECT_EQ(ground.floor_at({3, 0}).friction, scene.arena.friction);
    EXPECT_EQ(ground.push_at({0, 0}, 10), (vec2{3, 3}));
    EXPECT_EQ(ground.recharge_at({0, 0}), 0.75f);
}

TEST(Ground, UsesTheCornersOfAPolygonInsteadOfItsLengthAndWidth) {
    Scene scene;
    scene.zones = {{.name = "a",
                    .x = 2,
                    .heading = maths::pi / 2,
                    .length = 0.1f,
                    .width = 0.1f,
                    .round = true,
                    .recharge = 1,
                    .corners = {{-1, -1}, {3, -1}, {-1, 1}}}};
    const Ground ground(scene);
    EXPECT_EQ(ground.recharge_at({2.9f, 2}), 1) << "2 m along its heading, 0.9 m to the right of it";
    EXPECT_EQ(ground.recharge_at({1.1f, 2}), 0) << "beyond the longest edge";
    EXPECT_EQ(ground.recharge_at({2, -1.1f}), 0);
}

TEST(Ground, FindsTheSameZonesAsASearchOfAllZones) {
    maths::Random chance{3, 1};
    Scene scene;
    scene.arena.width = 37, scene.arena.height = 9;
    for (int i = 0; i < 60; ++i) {
        Zone zone{.x = chance.uniform(-25, 25), .y = chance.uniform(-8, 8), .heading = chance.uniform(-3, 3)};
        zone.length = chance.uniform(0.02f, 12);
        zone.width = chance.uniform(0.02f, 6);
        zone.round = chance.next() % 2 == 0;
        const std::size_t corners = i % 3 == 0 ? 3 + chance.next() % 6 : 0;
        for (std::size_t c = 0; c < corners; ++c) {
            const vec2 at = maths::from_polar(4, 2 * maths::pi * static_cast<float>(c) / static_cast<float>(corners));
            zone.corners.push_back({at.x + 1, at.y});
        }
        zone.recharge = 1;
        scene.zones.push_back(zone);
    }
    const Ground ground(scene);
    float most = 0;
    for (int i = 0; i < 20000; ++i) {
        const vec2 place{chance.uniform(-30, 30), chance.uniform(-10, 10)};
        float wanted = 0;
        for (const Zone& zone : scene.zones) wanted += covers(zone, place) ? 1.0f : 0.0f;
        ASSERT_EQ(ground.recharge_at(place), wanted) << place;
        most = std::max(most, wanted);
    }
    EXPECT_GT(most, 5);
}

TEST(Ground, ContinuesAZoneAtTheOppositeEdgeOfATorus) {
    Scene scene;
    scene.arena.width = scene.arena.height = 20;
    scene.zones = {{.name = "corner", .x = 9, .y = 9.5f, .length = 4, .width = 4, .recharge = 1},
                   {.name = "inside", .x = 5, .length = 2, .width = 2, .recharge = 1}};
    EXPECT_EQ(Ground(scene).recharge_at({-9.5f, 9}), 0);
    scene.arena.edge = Boundary::torus;
    const Ground ground(scene);
    EXPECT_EQ(ground.recharge_at({9, 9}), 1);
    EXPECT_EQ(ground.recharge_at({-9.5f, 9}), 1);
    EXPECT_EQ(ground.recharge_at({9, -9.5f}), 1);
    EXPECT_EQ(ground.recharge_at({-9.5f, -9.5f}), 1);
    EXPECT_EQ(ground.recharge_at({-8.5f, 9}), 0);
    EXPECT_EQ(ground.recharge_at({5, 0}), 1);
    EXPECT_EQ(ground.recharge_at({-5, 0}), 0);
}

}  // namespace
}  // namespace braitenlab::tests::ground_test

#include "core/scene/scene.h"

#include <gtest/gtest.h>

#include "core/maths/angle.h"

namespace braitenlab {
namespace {

TEST(Zone, CoversWhatLiesInItsTurnedBoxOrEllipse) {
    Zone zone{.x = 3, .y = 1, .heading = maths::radians(90), .length = 4, .width = 2};
    EXPECT_TRUE(covers(zone, {3, 1}));
    EXPECT_TRUE(covers(zone, {3.9f, 2.9f}));  // near a corner: its length runs along y
    EXPECT_FALSE(covers(zone, {4.9f, 1}));
    EXPECT_FALSE(covers(zone, {3, 3.1f}));
    zone.round = true;
    EXPECT_FALSE(covers(zone, {3.9f, 2.9f}));
    EXPECT_TRUE(covers(zone, {3, 2.95f}));
}

TEST(Surface, IsThatOfTheLastZoneThatHasOne) {
    Scene scene;
    scene.zones = {{.name = "ice", .length = 4, .width = 4, .surface = Surface::ice},
                   {.name = "sand", .length = 2, .width = 2, .surface = Surface::sand},
                   {.name = "wind", .length = 2, .width = 2, .wind_x = 1}};
    EXPECT_EQ(surface_at(scene, {0, 0}), Surface::sand);
    EXPECT_EQ(surface_at(scene, {1.5f, 0}), Surface::ice);
    EXPECT_EQ(surface_at(scene, {5, 0}), Surface::none);
}

}  // namespace
}  // namespace braitenlab

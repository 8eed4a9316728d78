#include "render/view/trails.h"

#include <gtest/gtest.h>

#include "tests/view/hand_made.h"

namespace braitenlab {
namespace {

Snapshot one_vehicle() {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, 0, 0, 0);
    return now;
}

void drive(Snapshot& now, Trails& trails, int ticks) {
    for (int i = 0; i < ticks; ++i) {
        ++now.tick;
        now.vehicles[0].x += 0.02f;
        trails.record(now);
    }
}

TEST(Trails, GrowWithTheWayAndForgetItsBeginning) {
    Snapshot now = one_vehicle();
    Trails trails;
    drive(now, trails, 60);
    const std::size_t after_a_second = trails.of(0)->count;
    EXPECT_GE(after_a_second, 9U);
    drive(now, trails, 2000);
    EXPECT_EQ(trails.of(0)->count, Trail::capacity);
    EXPECT_NEAR(trails.of(0)->at(0).x, now.vehicles[0].x, 0.13f);
    EXPECT_GT(trails.of(0)->at(0).x, trails.of(0)->at(1).x);
}

TEST(Trails, BeginAgainWhenTimeGoesBack) {
    Snapshot now = one_vehicle();
    Trails trails;
    drive(now, trails, 60);
    now.tick = 5;
    trails.record(now);
    EXPECT_LE(trails.of(0)->count, 1U);
}

TEST(Trails, DoNotGrowWhileAVehicleStands) {
    Snapshot now = one_vehicle();
    Trails trails;
    for (int i = 0; i < 600; ++i) {
        ++now.tick;
        trails.record(now);
    }
    EXPECT_EQ(trails.of(0)->count, 1U);
}

TEST(Trails, BreakWhereAVehicleWasPutElsewhere) {
    Snapshot now = one_vehicle();
    Trails trails;
    drive(now, trails, 60);
    now.vehicles[0].x += 8;
    drive(now, trails, 7);
    EXPECT_LE(trails.of(0)->count, 2U);
}

TEST(Trails, OfVehiclesThatLeftAreForgotten) {
    Snapshot now = one_vehicle();
    hand_made::add(now, 0, 5, 5, 0);
    Trails trails;
    drive(now, trails, 10);
    ASSERT_NE(trails.of(1), nullptr);
    now.vehicles.pop_back();
    drive(now, trails, 1);
    EXPECT_EQ(trails.of(1), nullptr);
}

}  // namespace
}  // namespace braitenlab

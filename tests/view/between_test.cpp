#include "render/view/between.h"

#include <gtest/gtest.h>

#include "core/maths/angle.h"

namespace braitenlab::tests::between_test {
namespace {

using namespace render;

VehicleView at(VehicleId id, float x, float heading) {
    VehicleView v;
    v.id = id, v.x = x, v.heading = heading;
    return v;
}

TEST(Between, InterpolatesPositionAndTurnsTheShortWay) {
    Snapshot now;
    now.vehicles = {at(3, 0.2f, -3.1f)};
    stand_between(now, {at(1, 9, 9), at(3, 0.1f, 3.1f)}, 0.5f);
    EXPECT_FLOAT_EQ(now.vehicles[0].x, 0.15f);
    EXPECT_NEAR(std::fabs(now.vehicles[0].heading), maths::pi, 1e-5f);
}

TEST(Between, KeepsThePosesOfNewAndMovedVehicles) {
    Snapshot now;
    now.vehicles = {at(3, 5, 0), at(4, 1, 0)};
    stand_between(now, {at(3, 0, 0)}, 0);
    EXPECT_EQ(now.vehicles[0].x, 5);
    EXPECT_EQ(now.vehicles[1].x, 1);
}

}  // namespace
}  // namespace braitenlab::tests::between_test

#include <gtest/gtest.h>

#include "render/view/camera.h"
#include "tests/view/hand_made.h"

namespace braitenlab {
namespace {

const Rect window{0, 0, 1280, 800};

TEST(Pick, FindsTheVehicleWhereItIsDrawn) {
    Snapshot now = hand_made::empty(hand_made::scene());
    const VehicleId left = hand_made::add(now, 1, -5, 2, 0), right = hand_made::add(now, 2, 6, -7, 1);
    const Sight sight = look(Camera{}, now.scene->arena, nullptr, window, window);
    EXPECT_EQ(pick(now, sight, *project(sight, {-5, 2}, 0.15f)), left);
    EXPECT_EQ(pick(now, sight, *project(sight, {6, -7}, 0.15f)), right);
    EXPECT_EQ(pick(now, sight, *project(sight, {0, 0})), no_vehicle);
}

TEST(Pick, TakesTheNearestToThePixelOfTwoThatTouch) {
    Snapshot now = hand_made::empty(hand_made::scene());
    const VehicleId a = hand_made::add(now, 1, 0, 0, 0), b = hand_made::add(now, 1, 0.7f, 0, 0);
    const Sight sight = look(Camera{}, now.scene->arena, nullptr, window, window);
    EXPECT_EQ(pick(now, sight, *project(sight, {0.2f, 0}, 0.15f)), a);
    EXPECT_EQ(pick(now, sight, *project(sight, {0.5f, 0}, 0.15f)), b);
}

TEST(Pick, IsGenerousByAFewPixelsAndNoMore) {
    Snapshot now = hand_made::empty(hand_made::scene());
    const VehicleId only = hand_made::add(now, 0, 0, 0, 0);
    const Sight sight = look(Camera{}, now.scene->arena, nullptr, window, window);
    const auto centre = *project(sight, {0, 0}, 0.15f), side = *project(sight, {0.5f, 0}, 0.15f);
    EXPECT_EQ(pick(now, sight, {side.x + 3, centre.y}), only);
    EXPECT_EQ(pick(now, sight, {side.x + 12, centre.y}), no_vehicle);
}

TEST(Pick, FindsNothingBehindTheEye) {
    Snapshot now = hand_made::empty(hand_made::scene());
    VehicleView rider;
    hand_made::add(now, 0, -9, 0, 0);
    Camera camera;
    camera.mode = CameraMode::follow;
    const Sight sight = look(camera, now.scene->arena, &rider, window, window);
    EXPECT_EQ(pick(now, sight, {640, 400}), no_vehicle);
}

}  // namespace
}  // namespace braitenlab

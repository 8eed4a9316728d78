#include "render/view/camera.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/maths/angle.h"
#include "tests/view/hand_made.h"

namespace braitenlab {
namespace {

using maths::vec2;

const Rect window{0, 0, 1280, 800};
const Rect free_area{300, 44, 640, 640};

Sight overview(float azimuth = -maths::pi / 2, float elevation = Camera{}.elevation) {
    Camera camera;
    camera.azimuth = azimuth, camera.elevation = elevation;
    return look(camera, Arena{}, nullptr, window, free_area);
}

TEST(Camera, ShowsEveryCornerOfTheArenaInTheFreeArea) {
    const Rect windows[] = {{0, 0, 1280, 800}, {0, 0, 1024, 768}, {0, 0, 3840, 2160}, {0, 0, 700, 1200}};
    for (const Rect& w : windows)
        for (const Rect& area : {w, Rect{0.25f * w.w, 40, 0.5f * w.w, w.h - 160}, Rect{0.1f * w.w, 0, 0.3f * w.w, w.h}})
            for (float azimuth = -3; azimuth < 3.2f; azimuth += 0.7f)
                for (const float elevation : {0.15f, 0.6f, 0.95f, 1.5f}) {
                    Camera camera;
                    camera.azimuth = azimuth, camera.elevation = elevation;
                    Arena arena;
                    arena.height = 12;
                    const Sight sight = look(camera, arena, nullptr, w, area);
                    for (const vec2 corner : {vec2{-10, -6}, {10, -6}, {10, 6}, {-10, 6}}) {
                        const auto at = project(sight, corner);
                        ASSERT_TRUE(at);
                        EXPECT_TRUE(area.contains(at->x, at->y)) << *at << " azimuth " << azimuth;
                    }
                }
}

TEST(Camera, FillsTheFreeAreaInOneDirection) {
    const Sight sight = overview();
    float left = 1e9f, right = 0, top = 1e9f, bottom = 0;
    for (const vec2 corner : {vec2{-10, -10}, {10, -10}, {10, 10}, {-10, 10}}) {
        const auto at = project(sight, corner);
        ASSERT_TRUE(at);
        left = std::min(left, at->x), right = std::max(right, at->x);
        top = std::min(top, at->y), bottom = std::max(bottom, at->y);
    }
    EXPECT_GT(std::max((right - left) / free_area.w, (bottom - top) / free_area.h), 0.9f);
    EXPECT_NEAR((left + right) / 2, free_area.x + free_area.w / 2, 5);
}

TEST(Camera, ShowsLeftOnTheLeftAndFarAtTheTop) {
    const Sight sight = overview();
    EXPECT_LT(project(sight, {-3, 0})->x, project(sight, {3, 0})->x);
    EXPECT_LT(project(sight, {0, 3})->y, project(sight, {0, -3})->y);
    EXPECT_LT(project(sight, {0, 0}, 1)->y, project(sight, {0, 0})->y);
}

TEST(Camera, FindsThePlaceOnTheFloorThatAPixelShows) {
    for (const float azimuth : {-1.57f, 0.4f, 2.5f})
        for (const vec2 place : {vec2{0, 0}, {7, -3}, {-9.5f, 8}}) {
            const Sight sight = overview(azimuth);
            const auto pixel = project(sight, place);
            ASSERT_TRUE(pixel);
            const auto back = unproject(sight, *pixel);
            ASSERT_TRUE(back);
            EXPECT_LT(maths::distance(*back, place), 0.01f);
        }
}

TEST(Camera, FindsNoFloorAboveTheHorizon) {
    VehicleView vehicle;
    Camera camera;
    camera.mode = CameraMode::follow;
    const Sight sight = look(camera, Arena{}, &vehicle, window, window);
    EXPECT_FALSE(unproject(sight, {640, 2}));
    EXPECT_TRUE(unproject(sight, {640, 700}));
}

TEST(Camera, ProjectsNothingBehindTheEye) {
    VehicleView vehicle;
    Camera camera;
    camera.mode = CameraMode::follow;
    EXPECT_FALSE(project(look(camera, Arena{}, &vehicle, window, window), {-8, 0}));
}

TEST(Camera, RidesBehindAndAboveTheVehicleItFollows) {
    VehicleView vehicle;
    vehicle.x = 2, vehicle.y = 3, vehicle.heading = maths::pi / 2;
    Camera camera;
    camera.mode = CameraMode::follow;
    const Sight sight = look(camera, Arena{}, &vehicle, window, free_area);
    EXPECT_NEAR(sight.eye.x, 2, 1e-4);
    EXPECT_NEAR(-sight.eye.z, 3 - 4, 1e-4);
    EXPECT_NEAR(sight.eye.y, 2.6f, 1e-4);
    EXPECT_NEAR(project(sight, {2, 3})->x, free_area.x + free_area.w / 2, 0.5f);
}

TEST(Camera, WithoutAVehicleToFollowShowsTheOverview) {
    Camera camera;
    camera.mode = CameraMode::follow;
    EXPECT_LT(maths::distance(look(camera, Arena{}, nullptr, window, free_area).eye, overview().eye), 1e-3f);
}

TEST(Camera, ZoomKeepsTheMiddleOfTheFreeAreaInPlace) {
    Camera camera;
    const vec2 middle{free_area.x + free_area.w / 2, free_area.y + free_area.h / 2};
    const vec2 before = *unproject(look(camera, Arena{}, nullptr, window, free_area), middle);
    camera.zoom = 4;
    const Sight near = look(camera, Arena{}, nullptr, window, free_area);
    EXPECT_LT(maths::distance(*unproject(near, middle), before), 0.01f);
    EXPECT_GT(project(near, {1, 0})->x - project(near, {0, 0})->x,
              3.5f * (project(overview(), {1, 0})->x - project(overview(), {0, 0})->x));
}

TEST(Camera, PanMovesThePictureByThatManyMetres) {
    Camera camera;
    camera.pan = {3, -2};
    const auto moved = project(look(camera, Arena{}, nullptr, window, free_area), {4, 1});
    const auto still = project(overview(), {1, 3});
    EXPECT_LT(maths::distance(*moved, *still), 0.1f);
}

TEST(Camera, FitsIntoTheWholeWindowWhenCardsLeaveNoRoom) {
    const Sight sight = look(Camera{}, Arena{}, nullptr, window, Rect{600, 300, 10, 10});
    EXPECT_NEAR(project(sight, {0, 0})->x, 640, 2);
}

TEST(Glide, ComesMostOfTheWayInAFifthOfASecondAndArrives) {
    const Sight from = overview(-1.57f), to = overview(-0.6f, 0.7f);
    Sight now = from;
    for (int frame = 0; frame < 12; ++frame) now = glide(now, to, 1.0f / 60);
    EXPECT_LT(maths::distance(now.eye, to.eye), 0.06f * maths::distance(from.eye, to.eye));
    EXPECT_GT(maths::distance(now.eye, to.eye), 0);
    for (int frame = 0; frame < 120; ++frame) now = glide(now, to, 1.0f / 60);
    EXPECT_EQ(now.view, to.view);
    EXPECT_EQ(now.projection, to.projection);
}

TEST(Glide, KeepsTheViewARotationOnTheWay) {
    const Sight half = glide(overview(-1.57f), overview(0.3f, 1.4f), 0.04f);
    const maths::vec3 x{half.view[0].x, half.view[1].x, half.view[2].x},
        y{half.view[0].y, half.view[1].y, half.view[2].y};
    EXPECT_NEAR(maths::length(x), 1, 1e-5);
    EXPECT_NEAR(maths::length(y), 1, 1e-5);
    EXPECT_NEAR(maths::dot(x, y), 0, 1e-5);
}

TEST(Glide, DoesNotLagBehindAWindowThatChangesItsSize) {
    const Sight to = look(Camera{}, Arena{}, nullptr, {0, 0, 800, 600}, {0, 0, 800, 600});
    EXPECT_EQ(glide(overview(), to, 0.01f).projection, to.projection);
}

}  // namespace
}  // namespace braitenlab

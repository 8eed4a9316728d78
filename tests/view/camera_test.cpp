#include "render/view/camera.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/maths/angle.h"
#include "tests/view/hand_made.h"

namespace braitenlab::tests::camera_test {
namespace {

using maths::vec2;

const Rect window{0, 0, 1280, 800};
const Rect free_area{300, 44, 640, 640};

CameraView overview(float azimuth = -maths::pi / 2, float elevation = Camera{}.elevation) {
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
                    const CameraView camera_view = look(camera, arena, nullptr, w, area);
                    for (const vec2 corner : {vec2{-10, -6}, {10, -6}, {10, 6}, {-10, 6}}) {
                        const auto at = project(camera_view, corner);
                        ASSERT_TRUE(at);
                        EXPECT_TRUE(area.contains(at->x, at->y)) << *at << " azimuth " << azimuth;
                    }
                }
}

TEST(Camera, LeavesRoomForTheLabelsOfMetresInAPictureWithoutBars) {
    const auto below = [](Rect area) {
        const CameraView seen = look(Camera{}, Arena{}, nullptr, window, area);
        return area.y + area.h - project(seen, {0, -Arena{}.height / 2})->y;
    };
    EXPECT_GT(below(window), 0.04f * window.h);
    EXPECT_LT(below({100, 100, 1080, 600}), 0.04f * 600) << "there is room below the area";
}

TEST(Camera, FillsTheFreeAreaInOneDirection) {
    const CameraView camera_view = overview();
    float left = 1e9f, right = 0, top = 1e9f, bottom = 0;
    for (const vec2 corner : {vec2{-10, -10}, {10, -10}, {10, 10}, {-10, 10}}) {
        const auto at = project(camera_view, corner);
        ASSERT_TRUE(at);
        left = std::min(left, at->x), right = std::max(right, at->x);
        top = std::min(top, at->y), bottom = std::max(bottom, at->y);
    }
    EXPECT_GT(std::max((right - left) / free_area.w, (bottom - top) / free_area.h), 0.9f);
    EXPECT_NEAR((left + right) / 2, free_area.x + free_area.w / 2, 5);
}

TEST(Camera, ShowsLeftOnTheLeftAndFarAtTheTop) {
    const CameraView camera_view = overview();
    EXPECT_LT(project(camera_view, {-3, 0})->x, project(camera_view, {3, 0})->x);
    EXPECT_LT(project(camera_view, {0, 3})->y, project(camera_view, {0, -3})->y);
    EXPECT_LT(project(camera_view, {0, 0}, 1)->y, project(camera_view, {0, 0})->y);
}

TEST(Camera, FindsTheFloorPointThatAPixelShows) {
    for (const float azimuth : {-1.57f, 0.4f, 2.5f})
        for (const vec2 place : {vec2{0, 0}, {7, -3}, {-9.5f, 8}}) {
            const CameraView camera_view = overview(azimuth);
            const auto pixel = project(camera_view, place);
            ASSERT_TRUE(pixel);
            const auto back = unproject(camera_view, *pixel);
            ASSERT_TRUE(back);
            EXPECT_LT(maths::distance(*back, place), 0.01f);
        }
}

TEST(Camera, FindsNoFloorAboveTheHorizon) {
    VehicleView vehicle;
    Camera camera;
    camera.mode = CameraMode::follow;
    const CameraView camera_view = look(camera, Arena{}, &vehicle, window, window);
    EXPECT_FALSE(unproject(camera_view, {640, 2}));
    EXPECT_TRUE(unproject(camera_view, {640, 700}));
}

TEST(Camera, ProjectsNothingBehindTheCamera) {
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
    const CameraView camera_view = look(camera, Arena{}, &vehicle, window, free_area);
    EXPECT_NEAR(camera_view.eye.x, 2, 1e-4);
    EXPECT_NEAR(-camera_view.eye.z, 3 - 4, 1e-4);
    EXPECT_NEAR(camera_view.eye.y, 2.6f, 1e-4);
    EXPECT_NEAR(project(camera_view, {2, 3})->x, free_area.x + free_area.w / 2, 0.5f);
}

TEST(Camera, ShowsTheOverviewWithoutAVehicleToFollow) {
    Camera camera;
    camera.mode = CameraMode::follow;
    EXPECT_LT(maths::distance(look(camera, Arena{}, nullptr, window, free_area).eye, overview().eye), 1e-3f);
}

TEST(Camera, KeepsTheCentreOfTheFreeAreaWhileZooming) {
    Camera camera;
    const vec2 middle{free_area.x + free_area.w / 2, free_area.y + free_area.h / 2};
    const vec2 before = *unproject(look(camera, Arena{}, nullptr, window, free_area), middle);
    camera.zoom = 4;
    const CameraView near = look(camera, Arena{}, nullptr, window, free_area);
    EXPECT_LT(maths::distance(*unproject(near, middle), before), 0.01f);
    EXPECT_GT(project(near, {1, 0})->x - project(near, {0, 0})->x,
              3.5f * (project(overview(), {1, 0})->x - project(overview(), {0, 0})->x));
}

TEST(Camera, PansByMetres) {
    Camera camera;
    camera.pan = {3, -2};
    const auto moved = project(look(camera, Arena{}, nullptr, window, free_area), {4, 1});
    const auto still = project(overview(), {1, 3});
    EXPECT_LT(maths::distance(*moved, *still), 0.1f);
}

TEST(Camera, FitsIntoTheWholeWindowWhenCardsLeaveNoRoom) {
    const CameraView camera_view = look(Camera{}, Arena{}, nullptr, window, Rect{600, 300, 10, 10});
    EXPECT_NEAR(project(camera_view, {0, 0})->x, 640, 2);
}

CameraView in_mode(CameraMode mode, const VehicleView* vehicle = nullptr) {
    Camera camera;
    camera.mode = mode;
    return look(camera, Arena{}, vehicle, window, free_area);
}

TEST(Camera, ShowsTheArenaFromStraightAboveWithoutPerspective) {
    const CameraView camera_view = in_mode(CameraMode::birds_eye);
    const vec2 a = *project(camera_view, {-9, -9}), b = *project(camera_view, {-8, -9}),
               c = *project(camera_view, {8, 9}), d = *project(camera_view, {8, 8});
    EXPECT_NEAR(b.x - a.x, d.y - c.y, 1e-2);  // a metre is a metre everywhere, x to the right, y up
    EXPECT_NEAR(a.y, b.y, 1e-3);
    EXPECT_NEAR(maths::distance(*project(camera_view, {3, 4}, 0), *project(camera_view, {3, 4}, 1)), 0, 1e-2);
    for (const vec2 corner : {vec2{-10, -10}, {10, -10}, {10, 10}, {-10, 10}})
        EXPECT_TRUE(free_area.contains(project(camera_view, corner)->x, project(camera_view, corner)->y));
    EXPECT_NEAR(project(camera_view, {0, 0})->x, free_area.x + free_area.w / 2, 0.1f);
}

TEST(Camera, LooksAheadInDriverMode) {
    VehicleView vehicle;
    vehicle.x = 1, vehicle.y = 2, vehicle.heading = maths::pi / 2;
    const CameraView camera_view = in_mode(CameraMode::driver, &vehicle);
    EXPECT_LT(maths::distance(maths::vec2{camera_view.eye.x, -camera_view.eye.z}, {1, 2}), 0.3f);
    EXPECT_NEAR(project(camera_view, {1, 8})->x, free_area.x + free_area.w / 2, 0.5f);
    EXPECT_LT(project(camera_view, {0, 6})->x, project(camera_view, {2, 6})->x);  // its left is on the left
    EXPECT_FALSE(project(camera_view, {1, -3}));
}

TEST(Camera, FindsTheFloorUnderAPixelInEveryMode) {
    VehicleView vehicle;
    for (const CameraMode mode :
         {CameraMode::overview, CameraMode::follow, CameraMode::birds_eye, CameraMode::driver}) {
        const CameraView camera_view = in_mode(mode, &vehicle);
        const auto back = unproject(camera_view, *project(camera_view, {4, 0.5f}));
        ASSERT_TRUE(back);
        EXPECT_LT(maths::distance(*back, {4, 0.5f}), 0.01f) << static_cast<int>(mode);
    }
}

TEST(Camera, FindsTheFloorUnderAPixelDuringAGlide) {
    const CameraView half = glide(in_mode(CameraMode::overview), in_mode(CameraMode::birds_eye), 0.03f);
    for (const vec2 place : {vec2{0, 0}, {6, -3}, {-7, 8}}) {
        const auto back = unproject(half, *project(half, place));
        ASSERT_TRUE(back);
        EXPECT_LT(maths::distance(*back, place), 0.02f);
    }
}

TEST(Camera, GivesPixelsPerMetre) {
    for (const CameraMode mode : {CameraMode::overview, CameraMode::birds_eye}) {
        const CameraView camera_view = in_mode(mode);
        // Across the line of sight: along x, as the camera is on the side of −y.
        const float apart = project(camera_view, {2.5f, 1})->x - project(camera_view, {1.5f, 1})->x;
        EXPECT_NEAR(pixels_per_metre(camera_view, {2, 1}), apart, 0.01f * apart);
    }
    VehicleView vehicle;
    EXPECT_EQ(pixels_per_metre(in_mode(CameraMode::follow, &vehicle), {-8, 0}), 0);
}

TEST(Camera, KeepsThePointUnderThePointerWhileZooming) {
    for (const CameraMode mode : {CameraMode::overview, CameraMode::birds_eye}) {
        Camera camera;
        camera.mode = mode, camera.azimuth = 0.4f, camera.elevation = 0.7f;
        const vec2 pixel{420, 300};
        const vec2 before = *unproject(look(camera, Arena{}, nullptr, window, free_area), pixel);
        zoom_about(camera, Arena{}, window, free_area, pixel, 2.5f);
        EXPECT_FLOAT_EQ(camera.zoom, 2.5f);
        EXPECT_LT(maths::distance(*unproject(look(camera, Arena{}, nullptr, window, free_area), pixel), before), 0.02f);
        zoom_about(camera, Arena{}, window, free_area, pixel, 1e9f);
        EXPECT_EQ(camera.zoom, 8);
    }
}

TEST(Camera, PansWithTheFloorPointUnderThePointer) {
    Camera camera;
    camera.azimuth = 2;
    const CameraView camera_view = look(camera, Arena{}, nullptr, window, free_area);
    const vec2 held = *unproject(camera_view, {500, 400});
    pan(camera, camera_view, {500, 400}, {620, 300});
    EXPECT_LT(maths::distance(*unproject(look(camera, Arena{}, nullptr, window, free_area), {620, 300}), held), 0.05f);
}

TEST(Camera, OrbitsOnlyAboveTheFloor) {
    Camera camera;
    orbit(camera, 100, -9);
    EXPECT_GT(camera.elevation, 0);
    EXPECT_LT(std::fabs(camera.azimuth), 3.2f);
    orbit(camera, 0, 9);
    EXPECT_LT(camera.elevation, maths::pi / 2);
}

TEST(Camera, GlidesFromPerspectiveToOrthographicAndArrives) {
    const CameraView to = in_mode(CameraMode::birds_eye);
    CameraView now = in_mode(CameraMode::overview);
    for (int frame = 0; frame < 120; ++frame) {
        now = glide(now, to, 1.0f / 60);
        ASSERT_TRUE(project(now, {0, 0}));
        EXPECT_TRUE(window.contains(project(now, {0, 0})->x, project(now, {0, 0})->y)) << frame;
    }
    EXPECT_EQ(now.view, to.view);
    EXPECT_EQ(now.projection, to.projection);
}

TEST(Camera, GlidesMostOfTheWayInAFifthOfASecondAndArrives) {
    const CameraView from = overview(-1.57f), to = overview(-0.6f, 0.7f);
    CameraView now = from;
    for (int frame = 0; frame < 12; ++frame) now = glide(now, to, 1.0f / 60);
    EXPECT_LT(maths::distance(now.eye, to.eye), 0.06f * maths::distance(from.eye, to.eye));
    EXPECT_GT(maths::distance(now.eye, to.eye), 0);
    for (int frame = 0; frame < 120; ++frame) now = glide(now, to, 1.0f / 60);
    EXPECT_EQ(now.view, to.view);
    EXPECT_EQ(now.projection, to.projection);
}

TEST(Camera, KeepsTheViewARotationDuringAGlide) {
    const CameraView half = glide(overview(-1.57f), overview(0.3f, 1.4f), 0.04f);
    const maths::vec3 x{half.view[0].x, half.view[1].x, half.view[2].x},
        y{half.view[0].y, half.view[1].y, half.view[2].y};
    EXPECT_NEAR(maths::length(x), 1, 1e-5);
    EXPECT_NEAR(maths::length(y), 1, 1e-5);
    EXPECT_NEAR(maths::dot(x, y), 0, 1e-5);
}

TEST(Camera, DoesNotGlideWhenTheWindowChangesItsSize) {
    const CameraView to = look(Camera{}, Arena{}, nullptr, {0, 0, 800, 600}, {0, 0, 800, 600});
    EXPECT_EQ(glide(overview(), to, 0.01f).projection, to.projection);
}

}  // namespace
}  // namespace braitenlab::tests::camera_test

#include "render/view/pick.h"

#include <gtest/gtest.h>

#include "tests/view/hand_made.h"

namespace braitenlab::tests::pick_test {
namespace {

const Rect window{0, 0, 1280, 800};

TEST(Pick, FindsTheVehicleWhereItIsDrawn) {
    Snapshot now = hand_made::empty(hand_made::scene());
    const VehicleId left = hand_made::add(now, 1, -5, 2, 0), right = hand_made::add(now, 2, 6, -7, 1);
    const CameraView camera_view = look(Camera{}, now.scene->arena, nullptr, window, window);
    EXPECT_EQ(pick(now, camera_view, *project(camera_view, {-5, 2}, 0.15f)), left);
    EXPECT_EQ(pick(now, camera_view, *project(camera_view, {6, -7}, 0.15f)), right);
    EXPECT_EQ(pick(now, camera_view, *project(camera_view, {0, 0})), no_vehicle);
}

TEST(Pick, PrefersTheNearestToThePixelOfTwoTouchingVehicles) {
    Snapshot now = hand_made::empty(hand_made::scene());
    const VehicleId a = hand_made::add(now, 1, 0, 0, 0), b = hand_made::add(now, 1, 0.7f, 0, 0);
    const CameraView camera_view = look(Camera{}, now.scene->arena, nullptr, window, window);
    EXPECT_EQ(pick(now, camera_view, *project(camera_view, {0.2f, 0}, 0.15f)), a);
    EXPECT_EQ(pick(now, camera_view, *project(camera_view, {0.5f, 0}, 0.15f)), b);
}

TEST(Pick, HasAMarginOfAFewPixels) {
    Snapshot now = hand_made::empty(hand_made::scene());
    const VehicleId only = hand_made::add(now, 0, 0, 0, 0);
    const CameraView camera_view = look(Camera{}, now.scene->arena, nullptr, window, window);
    const auto centre = *project(camera_view, {0, 0}, 0.15f), side = *project(camera_view, {0.5f, 0}, 0.15f);
    EXPECT_EQ(pick(now, camera_view, {side.x + 3, centre.y}), only);
    EXPECT_EQ(pick(now, camera_view, {side.x + 12, centre.y}), no_vehicle);
}

TEST(Pick, FindsNothingBehindTheCamera) {
    Snapshot now = hand_made::empty(hand_made::scene());
    VehicleView rider;
    hand_made::add(now, 0, -9, 0, 0);
    Camera camera;
    camera.mode = CameraMode::follow;
    const CameraView camera_view = look(camera, now.scene->arena, &rider, window, window);
    EXPECT_EQ(pick(now, camera_view, {640, 400}), no_vehicle);
}

SceneObject source(int index) { return {SceneObjectKind::source, index}; }
SceneObject obstacle(int index) { return {SceneObjectKind::obstacle, index}; }
SceneObject zone(int index) { return {SceneObjectKind::zone, index}; }

// An arena with these obstacles, seen from the overview.
struct Yard {
    explicit Yard(std::vector<Obstacle> obstacles) {
        auto scene = hand_made::scene();
        scene->obstacles = std::move(obstacles);
        for (const Obstacle& o : scene->obstacles) now.obstacles.push_back({o.x, o.y, o.heading});
        now.scene = scene;
        camera_view = look(Camera{}, scene->arena, nullptr, window, window);
    }
    SceneObject at(maths::vec2 place, float height = 0) const {
        return pick_object(now, camera_view, *project(camera_view, place, height));
    }
    Snapshot now;
    CameraView camera_view;
};

Obstacle box(float x, float y, float heading, float length, float width) {
    Obstacle made;
    made.x = x, made.y = y, made.heading = heading, made.length = length, made.width = width;
    return made;
}

TEST(Pick, FindsASourceByItsFootAndByItsBulb) {
    Yard yard({});
    hand_made::add_source(yard.now, Channel::light, 3, 4);
    hand_made::add_source(yard.now, Channel::smell, -3, 4);
    EXPECT_EQ(yard.at({3, 4}), source(0));
    EXPECT_EQ(yard.at({-3, 4}, bulb_height), source(1));
    EXPECT_FALSE(yard.at({0, 4}));
}

TEST(Pick, FindsATurnedBoxWithinItsOutlineAndByItsTop) {
    const Yard yard({box(2, 1, maths::radians(45), 4, 1)});
    EXPECT_EQ(yard.at({3.2f, 2.2f}), obstacle(0)) << "along its heading";
    EXPECT_FALSE(yard.at({3.2f, -0.2f})) << "at the same distance across its heading";
    EXPECT_EQ(yard.at({3.2f, 2.2f}, obstacle_height(yard.now.scene->arena)), obstacle(0));
}

TEST(Pick, FindsAPolygonByItsCornersAndNotByItsBox) {
    Obstacle triangle = box(0, 0, 0, 4, 4);
    triangle.corners = {{-2, -2}, {2, -2}, {-2, 2}};
    const Yard yard({triangle});
    EXPECT_EQ(yard.at({-1, -1}), obstacle(0));
    EXPECT_FALSE(yard.at({1.5f, 1.5f}, obstacle_height(yard.now.scene->arena)));
}

TEST(Pick, FindsAPushedObstacleWhereItIsNow) {
    Yard yard({box(0, 0, 0, 1, 1)});
    yard.now.obstacles[0] = {5, 5, 0};
    EXPECT_EQ(yard.at({5, 5}), obstacle(0));
    EXPECT_FALSE(yard.at({0, 0}));
    EXPECT_EQ(place_of(yard.now, obstacle(0))->x, 5);
}

TEST(Pick, PrefersVehiclesToSourcesAndSourcesToObstacles) {
    Yard yard({box(0, 0, 0, 3, 3)});
    hand_made::add_source(yard.now, Channel::light, 0, 0);
    EXPECT_EQ(yard.at({0, 0}), source(0));
    const VehicleId vehicle = hand_made::add(yard.now, 0, 0, 0, 0);
    EXPECT_EQ(yard.at({0, 0}), vehicle_object(vehicle));
    EXPECT_EQ(yard.at({1.2f, 1.2f}), obstacle(0));
}

// A yard with a box in the middle and these zones.
Yard with_zones(std::vector<Zone> zones) {
    Yard yard({box(0, 0, 0, 1, 1)});
    auto scene = std::make_shared<Scene>(*yard.now.scene);
    scene->zones = std::move(zones);
    yard.now.scene = scene;
    return yard;
}

TEST(Pick, FindsTheTopmostZoneBelowAllOtherObjects) {
    Yard yard = with_zones({{.name = "a", .length = 6, .width = 6}, {.name = "b", .x = 2, .length = 3, .width = 1}});
    EXPECT_EQ(yard.at({-2, 2}), zone(0));
    EXPECT_EQ(yard.at({2, 0}), zone(1)) << "of two the last one, which is drawn over the other";
    EXPECT_EQ(yard.at({0, 0}), obstacle(0));
    EXPECT_FALSE(yard.at({-4, 2}));
    EXPECT_FALSE(pick_object(yard.now, yard.camera_view, *project(yard.camera_view, {-2, 2}), false))
        << "zones are not shown";
    hand_made::add_source(yard.now, Channel::light, 2, 0);
    EXPECT_EQ(yard.at({2, 0}), source(0));
}

TEST(Pick, FindsAZoneWithinItsEllipseOrPolygon) {
    const Yard yard = with_zones({{.name = "a", .x = -5, .length = 6, .width = 4, .round = true},
                                  {.name = "b", .x = 5, .corners = {{-2, -2}, {2, -2}, {-2, 2}}}});
    EXPECT_EQ(yard.at({-5, 1.9f}), zone(0));
    EXPECT_FALSE(yard.at({-7.8f, 1.8f})) << "a corner of its rectangle";
    EXPECT_EQ(yard.at({4, -1}), zone(1));
    EXPECT_FALSE(yard.at({6.5f, 1.5f}));
    EXPECT_FLOAT_EQ(reach_of(yard.now, zone(0)), 3);
    EXPECT_EQ(outline_of(yard.now, zone(1)).size(), 3u);
}

TEST(Pick, NamesObjectsAndFindsThemByTheirName) {
    const Yard yard = with_zones({{.name = "a"}, {.name = "b"}});
    EXPECT_EQ(name_of(*yard.now.scene, zone(1)), "b");
    EXPECT_EQ(object_named(*yard.now.scene, SceneObjectKind::zone, "b"), zone(1));
    EXPECT_EQ(object_named(*yard.now.scene, SceneObjectKind::zone, "c"), SceneObject{});
    EXPECT_EQ(object_named(*yard.now.scene, SceneObjectKind::source, "b"), SceneObject{});
    EXPECT_EQ(name_of(*yard.now.scene, zone(2)), "");
}

TEST(Pick, IgnoresRemovedObjects) {
    const Yard yard({});
    for (const SceneObject& gone : {vehicle_object(7), source(0), obstacle(3), zone(0), SceneObject{}}) {
        EXPECT_FALSE(place_of(yard.now, gone));
        EXPECT_EQ(reach_of(yard.now, gone), 0);
    }
}

TEST(Pick, ReachesAsFarAsTheFarthestCorner) {
    Obstacle triangle = box(0, 0, 0, 1, 1);
    triangle.corners = {{-3, 0}, {1, -1}, {1, 1}};
    const Yard yard({box(0, 0, 0, 3, 4), triangle});
    EXPECT_FLOAT_EQ(reach_of(yard.now, obstacle(0)), 2.5f);
    EXPECT_FLOAT_EQ(reach_of(yard.now, obstacle(1)), 3);
}

}  // namespace
}  // namespace braitenlab::tests::pick_test

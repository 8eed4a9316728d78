// Handles of corners and waypoints in the scene: synthetic Dear ImGui mouse events over a hand-made snapshot.
#include "ui/scene_input/point_handles.h"

#include <set>

#include "core/maths/angle.h"
#include "desk.h"

namespace braitenlab::tests::point_handles_test {

using namespace ui;
namespace {

using maths::vec2;

constexpr float a_pixel = 0.05f;  // m

// A desk with a triangular obstacle at (-2, 2), a square zone at (2, 2) turned by 90°, and a vehicle that follows a
// path of three waypoints. The camera looks straight down.
struct PointHandles : testing::Test {
    PointHandles() {
        desk.now = snapshot(0);
        auto scene = std::make_shared<Scene>(*desk.now.scene);
        scene->arena.width = scene->arena.height = 10;
        scene->obstacles = {
            {.name = "wedge", .x = -2, .y = 2, .corners = {{-1, -0.5f}, {1, -0.5f}, {0, 1}}, .mass = 5}};
        scene->zones = {{.name = "pond",
                         .x = 2,
                         .y = 2,
                         .heading = maths::pi / 2,
                         .surface = Surface::ice,
                         .slope = 0.1f,
                         .corners = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}}};
        scene->kinds[0].driver = Driver::path;
        scene->kinds[0].waypoints = {{-3, -3}, {3, -3}, {0, -1}};
        desk.now.scene = scene;
        desk.now.obstacles = {{-2, 2, 0}};
        desk.now.vehicles[0].driver = Driver::path;
        desk.view.camera_view = &camera_view;
        desk.frame(3);
        Camera camera;
        camera.mode = CameraMode::birds_eye;
        camera_view = look(camera, scene->arena, nullptr, {0, 0, 1280, 800}, desk.layout.scene);
        desk.frame(2);
    }

    void select(SceneObject object) {
        desk.view.settings.selection.object = object;
        desk.frame(2);
    }
    void drag(const char* handle, vec2 to, bool release = true) {
        desk.point(handle);
        desk.frame();
        desk.button(0, true);
        desk.frame();
        const vec2 from{ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y}, end = *project(camera_view, to);
        for (int i = 1; i <= 5; ++i) {
            const vec2 at = from + (end - from) * (static_cast<float>(i) / 5);
            desk.point(at.x, at.y);
            desk.frame();
        }
        if (!release) return;
        desk.button(0, false);
        desk.frame();
    }
    template <class T>
    T last() const {
        return std::get<T>(desk.edits().back().command);
    }
    std::set<std::uint64_t> gestures() const {
        std::set<std::uint64_t> all;
        for (const EditRequest& edit : desk.edits()) all.insert(edit.gesture);
        return all;
    }
    static constexpr SceneObject wedge{SceneObjectKind::obstacle, 0}, pond{SceneObjectKind::zone, 0};

    Desk desk{1280, 800};
    CameraView camera_view = look(Camera{}, Arena{}, nullptr, {0, 0, 1280, 800}, {336, 64, 576, 680});
};

// The corners of a zone or obstacle on the floor.
template <class Shape>
std::vector<vec2> on_floor(const Shape& shape) {
    std::vector<vec2> corners = corners_of(shape);
    for (vec2& corner : corners)
        corner = vec2{shape.x, shape.y} + maths::rotate(corner, maths::direction(shape.heading));
    return corners;
}

void expect_corner_at(const std::vector<vec2>& corners, vec2 place) {
    const bool found = std::any_of(corners.begin(), corners.end(),
                                   [&](vec2 corner) { return maths::distance(corner, place) < a_pixel; });
    EXPECT_TRUE(found) << place.x << ", " << place.y;
}

}  // namespace

TEST_F(PointHandles, OfAPolygonAreShownWhileItAloneIsSelected) {
    EXPECT_FALSE(desk.anchors.find("handle.corner.1"));
    select(wedge);
    EXPECT_TRUE(desk.anchors.find("handle.corner.3"));
    EXPECT_FALSE(desk.anchors.find("handle.corner.4"));
    EXPECT_GE(desk.where("handle.corner.1").w, 24) << "large enough for a hand";
    desk.view.settings.selection.more = {vehicle_object(0)};
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("handle.corner.1"));
    desk.view.settings.selection.more.clear();
    select(pond);
    EXPECT_TRUE(desk.anchors.find("handle.corner.4"));
    desk.view.settings.overlays.surfaces = false;
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("handle.corner.4")) << "zones are hidden";
}

TEST_F(PointHandles, MoveACornerOfAnObstacleAndKeepTheOthersInOneGesture) {
    select(wedge);
    drag("handle.corner.3", {-2, 4});
    const EditObstacle edit = last<EditObstacle>();
    EXPECT_EQ(edit.index, 0);
    EXPECT_EQ(edit.to.name, "wedge");
    EXPECT_EQ(edit.to.mass, 5);
    ASSERT_EQ(edit.to.corners.size(), 3u);
    expect_corner_at(on_floor(edit.to), {-2, 4});
    expect_corner_at(on_floor(edit.to), {-3, 1.5f});
    expect_corner_at(on_floor(edit.to), {-1, 1.5f});
    EXPECT_EQ(gestures().size(), 1u);
    drag("handle.corner.3", {-2, 3.5f});
    EXPECT_EQ(gestures().size(), 2u) << "a second drag is a second step";
}

TEST_F(PointHandles, MoveACornerOfAZoneAndKeepItsHeadingAndEffects) {
    select(pond);
    drag("handle.corner.1", {4, 0.5f});  // the corner at (3, 1)
    const EditZone edit = last<EditZone>();
    EXPECT_FLOAT_EQ(edit.to.heading, maths::pi / 2);
    EXPECT_EQ(edit.to.slope, 0.1f);
    EXPECT_EQ(edit.to.surface, Surface::ice);
    expect_corner_at(on_floor(edit.to), {4, 0.5f});
    expect_corner_at(on_floor(edit.to), {1, 3});
}

TEST_F(PointHandles, RefuseACornerThatWouldDentThePolygon) {
    select(pond);
    drag("handle.corner.1", {1.2f, 2.8f}, false);  // beyond the diagonal
    EXPECT_EQ(desk.panels.scene_input.refusal.key, "scene_input.refused.dents");
    for (const EditRequest& edit : desk.edits()) EXPECT_EQ(std::get<EditZone>(edit.command).to.corners.size(), 4u);
    const std::vector<vec2> corners = on_floor(last<EditZone>().to);
    for (const vec2 corner : corners) EXPECT_GT(maths::distance(corner, {1.2f, 2.8f}), 0.2f);
}

TEST_F(PointHandles, MoveAWaypointOfTheSelectedVehiclesKind) {
    ASSERT_TRUE(desk.anchors.find("handle.waypoint.3"));
    drag("handle.waypoint.2", {2, -4});
    const EditKind edit = last<EditKind>();
    EXPECT_EQ(edit.kind, 0);
    ASSERT_EQ(edit.to.waypoints.size(), 3u);
    EXPECT_NEAR(edit.to.waypoints[1].x, 2, a_pixel);
    EXPECT_NEAR(edit.to.waypoints[1].y, -4, a_pixel);
    EXPECT_EQ(edit.to.waypoints[0], (Waypoint{-3, -3}));
    EXPECT_EQ(gestures().size(), 1u);
    drag("handle.waypoint.2", {20, -4});
    EXPECT_LE(last<EditKind>().to.waypoints[1].x, 5) << "within the arena";
}

TEST_F(PointHandles, LeaveThePressToAVehicleThatIsNearer) {
    const Rect handle = desk.where("handle.waypoint.1");
    desk.now.vehicles.push_back(desk.now.vehicles[0]);
    desk.now.vehicles.back().id = 1, desk.now.vehicles.back().x = -3.1f, desk.now.vehicles.back().y = -3;
    const vec2 at = *project(camera_view, {-3.1f, -3});
    desk.point(at.x, at.y);
    desk.frame(2);
    EXPECT_TRUE(handle.contains(at.x, at.y));
    EXPECT_FALSE(desk.panels.scene_input.points.hovered);
    desk.point("handle.waypoint.1");
    desk.frame(2);
    EXPECT_TRUE(desk.panels.scene_input.points.hovered);
}

TEST_F(PointHandles, OfThePathAreShownForAVehicleThatFollowsIt) {
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    scene->kinds[0].driver = Driver::brain;
    desk.now.scene = scene;
    desk.frame(2);
    EXPECT_TRUE(desk.anchors.find("handle.waypoint.1"));
    desk.now.vehicles[0].driver = Driver::brain;
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("handle.waypoint.1"));
}

TEST_F(PointHandles, EscRestoresThePointAndEndsTheDrag) {
    drag("handle.waypoint.1", {-1, -4}, false);
    desk.all.clear();
    desk.key({key::escape});
    ASSERT_EQ(desk.edits().size(), 1u);
    EXPECT_EQ(last<EditKind>().to.waypoints[0], (Waypoint{-3, -3}));
    desk.all.clear();
    desk.point(600, 300);
    desk.frame(2);
    EXPECT_TRUE(desk.edits().empty());
}

}  // namespace braitenlab::tests::point_handles_test

// The tools that draw on the floor, with mouse and keyboard.
#include <cmath>

#include "core/maths/angle.h"
#include "desk.h"
#include "ui/scene_input/scene_input.h"
#include "ui/scene_input/tools.h"

namespace braitenlab::tests::scene_input_tools_test {

using namespace ui;
namespace {

using maths::vec2;

constexpr float a_pixel = 0.05f;  // m: Dear ImGui rounds the mouse to whole pixels

struct SceneInputTools : testing::Test {
    SceneInputTools() {
        auto scene = std::make_shared<Scene>(*desk.now.scene);
        scene->sources.push_back({.name = "lamp", .x = -3, .y = 6});
        desk.now.scene = scene;
        desk.now.sources.push_back({0, Channel::light, -3, 6, 1});
        for (std::size_t i = 0; i < desk.now.vehicles.size(); ++i)
            desk.now.vehicles[i].x = -6 + 1.5f * static_cast<float>(i % 8), desk.now.vehicles[i].y = -6;
        desk.view.camera_view = &camera_view;
        desk.frame(2);
        camera_view = look(Camera{}, scene->arena, nullptr, {0, 0, 1280, 800}, desk.layout.scene);
    }

    void point(vec2 place) {
        const vec2 at = *project(camera_view, place);
        desk.point(at.x, at.y);
        desk.frame();
    }
    void press() { desk.button(0, true), desk.frame(); }
    void release() { desk.button(0, false), desk.frame(); }
    void click(vec2 place) {
        point(place), press(), release();
        desk.rest();
    }
    void drag(vec2 from, vec2 to) {
        point(from), press();
        for (int i = 1; i <= 4; ++i) point(from + (to - from) * (static_cast<float>(i) / 4));
        release();
    }
    template <class C>
    Found<EditRequest> edits() const {
        Found<EditRequest> found;
        for (const EditRequest& edit : desk.edits())
            if (std::holds_alternative<C>(edit.command)) found.push_back(edit);
        return found;
    }
    Zone zone(std::size_t i) const { return std::get<AddZone>(edits<AddZone>().at(i).command).object; }
    SceneInputState& state() { return desk.panels.scene_input; }
    // Moves the crosshair by whole steps of the arrow keys.
    void steps(int key, int count) {
        for (int i = 0; i < count; ++i) desk.key({key});
        desk.frame();
    }

    Desk desk;
    CameraView camera_view = look(Camera{}, Arena{}, nullptr, {0, 0, 1280, 800}, {336, 64, 576, 680});
};

TEST_F(SceneInputTools, DrawAZoneFromCornerToCorner) {
    desk.click("tool.zone");
    EXPECT_EQ(word(state().tool), "zone");
    drag({-1, 2}, {2, 4});
    ASSERT_EQ(edits<AddZone>().size(), 1u);
    EXPECT_NEAR(zone(0).length, 3, 2 * a_pixel);
    EXPECT_NEAR(zone(0).width, 2, 2 * a_pixel);
    EXPECT_NEAR(zone(0).y, 3, a_pixel);
    EXPECT_EQ(zone(0).surface, Surface::ice);
    EXPECT_EQ(state().tool, SceneInputTool::hand);
    EXPECT_TRUE(state().corners.empty());
    desk.click("tool.zone");
    click({1, 3});
    EXPECT_EQ(zone(1).length, 2) << "a click without a drag adds a zone of two metres";
}

TEST_F(SceneInputTools, DrawALineOfTapeAsOneStepOfUndo) {
    desk.click("tool.tape");
    for (const vec2 at : {vec2{0, 2}, vec2{3, 2}, vec2{3, 4}}) click(at);
    EXPECT_TRUE(desk.edits().empty()) << "the line is not ended";
    point({3, 4}), press(), release(), press(), release();  // a double click
    const auto added = edits<AddZone>();
    ASSERT_EQ(added.size(), 2u) << "the double click adds no segment";
    EXPECT_NE(added[0].gesture, 0u);
    EXPECT_EQ(added[0].gesture, added[1].gesture);
    EXPECT_EQ(zone(0).surface, Surface::tape);
    EXPECT_NEAR(zone(1).heading, maths::pi / 2, 0.05f);
    EXPECT_EQ(state().tool, SceneInputTool::hand);
}

TEST_F(SceneInputTools, EndALineByEnterOrEscapeAndTakeBackAPoint) {
    for (const int end : {key::enter, key::escape}) {
        desk.all.clear();
        desk.click("tool.tape");
        for (const vec2 at : {vec2{0, 2}, vec2{3, 2}, vec2{3, 4}}) click(at);
        desk.key({key::backspace});
        desk.key({end});
        EXPECT_EQ(edits<AddZone>().size(), 1u);
        EXPECT_EQ(state().tool, SceneInputTool::hand);
    }
    desk.all.clear();
    desk.click("tool.tape");
    click({0, 2});
    desk.key({key::escape});
    EXPECT_TRUE(desk.edits().empty()) << "one point is no line";
    EXPECT_TRUE(state().corners.empty());
}

TEST_F(SceneInputTools, LeaveNoGapBetweenSegmentsOfTape) {
    const std::vector<Zone> line = tape_along({{0, 0}, {2, 0}, {2, 3}}, 0.1f);
    ASSERT_EQ(line.size(), 2u);
    EXPECT_FLOAT_EQ(line[0].length, 2.05f) << "half a width beyond the bend, and not beyond the end";
    EXPECT_FLOAT_EQ(line[0].x, 1.025f);
    EXPECT_FLOAT_EQ(line[1].length, 3.05f);
    EXPECT_FLOAT_EQ(line[1].y, 1.475f);
    EXPECT_FLOAT_EQ(line[1].width, 0.1f);
    EXPECT_TRUE(tape_along({{1, 1}}, 0.1f).empty());
}

TEST_F(SceneInputTools, TakeTheWidthOfTapeFromTheNarrowestVehicle) {
    Scene scene;
    EXPECT_FLOAT_EQ(tape_width(scene), 0.1f);
    scene.kinds.resize(2);
    EXPECT_FLOAT_EQ(tape_width(scene), 0.1f) << "the standard vehicle";
    scene.kinds[1].body.width = 0.35f;
    EXPECT_FLOAT_EQ(tape_width(scene), 0.05f);
}

TEST_F(SceneInputTools, MeasureDistanceAndDirection) {
    desk.click("tool.ruler");
    drag({1, 2}, {1, 4});
    ASSERT_EQ(state().corners.size(), 2u);
    EXPECT_NEAR(maths::distance(state().corners[0], state().corners[1]), 2, 2 * a_pixel);
    EXPECT_TRUE(desk.edits().empty());
    EXPECT_EQ(state().tool, SceneInputTool::ruler) << "it stays selected";
    click({2, 2});
    ASSERT_EQ(state().corners.size(), 1u) << "a click begins another measurement";
    click({4, 2});
    ASSERT_EQ(state().corners.size(), 2u) << "and the next one ends it";
    EXPECT_NEAR(state().corners[1].x, 4, a_pixel);
    desk.key({key::escape});
    EXPECT_TRUE(state().corners.empty());
    desk.key({key::escape});
    EXPECT_EQ(state().tool, SceneInputTool::hand);
}

TEST_F(SceneInputTools, MeasureFromTheCentreOfANearObject) {
    desk.click("tool.ruler");
    drag({-2.9f, 6.1f}, {1, 4});
    EXPECT_EQ(state().corners.at(0), (vec2{-3, 6}));
    EXPECT_NEAR(state().corners.at(1).x, 1, a_pixel) << "no object is near";
}

TEST_F(SceneInputTools, MoveACrosshairByArrowKeysAndSetCornersByEnter) {
    desk.click("tool.zone");
    steps(key::right, 2);
    ASSERT_TRUE(state().crosshair);
    const vec2 from = *state().crosshair;
    ASSERT_TRUE(desk.anchors.find("stage.crosshair"));
    desk.key({key::enter});
    EXPECT_EQ(state().corners.size(), 1u);
    steps(key::right, 4);
    steps(key::up, 6);
    desk.key({key::enter});
    ASSERT_EQ(edits<AddZone>().size(), 1u);
    EXPECT_NEAR(zone(0).length, 2, 1e-4f);
    EXPECT_NEAR(zone(0).width, 3, 1e-4f);
    EXPECT_NEAR(zone(0).x, from.x + 1, 1e-4f);
    EXPECT_EQ(state().tool, SceneInputTool::hand);
    EXPECT_FALSE(state().crosshair);
}

TEST_F(SceneInputTools, DrawBoxPolygonLampAndTapeByKeysAlone) {
    desk.click("tool.box");
    steps(key::left, 1);
    desk.key({key::enter});
    steps(key::up, 2), steps(key::left, 2);
    desk.key({key::enter});
    ASSERT_EQ(edits<AddObstacle>().size(), 1u);
    EXPECT_NEAR(std::get<AddObstacle>(edits<AddObstacle>()[0].command).object.width, 1, 1e-4f);

    desk.click("tool.polygon");
    steps(key::up, 1);
    desk.key({key::enter});
    steps(key::right, 4);
    desk.key({key::enter});
    steps(key::up, 4);
    desk.key({key::enter});
    desk.key({key::enter});  // the same corner again closes it
    ASSERT_EQ(edits<AddObstacle>().size(), 2u);
    EXPECT_EQ(std::get<AddObstacle>(edits<AddObstacle>()[1].command).object.corners.size(), 3u);

    desk.click("tool.lamp");
    steps(key::down, 1);
    desk.key({key::enter});
    EXPECT_EQ(edits<AddSource>().size(), 1u);

    desk.click("tool.tape");
    steps(key::up, 1);
    for (int i = 0; i < 3; ++i) {
        desk.key({key::enter});
        if (i < 2) steps(key::right, 2);
    }
    desk.key({key::enter});
    EXPECT_EQ(edits<AddZone>().size(), 2u);
}

TEST_F(SceneInputTools, MeasureByKeysAlone) {
    desk.click("tool.ruler");
    steps(key::right, 1);
    desk.key({key::enter});
    steps(key::up, 4);
    desk.key({key::enter});
    ASSERT_EQ(state().corners.size(), 2u);
    EXPECT_NEAR(state().corners[1].y - state().corners[0].y, 2, 1e-4f);
    desk.key({key::enter});
    EXPECT_EQ(state().corners.size(), 1u) << "another measurement begins";
}

TEST_F(SceneInputTools, PointWithTheMouseAgainWhenItMoves) {
    desk.click("tool.zone");
    steps(key::right, 1);
    EXPECT_TRUE(state().crosshair);
    EXPECT_TRUE(takes_arrows(desk.view, state(), false)) << "the camera stands still";
    point({2, 2});
    EXPECT_FALSE(state().crosshair);
    desk.key({key::escape});
    EXPECT_FALSE(takes_arrows(desk.view, state(), false));
}

TEST_F(SceneInputTools, KeepTheCrosshairWithinTheArena) {
    desk.click("tool.lamp");
    for (int i = 0; i < 60; ++i) desk.key({key::right});
    EXPECT_FLOAT_EQ(state().crosshair->x, desk.now.scene->arena.width / 2);
}

TEST_F(SceneInputTools, ContinueALineFromTheMenuOfTheFloor) {
    point({1, 3});
    desk.button(1, true), desk.frame(), desk.button(1, false), desk.frame();
    desk.frame(2);
    desk.click("menu.add.tape");
    EXPECT_EQ(state().tool, SceneInputTool::tape);
    ASSERT_EQ(state().corners.size(), 1u);
    click({3, 3});
    desk.key({key::enter});
    EXPECT_NEAR(zone(0).length, 2, 2 * a_pixel);
}

}  // namespace
TEST(ToolPalette, ShowsAFingerTheChosenToolOnAnUprightPageUntilItIsOpened) {
    Desk desk(512, 1024, 1, true);
    desk.view.program.touch = true, desk.view.program.finger = 57;
    CameraView camera_view;
    desk.view.camera_view = &camera_view;
    desk.frame(2);
    camera_view = look(Camera{}, desk.now.scene->arena, nullptr, {0, 0, 512, 1024}, desk.layout.scene);
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("tool.lamp"));
    EXPECT_GE(desk.where("tools").h, 57);
    EXPECT_LE(desk.layout.scene.x, 12) << "the scene has the width";
    desk.click("tools");
    desk.frame(2);
    for (const char* id :
         {"tool.hand", "tool.lamp", "tool.box", "tool.polygon", "tool.zone", "tool.tape", "tool.ruler"}) {
        const Rect at = desk.where(id);
        EXPECT_EQ(at.y, desk.where("tool.hand").y) << id;
        EXPECT_LE(at.x + at.w, 512) << id;
    }
    desk.click("tool.lamp");
    desk.frame(2);
    EXPECT_EQ(desk.panels.scene_input.tool, SceneInputTool::lamp);
    EXPECT_FALSE(desk.anchors.find("tool.lamp"));
    desk.view.program.touch = false, desk.view.program.finger = 0;
    desk.frame(2);
    EXPECT_TRUE(desk.anchors.find("tool.lamp")) << "the mouse has all";
}

}  // namespace braitenlab::tests::scene_input_tools_test

// Mouse input in the scene without a window.
#include "ui/scene_input/scene_input.h"

#include <cmath>

#include "core/maths/angle.h"
#include "hold_shift.h"
#include "scene_on_desk.h"
#include "ui/scene_input/edits.h"

namespace braitenlab::tests::stage_test {

using namespace ui;
namespace {

using maths::vec2;

using SceneInput = SceneOnDesk;

TEST_F(SceneInput, FindsTheObjectUnderThePointerAndSetsTheCursor) {
    EXPECT_FALSE(scene_input().hovered);
    EXPECT_EQ(ImGui::GetMouseCursor(), ImGuiMouseCursor_Arrow);
    point({-3, 6});
    EXPECT_EQ(scene_input().hovered.object, lamp);
    EXPECT_EQ(ImGui::GetMouseCursor(), ImGuiMouseCursor_Hand);
    point({3, 6});
    EXPECT_EQ(scene_input().hovered.object, box);
    point({-6, 0});
    EXPECT_EQ(scene_input().hovered.object, vehicle_object(0));
}

// A thin wall between two lines of the colour of text would look black in the light theme.
TEST_F(SceneInput, MarksWhatIsUnderThePointerInTheColourOfTheAccent) {
    for (const Theme theme : {Theme::dark, Theme::light}) {
        desk.view.program.theme = theme;
        const auto count = [](Colour colour) {
            const ImU32 rgb = paint(colour) & 0xFFFFFF;
            int vertices = 0;
            for (const ImDrawVert& vertex : ImGui::GetBackgroundDrawList()->VtxBuffer)
                vertices += (vertex.col & 0xFFFFFF) == rgb;
            return vertices;
        };
        rest_pointer();
        const int accent = count(palette(theme).accent), second = count(palette(theme).second_text);
        point({3, 6});
        EXPECT_GT(count(palette(theme).accent), accent);
        EXPECT_EQ(count(palette(theme).second_text), second);
    }
}

TEST_F(SceneInput, SelectsByAClickAndMovesNothing) {
    click({-4.5f, 0});
    ASSERT_EQ(requests<SelectRequest>().size(), 1u);
    EXPECT_EQ(requests<SelectRequest>()[0].vehicle, 1);
    click({3, 6});
    ASSERT_EQ(requests<TakeRequest>().size(), 1u);
    EXPECT_EQ(requests<TakeRequest>()[0].object, box);
    EXPECT_TRUE(desk.edits().empty());
}

TEST_F(SceneInput, DeselectsALampOnAClickOnTheFloor) {
    take(lamp);
    click({0, 3});
    ASSERT_EQ(requests<TakeRequest>().size(), 1u);
    EXPECT_FALSE(requests<TakeRequest>()[0].object);
}

TEST_F(SceneInput, DragsAVehicleByTheGrabbedPointInOneGesture) {
    hold({-6.1f, 0}, {-6.1f, 3});
    const auto moves = commands<MoveVehicle>();
    ASSERT_GE(moves.size(), 2u);
    EXPECT_NEAR(moves.back().x, -6, a_pixel) << "it does not jump to the pointer";
    EXPECT_NEAR(moves.back().y, 3, a_pixel);
    EXPECT_EQ(desk.edits().front().gesture, desk.edits().back().gesture);
    EXPECT_GE(desk.edits().front().gesture, gestures::viewport);
    release();
    const auto first = desk.edits().back().gesture;
    hold({-3, 6}, {-3, 8});
    EXPECT_NE(desk.edits().back().gesture, first) << "a second drag is a second step";
    EXPECT_NEAR(commands<MoveSource>().back().y, 8, a_pixel);
}

TEST_F(SceneInput, PutsObjectsAtWholeMillimetres) {
    hold({-3, 6}, {-1.23456f, 7.65432f});
    const MoveSource to = commands<MoveSource>().back();
    EXPECT_EQ(to.x, std::round(to.x * 1000) / 1000);
    EXPECT_EQ(to.y, std::round(to.y * 1000) / 1000);
    EXPECT_NEAR(to.x, -1.23456f, a_pixel);
}

TEST_F(SceneInput, HoldsADraggedVehicleAgainstItsBrain) {
    hold({-6, 0}, {-6, 3});
    const auto before = commands<MoveVehicle>().size();
    desk.now.vehicles[0].x = -5.5f;  // a few ticks later
    desk.frame();
    ASSERT_GT(commands<MoveVehicle>().size(), before);
    EXPECT_NEAR(commands<MoveVehicle>().back().x, -6, a_pixel);
}

TEST_F(SceneInput, MovesTheStartOfAVehicleOnlyBeforeTheFirstTick) {
    desk.now.vehicles[0].start = 0;
    Scene scene = *desk.now.scene;
    scene.starts = {{.name = "it", .kind = "k", .x = -6, .facing = "lamp", .place_spread = 1, .heading_spread = 1}};
    desk.now.scene = std::make_shared<const Scene>(scene);
    desk.now.tick = 0;
    hold({-6, 0}, {-6, 3});
    EXPECT_TRUE(commands<EditStart>().empty()) << "no new start during a drag: Esc can still cancel it";
    release();
    ASSERT_EQ(commands<EditStart>().size(), 1u);
    const Start start = commands<EditStart>()[0].to;
    EXPECT_NEAR(start.y, 3, a_pixel);
    EXPECT_EQ(start.facing, "");
    EXPECT_EQ(start.place_spread + start.heading_spread, 0);
    EXPECT_EQ(desk.edits().front().gesture, desk.edits().back().gesture) << "one step of undo";
    desk.now.tick = 1;
    hold({-6, 0}, {-6, 3});
    release();
    EXPECT_EQ(commands<EditStart>().size(), 1u);
}

TEST_F(SceneInput, KeepsObjectsInsideTheArena) {
    hold({3, 6}, {40, 6});
    EXPECT_FLOAT_EQ(commands<MoveObstacle>().back().x, 10);
    release();
    hold({-6, 0}, {-30, 0});
    EXPECT_LT(commands<MoveVehicle>().back().x, -9);
    EXPECT_GT(commands<MoveVehicle>().back().x, -10) << "at least half its width from the wall";
}

TEST_F(SceneInput, RestoresThePositionOnEscapeDuringADrag) {
    hold({3, 6}, {5, 8});
    desk.now.obstacles[0] = {5, 8, 0};
    desk.key({key::escape});
    const MoveObstacle back = commands<MoveObstacle>().back();
    EXPECT_EQ(back, (MoveObstacle{0, 3, 6, 0}));
    EXPECT_EQ(desk.edits().back().gesture, desk.edits().front().gesture) << "the same gesture, so that no step is left";
    const auto count = desk.edits().size();
    point({7, 8});
    release();
    EXPECT_EQ(desk.edits().size(), count);
    EXPECT_TRUE(desk.actions().empty()) << "the scene has used Esc";
}

TEST_F(SceneInput, RotatesTheSelectionByItsRing) {
    take(box);
    point({3.2f, 6.2f});
    desk.frame();
    ASSERT_TRUE(desk.anchors.find("stage.knob"));
    desk.point("stage.knob");
    desk.frame();
    EXPECT_TRUE(scene_input().hovered.handle);
    press();
    point({3, 9});  // from the east to the north of it
    EXPECT_NEAR(commands<MoveObstacle>().back().heading, maths::pi / 2, 0.02f);
    EXPECT_EQ(commands<MoveObstacle>().back().heading, maths::to_degree_steps(commands<MoveObstacle>().back().heading))
        << "a file has whole degrees";
    EXPECT_FLOAT_EQ(commands<MoveObstacle>().back().x, 3);
    hold_shift(true);
    point({2.8f, 9});
    EXPECT_NEAR(std::remainder(commands<MoveObstacle>().back().heading, maths::pi / 12), 0, 1e-4f) << "in steps of 15°";
    hold_shift(false);
}

TEST_F(SceneInput, PrefersAVehicleToTheRingKnobOverIt) {
    point({-5.9f, 0.1f});  // the knob of vehicle 0 is at the edge of vehicle 1
    ASSERT_TRUE(desk.anchors.find("stage.knob"));
    point({-4.5f, 0});
    EXPECT_EQ(scene_input().hovered, (SceneInputHit{vehicle_object(1), false}));
    desk.point("stage.knob");
    desk.frame();
    EXPECT_TRUE(scene_input().hovered.handle);
}

TEST_F(SceneInput, SelectsAZoneByAClickAndTurnsTheViewByADragOfAnUnselectedOne) {
    hold({6, -7}, {7, -7});
    EXPECT_EQ(scene_input().drag.phase, SceneInputPhase::orbit);
    release();
    EXPECT_TRUE(requests<TakeRequest>().empty());
    desk.rest();
    click({6, -7});
    ASSERT_EQ(requests<TakeRequest>().size(), 1u);
    EXPECT_EQ(requests<TakeRequest>()[0].object, pond);
    EXPECT_TRUE(desk.edits().empty());
}

TEST_F(SceneInput, DragsTheSelectedZoneInOneGestureAndEscapeRestoresIt) {
    take(pond);
    hold({6, -7}, {4, -6});
    const auto moves = commands<MoveZone>();
    ASSERT_GE(moves.size(), 2u);
    EXPECT_NEAR(moves.back().x, 4, a_pixel);
    EXPECT_NEAR(moves.back().y, -6, a_pixel);
    EXPECT_EQ(desk.edits().front().gesture, desk.edits().back().gesture);
    Scene scene = *desk.now.scene;
    scene.zones[0].x = 4, scene.zones[0].y = -6;
    desk.now.scene = std::make_shared<const Scene>(scene);
    desk.key({key::escape});
    EXPECT_EQ(commands<MoveZone>().back(), (MoveZone{0, 6, -7, 0}));
}

TEST_F(SceneInput, TurnsAZoneByItsRingAndMovesItByArrowKeys) {
    take(pond);
    point({6.2f, -7});
    desk.frame();
    ASSERT_TRUE(desk.anchors.find("stage.knob"));
    desk.point("stage.knob");
    desk.frame();
    press();
    point({6, -4});
    EXPECT_NEAR(commands<MoveZone>().back().heading, maths::pi / 2, 0.02f);
    release();
    desk.key({key::left});
    EXPECT_NEAR(commands<MoveZone>().back().x, 5.9f, 1e-4f);
}

TEST_F(SceneInput, IgnoresZonesThatAreNotShown) {
    desk.view.settings.overlays.surfaces = false;
    point({6, -7});
    EXPECT_FALSE(scene_input().hovered);
}

TEST_F(SceneInput, GivesADrawnOutlineToItsZoneWhenTheIndexHasChanged) {
    take(pond);
    desk.frame(2);
    desk.click("thing.shape.3");
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    Zone first = scene->zones[0];
    first.name = "first";
    scene->zones.insert(scene->zones.begin(), first);
    desk.now.scene = scene;
    for (const vec2 corner : {vec2{-1, 2}, vec2{2, 2}, vec2{2, 4}}) click(corner);
    desk.key({key::enter});
    ASSERT_FALSE(commands<EditZone>().empty());
    EXPECT_EQ(commands<EditZone>().back().index, 1);
    EXPECT_EQ(commands<EditZone>().back().to.name, scene->zones[1].name);
}

TEST_F(SceneInput, DiscardsWhatIsInProgressWhenAnotherDocumentIsOpened) {
    take(pond);
    desk.frame(2);
    desk.click("thing.shape.3");
    click({-1, 2});
    click({2, 2});
    ASSERT_EQ(scene_input().corners.size(), 2u);
    ++desk.view.run_id;
    desk.frame();
    EXPECT_EQ(scene_input().tool, SceneInputTool::hand);
    EXPECT_TRUE(scene_input().corners.empty());
    click({6, -7}, 1);
    ASSERT_TRUE(scene_input().menu.open);
    ++desk.view.run_id;
    desk.frame();
    EXPECT_FALSE(scene_input().menu.open);
    hold({6, -7}, {3, -7});
    ASSERT_NE(scene_input().drag.phase, SceneInputPhase::idle);
    ++desk.view.run_id;
    desk.all.clear();
    desk.frame(2);
    EXPECT_EQ(scene_input().drag.phase, SceneInputPhase::idle);
    EXPECT_TRUE(desk.edits().empty());
    release();
}

TEST_F(SceneInput, SelectsEverythingInARectangleByShiftAndADrag) {
    hold_shift(true);
    hold({-5, 7.5f}, {5, 4.5f});
    EXPECT_EQ(scene_input().drag.phase, SceneInputPhase::select);
    release();
    hold_shift(false);
    ASSERT_EQ(requests<SelectObjectsRequest>().size(), 1u);
    EXPECT_EQ(requests<SelectObjectsRequest>()[0].objects, (std::vector{lamp, box}));
    EXPECT_TRUE(desk.edits().empty()) << "the drag begins and ends on the floor and moves nothing";
    desk.view.settings.overlays.surfaces = false;
    hold_shift(true);
    hold({9, 9}, {-9, -9});
    release();
    hold_shift(false);
    const auto all = requests<SelectObjectsRequest>().back().objects;
    EXPECT_EQ(all.size(), desk.now.vehicles.size() + 2) << "a zone that is not shown is not selected";
}

TEST_F(SceneInput, AddsToTheSelectionByShiftAndAClickAndTakesAway) {
    take(lamp);
    hold_shift(true);
    click({3, 6});
    ASSERT_EQ(requests<SelectObjectsRequest>().size(), 1u);
    EXPECT_EQ(requests<SelectObjectsRequest>()[0].objects, (std::vector{lamp, box}));
    desk.view.settings.selection.more = {box};
    click({-3, 6});
    EXPECT_EQ(requests<SelectObjectsRequest>().back().objects, std::vector{box});
    hold_shift(false);
    EXPECT_TRUE(requests<TakeRequest>().empty());
}

TEST_F(SceneInput, DragsAllSelectedObjectsInOneGestureAndEscapeRestoresThem) {
    take(lamp);
    desk.view.settings.selection.more = {box, vehicle_object(2)};
    hold({3, 6}, {4, 5});
    EXPECT_NEAR(commands<MoveObstacle>().back().x, 4, a_pixel);
    EXPECT_NEAR(commands<MoveSource>().back().x, -2, a_pixel);
    EXPECT_NEAR(commands<MoveSource>().back().y, 5, a_pixel);
    EXPECT_NEAR(commands<MoveVehicle>().back().x, desk.now.vehicles[2].x + 1, a_pixel);
    EXPECT_EQ(desk.edits().front().gesture, desk.edits().back().gesture);
    EXPECT_TRUE(requests<TakeRequest>().empty()) << "the selection is kept";
    desk.now.sources[0].x = -2, desk.now.obstacles[0].x = 4, desk.now.vehicles[2].x += 1;
    desk.key({key::escape});
    EXPECT_EQ(commands<MoveSource>().back(), (MoveSource{0, -3, 6}));
    EXPECT_EQ(commands<MoveObstacle>().back(), (MoveObstacle{0, 3, 6, 0}));
}

TEST_F(SceneInput, SelectsOneOfSeveralObjectsByAClick) {
    take(lamp);
    desk.frame(2);
    const auto says_several = [&] {
        return std::any_of(desk.written.begin(), desk.written.end(),
                           [](const Written& w) { return w.words == "1 source, 1 obstacle"; });
    };
    EXPECT_FALSE(says_several());
    desk.view.settings.selection.more = {box};
    desk.frame(2);
    EXPECT_TRUE(says_several()) << "the card shows the values of one of them";
    click({3, 6});
    ASSERT_EQ(requests<TakeRequest>().size(), 1u);
    EXPECT_EQ(requests<TakeRequest>()[0].object, box);
    EXPECT_TRUE(desk.edits().empty());
}

TEST_F(SceneInput, SaysOnACardWhatIsSelectedAndWhatCanBeDone) {
    desk.view.settings.selection.vehicle = 0;
    desk.view.settings.selection.more = {vehicle_object(1), vehicle_object(2)};
    desk.frame(3);
    const auto says = [&](std::string_view words) {
        return std::any_of(desk.written.begin(), desk.written.end(),
                           [&](const Written& w) { return w.words.find(words) != w.words.npos; });
    };
    EXPECT_TRUE(desk.anchors.find("card.thing")) << "also for vehicles alone";
    EXPECT_TRUE(says("SELECTION"));
    EXPECT_TRUE(says("3 vehicles"));
    EXPECT_TRUE(says("Ctrl+D, Ctrl+C and Del act on all of them"));
    EXPECT_FALSE(says("Values of"));
    desk.click("thing.erase");
    EXPECT_EQ(desk.actions().back(), Action::erase);
    desk.view.settings.selection.object = lamp;
    desk.view.settings.selection.more = {vehicle_object(1), vehicle_object(2)};
    desk.frame(3);
    EXPECT_TRUE(says("2 vehicles, 1 source"));
    EXPECT_TRUE(says("Values of “" + desk.now.scene->sources[0].name + "” only"));
}

TEST_F(SceneInput, MovesAndTurnsAllSelectedObjectsByKeysAsOneStep) {
    take(box);
    desk.view.settings.selection.more = {lamp, pond};
    desk.key({key::right});
    EXPECT_NEAR(commands<MoveSource>().back().x, -2.9f, 1e-4f);
    EXPECT_NEAR(commands<MoveObstacle>().back().x, 3.1f, 1e-4f);
    EXPECT_NEAR(commands<MoveZone>().back().x, 6.1f, 1e-4f);
    desk.key({'Z'});
    EXPECT_NEAR(commands<MoveZone>().back().heading, maths::radians(5), 1e-4f);
    desk.key({'Z', false, true});
    EXPECT_NEAR(commands<MoveObstacle>().back().heading, -maths::radians(5), 1e-4f);
    EXPECT_EQ(desk.edits().front().gesture, desk.edits().back().gesture);
    point({3.2f, 6.2f});
    EXPECT_FALSE(desk.anchors.find("stage.knob")) << "the ring turns one object";
}

TEST_F(SceneInput, TurnsTheChosenVehicleByAKeyAndNoLamp) {
    desk.now.vehicles[0].heading = maths::radians(-1.3f);
    desk.key({'Z'});
    ASSERT_EQ(commands<MoveVehicle>().size(), 1u);
    EXPECT_EQ(commands<MoveVehicle>()[0].heading, maths::from_degrees(4)) << "a file has whole degrees";
    take(lamp);
    desk.key({'Z'});
    EXPECT_TRUE(commands<MoveSource>().empty());
}

TEST_F(SceneInput, CopiesCutsAndSelectsAllInTheSceneAndPastesAtThePointer) {
    for (const auto& [letter, action] :
         {std::pair{'C', Action::copy}, std::pair{'X', Action::cut}, std::pair{'A', Action::select_all}}) {
        desk.key({letter, true});
        EXPECT_EQ(desk.actions().back(), action);
    }
    point({1, 3});
    desk.key({'V', true});
    ASSERT_EQ(requests<PasteRequest>().size(), 1u);
    EXPECT_NEAR(requests<PasteRequest>()[0].at->x, 1, a_pixel);
    desk.point("card.brain");
    desk.frame();
    desk.key({'V', true});
    EXPECT_FALSE(requests<PasteRequest>()[1].at) << "the pointer is over a card";
}

TEST_F(SceneInput, HasNoRingAroundALamp) {
    take(lamp);
    point({-2.6f, 6});
    desk.frame();
    EXPECT_FALSE(desk.anchors.find("stage.knob"));
}

TEST_F(SceneInput, RotatesTheCameraOnAFreePlace) {
    hold({0, 3}, {1, 3});
    EXPECT_EQ(scene_input().drag.phase, SceneInputPhase::orbit);
    release();
    desk.view.settings.camera.mode = CameraMode::birds_eye;
    hold({0, 3}, {1, 3});
    EXPECT_EQ(scene_input().drag.phase, SceneInputPhase::pan);
    EXPECT_TRUE(desk.edits().empty());
}

TEST_F(SceneInput, DoesNotDragTheVehicleThatTheCameraFollows) {
    desk.view.settings.camera.mode = CameraMode::follow;
    desk.view.settings.selection.vehicle = 0;
    hold({-6, 0}, {-6, 3});
    EXPECT_TRUE(desk.edits().empty());
}

TEST_F(SceneInput, MovesALampByArrowKeysAlongTheGridAndMergesQuickPresses) {
    take(lamp);
    desk.key({key::right});
    EXPECT_EQ(commands<MoveSource>().back(), (MoveSource{0, -2.9f, 6}));
    desk.key({key::up, false, true});
    EXPECT_EQ(commands<MoveSource>().back(), (MoveSource{0, -3, 6.01f}));
    EXPECT_EQ(desk.edits()[0].gesture, desk.edits()[1].gesture);
    desk.frame(90);
    desk.key({key::left});
    EXPECT_NE(desk.edits()[2].gesture, desk.edits()[0].gesture);
}

TEST_F(SceneInput, MovesTheCameraByArrowKeysUnlessALampIsSelectedOrCtrlIsHeld) {
    desk.key({key::right});
    EXPECT_TRUE(desk.edits().empty());
    EXPECT_FALSE(takes_arrows(desk.view, scene_input(), false));
    desk.key({key::right, true});
    EXPECT_NEAR(commands<MoveVehicle>().back().x, -5.9f, 1e-4f);
    take(lamp);
    EXPECT_TRUE(takes_arrows(desk.view, scene_input(), false));
}

TEST_F(SceneInput, AddsALampAtTheClick) {
    desk.click("tool.lamp");
    EXPECT_EQ(scene_input().tool, SceneInputTool::lamp);
    click({1, 3});
    ASSERT_EQ(commands<AddSource>().size(), 1u);
    EXPECT_NEAR(commands<AddSource>()[0].object.x, 1, a_pixel);
    EXPECT_EQ(scene_input().tool, SceneInputTool::hand) << "one object, then the hand tool again";
}

TEST_F(SceneInput, DrawsABoxFromCornerToCorner) {
    desk.click("tool.box");
    hold({-1, 2}, {2, 4});
    release();
    ASSERT_EQ(commands<AddObstacle>().size(), 1u);
    EXPECT_NEAR(commands<AddObstacle>()[0].object.length, 3, 2 * a_pixel);
    EXPECT_NEAR(commands<AddObstacle>()[0].object.width, 2, 2 * a_pixel);
}

TEST_F(SceneInput, DrawsAPolygonByItsCornersAndClosesItWithEnter) {
    desk.click("tool.polygon");
    for (const vec2 corner : {vec2{-1, 2}, vec2{2, 2}, vec2{2, 4}}) click(corner);
    EXPECT_TRUE(desk.edits().empty()) << "no obstacle before the outline is closed";
    desk.key({key::enter});
    ASSERT_EQ(commands<AddObstacle>().size(), 1u);
    EXPECT_EQ(commands<AddObstacle>()[0].object.corners.size(), 3u);
    EXPECT_TRUE(scene_input().corners.empty());
}

TEST_F(SceneInput, ClosesAPolygonByItsFirstCornerOrADoubleClick) {
    desk.click("tool.polygon");
    for (const vec2 corner : {vec2{-1, 2}, vec2{2, 2}, vec2{2, 4}, vec2{-1, 2}}) click(corner);
    EXPECT_EQ(commands<AddObstacle>().size(), 1u);
    desk.click("tool.polygon");
    desk.rest();
    for (const vec2 corner : {vec2{-1, 2}, vec2{2, 2}}) click(corner);
    point({2, 4}), press(), release(), press(), release();
    ASSERT_EQ(commands<AddObstacle>().size(), 2u);
    EXPECT_EQ(commands<AddObstacle>()[1].object.corners.size(), 3u) << "the second click adds no corner";
}

TEST_F(SceneInput, RefusesACornerWithAReasonAndRemovesTheLastOne) {
    desk.click("tool.polygon");
    for (const vec2 corner : {vec2{0, 2}, vec2{2, 2}, vec2{2, 4}}) click(corner);
    point({1, 1}), press();
    EXPECT_EQ(scene_input().refusal.key, "scene_input.refused.crosses");
    release();
    EXPECT_EQ(scene_input().corners.size(), 3u);
    desk.key({key::backspace});
    EXPECT_EQ(scene_input().corners.size(), 2u);
    desk.key({key::enter});
    EXPECT_EQ(scene_input().refusal.key, "scene_input.refused.too_few");
    EXPECT_TRUE(desk.edits().empty());
}

TEST_F(SceneInput, CancelsDrawingByEscapeStepByStep) {
    desk.click("tool.polygon");
    click({0, 2});
    desk.key({key::escape});
    EXPECT_TRUE(scene_input().corners.empty());
    EXPECT_EQ(scene_input().tool, SceneInputTool::polygon);
    desk.key({key::escape});
    EXPECT_EQ(scene_input().tool, SceneInputTool::hand);
    EXPECT_TRUE(desk.actions().empty());
    desk.key({key::escape});
    EXPECT_EQ(desk.actions().size(), 1u) << "the next Esc goes to the window";
}

TEST_F(SceneInput, KeepsAddedAndDuplicatedObjectsOffTheWallsAndOtherObjects) {
    const float rim = desk.now.scene->arena.width / 2;
    click({rim - 0.05f, 3}, 1);
    desk.click("menu.add.vehicle.1");
    ASSERT_EQ(commands<AddVehicle>().size(), 1u);
    EXPECT_LT(commands<AddVehicle>()[0].at->x, rim - 0.5f);
    click({-6.0f, -0.9f}, 1);  // before a vehicle, on the floor
    desk.click("menu.add.vehicle.1");
    ASSERT_EQ(commands<AddVehicle>().size(), 2u);
    const auto clear = [&](vec2 at) {
        for (const VehicleView& v : desk.now.vehicles)
            if (maths::distance(at, {v.x, v.y}) < 1.1f) return false;
        return true;
    };
    EXPECT_TRUE(clear({commands<AddVehicle>()[1].at->x, commands<AddVehicle>()[1].at->y}));
    const auto copy = copy_of(desk.now, vehicle_object(2));
    const Pose at = *std::get<AddVehicle>(*copy).at;
    EXPECT_TRUE(clear({at.x, at.y})) << "another vehicle is 0.8 m beside it";
}

TEST_F(SceneInput, IsInactiveWhileTheWiringIsOpen) {
    desk.view.mode = Mode::wiring;
    point({-6, 0});
    EXPECT_FALSE(scene_input().hovered);
    desk.key({key::right, true});
    EXPECT_TRUE(desk.edits().empty());
}

TEST_F(SceneInput, TakesAHandleFartherAwayWithAFinger) {
    take(box);
    point({3.2f, 6.2f});
    desk.frame();
    const Rect knob = desk.where("stage.knob");
    const auto beside = [&] {  // to the right of the knob, away from the ring
        desk.point(knob.x + knob.w / 2 + 17, knob.y + knob.h / 2);
        desk.frame(2);
        return scene_input().hovered.handle;
    };
    EXPECT_FALSE(beside());
    desk.view.program.touch = true;
    EXPECT_TRUE(beside());
    EXPECT_GT(desk.where("stage.knob").w, 1.5f * knob.w);
}

}  // namespace
}  // namespace braitenlab::tests::stage_test

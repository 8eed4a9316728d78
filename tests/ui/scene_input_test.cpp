// Mouse input in the scene without a window: synthetic Dear ImGui mouse events over a hand-made snapshot.
#include "ui/scene_input/scene_input.h"

#include <cmath>

#include "core/maths/angle.h"
#include "desk.h"
#include "ui/scene_input/edits.h"

namespace braitenlab::tests::stage_test {

using namespace ui;
namespace {

using maths::vec2;

constexpr float a_pixel = 0.05f;  // m: Dear ImGui rounds the mouse to whole pixels

// A desk with a scene for the mouse: four predators in the middle, a lamp and a box to the north.
struct SceneInput : testing::Test {
    SceneInput() {
        auto scene = std::make_shared<Scene>(*desk.now.scene);
        scene->sources.push_back({.name = "lamp", .x = -3, .y = 6});
        scene->obstacles.push_back({.name = "box", .x = 3, .y = 6, .length = 2, .width = 1});
        scene->zones.push_back({.name = "pond", .x = 6, .y = -7, .length = 3, .width = 2, .surface = Surface::ice});
        desk.now.scene = scene;
        desk.now.sources.push_back({0, Channel::light, -3, 6, 1});
        desk.now.obstacles.push_back({3, 6, 0});
        for (const Kind& kind : scene->kinds) desk.now.kind_brains.push_back(std::make_shared<BrainGraph>(kind.brain));
        for (std::size_t i = 0; i < desk.now.vehicles.size(); ++i) {
            desk.now.vehicles[i].x = -6 + 1.5f * static_cast<float>(i % 8);
            desk.now.vehicles[i].y = i < 8 ? 0.0f : -4.0f;
        }
        desk.view.camera_view = &camera_view;
        desk.frame(2);  // cards are measured in the first frames
        camera_view = look(Camera{}, scene->arena, nullptr, {0, 0, 1280, 800}, desk.layout.scene);
        rest_pointer();
    }

    vec2 pixel(vec2 place) const { return *project(camera_view, place); }
    void point(vec2 place) {
        desk.point(pixel(place).x, pixel(place).y);
        desk.frame();
    }
    void rest_pointer() { point({0, 3}); }
    void press(int button = 0) { desk.button(button, true), desk.frame(); }
    void release(int button = 0) { desk.button(button, false), desk.frame(); }
    void click(vec2 place, int button = 0) {
        point(place), press(button), release(button);
        desk.rest();
    }
    // Presses at one place and moves to another in steps.
    void hold(vec2 from, vec2 to) {
        point(from), press();
        for (int i = 1; i <= 4; ++i) point(from + (to - from) * (static_cast<float>(i) / 4));
    }

    template <class C>
    std::vector<C> commands() const {
        std::vector<C> found;
        for (const EditRequest& edit : desk.edits())
            if (const auto* command = std::get_if<C>(&edit.command)) found.push_back(*command);
        return found;
    }
    template <class R>
    std::vector<R> requests() const {
        std::vector<R> found;
        for (const Request& request : desk.all)
            if (const auto* one = std::get_if<R>(&request)) found.push_back(*one);
        return found;
    }
    SceneInputState& scene_input() { return desk.panels.scene_input; }
    // Applies the requests, as the lab does.
    void take(SceneObject object) { desk.view.settings.selection.object = object, desk.frame(); }

    Desk desk;
    CameraView camera_view = look(Camera{}, Arena{}, nullptr, {0, 0, 1280, 800}, {336, 64, 576, 680});
    const SceneObject lamp{SceneObjectKind::source, 0}, box{SceneObjectKind::obstacle, 0},
        pond{SceneObjectKind::zone, 0};
};

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
    EXPECT_FLOAT_EQ(commands<MoveObstacle>().back().x, 3);
    ImGui::GetIO().KeyShift = true;
    point({2.8f, 9});
    EXPECT_NEAR(std::remainder(commands<MoveObstacle>().back().heading, maths::pi / 12), 0, 1e-4f) << "in steps of 15°";
    ImGui::GetIO().KeyShift = false;
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

TEST_F(SceneInput, OffersAZoneItsOwnMenuAndWhatCanBeAddedOnIt) {
    click({6, -7}, 1);
    EXPECT_EQ(scene_input().menu.object, pond);
    desk.click("menu.add.light");
    EXPECT_NEAR(commands<AddSource>().back().source.x, 6, a_pixel);
    click({6, -7}, 1);
    desk.click("menu.erase");
    EXPECT_EQ(commands<RemoveZone>().size(), 1u);
    click({6, -7}, 1);
    desk.click("menu.duplicate");
    EXPECT_EQ(commands<AddZone>().back().zone.surface, Surface::ice);
    click({0, 3}, 1);
    desk.click("menu.add.zone");
    EXPECT_NEAR(commands<AddZone>().back().zone.y, 3, a_pixel);
}

TEST_F(SceneInput, EditsAZoneOnItsCard) {
    take(pond);
    desk.frame(2);
    desk.click("thing.surface.sand");
    EXPECT_EQ(commands<EditZone>().back().to.surface, Surface::sand);
    EXPECT_EQ(commands<EditZone>().back().to.length, 3);
    desk.click("thing.shape.2");
    EXPECT_TRUE(commands<EditZone>().back().to.round);
    const auto edits = commands<EditZone>().size();
    for (const char* slider : {"thing.length", "thing.width", "thing.heading", "thing.recharge", "thing.wind_x",
                               "thing.wind_y", "thing.slope", "thing.pull"})
        EXPECT_TRUE(desk.anchors.find(slider)) << slider;
    desk.click("thing.shape.3");
    EXPECT_EQ(scene_input().tool, SceneInputTool::polygon);
    for (const vec2 corner : {vec2{-1, 2}, vec2{2, 2}, vec2{2, 4}}) click(corner);
    desk.key({key::enter});
    ASSERT_EQ(commands<EditZone>().size(), edits + 1);
    EXPECT_EQ(commands<EditZone>().back().zone, 0);
    EXPECT_EQ(commands<EditZone>().back().to.corners.size(), 3u);
    EXPECT_TRUE(commands<AddObstacle>().empty()) << "the outline is that of the zone";
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
    EXPECT_EQ(commands<EditZone>().back().zone, 1);
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
    ImGui::GetIO().KeyShift = true;
    hold({-5, 7.5f}, {5, 4.5f});
    EXPECT_EQ(scene_input().drag.phase, SceneInputPhase::select);
    release();
    ImGui::GetIO().KeyShift = false;
    ASSERT_EQ(requests<SelectObjectsRequest>().size(), 1u);
    EXPECT_EQ(requests<SelectObjectsRequest>()[0].objects, (std::vector{lamp, box}));
    EXPECT_TRUE(desk.edits().empty()) << "the drag begins and ends on the floor and moves nothing";
    desk.view.settings.overlays.surfaces = false;
    ImGui::GetIO().KeyShift = true;
    hold({9, 9}, {-9, -9});
    release();
    ImGui::GetIO().KeyShift = false;
    const auto all = requests<SelectObjectsRequest>().back().objects;
    EXPECT_EQ(all.size(), desk.now.vehicles.size() + 2) << "a zone that is not shown is not selected";
}

TEST_F(SceneInput, AddsToTheSelectionByShiftAndAClickAndTakesAway) {
    take(lamp);
    ImGui::GetIO().KeyShift = true;
    click({3, 6});
    ASSERT_EQ(requests<SelectObjectsRequest>().size(), 1u);
    EXPECT_EQ(requests<SelectObjectsRequest>()[0].objects, (std::vector{lamp, box}));
    desk.view.settings.selection.more = {box};
    click({-3, 6});
    EXPECT_EQ(requests<SelectObjectsRequest>().back().objects, std::vector{box});
    ImGui::GetIO().KeyShift = false;
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
                           [](const Written& w) { return w.words.starts_with("2 objects"); });
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
    desk.key({'Z'});
    ASSERT_EQ(commands<MoveVehicle>().size(), 1u);
    EXPECT_NEAR(commands<MoveVehicle>()[0].heading, maths::radians(5), 1e-4f);
    take(lamp);
    desk.key({'Z'});
    EXPECT_TRUE(commands<MoveSource>().empty());
}

TEST_F(SceneInput, OpensTheMenuOfTheFloorInTheMiddleOfTheViewByAKey) {
    desk.key({'H'});
    desk.frame(2);
    ASSERT_TRUE(scene_input().menu.open);
    EXPECT_FALSE(scene_input().menu.object);
    EXPECT_LT(maths::length(scene_input().menu.place), 4);
    desk.key({key::down});  // past the first kind
    EXPECT_EQ(desk.panels.keyboard.focus, "menu.add.vehicle.1");
    desk.key({key::enter});
    desk.frame(2);
    EXPECT_EQ(commands<AddVehicle>().size(), 1u);
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
    EXPECT_NEAR(commands<AddSource>()[0].source.x, 1, a_pixel);
    EXPECT_EQ(scene_input().tool, SceneInputTool::hand) << "one object, then the hand tool again";
}

TEST_F(SceneInput, DrawsABoxFromCornerToCorner) {
    desk.click("tool.box");
    hold({-1, 2}, {2, 4});
    release();
    ASSERT_EQ(commands<AddObstacle>().size(), 1u);
    EXPECT_NEAR(commands<AddObstacle>()[0].obstacle.length, 3, 2 * a_pixel);
    EXPECT_NEAR(commands<AddObstacle>()[0].obstacle.width, 2, 2 * a_pixel);
}

TEST_F(SceneInput, DrawsAPolygonByItsCornersAndClosesItWithEnter) {
    desk.click("tool.polygon");
    for (const vec2 corner : {vec2{-1, 2}, vec2{2, 2}, vec2{2, 4}}) click(corner);
    EXPECT_TRUE(desk.edits().empty()) << "no obstacle before the outline is closed";
    desk.key({key::enter});
    ASSERT_EQ(commands<AddObstacle>().size(), 1u);
    EXPECT_EQ(commands<AddObstacle>()[0].obstacle.corners.size(), 3u);
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
    EXPECT_EQ(commands<AddObstacle>()[1].obstacle.corners.size(), 3u) << "the second click adds no corner";
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
    click({-6.0f, 0.9f}, 1);  // beside a vehicle, on the floor
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

TEST_F(SceneInput, IgnoresTheClickThatClosesAMenu) {
    click({0, 3}, 1);
    ASSERT_TRUE(scene_input().menu.open);
    desk.all.clear();
    click({-3, 6});  // a lamp
    EXPECT_FALSE(scene_input().menu.open);
    EXPECT_TRUE(desk.all.empty());
    desk.key({'E'});
    desk.frame(3);
    ASSERT_EQ(desk.panels.menu_bar.open, "view");
    click({-3, 6});
    EXPECT_EQ(desk.panels.menu_bar.open, "");
    EXPECT_TRUE(desk.all.empty());
    click({-3, 6});
    EXPECT_FALSE(desk.all.empty());
}

TEST_F(SceneInput, AddsObjectsAtThePositionOfTheMenu) {
    click({1, 3}, 1);
    desk.click("menu.add.vehicle.1");
    const auto added = commands<AddVehicle>();
    ASSERT_EQ(added.size(), 1u);
    EXPECT_EQ(added[0].kind, 1);
    EXPECT_NEAR(added[0].at->x, 1, a_pixel);
    EXPECT_FALSE(scene_input().menu.open);
    click({1, 3}, 1);
    desk.click("menu.add.smell");
    EXPECT_EQ(commands<AddSource>().back().source.channel, Channel::smell);
    click({1, 3}, 1);
    desk.click("menu.add.polygon");
    EXPECT_EQ(scene_input().tool, SceneInputTool::polygon);
    EXPECT_EQ(scene_input().corners.size(), 1u);
}

TEST_F(SceneInput, ExecutesTheMenuOfAVehicle) {
    click({-4.5f, 0}, 1);
    EXPECT_EQ(scene_input().menu.object, vehicle_object(1));
    desk.click("menu.drive");
    EXPECT_EQ(requests<SelectRequest>().back().vehicle, 1);
    EXPECT_EQ(desk.actions().back(), Action::drive);
    click({-4.5f, 0}, 1);
    desk.click("menu.duplicate");
    EXPECT_EQ(commands<AddVehicle>().back().kind, desk.now.vehicles[1].kind);
    click({-4.5f, 0}, 1);
    desk.click("menu.erase");
    EXPECT_EQ(commands<RemoveVehicle>().back().vehicle, 1);
    click({-4.5f, 0}, 1);
    desk.click("menu.brains");
    desk.frame(2);
    bool says_whose = false;
    for (const Written& w : desk.written) says_whose |= w.words.ends_with("2  ·  Another brain");
    EXPECT_TRUE(says_whose);
    desk.click("menu.brain.2a-coward");
    EXPECT_EQ(commands<SetBrain>().back().target, (Target{1, -1}));
}

TEST_F(SceneInput, MenuCanBeUsedByKeysAlone) {
    desk.key({key::menu});
    desk.frame(3);
    ASSERT_TRUE(scene_input().menu.open);
    EXPECT_EQ(desk.panels.keyboard.focus, "menu.brains");
    desk.key({key::up});
    EXPECT_EQ(desk.panels.keyboard.focus, "menu.erase");
    desk.key({key::enter});
    desk.frame(2);
    EXPECT_EQ(commands<RemoveVehicle>().size(), 1u);
    EXPECT_FALSE(scene_input().menu.open);
    desk.key({key::menu});
    desk.frame(3);
    desk.key({key::escape});
    desk.frame(2);
    EXPECT_FALSE(scene_input().menu.open);
}

TEST_F(SceneInput, IsInactiveWhileTheWiringIsOpen) {
    desk.view.mode = Mode::wiring;
    point({-6, 0});
    EXPECT_FALSE(scene_input().hovered);
    desk.key({key::right, true});
    EXPECT_TRUE(desk.edits().empty());
}

TEST_F(SceneInput, CardChangesTheValuesOfALampWithOneGesturePerDrag) {
    take(lamp);
    desk.frame(2);
    desk.point("thing.strength", 0.5f);
    desk.frame(2);
    press();
    desk.point("thing.strength", 0.45f);
    desk.frame();
    desk.point("thing.strength", 0.4f);
    desk.frame();
    release();
    const auto edits = commands<EditSource>();
    ASSERT_GE(edits.size(), 2u);
    EXPECT_LT(edits.back().to.strength, edits.front().to.strength);
    EXPECT_EQ(desk.edits().front().gesture, desk.edits().back().gesture);
    EXPECT_EQ(edits.back().to.x, -3) << "other values are unchanged";
    desk.click("thing.channel.heat");
    EXPECT_EQ(commands<EditSource>().back().to.channel, Channel::heat);
    desk.click("thing.solid.2");
    EXPECT_TRUE(commands<EditSource>().back().to.solid);
}

TEST_F(SceneInput, CardEditsAnObstacleAtItsPresentPosition) {
    desk.now.obstacles[0] = {4, 5, 0};  // pushed
    take(box);
    desk.frame(2);
    desk.click("thing.length", 0, 0.6f);
    const auto edits = commands<EditObstacle>();
    ASSERT_GE(edits.size(), 1u);
    EXPECT_NE(edits.back().to.length, 2);
    EXPECT_EQ(edits.back().to.x, 4);
    desk.click("thing.erase");
    ASSERT_EQ(desk.actions().size(), 1u);
    EXPECT_EQ(desk.actions()[0], Action::erase);
}

}  // namespace
}  // namespace braitenlab::tests::stage_test

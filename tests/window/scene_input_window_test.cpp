// Mouse input in the scene: dragging, drawing, the context menu, and undo.
#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

#include "tests/window/lab_window.h"

namespace braitenlab::tests::stage_window_test {
namespace {

bool wait_for(const std::function<bool()>& holds, double patience = 5) {
    return LabWindow::eventually(holds, patience);
}

Point place(const Json& thing) {
    return {static_cast<int>(thing["at"][0].get<double>()), static_cast<int>(thing["at"][1].get<double>())};
}
Point vehicle(const Json& state, std::size_t i) { return place(state["vehicles"][i]); }
Point vehicle(const LabWindow& lab, std::size_t i) { return vehicle(lab.state(), i); }
Point source(const LabWindow& lab, std::size_t i) { return place(lab.state()["sources"][i]); }

// Where the first obstacle is in the window, once the camera has come to rest.
Point obstacle_at_rest(const LabWindow& lab) {
    const auto now = [&] { return place(lab.state()["obstacles"][0]); };
    Point at = now();
    EXPECT_TRUE(wait_for([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        const Point before = std::exchange(at, now());
        return before.x == at.x && before.y == at.y;
    }));
    return at;
}

void right_click(const LabWindow& lab, Point at) {
    lab.move(at);
    lab.press(3), lab.release(3);
}

void press_at(const LabWindow& lab, Point at) {
    lab.move(at);
    lab.press();
}

void drag(const LabWindow& lab, Point from, Point to) {
    press_at(lab, from);
    for (int i = 1; i <= 4; ++i) lab.move({from.x + (to.x - from.x) * i / 4, from.y + (to.y - from.y) * i / 4});
    lab.release();
}

void choose_tool(const LabWindow& lab, const std::string& name) {
    lab.move(lab.at("tool." + name));
    lab.press(), lab.release();
    EXPECT_TRUE(wait_for([&] { return lab.state()["tool"] == name; }));
}

TEST(SceneInputWindow, DragsAVehicleWhilePlayingAndUndoRestoresIt) {
    LabWindow lab({"2a-coward", "--size", "1280x800", "--set", "kind.coward.brain.LM=0", "--set",
                   "kind.coward.brain.RM=0", "--set", "kind.coward.brain.LL=0", "--set", "kind.coward.brain.RR=0",
                   "--play"});
    const Json before = lab.state()["vehicles"][0];
    const Point from = place(before);
    drag(lab, from, {from.x + 70, from.y - 50});
    EXPECT_TRUE(wait_for([&] { return lab.state()["undo_depth"] == 1; }));
    const Json after = lab.state()["vehicles"][0];
    EXPECT_GT(after["x"].get<double>(), before["x"].get<double>() + 0.5);
    EXPECT_GT(after["y"].get<double>(), before["y"].get<double>() + 0.5);
    EXPECT_EQ(lab.state()["mode"], "playing");
    lab.key("ctrl+z");
    EXPECT_TRUE(wait_for(
        [&] { return std::abs(lab.state()["vehicles"][0]["x"].get<double>() - before["x"].get<double>()) < 0.05; }));
}

TEST(SceneInputWindow, AClickOnTheTrailTellsTheCauseOfThatMoment) {
    LabWindow lab({"2b-aggressor", "--size", "1280x800"});
    lab.key("Tab");
    EXPECT_TRUE(wait_for([&] { return lab.state()["selected"] == 0; }));
    lab.key("space");
    EXPECT_TRUE(wait_for([&] { return lab.state()["tick"].get<int>() > 60; }, 15));
    lab.key("space");
    EXPECT_TRUE(wait_for([&] { return lab.state()["mode"] == "paused"; }));
    const Json before = lab.state();
    lab.key("space");
    const int then = before["tick"].get<int>();
    EXPECT_TRUE(wait_for([&] { return lab.state()["tick"].get<int>() > then + 90; }, 15));
    lab.click(vehicle(before, 0));
    EXPECT_TRUE(wait_for([&] { return !lab.state()["why"].is_null(); }));
    const Json state = lab.state();
    EXPECT_EQ(state["mode"], "paused");
    EXPECT_NEAR(state["tick"].get<int>(), then, 12) << "the vehicle is back where it was";
}

TEST(SceneInputWindow, HoldsADraggedVehicleWhilePlaying) {
    LabWindow lab({"2a-coward", "--size", "1280x800"});
    const Point from = vehicle(lab, 0), to{from.x + 40, from.y + 60};
    press_at(lab, from);
    lab.move({from.x + 20, from.y + 30});
    lab.move(to);
    EXPECT_TRUE(wait_for([&] { return std::hypot(vehicle(lab, 0).x - to.x, vehicle(lab, 0).y - to.y) < 5; }));
    for (int i = 0; i < 3; ++i) lab.key("minus");  // slow, so that a long frame has few ticks
    lab.key("space");
    EXPECT_TRUE(wait_for([&] { return lab.state()["tick"].get<int>() > 12; })) << "time passes";
    EXPECT_LT(std::hypot(vehicle(lab, 0).x - to.x, vehicle(lab, 0).y - to.y), 25) << "and it stays under the pointer";
    lab.release();
}

TEST(SceneInputWindow, DragsALampAndRestoresItOnEscape) {
    LabWindow lab({"2a-coward", "--size", "1280x800"});
    const Json before = lab.state()["sources"];
    const Point from = source(lab, 0);
    drag(lab, from, {from.x - 60, from.y + 40});
    EXPECT_TRUE(wait_for([&] { return lab.state()["undo_depth"] == 1; }));
    EXPECT_EQ(lab.state()["thing"]["kind"], "source");
    EXPECT_NE(lab.state()["sources"], before);
    lab.key("ctrl+z");
    EXPECT_TRUE(wait_for([&] { return lab.state()["sources"] == before; }));

    press_at(lab, from);
    lab.move({from.x + 30, from.y});
    lab.move({from.x + 60, from.y});
    EXPECT_TRUE(wait_for([&] { return lab.state()["sources"] != before; }));
    lab.key("Escape");
    EXPECT_TRUE(wait_for([&] { return lab.state()["sources"] == before; }));
    lab.move({from.x + 90, from.y});
    lab.release();
    EXPECT_EQ(lab.state()["sources"], before);
    EXPECT_EQ(lab.state()["undo_depth"], 0) << "no edit was made";
}

TEST(SceneInputWindow, DragsAWaypointAsOneStepOfUndo) {
    LabWindow lab({"convoy", "--size", "1280x800"});
    const auto is_near = [&](Point wanted) {
        const Point at = lab.at("handle.waypoint.5");
        return std::hypot(at.x - wanted.x, at.y - wanted.y) < 3;
    };
    const Point from = lab.at("handle.waypoint.5"), to{from.x + 40, from.y + 50};
    lab.drag(from, to);
    EXPECT_TRUE(wait_for([&] { return is_near(to); }));
    EXPECT_EQ(lab.state()["undo_depth"], 1);
    lab.key("ctrl+z");
    EXPECT_TRUE(wait_for([&] { return is_near(from); }));
    EXPECT_EQ(lab.state()["undo_depth"], 0);
}

TEST(SceneInputWindow, HighlightsTheObjectThatAClickSelects) {
    LabWindow lab({"2a-coward", "--size", "1280x800"});
    lab.move(source(lab, 0));
    EXPECT_TRUE(wait_for([&] { return lab.state()["hovered"]["kind"] == "source"; }));
    EXPECT_EQ(lab.state()["cursor"], "hand");
    lab.move(vehicle(lab, 0));
    EXPECT_TRUE(wait_for([&] { return lab.state()["hovered"]["kind"] == "vehicle"; }));
    lab.move(lab.at("card.brain"));
    EXPECT_TRUE(wait_for([&] { return lab.state()["hovered"]["kind"] == "none"; })) << "a card covers the scene";
    EXPECT_EQ(lab.state()["cursor"], "arrow");
}

TEST(SceneInputWindow, AddsFromTheContextMenuAndUndoRemovesIt) {
    LabWindow lab({"predator-prey", "--size", "1280x800"});
    const Point free = lab.at("viewport");
    right_click(lab, {free.x - 150, free.y - 150});
    lab.click("menu.add.light");
    EXPECT_TRUE(wait_for([&] { return lab.state()["sources"].size() == 1; }));
    const Point lamp = source(lab, 0);
    EXPECT_NEAR(lamp.x, free.x - 150, 3);
    EXPECT_NEAR(lamp.y, free.y - 150, 3);
    right_click(lab, {free.x - 190, free.y + 60});
    lab.click("menu.add.vehicle.1");
    EXPECT_TRUE(wait_for([&] { return lab.state()["population"] == 21; }));
    EXPECT_EQ(lab.state()["selected"], 20) << "the added vehicle is selected";
    lab.key("Delete");
    EXPECT_TRUE(wait_for([&] { return lab.state()["population"] == 20; }));
    for (int i = 0; i < 3; ++i) lab.key("ctrl+z");
    EXPECT_TRUE(wait_for([&] { return lab.state()["sources"].empty(); }));
    EXPECT_EQ(lab.state()["population"], 20);
}

TEST(SceneInputWindow, DrawsATriangleByItsCornersAndUndoRemovesIt) {
    LabWindow lab({"2a-coward", "--size", "1280x800"});
    const Point middle = lab.at("viewport");
    choose_tool(lab, "polygon");
    int corners = 0;
    for (const Point corner : {Point{-120, -60}, Point{-30, -60}, Point{-70, -130}}) {
        press_at(lab, {middle.x + corner.x, middle.y + corner.y});
        lab.release();
        ++corners;
        EXPECT_TRUE(wait_for([&] { return lab.state()["corners"] == corners; })) << lab.state()["corners"];
    }
    lab.key("Return");
    EXPECT_TRUE(wait_for([&] { return lab.state()["obstacles"].size() == 1; }));
    EXPECT_EQ(lab.state()["obstacles"][0]["corners"], 3);
    EXPECT_EQ(lab.state()["tool"], "hand");
    EXPECT_EQ(lab.state()["thing"]["kind"], "obstacle");
    lab.key("ctrl+z");
    EXPECT_TRUE(wait_for([&] { return lab.state()["obstacles"].empty(); }));
    lab.key("ctrl+shift+z");
    EXPECT_TRUE(wait_for([&] { return lab.state()["obstacles"].size() == 1; }));
}

TEST(SceneInputWindow, RotatesABoxByItsRingAndEditsItOnItsCard) {
    LabWindow lab({"2a-coward", "--size", "1280x800"});
    const Point middle = lab.at("viewport");
    choose_tool(lab, "box");
    drag(lab, {middle.x - 130, middle.y - 120}, {middle.x - 60, middle.y - 80});
    ASSERT_TRUE(wait_for([&] { return lab.state()["obstacles"].size() == 1; }));
    const Point box = obstacle_at_rest(lab);
    lab.move(box);
    const Point knob = lab.at("stage.knob");
    drag(lab, knob, {box.x, box.y - 60});
    EXPECT_TRUE(wait_for([&] { return std::abs(lab.state()["obstacles"][0]["heading"].get<double>() - 1.57) < 0.2; }))
        << lab.state()["obstacles"];
    const auto depth = lab.state()["undo_depth"].get<int>();
    const Point slider = lab.at("thing.mass");
    drag(lab, {slider.x, slider.y}, {slider.x + 40, slider.y});
    EXPECT_TRUE(wait_for([&] { return lab.state()["obstacles"][0]["mass"].get<double>() > 1; }));
    EXPECT_EQ(lab.state()["undo_depth"], depth + 1) << "one drag, one step";
    lab.key("ctrl+z");
    EXPECT_TRUE(wait_for([&] { return lab.state()["obstacles"][0]["mass"] == 0; }));
}

TEST(SceneInputWindow, DrawsAZoneDragsItWhilePlayingAndSelectsSeveralObjects) {
    LabWindow lab({"2a-coward", "--size", "1280x800"});
    const Point middle = lab.at("viewport");
    choose_tool(lab, "zone");
    drag(lab, {middle.x - 130, middle.y - 120}, {middle.x - 50, middle.y - 60});
    ASSERT_TRUE(wait_for([&] { return lab.state()["zones"].size() == 1; }));
    EXPECT_EQ(lab.state()["thing"]["kind"], "zone");
    EXPECT_EQ(lab.state()["zones"][0]["surface"], "ice");
    lab.click("thing.surface.sand");
    EXPECT_TRUE(wait_for([&] { return lab.state()["zones"][0]["surface"] == "sand"; }));
    lab.key("space");
    // Without its position in the window: the camera follows the action.
    const auto zone = [&] {
        Json all = lab.state()["zones"][0];
        all.erase("at");
        return all;
    };
    const Json before = zone();
    const Point from = place(lab.state()["zones"][0]);
    drag(lab, from, {from.x + 40, from.y + 20});
    EXPECT_TRUE(wait_for([&] { return lab.state()["zones"][0]["x"].get<double>() > before["x"].get<double>() + 0.5; }));
    lab.key("space");
    lab.key("ctrl+z");
    EXPECT_TRUE(wait_for([&] { return zone() == before; }));

    lab.xdotool("keydown shift");
    drag(lab, {middle.x - 270, middle.y - 230}, {middle.x + 270, middle.y + 230});
    lab.xdotool("keyup shift");
    EXPECT_TRUE(wait_for([&] { return lab.state()["chosen"] == 3; })) << "vehicle, lamp and zone";
    lab.key("ctrl+c");
    EXPECT_TRUE(wait_for([&] { return lab.state()["clipboard"] == 3; }));
    lab.move({middle.x + 60, middle.y + 100});
    lab.key("ctrl+v");
    EXPECT_TRUE(wait_for([&] { return lab.state()["zones"].size() == 2 && lab.state()["population"] == 2; }));
    EXPECT_EQ(lab.state()["sources"].size(), 2u);
    lab.key("Delete");
    EXPECT_TRUE(wait_for([&] { return lab.state()["zones"].size() == 1 && lab.state()["population"] == 1; }));
    lab.key("ctrl+z");
    lab.key("ctrl+z");
    EXPECT_TRUE(wait_for([&] { return lab.state()["zones"].size() == 1 && lab.state()["sources"].size() == 1; }));
}

TEST(SceneInputWindow, BuildsASceneByKeysAlone) {
    LabWindow lab({"empty", "--size", "1280x800"});
    const auto press = [&](std::initializer_list<const char*> keys) {
        for (const char* key : keys) lab.key(key), lab.draw_frames();
    };
    press({"h", "Down", "Return"});  // the first row is the kind of vehicle, the second one a lamp
    ASSERT_TRUE(wait_for([&] { return lab.state()["sources"].size() == 1; }));
    const double y = lab.state()["sources"][0]["y"];
    press({"Up", "Up"});
    EXPECT_TRUE(wait_for([&] { return lab.state()["sources"][0]["y"].get<double>() > y + 0.15; }));

    press({"h", "Up", "Up", "Up", "Return"});  // from the last row up: whole view, tape, zone
    ASSERT_TRUE(wait_for([&] { return lab.state()["zones"].size() == 1; }));
    press({"z"});
    EXPECT_TRUE(wait_for([&] { return lab.state()["zones"][0]["heading"].get<double>() > 0.05; }));

    press({"h", "Up", "Up", "Up", "Up", "Return"});  // a polygon
    EXPECT_TRUE(wait_for([&] { return lab.state()["tool"] == "polygon"; }));
    press({"Right", "Right", "Right", "Return", "Up", "Up", "Up", "Return", "Return"});
    ASSERT_TRUE(wait_for([&] { return lab.state()["obstacles"].size() == 1; }));
    EXPECT_EQ(lab.state()["obstacles"][0]["corners"], 3);

    press({"x", "x"});  // from the obstacle to the zone, then to the lamp
    EXPECT_TRUE(wait_for([&] { return lab.state()["thing"]["kind"] == "source"; }));
    press({"Delete"});
    EXPECT_TRUE(wait_for([&] { return lab.state()["sources"].empty(); }));
    press({"ctrl+z", "ctrl+a", "ctrl+c"});
    EXPECT_TRUE(wait_for([&] { return lab.state()["clipboard"] == 4; })) << "vehicle, lamp, zone and obstacle";

    press({"Escape"});
    lab.xdotool("keydown Prior");
    EXPECT_TRUE(wait_for([&] { return lab.state()["view"]["zoom"].get<double>() > 1.2; }));
    lab.xdotool("keyup Prior");
    const Json before = lab.state()["view"]["pan"];
    lab.xdotool("keydown shift keydown Right");
    EXPECT_TRUE(wait_for([&] { return lab.state()["view"]["pan"] != before; }));
    lab.xdotool("keyup Right keyup shift");
    EXPECT_EQ(lab.state()["pressed"], 0) << "no button of the mouse was used";
}

TEST(SceneInputWindow, PansZoomsAtThePointerAndResetsTheView) {
    LabWindow lab({"2a-coward", "--size", "1280x800"});
    const Json home = lab.state()["view"];
    const Point free = lab.at("viewport");
    const Point start = source(lab, 0);
    lab.move({free.x - 100, free.y + 100});
    lab.press(3);
    for (int i = 1; i <= 6; ++i) lab.move({free.x - 100 + 10 * i, free.y + 100});
    lab.release(3);
    EXPECT_TRUE(wait_for([&] { return std::abs(source(lab, 0).x - start.x - 60) < 12; })) << "the floor follows";
    const Point lamp = source(lab, 0);
    lab.move(lamp);
    lab.xdotool("click 4"), lab.xdotool("click 4");
    EXPECT_TRUE(wait_for([&] { return lab.state()["view"]["zoom"].get<double>() > 1.2; }));
    EXPECT_NEAR(source(lab, 0).x, lamp.x, 3) << "the point under the pointer stays there";
    lab.key("Home");
    EXPECT_TRUE(wait_for([&] { return lab.state()["view"] == home; }));
    EXPECT_TRUE(wait_for([&] { return std::abs(source(lab, 0).x - start.x) < 2; })) << "after a short glide";
}

}  // namespace
}  // namespace braitenlab::tests::stage_window_test

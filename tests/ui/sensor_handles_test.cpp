// Handles of a sensor's field in the scene: synthetic Dear ImGui mouse events over a hand-made snapshot.
#include "ui/scene_input/sensor_handles.h"

#include <cmath>
#include <set>

#include "core/maths/angle.h"
#include "desk.h"

namespace braitenlab::tests::sensor_handles_test {

using namespace ui;
namespace {

using maths::vec2;

constexpr float degree = maths::radians(1);

// A desk with one vehicle in the middle that looks to +y, two eyes of 4 m, the sensor card open.
struct SensorHandles : testing::Test {
    SensorHandles() {
        auto scene = std::make_shared<Scene>(*desk.now.scene);
        std::vector<Sensor>& sensors = scene->kinds[0].sensors;
        for (int i = 0; i < 2; ++i) {
            const float side = i == 0 ? 1.0f : -1.0f;
            sensors[static_cast<std::size_t>(i)].y = 0.24f * side;
            sensors[static_cast<std::size_t>(i)].angle = 35 * degree * side;
            sensors[static_cast<std::size_t>(i)].fov = 60 * degree;
            sensors[static_cast<std::size_t>(i)].range = 4;
        }
        scene->arena.width = scene->arena.height = 10;
        desk.now.scene = scene;
        desk.now.vehicles.resize(1);
        desk.now.vehicles[0].heading = maths::pi / 2;
        desk.view.camera_view = &camera_view;
        desk.panels.card(Card::sensors).folded = false;
        desk.frame(3);
        Camera camera;
        camera.mode = CameraMode::birds_eye;
        camera_view = look(camera, scene->arena, nullptr, {0, 0, 1280, 800}, desk.layout.scene);
        desk.frame(2);
    }

    vec2 at(const char* handle) const {
        const Rect r = desk.where(handle);
        return {r.x + r.w / 2, r.y + r.h / 2};
    }
    // Presses the handle and moves by steps of these pixels.
    void drag(const char* handle, vec2 by, bool release = true) {
        vec2 pointer = at(handle);
        desk.point(pointer.x, pointer.y);
        desk.frame();
        desk.button(0, true);
        desk.frame();
        for (int i = 1; i <= 5; ++i) {
            pointer += by / 5.0f;
            desk.point(pointer.x, pointer.y);
            desk.frame();
            take_over();
        }
        if (!release) return;
        desk.button(0, false);
        desk.frame();
    }
    // Executes the requests, as the lab does.
    void take_over() {
        for (const Request& request : desk.asked) {
            const auto* edit = std::get_if<EditRequest>(&request);
            const auto* set = edit ? std::get_if<SetSensors>(&edit->command) : nullptr;
            if (!set) continue;
            auto scene = std::make_shared<Scene>(*desk.now.scene);
            scene->kinds[0].sensors = set->sensors;
            desk.now.scene = scene;
        }
    }
    const std::vector<Sensor>& sensors() const { return desk.now.scene->kinds[0].sensors; }

    Desk desk{1280, 800};
    CameraView camera_view = look(Camera{}, Arena{}, nullptr, {0, 0, 1280, 800}, {336, 64, 576, 680});
};

TEST_F(SensorHandles, AreShownWhileTheSensorCardIsOpen) {
    EXPECT_TRUE(desk.anchors.find("handle.axis"));
    EXPECT_TRUE(desk.anchors.find("handle.left"));
    EXPECT_TRUE(desk.anchors.find("handle.right"));
    desk.panels.card(Card::sensors).folded = true;
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("handle.axis"));
    desk.panels.card(Card::sensors).folded = false;
    desk.view.settings.selection.vehicle = no_vehicle;
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("handle.axis"));
}

TEST_F(SensorHandles, TheMiddleOfTheArcTurnsBothEyesAlongTheArcInOneGesture) {
    // The axis of the left eye points up and to the left; a movement across it to the left turns it left.
    drag("handle.axis", {-30, 21});
    EXPECT_GT(sensors()[0].angle, 40 * degree);
    EXPECT_EQ(sensors()[1].angle, -sensors()[0].angle);
    EXPECT_EQ(sensors()[0].range, 4) << "only the direction changes";
    std::set<std::uint64_t> gestures;
    for (const EditRequest& edit : desk.edits()) gestures.insert(edit.gesture);
    EXPECT_EQ(gestures.size(), 1u);
    EXPECT_EQ(std::get<SetSensors>(desk.edits().front().command).target, (Target{.kind = 0}));
    const auto first = desk.edits().back().gesture;
    drag("handle.axis", {-10, 7});
    EXPECT_NE(desk.edits().back().gesture, first) << "a second drag is a second step";
}

TEST_F(SensorHandles, TheMiddleOfTheArcChangesTheRangeOutwards) {
    drag("handle.axis", {14, 20});
    EXPECT_LT(sensors()[0].range, 3.9f);
    EXPECT_EQ(sensors()[1].range, sensors()[0].range);
    EXPECT_EQ(sensors()[0].angle, 35 * degree);
}

TEST_F(SensorHandles, TheMiddleOfTheArcPulledAcrossTheVehicleTurnsTheEyesToTheRear) {
    const vec2 handle = at("handle.axis"), mount = at("handle.mount");
    drag("handle.axis", (mount - handle) * 1.7f);
    EXPECT_NEAR(sensors()[0].angle, (35 - 180) * degree, 6 * degree);
    EXPECT_EQ(sensors()[1].angle, -sensors()[0].angle);
    EXPECT_EQ(sensors()[0].range, 4) << "only the direction changes";
}

TEST_F(SensorHandles, AnEndOfTheArcChangesTheOpeningAngle) {
    drag("handle.left", {-10, 40});
    EXPECT_GT(sensors()[0].fov, 65 * degree);
    EXPECT_EQ(sensors()[0].angle, 35 * degree);
    EXPECT_EQ(sensors()[1].fov, sensors()[0].fov);
    const float wide = sensors()[0].fov;
    drag("handle.right", {-20, -20});
    EXPECT_LT(sensors()[0].fov, wide);
}

TEST_F(SensorHandles, TheMountMovesTheSensorAndTheOtherOneAsItsMirrorImage) {
    drag("handle.mount", {-12, 0});
    EXPECT_GT(sensors()[0].y, 0.3f) << "the vehicle looks up: left is to the left";
    EXPECT_EQ(sensors()[1].y, -sensors()[0].y);
    EXPECT_EQ(sensors()[0].x, sensors()[1].x);
}

TEST_F(SensorHandles, ChangeOneSideAndOneVehicleWhereTheCardSaysSo) {
    desk.panels.sensors.alone = true;
    desk.panels.sensors.shown = "SR";
    desk.view.settings.selection.whole_kind = false;
    desk.frame(2);
    drag("handle.axis", {30, 21});
    const auto set = std::get<SetSensors>(desk.edits().back().command);
    EXPECT_EQ(set.target, (Target{.vehicle = 0}));
    EXPECT_EQ(set.sensors[0].angle, 35 * degree);
    EXPECT_LT(set.sensors[1].angle, -40 * degree);
}

TEST_F(SensorHandles, EscRestoresTheSensorsAndEndsTheDrag) {
    const std::vector<Sensor> before = sensors();
    drag("handle.axis", {-30, 21}, false);
    ASSERT_NE(sensors(), before);
    desk.all.clear();
    desk.key({key::escape});
    ASSERT_EQ(desk.edits().size(), 1u);
    EXPECT_EQ(std::get<SetSensors>(desk.edits()[0].command).sensors, before);
    EXPECT_EQ(desk.panels.scene_input.drag.phase, SceneInputPhase::idle);
    desk.all.clear();
    desk.point(600, 300);
    desk.frame(2);
    EXPECT_TRUE(desk.edits().empty());
}

TEST_F(SensorHandles, EscRestoresTheSensorsOfTheKindAndTheOwnSensorsOfItsVehicles) {
    const std::vector<Sensor> of_kind = sensors();
    auto own = std::make_shared<Kind>(desk.now.scene->kinds[0]);
    for (Sensor& sensor : own->sensors) sensor.range = 3;
    auto other = std::make_shared<Kind>(desk.now.scene->kinds[0]);
    other->sensors = {{.name = "SX"}};
    desk.now.designs = {own, other};
    desk.now.vehicles[0].design = 0;
    for (const VehicleId id : {1, 2}) {
        desk.now.vehicles.push_back(desk.now.vehicles[0]);
        desk.now.vehicles.back().id = id;
        desk.now.vehicles.back().x = 4;
        desk.now.vehicles.back().design = 1;
    }
    desk.frame(2);
    drag("handle.axis", {-30, 21}, false);
    ASSERT_FALSE(desk.edits().empty());
    desk.all.clear();
    desk.now.vehicles.pop_back();
    desk.key({key::escape});
    const auto restored = desk.edits();
    ASSERT_EQ(restored.size(), 3u) << "of the vehicle that died meanwhile nothing is restored";
    const auto is = [&](std::size_t i, Target target, const std::vector<Sensor>& expected) {
        EXPECT_EQ(std::get<SetSensors>(restored[i].command), (SetSensors{target, expected})) << i;
        EXPECT_EQ(restored[i].gesture, restored[0].gesture);
    };
    is(0, {.kind = 0}, of_kind);
    is(1, {.vehicle = 0}, own->sensors);
    is(2, {.vehicle = 1}, other->sensors);
}

TEST_F(SensorHandles, FollowAVehicleThatDrivesDuringADrag) {
    drag("handle.axis", {-30, 21}, false);
    const float angle = sensors()[0].angle;
    desk.now.vehicles[0].heading += 0.3f;
    desk.frame();
    take_over();
    EXPECT_LT(sensors()[0].angle, angle - 0.15f) << "the pointer is at rest, so the eye turns back in the vehicle";
}

TEST_F(SensorHandles, AreWithinTheSceneForARangeBeyondIt) {
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    for (Sensor& sensor : scene->kinds[0].sensors) sensor.range = 90;
    desk.now.scene = scene;
    desk.frame(2);
    const vec2 axis = at("handle.axis");
    EXPECT_TRUE(desk.layout.scene.contains(axis.x, axis.y));
    drag("handle.axis", {14, 20});
    EXPECT_LT(sensors()[0].range, 85);
    EXPECT_GT(sensors()[0].range, 45) << "by the share of the distance";
}

TEST_F(SensorHandles, ASensorOfItsOwnEnergyHasOnlyAPosition) {
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    scene->kinds[0].sensors = {{.name = "EN", .channel = Channel::energy}};
    desk.now.scene = scene;
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("handle.axis"));
    EXPECT_TRUE(desk.anchors.find("handle.mount"));
}

}  // namespace
TEST_F(SensorHandles, TheNoteOfAHandleStaysInASmallScene) {
    for (const char* language : {"en", "de", "es"}) {
        desk.strings = speaking(language);
        ImGui::GetIO().DisplaySize = {800, 600};
        desk.panels.card(Card::brain).folded = true;  // there is room for one open card
        desk.frame(3);
        Camera camera;
        camera.mode = CameraMode::birds_eye;
        camera_view = look(camera, desk.now.scene->arena, nullptr, {0, 0, 800, 600}, desk.layout.scene);
        desk.frame(2);
        const vec2 axis = at("handle.axis");
        desk.point(axis.x, axis.y);
        desk.frame(3);
        const std::string words(desk.strings("scene_input.sensor_axis"));
        const std::string begin = words.substr(0, words.find(' '));
        const Rect scene = desk.layout.scene;
        bool found = false;
        for (const Written& each : desk.written) {
            if (!each.words.starts_with(begin) || !scene.contains(each.rect.x, each.rect.y)) continue;
            found = true;
            EXPECT_LE(each.rect.x + each.rect.w, scene.x + scene.w + 1) << language << ": " << each.words;
        }
        EXPECT_TRUE(found) << language;
    }
}

}  // namespace braitenlab::tests::sensor_handles_test

// Editing the sensors of a kind.
#include <cmath>
#include <set>

#include "desk.h"

namespace braitenlab::tests::sensor_card_test {

using namespace ui;

namespace {

constexpr float degree = 0.017453293f;

// Two eyes looking 35° outwards, and a bumper; the card open.
class SensorDesk : public Desk {
public:
    SensorDesk() : Desk(1280, 1000) {
        auto scene = std::make_shared<Scene>(*now.scene);
        std::vector<Sensor>& sensors = scene->kinds[0].sensors;
        sensors[0].angle = 35 * degree, sensors[1].angle = -35 * degree;
        sensors[0].y = 0.24f, sensors[1].y = -0.24f;
        sensors.push_back({.name = "TC", .channel = Channel::touch});
        now.scene = filed = scene;
        view.file = filed.get();
        panels.card(Card::sensors).folded = false;
        frame(4);
    }

    std::vector<Sensor> asked_for() const {
        const auto found = edits();
        if (found.empty()) throw std::runtime_error("nothing was asked for");
        return std::get<SetSensors>(found.back().command).sensors;
    }

    // The number of a slider, typed.
    void type_into(const char* slider, const char* number) {
        click(slider, 0, 0.97f);
        type(number);
        frame(2);
        key({key::enter});
        frame(2);
    }

    std::shared_ptr<const Scene> filed;
};

}  // namespace

TEST(SensorCard, IsFoldedUntilItIsOpened) {
    Desk desk;
    desk.frame(3);
    EXPECT_TRUE(desk.anchors.find("card.sensors"));
    EXPECT_FALSE(desk.anchors.find("sensor.angle"));
    desk.click("card.sensors.fold");
    desk.frame(3);
    EXPECT_TRUE(desk.anchors.find("sensor.angle"));
}

TEST(SensorCard, TurnsBothEyesAsMirrorImages) {
    SensorDesk desk;
    desk.type_into("sensor.angle", "60");
    const auto sensors = desk.asked_for();
    EXPECT_NEAR(sensors[0].angle, 60 * degree, 1e-4f);
    EXPECT_NEAR(sensors[1].angle, -60 * degree, 1e-4f);
    EXPECT_EQ(sensors[2], desk.now.scene->kinds[0].sensors[2]) << "the bumper is unchanged";
    EXPECT_EQ(std::get<SetSensors>(desk.edits().back().command).target.kind, 0);
    desk.all.clear();
    desk.type_into("sensor.field", "90");
    EXPECT_NEAR(desk.asked_for()[0].fov, 90 * degree, 1e-4f);
    EXPECT_NEAR(desk.asked_for()[1].fov, 90 * degree, 1e-4f);
}

TEST(SensorCard, EditsASingleEye) {
    SensorDesk desk;
    desk.click("sensor.SR");
    desk.click("sensor.sides.2");
    desk.type_into("sensor.y", "-0.5");
    EXPECT_FLOAT_EQ(desk.asked_for()[0].y, 0.24f);
    EXPECT_FLOAT_EQ(desk.asked_for()[1].y, -0.5f);
}

TEST(SensorCard, MakesADragOneGesture) {
    SensorDesk desk;
    const Rect r = desk.where("sensor.range");
    const float middle = r.x + 84 + 8 + (r.w - 84 - 56 - 16) * 0.6f;  // 12 of 20 m
    desk.point(middle, r.y + r.h / 2);
    desk.frame(2);
    desk.button(0, true);
    for (int i = 0; i < 10; ++i) {
        desk.point(middle - 3.0f * static_cast<float>(i), r.y + r.h / 2);
        desk.frame();
    }
    desk.button(0, false);
    desk.frame(2);
    std::set<std::uint64_t> gestures;
    for (const EditRequest& edit : desk.edits()) gestures.insert(edit.gesture);
    EXPECT_GE(desk.edits().size(), 5u);
    EXPECT_EQ(gestures.size(), 1u);
    EXPECT_LT(desk.asked_for()[0].range, 12);
}

TEST(SensorCard, ChangesShapeAndResponse) {
    SensorDesk desk;
    desk.click("sensor.shape.2");
    EXPECT_EQ(desk.asked_for()[0].shape, SensorShape::triangle);
    EXPECT_EQ(desk.asked_for()[1].shape, SensorShape::triangle);
    desk.click("sensor.response.2");
    EXPECT_EQ(desk.asked_for()[1].response, SensorResponse::boolean);
}

TEST(SensorCard, SetsTheChannelOfBothEyes) {
    SensorDesk desk;
    EXPECT_FALSE(desk.anchors.find("sensor.channel.heat"));
    desk.click("sensor.channel");
    desk.click("sensor.channel.heat");
    const auto sensors = desk.asked_for();
    EXPECT_EQ(sensors[0].channel, Channel::heat);
    EXPECT_EQ(sensors[1].channel, Channel::heat);
    EXPECT_EQ(sensors[2].channel, Channel::touch) << "the bumper keeps its channel";
    EXPECT_NE(desk.edits().back().gesture, 0u) << "a separate step of undo";
    desk.all.clear();
    desk.click("sensor.channel.light");
    EXPECT_TRUE(desk.edits().empty()) << "it senses light already";
}

TEST(SensorCard, KeepsNoiseAndDelayFoldedAndClampsThem) {
    SensorDesk desk;
    EXPECT_FALSE(desk.anchors.find("sensor.noise"));
    desk.click("sensor.more");
    desk.frame(2);
    desk.type_into("sensor.latency", "7");
    EXPECT_FLOAT_EQ(desk.asked_for()[0].latency, 1);
    desk.type_into("sensor.noise", "0,25");
    EXPECT_FLOAT_EQ(desk.asked_for()[1].noise, 0.25f);
}

TEST(SensorCard, RightClickRestoresTheAngleOfTheFile) {
    SensorDesk desk;
    auto turned = std::make_shared<Scene>(*desk.now.scene);
    turned->kinds[0].sensors[0].angle = 1;
    desk.now.scene = turned;
    desk.frame(2);
    desk.click("sensor.angle", 1);
    EXPECT_NEAR(desk.asked_for()[0].angle, 35 * degree, 1e-4f);
}

TEST(SensorCard, HidesTheNameOfASingleKind) {
    Desk desk(1280, 1000);
    desk.now = snapshot(0);
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    scene->kinds[0].name = "aggressor";
    desk.now.scene = scene;
    desk.panels.card(Card::sensors).folded = false;
    desk.frame(4);
    ASSERT_TRUE(desk.anchors.find("sensor.angle"));
    for (const Written& w : desk.written) EXPECT_EQ(w.words.find("ggressor"), std::string::npos) << w.words;
}

TEST(SensorCard, ReportsAVehicleWithoutSensors) {
    Desk desk;
    desk.panels.card(Card::sensors).folded = false;
    desk.view.settings.selection.vehicle = no_vehicle;
    desk.frame(3);
    EXPECT_TRUE(desk.anchors.find("card.sensors"));
    EXPECT_FALSE(desk.anchors.find("sensor.angle"));
}

}  // namespace braitenlab::tests::sensor_card_test

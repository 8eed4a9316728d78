// Sensors by hand in the real window: the sensor card and the handles in the scene.
#include <cmath>

#include "lab_window.h"

namespace braitenlab::tests::sensor_window_test {
namespace {

bool wait_for(const std::function<bool()>& holds) { return LabWindow::eventually(holds, 6); }

TEST(SensorWindow, AddsAPairOfSensorsToOneVehicleAsOneStepOfUndo) {
    LabWindow lab({"dance", "--size", "1280x800"});
    lab.draw_frames();  // the cards measure themselves in the first frames
    lab.click("card.sensors.fold");
    lab.click("sensor.scope.1");
    const std::size_t before = lab.state()["sensor_names"].size();
    lab.click("sensor.add");
    lab.click("sensor.new.heat");
    EXPECT_TRUE(wait_for([&] { return lab.state()["sensor_names"].size() == before + 2; }));
    EXPECT_EQ(lab.state()["own_sensors"], true);
    EXPECT_EQ(lab.state()["undo_depth"], 1);
    lab.key("ctrl+z");
    EXPECT_TRUE(wait_for([&] { return lab.state()["sensor_names"].size() == before; }));
    EXPECT_EQ(lab.state()["own_sensors"], false);
}

TEST(SensorWindow, TurnsBothEyesByTheHandleInTheScene) {
    LabWindow lab({"2a-coward", "--size", "1280x800"});
    lab.draw_frames();
    lab.click("card.sensors.fold");
    ASSERT_TRUE(wait_for([&] { return lab.anchors().contains("handle.axis"); }));
    const auto angles = [&] { return lab.state()["sensor_angles"]; };
    const Json before = angles();
    const Point axis = lab.at("handle.axis");
    const Json vehicle = lab.state()["vehicles"][0]["at"];
    const double x = axis.x - vehicle[0].get<double>(), y = axis.y - vehicle[1].get<double>(),
                 length = std::hypot(x, y);
    lab.drag(axis, {static_cast<int>(axis.x - 60 * y / length), static_cast<int>(axis.y + 60 * x / length)});
    EXPECT_TRUE(wait_for([&] { return angles() != before; }));
    EXPECT_NEAR(angles()[0].get<double>(), -angles()[1].get<double>(), 1e-3);
    EXPECT_EQ(lab.state()["undo_depth"], 1);
    lab.key("ctrl+z");
    EXPECT_TRUE(wait_for([&] { return angles() == before; }));
}

}  // namespace
}  // namespace braitenlab::tests::sensor_window_test

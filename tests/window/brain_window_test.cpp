// The brain card, the sensor card and the charts in the real window.
#include "tests/window/lab_window.h"

namespace braitenlab::tests::brain_window_test {
namespace {

bool wait_for(const std::function<bool()>& holds) { return LabWindow::eventually(holds, 6); }

void type_into(const LabWindow& lab, const std::string& slider, const std::string& number) {
    lab.move(lab.at(slider));
    lab.xdotool("keydown ctrl");
    lab.press();
    lab.release();
    lab.xdotool("keyup ctrl");
    ASSERT_TRUE(wait_for([&] { return lab.state()["typed"] != ""; }));
    if (!number.empty()) lab.xdotool("type --delay 60 -- " + number);
    lab.key("Return");
    ASSERT_TRUE(wait_for([&] { return lab.state()["typed"] == ""; }));
}

TEST(PairWindow, SetsTheWiresOfTheChosenPair) {
    LabWindow lab({"3c-values", "--size", "1280x800"});
    ASSERT_TRUE(wait_for([&] { return lab.state()["pair"] == "light"; }));
    EXPECT_EQ(lab.state()["pairs"].size(), 5u);
    EXPECT_EQ(lab.state()["pairs"][1]["character"], "coward");
    lab.click("pair.heat");
    ASSERT_TRUE(wait_for([&] { return lab.state()["pair"] == "heat"; }));
    const Json before = lab.state()["weights"];
    lab.click("button.cross");
    ASSERT_TRUE(wait_for([&] { return lab.state()["weights"]["RL"] == before["LL"]; }));
    EXPECT_EQ(lab.state()["pairs"][1]["character"], "aggressor") << "from fleeing to attacking";
    EXPECT_EQ(lab.state()["pairs"][0]["character"], "aggressor") << "the light sensors keep their wires";
}

TEST(BrainWindow, ClampsATypedNumberAndRefusesOtherText) {
    LabWindow lab({"2a-coward", "--size", "1280x800"});
    type_into(lab, "slider.LR", "7.5");
    EXPECT_TRUE(wait_for([&] { return lab.state()["weights"]["LR"] == 2; })) << lab.state()["weights"];
    EXPECT_EQ(lab.state()["undo_depth"], 1);
    lab.click("button.thresholds");
    ASSERT_TRUE(wait_for([&] { return lab.anchors().contains("threshold.LR"); }));
    type_into(lab, "threshold.LR", "-3");
    type_into(lab, "slider.LR", "nan");  // letters are not accepted: the number stays
    type_into(lab, "slider.LR", "-");
    lab.draw_frames();
    EXPECT_EQ(lab.state()["weights"]["LR"], 2);
    EXPECT_EQ(lab.state()["thresholds"]["LR"], 0);
    EXPECT_EQ(lab.state()["undo_depth"], 1);
    lab.key("ctrl+z");
    EXPECT_TRUE(wait_for([&] { return lab.state()["weights"]["LR"] == 0; }));
}

TEST(BrainWindow, NamesTheCharacterAndRestoresTheValueOfTheFile) {
    LabWindow lab({"2a-coward", "--size", "1280x800"});
    EXPECT_EQ(lab.state()["character"], "coward");
    const double filed = lab.state()["weights"]["LL"];
    lab.click("button.cross");
    EXPECT_TRUE(wait_for([&] { return lab.state()["character"] == "aggressor"; }));
    lab.move(lab.at("slider.LL"));
    lab.xdotool("click 3");
    EXPECT_TRUE(wait_for([&] { return lab.state()["weights"]["LL"] == filed; }));
    lab.click("button.mirror");
    EXPECT_TRUE(wait_for([&] { return lab.state()["weights"]["RR"] == filed; }));
    for (int i = 0; i < 3; ++i) lab.key("ctrl+z");
    EXPECT_TRUE(wait_for([&] { return lab.state()["character"] == "coward" && lab.state()["undo_depth"] == 0; }));
}

TEST(BrainWindow, CoversAnEyeByAClickAndUndoUncoversIt) {
    LabWindow lab({"2a-coward", "--size", "1280x800", "--play"});
    ASSERT_EQ(lab.state()["lesions"], 0);
    lab.click("lesion.SL");
    EXPECT_TRUE(wait_for([&] { return lab.state()["lesions"] == 1; }));
    lab.click("lesion.RR");
    EXPECT_TRUE(wait_for([&] { return lab.state()["lesions"] == 2; }));
    EXPECT_EQ(lab.state()["weights"]["RR"], lab.state()["weights"]["LL"]) << "numbers are exact";
    lab.key("ctrl+z");
    lab.key("ctrl+z");
    EXPECT_TRUE(wait_for([&] { return lab.state()["lesions"] == 0; }));
}

TEST(BrainWindow, DrivesTheVehicleWithTheArrowKeys) {
    LabWindow lab({"2a-coward", "--size", "1280x800", "--play"});
    lab.click("viewport");
    lab.key("g");
    ASSERT_TRUE(wait_for([&] { return lab.state()["driver"] == "manual"; }));
    const Json view = lab.state()["view"];
    lab.xdotool("keydown Up");
    EXPECT_TRUE(wait_for([&] { return lab.state()["motor"] == Json({1.0, 1.0}); })) << lab.state()["motor"];
    lab.xdotool("keyup Up");
    EXPECT_TRUE(wait_for([&] { return lab.state()["motor"] == Json({0.0, 0.0}); }));
    EXPECT_EQ(lab.state()["view"], view) << "the keys do not move the camera";
    lab.key("g");
    EXPECT_TRUE(wait_for([&] { return lab.state()["driver"] == "brain"; }));
}

TEST(BrainWindow, DragsASensorsRangeAsOneStepOfUndo) {
    LabWindow lab({"2a-coward", "--size", "1280x800", "--play"});
    lab.draw_frames();  // the cards measure themselves in the first frames
    lab.click("card.sensors.fold");
    const Point middle = lab.at("sensor.range");
    const auto ranges = [&] { return lab.state()["sensor_ranges"]; };
    const Json before = ranges();
    lab.drag(middle, {middle.x - 30, middle.y});
    EXPECT_TRUE(wait_for([&] { return ranges() != before; }));
    EXPECT_EQ(lab.state()["undo_depth"], 1);
    lab.key("ctrl+z");
    EXPECT_TRUE(wait_for([&] { return ranges() == before; }));
}

TEST(BrainWindow, PredictsThePathOfADraggedSliderAndTheVehicleDrivesIt) {
    LabWindow lab({"2b-aggressor", "--size", "1280x800"});
    lab.draw_frames();
    const Point slider = lab.at("slider.LR");
    EXPECT_TRUE(lab.state()["prediction"].is_null());
    lab.move(slider);
    lab.press();
    lab.move({slider.x - 40, slider.y});
    ASSERT_TRUE(
        wait_for([&] { return lab.state()["prediction"].is_object() && lab.anchors().contains("stage.prediction"); }));
    EXPECT_TRUE(lab.state()["prediction"]["before"]);
    lab.release();
    lab.draw_frames();
    const Json path = lab.state()["prediction"]["points"];
    ASSERT_EQ(path.size(), 81u) << "8 s, ten a second";
    for (int tick = 0; tick < 6; ++tick) lab.key("period");
    ASSERT_TRUE(wait_for([&] { return lab.state()["tick"] == 6; }));
    const Json vehicle = lab.state()["vehicles"][0];
    EXPECT_EQ(Json({vehicle["x"], vehicle["y"]}), path[1]);
}

TEST(BrainWindow, ShowsAndHidesTheLargeCharts) {
    LabWindow lab({"predator-prey", "--size", "1024x768", "--play"});
    lab.key("c");
    ASSERT_TRUE(wait_for([&] { return lab.anchors().contains("card.charts"); }));
    lab.click("charts.tab.6");
    EXPECT_TRUE(wait_for([&] { return lab.anchors().contains("charts.bars"); }));
    lab.key("c");
    EXPECT_TRUE(wait_for([&] { return !lab.anchors().contains("card.charts"); }));
}

TEST(BrainWindow, ASignalIsDraggedToTheChartAndRemovedThere) {
    LabWindow lab({"2a-coward", "--size", "1280x800", "--play"});
    lab.key("c");
    ASSERT_TRUE(wait_for([&] { return lab.anchors().contains("card.charts"); }));
    EXPECT_EQ(lab.state()["strips"], Json::array());
    lab.drag(lab.at("lesion.SL"), lab.at("card.charts"));
    EXPECT_TRUE(wait_for([&] { return lab.state()["strips"] == Json{"SL"}; })) << lab.state()["strips"];
    EXPECT_TRUE(wait_for([&] { return lab.anchors().contains("charts.strip.SL"); }));
    EXPECT_EQ(lab.state()["lesions"], 0);
    lab.click("charts.tab.2");
    lab.click("charts.add.MR");
    EXPECT_TRUE(wait_for([&] { return lab.state()["strips"] == Json{"SL", "MR"}; })) << lab.state()["strips"];
    lab.click("charts.tab.3");
    lab.click("charts.remove.SL");
    EXPECT_TRUE(wait_for([&] { return lab.state()["strips"] == Json{"MR"}; })) << lab.state()["strips"];
}

}  // namespace
}  // namespace braitenlab::tests::brain_window_test

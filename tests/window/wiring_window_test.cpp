// The wiring editor in the real window.
#include "tests/window/lab_window.h"

namespace braitenlab::tests::wiring_window_test {
namespace {

bool wait_for(const std::function<bool()>& holds, double patience = 5) {
    return LabWindow::eventually(holds, patience);
}

// A window in wiring mode, showing a coward: LL and RR wired, LR and RL not.
struct WiringWindow : testing::Test {
    LabWindow lab{{"2a-coward", "--size", "1280x800", "--play"}};

    void SetUp() override {
        lab.key("w");
        ASSERT_TRUE(wait_for([&] { return lab.state()["mode"] == "wiring" && lab.anchors().contains("pin.SL.out"); }));
        lab.draw_frames();  // the view fits itself in the first frames
    }
    double weight(const char* name) const { return lab.state()["weights"][name]; }
};

TEST(WatchWindow, ShowsTheWiringBelowThePlayingSceneWithABorderThatCanBeDragged) {
    LabWindow lab({"5-logic", "--size", "1280x800", "--play"});
    lab.key("shift+w");
    ASSERT_TRUE(wait_for([&] { return lab.state()["watching"] == true && lab.anchors().contains("canvas"); }));
    const double before = lab.anchors()["canvas"][3];
    const Point border = lab.at("canvas.border");
    lab.drag(border, {border.x, border.y - 100});
    EXPECT_TRUE(wait_for([&] { return lab.anchors()["canvas"][3].get<double>() > before + 80; }));
    EXPECT_EQ(lab.state()["mode"], "playing");
    const int tick = lab.state()["tick"];
    EXPECT_TRUE(wait_for([&] { return lab.state()["tick"] > tick + 10; }));
    lab.key("shift+w");
    EXPECT_TRUE(wait_for([&] { return lab.state()["watching"] == false && !lab.anchors().contains("canvas"); }));
}

TEST_F(WiringWindow, PausesAndEscLeavesItPaused) {
    const auto tick = lab.state()["tick"];
    lab.draw_frames();
    EXPECT_EQ(lab.state()["tick"], tick);
    EXPECT_TRUE(lab.anchors().contains("canvas"));
    lab.key("Escape");
    EXPECT_TRUE(wait_for([&] { return lab.state()["mode"] == "paused"; }));
    EXPECT_TRUE(wait_for([&] { return !lab.anchors().contains("canvas"); }));
}

TEST_F(WiringWindow, DraggingFromTheLeftEyeToTheRightMotorTurnsTheSliderRL) {
    EXPECT_EQ(weight("RL"), 0);
    lab.drag(lab.at("pin.SL.out"), lab.at("pin.MR.in"));
    EXPECT_TRUE(wait_for([&] { return weight("RL") == 1; })) << weight("RL");
    EXPECT_EQ(lab.state()["undo_depth"], 1);
}

TEST_F(WiringWindow, TheReverseDragMakesTheSameWire) {
    lab.drag(lab.at("pin.ML.in"), lab.at("pin.SR.out"));
    EXPECT_TRUE(wait_for([&] { return weight("LR") == 1; })) << weight("LR");
}

TEST_F(WiringWindow, ASecondWireBetweenTheSamePinsIsRefused) {
    const double before = weight("LL");
    lab.drag(lab.at("pin.SL.out"), lab.at("pin.ML.in"));
    EXPECT_TRUE(wait_for([&] { return lab.anchors().contains("refused.duplicate"); }, 2)) << "the reason is shown";
    EXPECT_EQ(weight("LL"), before);
    EXPECT_EQ(lab.state()["undo_depth"], 0);
}

TEST_F(WiringWindow, AClickOnAWiresLabelAndDelMakeItsSliderReadZero) {
    lab.click("wire.LL");
    lab.key("Delete");
    EXPECT_TRUE(wait_for([&] { return weight("LL") == 0; })) << weight("LL");
    lab.key("ctrl+z");
    EXPECT_TRUE(wait_for([&] { return weight("LL") == 1.5; })) << weight("LL");
}

TEST_F(WiringWindow, AClickOnTheCurveSelectsItsWireAndDelMakesItsSliderReadZero) {
    lab.click("curve.RR");
    ASSERT_TRUE(wait_for([&] { return lab.anchors().contains("selected.RR"); }));
    lab.key("Delete");
    EXPECT_TRUE(wait_for([&] { return weight("RR") == 0; })) << weight("RR");
    EXPECT_NE(weight("LL"), 0);
}

TEST_F(WiringWindow, TheWheelZoomsAndKeepsThePointUnderTheCursor) {
    const Point pin = lab.at("pin.MR.in");
    const auto width = [&] { return lab.anchors()["node.MR"][2].get<double>(); };
    const double before = width();
    lab.move(pin);
    lab.xdotool("click --repeat 3 --delay 80 5");
    ASSERT_TRUE(wait_for([&] { return width() < before * 0.8; })) << width();
    lab.draw_frames();
    const Point after = lab.at("pin.MR.in");
    EXPECT_NEAR(after.x, pin.x, 2);
    EXPECT_NEAR(after.y, pin.y, 2);
}

TEST_F(WiringWindow, ABoxSelectsNodesThatCtrlCAndCtrlVCopy) {
    const auto canvas = lab.anchors()["canvas"].get<std::vector<double>>();
    const int middle = static_cast<int>(canvas[0] + canvas[2] / 2);
    const auto at = [&](double share) { return static_cast<int>(canvas[1] + canvas[3] * share); };
    // Make room below, and a neuron there.
    lab.move({middle, at(0.15)});
    lab.move(lab.at("canvas.fit"));
    lab.move({middle, at(0.97)});
    lab.press(3);
    for (const double share : {0.8, 0.6, 0.45}) lab.move({middle, at(share)});
    lab.release(3);
    lab.drag(lab.at("pin.SR.out"), {middle, at(0.75)});
    lab.click("menu.hump");
    ASSERT_TRUE(wait_for([&] { return lab.anchors().contains("node.N1"); }));
    lab.key("Escape");  // clears the selection
    ASSERT_TRUE(wait_for([&] { return !lab.anchors().contains("selected.N1"); }));
    const auto card = lab.anchors()["node.N1"].get<std::vector<double>>();
    lab.drag({static_cast<int>(card[0] + card[2] + 60), static_cast<int>(card[1] + card[3] + 20)}, lab.at("node.N1"));
    ASSERT_TRUE(wait_for([&] { return lab.anchors().contains("selected.N1"); }));
    const int depth = lab.state()["undo_depth"];
    lab.key("ctrl+c");
    lab.key("ctrl+v");
    EXPECT_TRUE(wait_for([&] { return lab.anchors().contains("node.N2"); }));
    EXPECT_TRUE(wait_for([&] { return lab.state()["undo_depth"] == depth + 1; })) << "one paste is one step of undo";
}

TEST_F(WiringWindow, KeysSelectCutAndRestoreAWire) {
    for (const char* name : {"Right", "Right"}) {
        lab.key(name);
        lab.draw_frames();
    }
    EXPECT_TRUE(wait_for([&] {
        const Json all = lab.anchors();
        for (const auto& [anchor, rect] : all.items())
            if (anchor.starts_with("selected.")) return true;
        return false;
    }));
    lab.key("l");
    EXPECT_TRUE(wait_for([&] { return lab.state()["undo_depth"] == 1; }));
    lab.key("ctrl+z");
    EXPECT_TRUE(wait_for([&] { return lab.state()["undo_depth"] == 0; }));
    EXPECT_EQ(lab.state()["mode"], "wiring");
}

TEST_F(WiringWindow, EscapeDuringADragChangesNothing) {
    const Point from = lab.at("pin.SL.out"), to = lab.at("pin.MR.in");
    lab.move(from);
    lab.press();
    lab.move({(from.x + to.x) / 2, (from.y + to.y) / 2});
    lab.key("Escape");
    lab.move(to);
    lab.release();
    lab.draw_frames();
    EXPECT_EQ(weight("RL"), 0);
    EXPECT_EQ(lab.state()["mode"], "wiring");
}

TEST_F(WiringWindow, ADraggedNodeIsOneStepOfUndoAndKeepsTheFuture) {
    lab.key("Escape");
    lab.key("comma");  // a step back, so that a recorded future exists
    ASSERT_TRUE(wait_for([&] { return lab.state()["tick"] < lab.state()["latest"]; }));
    const auto latest = lab.state()["latest"];
    lab.key("w");
    ASSERT_TRUE(wait_for([&] { return lab.anchors().contains("node.MR"); }));
    lab.draw_frames();
    const Point before = lab.at("node.MR"), after{before.x - 60, before.y + 20};
    const auto stands_at = [&](Point place) {
        return wait_for([&] {
            const Point now = lab.at("node.MR");
            return std::abs(now.x - place.x) < 3 && std::abs(now.y - place.y) < 3;
        });
    };
    lab.drag(before, after);
    EXPECT_TRUE(stands_at(after));
    EXPECT_TRUE(wait_for([&] { return lab.state()["undo_depth"] == 1; }));
    EXPECT_EQ(lab.state()["latest"], latest);
    lab.key("ctrl+z");
    EXPECT_TRUE(stands_at(before));
    lab.key("ctrl+y");
    EXPECT_TRUE(stands_at(after));
}

TEST_F(WiringWindow, PPlacesAProbeBesideTheNodeAndTheMenuPutsItOnTheChart) {
    EXPECT_EQ(lab.state()["probes"], Json::array());
    lab.click("node.SR");
    lab.key("p");
    EXPECT_TRUE(wait_for([&] { return lab.state()["probes"] == Json{"SR"}; })) << lab.state()["probes"];
    EXPECT_TRUE(wait_for([&] { return lab.anchors().contains("probe.SR"); }));
    const Point node = lab.at("node.SR");
    lab.move(node), lab.press(3), lab.release(3);
    lab.click("menu.chart");
    EXPECT_TRUE(wait_for([&] { return lab.state()["strips"] == Json{"SR"}; })) << lab.state()["strips"];
    EXPECT_EQ(lab.state()["undo_depth"], 0);
}

TEST_F(WiringWindow, AWireUnderThePointerShowsThePathWithoutIt) {
    const auto canvas = lab.anchors()["canvas"].get<std::vector<double>>();
    const Point beside{static_cast<int>(canvas[0]) + 8, static_cast<int>(canvas[1]) + 8};
    lab.move(beside);
    ASSERT_TRUE(wait_for([&] { return lab.state()["prediction"].is_null(); }));
    lab.move(lab.at("wire.LL"));
    EXPECT_TRUE(wait_for([&] { return !lab.state()["prediction"].is_null(); }));
    EXPECT_EQ(lab.state()["prediction"]["before"], true);
    EXPECT_EQ(lab.state()["mode"], "wiring");
    lab.move(beside);
    EXPECT_TRUE(wait_for([&] { return lab.state()["prediction"].is_null(); }));
}

TEST_F(WiringWindow, SpaceLeavesTheEditorAndPlays) {
    lab.key("space");
    EXPECT_TRUE(wait_for([&] { return lab.state()["mode"] == "playing"; }));
}

}  // namespace
}  // namespace braitenlab::tests::wiring_window_test

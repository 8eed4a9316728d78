// The wiring editor in the real window.
#include "tests/window/lab_window.h"

namespace braitenlab::tests {
namespace {

bool wait_for(const std::function<bool()>& holds, double patience = 5) {
    return LabWindow::eventually(holds, patience);
}

// A window in wiring mode, showing a coward: LL and RR wired, LR and RL free places.
struct Wiring : testing::Test {
    LabWindow lab{{"2a-coward", "--size", "1280x800", "--play"}};

    void SetUp() override {
        lab.key("w");
        ASSERT_TRUE(wait_for([&] { return lab.state()["mode"] == "wiring" && lab.anchors().contains("pin.SL.out"); }));
        LabWindow::wait(0.3);  // the view has fitted
    }
    double weight(const char* name) const { return lab.state()["weights"][name]; }
};

TEST_F(Wiring, PausesAndEscLeavesItPaused) {
    const auto tick = lab.state()["tick"];
    LabWindow::wait(0.3);
    EXPECT_EQ(lab.state()["tick"], tick);
    EXPECT_TRUE(lab.anchors().contains("canvas"));
    lab.key("Escape");
    EXPECT_TRUE(wait_for([&] { return lab.state()["mode"] == "paused"; }));
    EXPECT_TRUE(wait_for([&] { return !lab.anchors().contains("canvas"); }));
}

TEST_F(Wiring, DraggingFromTheLeftEyeToTheRightMotorTurnsTheSliderRL) {
    EXPECT_EQ(weight("RL"), 0);
    lab.drag(lab.at("pin.SL.out"), lab.at("pin.MR.in"));
    EXPECT_TRUE(wait_for([&] { return weight("RL") == 1; })) << weight("RL");
    EXPECT_EQ(lab.state()["undo_depth"], 1);
}

TEST_F(Wiring, TheReverseDragMakesTheSameWire) {
    lab.drag(lab.at("pin.ML.in"), lab.at("pin.SR.out"));
    EXPECT_TRUE(wait_for([&] { return weight("LR") == 1; })) << weight("LR");
}

TEST_F(Wiring, ASecondWireBetweenTheSamePinsIsRefused) {
    const double before = weight("LL");
    lab.drag(lab.at("pin.SL.out"), lab.at("pin.ML.in"));
    LabWindow::wait(0.3);
    EXPECT_EQ(weight("LL"), before);
    EXPECT_EQ(lab.state()["undo_depth"], 0);
}

TEST_F(Wiring, AClickOnAWiresLabelAndDelMakeItsSliderReadZero) {
    lab.click("wire.LL");
    lab.key("Delete");
    EXPECT_TRUE(wait_for([&] { return weight("LL") == 0; })) << weight("LL");
    lab.key("ctrl+z");
    EXPECT_TRUE(wait_for([&] { return weight("LL") == 1.5; })) << weight("LL");
}

TEST_F(Wiring, EscInMidDragChangesNothingAndStaysInTheEditor) {
    const Point from = lab.at("pin.SL.out"), to = lab.at("pin.MR.in");
    lab.move(from);
    lab.press();
    lab.move({(from.x + to.x) / 2, (from.y + to.y) / 2});
    lab.key("Escape");
    lab.move(to);
    lab.release();
    LabWindow::wait(0.3);
    EXPECT_EQ(weight("RL"), 0);
    EXPECT_EQ(lab.state()["mode"], "wiring");
}

TEST_F(Wiring, SpaceLeavesItAndPlays) {
    lab.key("space");
    EXPECT_TRUE(wait_for([&] { return lab.state()["mode"] == "playing"; }));
}

}  // namespace
}  // namespace braitenlab::tests

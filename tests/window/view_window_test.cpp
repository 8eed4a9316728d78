// Overlays and fields in the real window.
#include "tests/window/lab_window.h"

namespace braitenlab::tests::view_window_test {
namespace {

bool wait_for(const std::function<bool()>& holds) { return LabWindow::eventually(holds, 8); }

TEST(ViewWindow, CyclesFieldsByKeyAndSwitchesOverlaysInTheMenu) {
    LabWindow lab({"2b-aggressor", "--size", "1024x768"});
    const auto shows = [&](const char* what) { return lab.state()["overlays"][what]; };
    EXPECT_EQ(shows("field"), "");
    lab.key("i");
    EXPECT_TRUE(wait_for([&] { return shows("field") == "light"; }));
    lab.key("i");
    EXPECT_TRUE(wait_for([&] { return shows("field") == ""; }));
    lab.click("button.view");
    EXPECT_TRUE(wait_for([&] { return lab.anchors().contains("card.view"); }));
    lab.click("view.labels");
    EXPECT_TRUE(wait_for([&] { return shows("labels") == false; }));
    lab.click("view.light");
    EXPECT_TRUE(wait_for([&] { return shows("field") == "light"; }));
    EXPECT_TRUE(lab.anchors().contains("card.view")) << "the menu stays open";
    lab.key("Escape");
    EXPECT_TRUE(wait_for([&] { return !lab.anchors().contains("card.view"); }));
    lab.key("p");
    EXPECT_TRUE(wait_for([&] { return shows("trails") == false; }));
    EXPECT_EQ(lab.state()["graphics_errors"], 0);
}

}  // namespace
}  // namespace braitenlab::tests::view_window_test

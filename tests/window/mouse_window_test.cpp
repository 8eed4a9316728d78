// Clicks and drags of a pointer that moves on at once, at the low frame rate of these tests.
#include "tests/window/lab_window.h"

namespace braitenlab::tests::mouse_window_test {
namespace {

bool wait_for(const std::function<bool()>& holds, double patience = 5) {
    return LabWindow::eventually(holds, patience);
}

constexpr Point over_the_scene{640, 400};

TEST(MouseQueueWindow, EachClickCountsThoughThePointerMovesOnWithinTheFrame) {
    LabWindow lab({"2a-coward", "--size", "1280x800"});
    const Point play = lab.at("button.play");
    for (int i = 0; i < 8; ++i) {
        const std::string wanted = i % 2 == 0 ? "playing" : "paused";
        lab.move(over_the_scene);
        lab.click_and_leave(play, over_the_scene);
        EXPECT_TRUE(wait_for([&] { return lab.state()["mode"] == wanted; })) << i;
    }
}

TEST(MouseQueueWindow, AClickOnAVehicleSelectsItThoughThePointerMovesOn) {
    LabWindow lab({"predator-prey", "--size", "1280x800"});
    for (const std::size_t i : {std::size_t{1}, std::size_t{4}, std::size_t{2}}) {
        const Json at = lab.state()["vehicles"][i]["at"];
        lab.click_and_leave({at[0].get<int>(), at[1].get<int>()}, {640, 780});
        EXPECT_TRUE(wait_for([&] { return lab.state()["selected"] == static_cast<int>(i); })) << i;
    }
}

TEST(MouseQueueWindow, AWireIsDrawnByADragThatIsShorterThanAFrame) {
    LabWindow lab({"2a-coward", "--size", "1280x800"});
    lab.key("w");
    ASSERT_TRUE(wait_for([&] { return lab.state()["mode"] == "wiring" && lab.anchors().contains("pin.SL.out"); }));
    lab.draw_frames();
    lab.move(over_the_scene);
    lab.drag_and_leave(lab.at("pin.SL.out"), lab.at("pin.MR.in"), over_the_scene);
    EXPECT_TRUE(wait_for([&] { return lab.state()["weights"]["RL"] == 1; }));
    EXPECT_EQ(lab.state()["undo_depth"], 1);
}

TEST(MouseQueueWindow, TheReleaseOutsideTheWindowEndsADrag) {
    LabWindow lab({"2a-coward", "--size", "1000x700"});
    lab.move({500, 400});
    lab.press();
    lab.xdotool("mousemove 1279 500");
    lab.xdotool("mouseup 1");
    EXPECT_TRUE(wait_for([&] { return lab.state()["pressed"] == 0; }));
    EXPECT_TRUE(wait_for([&] { return lab.state()["pointer"] == Json{-1, -1}; })) << lab.state()["pointer"];
}

}  // namespace
}  // namespace braitenlab::tests::mouse_window_test

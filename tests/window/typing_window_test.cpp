// Keys typed faster than frames are drawn, in the real window.
#include "tests/window/lab_window.h"

namespace braitenlab::tests::typing_window_test {
namespace {

// All keys within two or three frames. Not faster: if a key is pressed twice within a millisecond, GLFW ignores the
// second press.
constexpr const char* burst = "key --delay 2 ";

TEST(TypingWindow, KeepsTheOrderOfKeysTypedWithinAFrame) {
    LabWindow lab({"2a-coward", "--size", "1280x800"});
    lab.key("ctrl+shift+s");
    ASSERT_TRUE(LabWindow::eventually([&] { return lab.state()["typed"] == "2a-coward"; })) << lab.state().dump(1);
    lab.xdotool(burst + std::string("ctrl+a h e l l o ctrl+a x Home y"));
    EXPECT_TRUE(LabWindow::eventually([&] { return lab.state()["typed"] == "yx"; })) << lab.state()["typed"];
    lab.xdotool(burst + std::string("BackSpace BackSpace End BackSpace a b ctrl+a ctrl+c End ctrl+v"));
    EXPECT_TRUE(LabWindow::eventually([&] { return lab.state()["typed"] == "abab"; })) << lab.state()["typed"];
}

TEST(TypingWindow, TypesIntoTheFieldThatTheFirstKeyOpens) {
    LabWindow lab({"2a-coward", "--size", "1280x800"});
    lab.xdotool(burst + std::string("ctrl+shift+s ctrl+a s p a c e space 1"));
    EXPECT_TRUE(LabWindow::eventually([&] { return lab.state()["typed"] == "space 1"; })) << lab.state().dump(1);
    EXPECT_EQ(lab.state()["toggles"], 0) << "no letter was a shortcut";
}

TEST(TypingWindow, EachKeyWithinAFrameActsOnWhatTheOneBeforeHasChanged) {
    LabWindow lab({"05-aggressor", "--size", "1280x800"});
    lab.draw_frames();
    lab.xdotool(burst + std::string("1 space"));
    EXPECT_TRUE(LabWindow::eventually([&] { return lab.state()["tick"] > 0; })) << "Space plays";
    EXPECT_EQ(lab.state()["exercise"]["predicted"], 0);
}

TEST(TypingWindow, TypesIntoTheNumberThatAClickOpens) {
    LabWindow lab({"2a-coward", "--size", "1280x800"});
    const auto slider = lab.anchors()["slider.LR"];
    const double right = double(slider[0]) + double(slider[2]), middle = double(slider[1]) + double(slider[3]) / 2;
    lab.xdotool(fmt::format("mousemove {:.0f} {:.0f} click 1 ", right - 12, middle) + burst + "1 period 2 5 Return");
    EXPECT_TRUE(LabWindow::eventually([&] { return lab.state()["weights"]["LR"] == 1.25; }))
        << lab.state()["weights"]["LR"];
    EXPECT_EQ(lab.state()["tick"], 0) << "the point was no step";
}

}  // namespace
}  // namespace braitenlab::tests::typing_window_test

// What is typed faster than frames are drawn, in the real window.
#include "tests/window/lab_window.h"

namespace braitenlab::tests {
namespace {

TEST(TypingWindow, KeepsKeysAndCharactersOfABurstInTheirOrder) {
    LabWindow lab({"2a-coward", "--size", "1280x800"});
    lab.key("ctrl+shift+s");
    ASSERT_TRUE(LabWindow::eventually([&] { return lab.state()["typed"] == "2a-coward"; })) << lab.state().dump(1);
    lab.xdotool("key --delay 0 ctrl+a h e l l o ctrl+a x Home y");
    EXPECT_TRUE(LabWindow::eventually([&] { return lab.state()["typed"] == "yx"; })) << lab.state()["typed"];
    lab.xdotool("key --delay 0 BackSpace BackSpace End BackSpace a b ctrl+a ctrl+c End ctrl+v");
    EXPECT_TRUE(LabWindow::eventually([&] { return lab.state()["typed"] == "abab"; })) << lab.state()["typed"];
}

TEST(TypingWindow, ReachesTheFieldThatTheFirstKeyOfABurstOpens) {
    LabWindow lab({"2a-coward", "--size", "1280x800"});
    lab.xdotool("key --delay 0 ctrl+shift+s ctrl+a s p a c e space 1");
    EXPECT_TRUE(LabWindow::eventually([&] { return lab.state()["typed"] == "space 1"; })) << lab.state().dump(1);
    EXPECT_EQ(lab.state()["toggles"], 0) << "no letter was a shortcut";
}

}  // namespace
}  // namespace braitenlab::tests

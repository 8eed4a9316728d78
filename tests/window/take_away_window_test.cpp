// Pictures and clips saved by the sheet of the window.
#include <gtest/gtest.h>

#include "lab_window.h"

namespace braitenlab::tests::take_away_window_test {
namespace {

struct TakeAwayWindow : testing::Test {
    const Home home;
    LabWindow lab{{"3a-love", "--size", "1100x700", "--quality", "low"}, home.path};

    TakeAwayWindow() {
        if (!windows_program().empty()) return;
        lab.key("space");
        EXPECT_TRUE(LabWindow::eventually([&] { return lab.state()["tick"].get<int>() > 100; }, 20));
        lab.key("space");
        EXPECT_TRUE(LabWindow::eventually([&] { return lab.state()["mode"] == "paused"; }));
    }
    std::string notice() const { return lab.state()["notice"].get<std::string>(); }
    std::string saved(const char* name) const { return (home.path / "Pictures" / name).string(); }
    void open(const char* page) const {
        lab.choose("file", "take_away");
        lab.click(std::string("take.page.") + page);
    }
    void expect_saved(const std::string& file) const {
        EXPECT_TRUE(LabWindow::eventually([&] { return notice().find(file) != std::string::npos; }, 60)) << notice();
        EXPECT_TRUE(std::filesystem::exists(file));
    }
};

TEST_F(TakeAwayWindow, SavesPicturesLargerThanItself) {
    if (!windows_program().empty()) GTEST_SKIP() << "Windows has no file of the user's folders";
    open("1");
    lab.click("take.size.2");
    lab.click("button.clip");
    expect_saved(saved("braitenlab-001.png"));
    const auto anchors = lab.anchors();
    open("1");
    lab.click("take.shows.2");
    lab.click("take.size.2");
    lab.click("button.clip");
    expect_saved(saved("braitenlab-002.png"));
    for (const char* name : {"braitenlab-001.png", "braitenlab-002.png"})
        EXPECT_EQ(shell("identify -format '%wx%h' " + saved(name)).out, "1920x1080");
    const Ran differ =
        shell(fmt::format("compare -metric AE {} {} null:", saved("braitenlab-001.png"), saved("braitenlab-002.png")));
    EXPECT_GT(std::stod(differ.out), 100000) << "the scene alone, and the window with its cards";
    EXPECT_EQ(lab.anchors()["card.brain"], anchors["card.brain"]) << "the window is as it was";
}

TEST_F(TakeAwayWindow, SavesTheDiagramAndThePathsAsSvg) {
    if (!windows_program().empty()) GTEST_SKIP() << "Windows has no file of the user's folders";
    for (const auto& [choice, name, part] :
         {std::tuple{"take.shows.3", "braitenlab-001.svg", "SL"}, {"take.shows.4", "braitenlab-002.svg", "path"}}) {
        open("1");
        lab.click(choice);
        lab.click("button.clip");
        expect_saved(saved(name));
        const std::string text = shell("cat " + saved(name)).out;
        EXPECT_NE(text.find("<svg"), std::string::npos) << name;
        EXPECT_NE(text.find(part), std::string::npos) << name;
    }
}

TEST_F(TakeAwayWindow, SavesAClipOfThePastAndLeavesTheRunAsItIs) {
    if (!windows_program().empty()) GTEST_SKIP() << "Windows has no file of the user's folders";
    const auto before = lab.state();
    open("2");
    lab.click("button.clip");
    expect_saved(saved("braitenlab-001.gif"));
    const int pictures = std::stoi(shell("identify -format '%n\\n' " + saved("braitenlab-001.gif") + " | head -1").out);
    EXPECT_EQ(pictures, before["tick"].get<int>() / 3 + 1)
        << "20 per second of the whole run, which has less than 10 s";
    EXPECT_EQ(lab.state()["tick"], before["tick"]);
    for (const char* number : {"x", "y", "heading"})
        EXPECT_EQ(lab.state()["vehicles"][0][number], before["vehicles"][0][number]) << number;
    lab.key("space");
    EXPECT_TRUE(LabWindow::eventually([&] { return lab.state()["tick"] > before["tick"]; }));
}

TEST_F(TakeAwayWindow, WritesNoFileOfACancelledClip) {
    if (!windows_program().empty()) GTEST_SKIP() << "Windows has no file of the user's folders";
    open("2");
    lab.click("take.size.3");
    lab.click("button.clip");
    ASSERT_TRUE(LabWindow::eventually([&] { return !lab.anchors().contains("button.clip"); }));
    lab.click("take.cancel");
    EXPECT_TRUE(LabWindow::eventually([&] { return !lab.anchors().contains("card.take"); }));
    LabWindow::wait(0.3);
    EXPECT_TRUE(std::filesystem::is_empty(home.path / "Pictures"));
}

}  // namespace
}  // namespace braitenlab::tests::take_away_window_test

// Overlays and fields in the real window.
#include "tests/window/lab_window.h"
#include "tests/x_server.h"

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
    lab.click("menu.view");
    EXPECT_TRUE(wait_for([&] { return lab.anchors().contains("menu.rows"); }));
    lab.click("menu.view.labels");
    EXPECT_TRUE(wait_for([&] { return shows("labels") == false; }));
    lab.click("menu.view.field.light");
    EXPECT_TRUE(wait_for([&] { return shows("field") == "light"; }));
    EXPECT_TRUE(lab.anchors().contains("menu.rows")) << "the menu stays open";
    lab.key("Escape");
    EXPECT_TRUE(wait_for([&] { return !lab.anchors().contains("menu.rows"); }));
    lab.key("p");
    EXPECT_TRUE(wait_for([&] { return shows("trails") == false; }));
    EXPECT_EQ(lab.state()["graphics_errors"], 0);
}

TEST(ViewWindow, KeepsItsPictureWhileNothingChanges) {
    LabWindow lab({"2b-aggressor", "--size", "800x600"});
    lab.move({795, 5});  // over no scene, whose handles end when the pointer leaves
    lab.key("space");
    EXPECT_TRUE(wait_for([&] { return lab.state()["tick"] > 0; }));
    lab.key("space");  // from now on no hint asks to play, and nothing pulses
    const auto number = [&](const char* what) { return lab.state()[what].get<int>(); };
    const auto rests = [&] {
        const int pictures = number("pictures"), frames = number("frames");
        return wait_for([&] { return number("frames") >= frames + 5; }) && number("pictures") == pictures;
    };
    EXPECT_TRUE(wait_for(rests));
    const auto on_screen = [] { return shell("import -window root rgb:- | md5sum").out; };
    const std::string before = on_screen();
    lab.hide_and_show();
    EXPECT_TRUE(wait_for([&] { return on_screen() == before; })) << "a window that was covered is empty";
    EXPECT_TRUE(wait_for(rests));
    lab.key("i");
    EXPECT_TRUE(wait_for([&] { return on_screen() != before; })) << "the field is not shown";
    EXPECT_TRUE(wait_for(rests));
    lab.key("i");
    EXPECT_TRUE(wait_for([&] { return on_screen() == before; }));
}

TEST(ViewWindow, RestsAfterAHintHasPulsedForAWhile) {
    LabWindow lab({"2b-aggressor", "--size", "800x600"});
    const auto pictures = [&] { return lab.state()["pictures"].get<int>(); };
    const int first = pictures();
    EXPECT_TRUE(wait_for([&] { return pictures() > first + 10; })) << "the button that plays does not pulse";
    EXPECT_TRUE(LabWindow::eventually(
        [&] {
            const int before = pictures(), frames = lab.state()["frames"];
            return wait_for([&] { return lab.state()["frames"] > frames + 5; }) && pictures() == before;
        },
        40));
}

TEST(ViewWindow, IsNotLargerThanTheDisplayUnlessItsSizeIsGiven) {
    if (!windows_program().empty()) GTEST_SKIP() << "wine has a desktop of its own";
    const std::string usual = std::getenv("DISPLAY");
    XServer server("1024x600");
    setenv("DISPLAY", server.display().c_str(), 1);
    const auto has_size = [](const char* size) {
        const std::string geometry = "xdotool search --onlyvisible --name Braitenlab getwindowgeometry";
        return wait_for([&] { return shell(geometry).out.find(size) != std::string::npos; });
    };
    {
        LabWindow lab({"2a-coward"});
        EXPECT_TRUE(has_size("1024x600"));
    }
    {
        LabWindow lab({"2a-coward", "--size", "1280x800"});
        EXPECT_TRUE(has_size("1280x800"));
    }
    setenv("DISPLAY", usual.c_str(), 1);
}

TEST(MenuWindow, OpensByF10AndByAltAloneAndIsUsedByKeys) {
    LabWindow lab({"2a-coward", "--size", "1024x768"});
    const auto open = [&](const char* menu) { return wait_for([&] { return lab.state()["menu"] == menu; }); };
    EXPECT_EQ(lab.state()["menu"], "");
    lab.key("Alt_L");
    EXPECT_TRUE(open("file"));
    lab.key("Alt_L");
    EXPECT_TRUE(open(""));
    lab.key("alt+Shift_L");
    lab.draw_frames();
    EXPECT_EQ(lab.state()["menu"], "") << "Alt with another key opens no menu";
    lab.key("F10");
    EXPECT_TRUE(open("file"));
    for (const char* menu : {"edit", "view", "simulation"}) {
        lab.key("Right");
        EXPECT_TRUE(open(menu));
    }
    lab.key("Down");
    lab.key("Return");
    EXPECT_TRUE(wait_for([&] { return lab.state()["tick"] == 1; })) << "the second row is one step";
    EXPECT_TRUE(open(""));
    lab.click("menu.file");
    EXPECT_TRUE(open("file"));
    lab.move(lab.at("menu.help"));
    EXPECT_TRUE(open("help"));
    lab.click("menu.help.about");
    EXPECT_TRUE(wait_for([&] { return lab.anchors().contains("card.about"); }));
}

}  // namespace
}  // namespace braitenlab::tests::view_window_test

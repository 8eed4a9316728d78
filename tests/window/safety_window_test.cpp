// Lecture mode, crashes, unsaved edits and keyboard control in the real window.
#include "tests/window/lab_window.h"
#include "tests/x_server.h"

namespace braitenlab::tests::safety_window_test {
namespace {

bool wait_for(const std::function<bool()>& holds, double patience = 8) {
    return LabWindow::eventually(holds, patience);
}

// When the autosave was written last; the default time if there is none.
std::filesystem::file_time_type written(const Home& home) {
    const auto folder = home.path / "state" / "braitenlab" / "autosave";
    std::error_code none;
    for (std::filesystem::directory_iterator entry(folder, none); entry != std::filesystem::directory_iterator();
         entry.increment(none))
        if (entry->path().extension() == ".autosave") return entry->last_write_time(none);
    return {};
}

// Waits until the autosave exists and has not changed for a second, in which each edit is written.
bool wait_for_the_last_edit(const Home& home) {
    for (int i = 0; i < 20; ++i) {
        const auto before = written(home);
        LabWindow::wait(1);
        if (before != std::filesystem::file_time_type{} && written(home) == before) return true;
    }
    return false;
}

TEST(LectureWindow, F9TwiceRestoresEverything) {
    LabWindow lab({"predator-prey", "--size", "1280x800"});
    lab.click("card.information.fold");
    lab.key("f");
    ASSERT_TRUE(wait_for([&] { return lab.state()["camera"] == "follow"; }));
    lab.draw_frames();
    const Json before = lab.anchors(), looked = lab.state();
    lab.key("F9");
    ASSERT_TRUE(wait_for([&] { return lab.state()["lecture"] == true && lab.anchors().contains("lecture.prey"); }));
    EXPECT_EQ(lab.state()["theme"], "light");
    EXPECT_NEAR(lab.state()["type_size"].get<double>(), 1.4, 0.001);
    lab.key("s");
    EXPECT_TRUE(wait_for([&] { return lab.anchors().contains("lecture.keys"); })) << "pressed keys are shown";
    lab.key("t");
    lab.key("f");
    ASSERT_TRUE(wait_for([&] { return lab.state()["camera"] == "overview"; }));
    lab.key("F9");
    ASSERT_TRUE(wait_for([&] { return lab.state()["lecture"] == false && lab.anchors() == before; }))
        << lab.anchors().dump(1);
    for (const char* what : {"theme", "type_size", "camera", "view", "sensors", "language", "hash", "mode"})
        EXPECT_EQ(lab.state()[what], looked[what]) << what;
}

TEST(SheetWindow, PausesTheRunWhileItIsOpen) {
    LabWindow lab({"predator-prey", "--size", "1280x800", "--play"});
    ASSERT_TRUE(wait_for([&] { return lab.state()["tick"] > 0; }));
    lab.key("F1");
    ASSERT_TRUE(wait_for([&] { return lab.anchors().contains("card.keys"); }));
    lab.draw_frames();
    const Json tick = lab.state()["tick"];
    lab.key("r");
    lab.draw_frames();
    EXPECT_EQ(lab.state()["tick"], tick);
    EXPECT_EQ(lab.state()["mode"], "playing");
    lab.key("space");  // presses the button with the ring, Close
    EXPECT_TRUE(wait_for([&] { return lab.state()["tick"] > tick; }));
}

TEST(CrashWindow, OffersTheWorkAfterACrash) {
    const Home home;
    {
        LabWindow lab({"2a-coward", "--size", "1280x800"}, home.path);
        lab.key("2");
        for (int i = 0; i < 10; ++i) lab.key("Right");
        ASSERT_TRUE(wait_for([&] { return lab.state()["weights"]["LR"] == 0.5; }));
        ASSERT_TRUE(wait_for_the_last_edit(home));
        lab.kill_at_once();
    }
    {
        LabWindow lab({"3a-love", "--size", "1280x800"}, home.path);
        ASSERT_TRUE(wait_for([&] { return lab.anchors().contains("recovery.take"); }));
        lab.key("Return");
        EXPECT_TRUE(wait_for([&] { return lab.state()["weights"]["LR"] == 0.5; })) << lab.state().dump(1);
        EXPECT_EQ(lab.state()["opened"], "2a-coward");
        lab.key("ctrl+q");
        ASSERT_TRUE(wait_for([&] { return lab.anchors().contains("leaving.discard"); }));
        lab.draw_frames();  // the sheet measures itself in its first frames
        lab.click("leaving.discard");
        EXPECT_EQ(lab.exit_code(), 0);
    }
    LabWindow lab({"3a-love", "--size", "1280x800"}, home.path);
    lab.draw_frames();
    EXPECT_FALSE(lab.anchors().contains("recovery.take")) << "no recovery is offered after a normal end";
}

TEST(CrashWindow, OffersTheWorkAfterTheDisplayIsLost) {
    if (!windows_program().empty()) GTEST_SKIP() << "Windows has no X server";
    const Home home;
    const std::string usual = std::getenv("DISPLAY");
    {
        XServer server;
        setenv("DISPLAY", server.display().c_str(), 1);
        LabWindow lab({"2a-coward", "--size", "1280x800"}, home.path);
        const auto set_to = [&](const char* key, double value) {
            lab.key(key);
            ASSERT_TRUE(wait_for([&] { return lab.state()["weights"]["LR"] == value; }));
        };
        lab.key("2");
        set_to("Right", 0.05);
        ASSERT_TRUE(wait_for([&] { return written(home) != std::filesystem::file_time_type{}; }));
        const auto first = written(home);
        set_to("Right", 0.1);
        ASSERT_TRUE(wait_for([&] { return written(home) != first; })) << "the second edit, too";
        server.end();
        EXPECT_EQ(lab.exit_code(), 1);
        setenv("DISPLAY", usual.c_str(), 1);
    }
    LabWindow lab({"3a-love", "--size", "1280x800"}, home.path);
    ASSERT_TRUE(wait_for([&] { return lab.anchors().contains("recovery.take"); }));
    lab.key("Return");
    EXPECT_TRUE(wait_for([&] { return lab.state()["weights"]["LR"] == 0.1; })) << lab.state().dump(1);
}

TEST(CrashWindow, OffersARunWithoutEdits) {
    const Home home;
    int reached = 0;
    {
        LabWindow lab({"predator-prey", "--size", "640x480", "--play"}, home.path);  // small: it is drawn for 20 s
        ASSERT_TRUE(wait_for([&] { return written(home) != std::filesystem::file_time_type{}; }));
        const auto first = written(home);
        ASSERT_TRUE(wait_for([&] { return written(home) != first; }, 40)) << "written every twenty seconds";
        reached = lab.state()["tick"];
        lab.kill_at_once();
    }
    LabWindow lab({"3a-love", "--size", "1280x800"}, home.path);
    ASSERT_TRUE(wait_for([&] { return lab.anchors().contains("recovery.take"); }));
    lab.key("Return");
    ASSERT_TRUE(wait_for([&] { return lab.state()["opened"] == "predator-prey"; }));
    EXPECT_GT(lab.state()["tick"], 60) << "the run continues, not its start";
    EXPECT_GE(lab.state()["tick"], reached - 20 * 60) << "at most twenty seconds are lost";
    EXPECT_LE(lab.state()["tick"], reached + 60);
}

TEST(CrashWindow, ASignalDuringAComparisonKeepsTheBrainOfTheStudent) {
    if (!windows_program().empty()) GTEST_SKIP() << "Windows has no signals";
    const Home home;
    {
        LabWindow lab({"2a-coward", "--size", "1280x800"}, home.path);
        const auto raise_to = [&](double value) {
            lab.key("2");
            lab.key("Right");
            ASSERT_TRUE(wait_for([&] { return lab.state()["weights"]["LR"] == value; }));
        };
        lab.key("q");  // A
        raise_to(0.05);
        lab.key("q");  // B
        raise_to(0.1);
        lab.key("shift+q");
        ASSERT_TRUE(wait_for([&] { return lab.state()["weights"]["LR"] == 0.0; }));
        lab.send(SIGTERM);
        EXPECT_EQ(lab.exit_code(), 0);
    }
    LabWindow lab({"2a-coward", "--size", "1280x800"}, home.path);
    ASSERT_TRUE(wait_for([&] { return lab.anchors().contains("recovery.take"); }));
    lab.key("Return");
    EXPECT_TRUE(wait_for([&] { return lab.state()["weights"]["LR"] == 0.1; })) << lab.state()["weights"].dump();
}

TEST(CrashWindow, EndsOnSigtermAndOffersTheWork) {
    if (!windows_program().empty()) GTEST_SKIP() << "Windows has no signals";
    const Home home;
    {
        LabWindow lab({"2a-coward", "--size", "1280x800"}, home.path);
        lab.key("2");
        lab.key("Right");
        ASSERT_TRUE(wait_for([&] { return lab.state()["weights"]["LR"] == 0.05; }));
        lab.key("t");
        ASSERT_TRUE(wait_for([&] { return lab.state()["theme"] == "light"; }));
        lab.send(SIGTERM);
        EXPECT_EQ(lab.exit_code(), 0);
    }
    LabWindow lab({"2a-coward", "--size", "1280x800"}, home.path);
    EXPECT_EQ(lab.state()["theme"], "light") << "settings are written";
    ASSERT_TRUE(wait_for([&] { return lab.anchors().contains("recovery.take"); }));
    lab.key("Return");
    EXPECT_TRUE(wait_for([&] { return lab.state()["weights"]["LR"] == 0.05; }));
}

TEST(CrashWindow, LeavesTheScreenBeforeItKeepsTheWork) {
    if (!windows_program().empty()) GTEST_SKIP() << "Windows has no signals";
    const Home home;
    std::ofstream(home.path / "crowd.toml")
        << "format = 1\n[arena]\nwidth = 400\nheight = 400\n[kind.k.brain]\nLM = 1\n"
           "RM = 0.9\n[ecology]\npopulation = 20000\n";
    LabWindow lab({(home.path / "crowd.toml").string(), "--size", "640x480", "--play"}, home.path);
    ASSERT_TRUE(wait_for([&] { return lab.state()["tick"] > 0; }, 60));
    ASSERT_TRUE(lab.is_on_screen());
    lab.send(SIGTERM);
    EXPECT_TRUE(wait_for([&] { return !lab.is_on_screen(); }, 60));
    EXPECT_FALSE(lab.has_ended()) << "it writes 20,000 vehicles";
    EXPECT_EQ(lab.exit_code(60), 0);
    EXPECT_NE(written(home), std::filesystem::file_time_type{});
}

TEST(UnsavedWindow, AsksBeforeItLeavesAndSavesUnderANewName) {
    const Home home;
    LabWindow lab({"2a-coward", "--size", "1280x800"}, home.path);
    lab.key("2");
    lab.key("Right");
    ASSERT_TRUE(wait_for([&] { return lab.state()["weights"]["LR"] == 0.05; }));
    lab.key("ctrl+q");
    ASSERT_TRUE(wait_for([&] { return lab.anchors().contains("leaving.save"); }));
    EXPECT_EQ(lab.exit_code(0.5), -1);
    lab.key("Escape");
    ASSERT_TRUE(wait_for([&] { return !lab.anchors().contains("leaving.save"); }));
    EXPECT_EQ(lab.state()["weights"]["LR"], 0.05);
    lab.choose("file", "open");
    lab.click("open.3a-love");
    ASSERT_TRUE(wait_for([&] { return lab.anchors().contains("leaving.save"); }));
    lab.key("Return");
    ASSERT_TRUE(wait_for([&] { return lab.anchors().contains("files.path"); }));
    lab.draw_frames();
    lab.key("ctrl+a");
    lab.xdotool("type --delay 60 " + path_for_program(home.path / "mine"));
    lab.key("Return");
    EXPECT_TRUE(wait_for([&] { return lab.state()["opened"] == "3a-love"; })) << lab.state()["opened"];
    EXPECT_TRUE(std::filesystem::exists(home.path / "mine.toml"));
    lab.key("F1");
    ASSERT_TRUE(wait_for([&] { return lab.anchors().contains("card.keys"); }));
    lab.key("ctrl+q");
    EXPECT_EQ(lab.exit_code(), 0) << "nothing is unsaved, and an open sheet does not matter";
}

TEST(ScreenshotWindow, WritesToTheFolderOfPictures) {
    if (!windows_program().empty()) GTEST_SKIP() << "Windows has no file of the user's folders";
    const Home home;
    std::filesystem::create_directories(home.path / "config");
    std::ofstream(home.path / "config" / "user-dirs.dirs") << "XDG_PICTURES_DIR=\"$HOME/Bilder\"\n";
    LabWindow lab({"2a-coward", "--size", "1280x800"}, home.path);
    lab.key("F12");
    const auto file = home.path / "Bilder" / "braitenlab-001.png";
    EXPECT_TRUE(wait_for([&] {
        return lab.state()["notice"].get<std::string>().find(file.string()) != std::string::npos;
    })) << lab.state()["notice"];
    EXPECT_TRUE(std::filesystem::exists(file));
}

struct Screen {
    const char *size, *scale;
};

class KeyboardAlone : public testing::TestWithParam<Screen> {
protected:
    LabWindow lab{{"05-aggressor", "--size", GetParam().size, "--scale", GetParam().scale}};

    // The focused widget is visible as a whole.
    void expect_focus_in_sight() const {
        const std::string focus = lab.state()["focus"];
        if (focus.empty()) return;
        const double least = 15 * std::stod(GetParam().scale);  // px; on a busy machine a card scrolls frames later
        ASSERT_TRUE(wait_for([&] {
            const Json all = lab.anchors();
            return all.contains(focus) && all[focus][3] >= least;
        })) << focus
            << " is missing or clipped";
        const auto r = lab.anchors()[focus].get<std::vector<double>>();
        int width = 0, height = 0;
        std::sscanf(GetParam().size, "%dx%d", &width, &height);
        EXPECT_GE(r[0], 0) << focus;
        EXPECT_GE(r[1], 0) << focus;
        EXPECT_LE(r[0] + r[2], width) << focus;
        EXPECT_LE(r[1] + r[3], height) << focus;
    }
    void press(const std::string& key) const {
        lab.key(key);
        lab.draw_frames();
        expect_focus_in_sight();
    }
    bool go_to(const std::string& anchor, const std::string& by) const {
        for (int i = 0; i < 40; ++i) {
            const Json before = lab.state()["focus"];
            if (before == anchor) return true;
            lab.key(by);
            wait_for([&] { return lab.state()["focus"] != before; });
            expect_focus_in_sight();
        }
        return false;
    }
    void set(const std::string& slider, const std::string& anchor, const std::string& value) const {
        press(slider);
        ASSERT_TRUE(wait_for([&] { return lab.state()["focus"] == "slider." + anchor; }));
        press("Return");
        lab.draw_frames();  // the field opens with the next frame
        lab.xdotool("type --delay 40 " + value);
        press("Return");
        EXPECT_TRUE(wait_for([&] { return lab.state()["weights"][anchor] == std::stod(value); })) << anchor;
    }
};

TEST_P(KeyboardAlone, FinishesTheExercise) {
    ASSERT_TRUE(go_to("card.exercise.fold", "ctrl+Tab"));
    ASSERT_TRUE(go_to("exercise.predict.1", "Tab"));
    press("Return");
    press("space");  // until the first run the digits correct the answer
    ASSERT_TRUE(wait_for([&] { return lab.state()["tick"] > 0; }));
    press("space");
    set("1", "LL", "0");
    set("2", "LR", "1.5");
    set("3", "RL", "1.5");
    set("4", "RR", "0");
    lab.set_speed(8);
    press("space");
    EXPECT_TRUE(wait_for([&] { return lab.state()["exercise"]["passed"] == true; }, 60)) << lab.state().dump(1);
}

INSTANTIATE_TEST_SUITE_P(Screens, KeyboardAlone, testing::Values(Screen{"1024x768", "1"}, Screen{"1920x1150", "2"}),
                         [](const auto& given) { return "AtScale" + std::string(given.param.scale); });

}  // namespace
}  // namespace braitenlab::tests::safety_window_test

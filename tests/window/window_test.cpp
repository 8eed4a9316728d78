#include <cmath>
#include <memory>

#include "render/view/camera.h"
#include "render/view/framing.h"
#include "tests/folder.h"
#include "tests/window/lab_window.h"

namespace braitenlab::tests::window_test {
namespace {

bool wait_for(const std::function<bool()>& holds, double patience = 5) {
    return LabWindow::eventually(holds, patience);
}

TEST(LabWindow, OpensTheFirstExercisePausedWithItsVehicleSelected) {
    LabWindow lab({"--size", "1280x800"});
    EXPECT_FALSE(lab.anchors().contains("button.play")) << "only the title page";
    lab.click("title.begin");
    EXPECT_TRUE(wait_for([&] { return lab.anchors().contains("button.play"); }));
    const Json state = lab.state();
    EXPECT_EQ(state["mode"], "paused");
    EXPECT_EQ(state["tick"], 0);
    EXPECT_EQ(state["selected"], 0);
    EXPECT_EQ(state["exercise"]["id"], "01-drive");
    EXPECT_EQ(state["exercise"]["passed"], false);
    EXPECT_EQ(state["toggles"], 0);
}

TEST(LabWindow, TogglesPlayOncePerPressOfSpace) {
    LabWindow lab({"predator-prey", "--size", "1280x800"});
    lab.xdotool("key --delay 12 " + []() {
        std::string keys;
        for (int i = 0; i < 20; ++i) keys += "space ";
        return keys;
    }());
    EXPECT_TRUE(wait_for([&] { return lab.state()["toggles"] == 20; }, 5)) << lab.state()["toggles"];
    EXPECT_EQ(lab.state()["mode"], "paused");
}

TEST(LabWindow, ChangesAWeightWhileItIsDraggedAndPlaying) {
    LabWindow lab({"predator-prey", "--size", "1280x800", "--play"});
    const double before = lab.state()["weights"]["LL"];
    const Point knob = lab.at("slider.LL");
    lab.move(knob);
    lab.press();
    lab.move({knob.x + 20, knob.y});
    lab.move({knob.x + 30, knob.y});
    EXPECT_TRUE(wait_for([&] { return lab.state()["weights"]["LL"] != before; })) << "while the button is down";
    const auto tick = lab.state()["tick"].get<int>();
    lab.release();
    EXPECT_TRUE(wait_for([&] { return lab.state()["undo_depth"] == 1; })) << "a drag is one step of undo";
    EXPECT_TRUE(wait_for([&] { return lab.state()["tick"].get<int>() > tick; })) << "the run continues";
    lab.key("ctrl+z");
    EXPECT_TRUE(wait_for([&] { return lab.state()["weights"]["LL"] == before; }));
}

TEST(LabWindow, GoesBackFiveSecondsAndForwardAgainExactly) {
    LabWindow lab({"predator-prey", "--size", "640x480", "--play"});
    lab.set_speed(8);
    ASSERT_TRUE(wait_for([&] { return lab.state()["tick"] > 420; }, 40));
    lab.key("space");
    ASSERT_TRUE(wait_for([&] { return lab.state()["mode"] == "paused"; }));
    lab.set_speed(1);
    const Json there = lab.state();
    lab.key("shift+comma");
    ASSERT_TRUE(wait_for([&] { return lab.state()["tick"] == there["tick"].get<int>() - 300; })) << lab.state()["tick"];
    EXPECT_EQ(lab.state()["latest"], there["tick"]);
    lab.key("space");
    ASSERT_TRUE(wait_for([&] { return lab.state()["tick"] > there["tick"]; }, 40)) << "also past the recorded tick";
    lab.key("space");
    ASSERT_TRUE(wait_for([&] { return lab.state()["mode"] == "paused"; }));
    while (lab.state()["tick"] > there["tick"]) {
        const Json now = lab.state()["tick"];
        lab.key("comma");
        ASSERT_TRUE(wait_for([&] { return lab.state()["tick"] < now; }));
    }
    EXPECT_EQ(lab.state()["hash"], there["hash"]);
}

TEST(LabWindow, ScrubsWithTheMouseAndReturnsToABookmark) {
    LabWindow lab({"predator-prey", "--size", "1280x800", "--play"});
    lab.set_speed(8);
    ASSERT_TRUE(wait_for([&] { return lab.state()["tick"] > 300; }, 40));
    lab.key("space");
    ASSERT_TRUE(wait_for([&] { return lab.state()["mode"] == "paused"; }));
    const Json there = lab.state();
    lab.click("timeline.bookmark");
    ASSERT_TRUE(wait_for([&] { return lab.state()["bookmarks"] == 1; }));
    const auto track = lab.anchors()["timeline.track"].get<std::vector<double>>();
    const int y = static_cast<int>(track[1] + track[3] / 2), left = static_cast<int>(track[0]);
    lab.drag({left + 20, y}, {left + 8, y});
    ASSERT_TRUE(wait_for([&] { return lab.state()["tick"] < 100; })) << lab.state()["tick"];
    EXPECT_EQ(lab.state()["latest"], there["tick"]);
    lab.click("bookmark.1");
    ASSERT_TRUE(wait_for([&] { return lab.state()["tick"] == there["tick"]; }));
    EXPECT_EQ(lab.state()["hash"], there["hash"]);
}

TEST(LabWindow, RunsAtOneEighthOfTheSpeed) {
    LabWindow lab({"2a-coward", "--size", "1280x800"});
    for (int i = 0; i < 3; ++i) lab.key("minus");
    ASSERT_TRUE(wait_for([&] { return lab.state()["time_scale"] == 0.125; }));
    lab.key("space");
    ASSERT_TRUE(wait_for([&] { return lab.state()["tick"] > 0; }));
    // A busy machine may be slower, but never faster. playback_test.cpp measures the speed itself.
    const auto begin = std::chrono::steady_clock::now();
    const double from = lab.state()["seconds"];
    ASSERT_TRUE(wait_for([&] { return lab.state()["seconds"].get<double>() > from + 0.25; }, 40));
    EXPECT_GT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), 0.25 * 8 * 0.9);
}

TEST(LabWindow, TurnsTheOverviewWithTheArrowKeys) {
    LabWindow lab({"predator-prey", "--size", "1280x800"});
    lab.click("viewport");
    const Json before = lab.state()["view"];
    lab.xdotool("keydown Right");
    EXPECT_TRUE(wait_for([&] { return lab.state()["view"]["azimuth"] != before["azimuth"]; }));
    lab.xdotool("keyup Right");
    lab.draw_frames();
    lab.key("Home");
    EXPECT_TRUE(wait_for([&] { return lab.state()["view"] == before; }));
}

TEST(LabWindow, PassesTheExerciseWithTheMouseAlone) {
    LabWindow lab({"05-aggressor", "--size", "1280x800"});
    lab.click("exercise.predict.1");
    // Sets the straight wires to 0 and the crossed ones to a large weight.
    const auto set = [&](const std::string& slider, double share) {
        const auto r = lab.anchors()[slider].get<std::vector<double>>();
        const Point middle = lab.at(slider);
        lab.drag(middle, {static_cast<int>(r[0] + r[2] * share), middle.y});
    };
    set("slider.LR", 0.9);
    set("slider.RL", 0.9);
    set("slider.LL", 0.5);
    set("slider.RR", 0.5);
    for (int i = 0; i < 3; ++i) lab.click("button.faster");
    lab.click("button.play");
    EXPECT_TRUE(wait_for([&] { return lab.state()["exercise"]["passed"] == true; }, 40)) << lab.state().dump(1);
}

// Position of a vehicle of predator-prey in the window at the start, from the camera and from
// braitenctl.
Point start_in_window(const LabWindow& lab, std::size_t vehicle) {
    const auto free = lab.anchors()["viewport"].get<std::vector<float>>();
    const Json all =
        Json::parse(shell(program("braitenctl") + " run predator-prey --seconds 0 --json").out)["vehicles"];
    auto scene = std::make_shared<Scene>();
    scene->arena.width = scene->arena.height = 24;
    Snapshot start;
    start.scene = scene;
    for (const Json& each : all) {
        start.vehicles.emplace_back();
        start.vehicles.back().x = each["x"], start.vehicles.back().y = each["y"];
    }
    const Json& v = all[vehicle];
    const Rect window{0, 0, 1280, 800}, area{free[0], free[1], free[2], free[3]};
    Framing framing;
    const FloorBox box = framing.follow(start, {.camera = {}, .window = window, .free_area = area});
    const CameraView camera_view = look(framing.raised({}), scene->arena, nullptr, window, area, &box);
    const auto at = project(camera_view, {v["x"], v["y"]}, 0.1f);
    return {static_cast<int>(at->x), static_cast<int>(at->y)};
}

TEST(LabWindow, SelectsTheVehicleThatIsClicked) {
    LabWindow lab({"predator-prey", "--size", "1280x800"});
    for (const std::size_t vehicle : {std::size_t{6}, std::size_t{3}}) {
        lab.click(start_in_window(lab, vehicle));
        EXPECT_TRUE(wait_for([&] { return lab.state()["selected"] == vehicle; })) << lab.state()["selected"];
    }
    EXPECT_EQ(lab.state()["undo_depth"], 0) << "a click does not move a vehicle";
}

TEST(LabWindow, DragsAVehicleAndUndoMovesItBack) {
    LabWindow lab({"predator-prey", "--size", "1280x800"});
    const auto before = lab.state()["hash"];
    const Point from = start_in_window(lab, 0);
    lab.drag(from, {from.x + 60, from.y - 40});
    EXPECT_TRUE(wait_for([&] { return lab.state()["undo_depth"] == 1; }));
    EXPECT_NE(lab.state()["hash"], before);
    lab.key("ctrl+z");
    EXPECT_TRUE(wait_for([&] { return lab.state()["hash"] == before; }));
}

TEST(LabWindow, OpensAnotherSceneFromItsMenu) {
    LabWindow lab({"--size", "1280x800"});
    lab.key("Return");
    lab.choose("file", "open");
    ASSERT_TRUE(wait_for([&] { return lab.anchors().contains("open.2a-coward"); }));
    lab.click("open.2a-coward");
    EXPECT_TRUE(wait_for([&] { return lab.state()["opened"] == "2a-coward"; }));
    EXPECT_TRUE(lab.state()["exercise"].is_null());
    EXPECT_EQ(lab.state()["mode"], "paused");
}

TEST(LabWindow, OpensAnEmptySceneForANewOne) {
    LabWindow lab({"predator-prey", "--size", "1280x800"});
    lab.choose("file", "new_scene");
    ASSERT_TRUE(wait_for([&] { return lab.state()["opened"] == "empty"; }));
    EXPECT_EQ(lab.state()["population"], 1);
    EXPECT_EQ(lab.state()["wires"], 0);
    EXPECT_TRUE(lab.state()["sources"].empty());
    lab.key("ctrl+s");
    EXPECT_TRUE(wait_for([&] { return lab.anchors().contains("files.path"); })) << "what ships is not written over";
}

TEST(LabWindow, OpensTheLastFileWithTheSavedThemeLanguageAndView) {
    const Home home;
    {
        LabWindow lab({"3a-love", "--size", "1100x780"}, home.path);
        lab.key("t");
        lab.key("b");
        lab.click("card.scene.fold");
        EXPECT_TRUE(wait_for([&] { return lab.state()["camera"] == "birds_eye"; }));
        lab.key("ctrl+comma");
        lab.click("settings.language.1");
        EXPECT_TRUE(wait_for([&] { return lab.state()["language"] == "de"; }));
        lab.key("Escape");
        lab.key("ctrl+q");
        EXPECT_EQ(lab.exit_code(), 0);
    }
    LabWindow lab({}, home.path);
    EXPECT_EQ(lab.state()["opened"], "3a-love");
    EXPECT_EQ(lab.state()["theme"], "light");
    EXPECT_EQ(lab.state()["language"], "de");
    EXPECT_EQ(lab.state()["camera"], "birds_eye");
    const Json bar = lab.anchors()["hint.bar"], card = lab.anchors()["card.scene"];
    EXPECT_EQ(bar[2], 1100) << "the window is as wide as it was";
    EXPECT_LT(card[3].get<double>(), 50) << "the card is folded";
}

TEST(LabWindow, StartsWithBrokenSettingsAndReportsThem) {
    const Home home;
    std::filesystem::create_directories(home.path / "config" / "braitenlab");
    std::ofstream(home.path / "config" / "braitenlab" / "settings.toml") << "theme = [[\n";
    LabWindow lab({"2a-coward", "--size", "1280x800"}, home.path);
    EXPECT_NE(lab.state()["notice"].get<std::string>().find("settings.toml"), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(home.path / "config" / "braitenlab" / "settings.toml.broken"));
}

TEST(LabWindow, TakesTheSamePictureTwice) {
    const Home home;
    const auto shoot = [&](const char* name) {
        const auto file = home.path / name;
        const Ran ran = shell(fmt::format("{} predator-prey --size 640x480 --seed 5 --play --after 1.5 --screenshot {}",
                                          program("braitenlab"), file.string()));
        EXPECT_EQ(ran.code, 0) << ran.out;
        return file.string();
    };
    const std::string a = shoot("a.png"), b = shoot("b.png");
    EXPECT_EQ(std::stoi(shell(fmt::format("compare -metric AE {} {} null:", a, b)).out), 0) << "pixels that differ";
    EXPECT_GT(std::stoi(shell(fmt::format("identify -format '%k' {}", a)).out), 200) << "colours in the picture";
}

TEST(LabWindow, TakesAPictureAtOnceWithTheLayoutOfLaterFrames) {
    const Home home;
    const auto shoot = [&](const char* after) {
        const std::string file = (home.path / after).string() + ".png";
        const Ran ran =
            shell(fmt::format("{} wheels-to-neurons --page 12 --revealed 2 --size 800x600 --quality low "
                              "--after {} --screenshot {}",
                              program("braitenlab"), after, file));
        EXPECT_EQ(ran.code, 0) << ran.out;
        return file;
    };
    const std::string at_once = shoot("0"), later = shoot("3");
    const std::string differ = shell(fmt::format("compare -metric AE {} {} null:", at_once, later)).out;
    EXPECT_LT(std::stoi(differ), 500) << "pixels; an eye that moves has about 50";
}

TEST(LabWindow, TakesAPictureLargerThanTheDisplay) {
    const Home home;
    const auto file = (home.path / "large.png").string();
    const Ran ran =
        shell(fmt::format("{} 2a-coward --size 3840x2160 --scale 2 --quality low --play --after 0.2 "
                          "--screenshot {}",
                          program("braitenlab"), file));
    EXPECT_EQ(ran.code, 0) << ran.out;
    EXPECT_EQ(shell("identify -format '%wx%h' " + file).out, "3840x2160");
    const std::string corner = shell(fmt::format("convert {} -crop 900x900+2900+1200 -format '%k' info:", file)).out;
    EXPECT_GT(std::stoi(corner), 50) << "colours beyond the edge of the display";
}

TEST(LabWindow, WritesAClipWithoutAPlayingWindow) {
    const Home home;
    const auto file = (home.path / "clip.gif").string();
    const Ran ran = shell(fmt::format("{} 3a-love --seed 5 --quality low --clip {} --from 2 --to 3 --size 320x200",
                                      program("braitenlab"), file));
    EXPECT_EQ(ran.code, 0) << ran.out;
    EXPECT_EQ(shell("identify -format '%n ' " + file + " | cut -d' ' -f1").out.substr(0, 2), "21") << "20 per second";
    EXPECT_EQ(shell("identify -format '%W %H %T\n' " + file + " | sort -u").out, "320 200 5\n");
    const std::string pictures = (home.path / "p").string();
    const Ran moves = shell(fmt::format(
        "convert {0} -coalesce {1}-%02d.png && compare -metric AE {1}-00.png {1}-20.png null:", file, pictures));
    EXPECT_GT(std::atoi(moves.out.c_str()), 100) << "pixels that the vehicle changes: " << moves.out;
}

TEST(LabWindow, RefusesAClipThatCannotBe) {
    const Home home;
    const auto in_home = [&](const char* name) { return (home.path / name).string(); };
    const auto clip = [&](const std::string& options) { return shell(program("braitenlab") + " 3a-love " + options); };
    const Ran ends = clip("--clip " + in_home("a.gif") + " --from 5 --to 2");
    EXPECT_EQ(ends.code, 2);
    EXPECT_NE(ends.out.find("ends before it begins"), std::string::npos) << ends.out;
    const Ran other = clip("--clip " + in_home("a.avi"));
    EXPECT_EQ(other.code, 2);
    EXPECT_NE(other.out.find(".webm"), std::string::npos) << other.out;
    const Ran small = clip("--size 320x200 --screenshot " + in_home("a.png"));
    EXPECT_EQ(small.code, 2);
    EXPECT_NE(small.out.find("640x480"), std::string::npos) << small.out;
    EXPECT_FALSE(std::filesystem::exists(home.path / "a.gif"));
}

TEST(LabWindow, ExitsWithTwoWithoutADisplay) {
    const Ran ran = shell("env -u DISPLAY -u WAYLAND_DISPLAY " + program("braitenlab"));
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.out.find("A display is needed"), std::string::npos) << ran.out;
}

TEST(LabWindow, PrintsNothingThatATerminalActsUpon) {
    const std::string hostile = "\"$(printf 'x\\033[2J\\nfaked')\"";
    for (const std::string& call : {"--size " + hostile, "--unknown" + hostile, "--screenshot p.png " + hostile}) {
        const Ran ran = shell("env -u DISPLAY -u WAYLAND_DISPLAY " + program("braitenlab") + " " + call);
        EXPECT_EQ(ran.code, 2) << call;
        EXPECT_NE(ran.out.find("faked"), std::string::npos) << call << "\n" << ran.out;
        EXPECT_EQ(ran.out.find("\nfaked"), std::string::npos) << call << "\n" << ran.out;
        EXPECT_EQ(ran.out.find('\033'), std::string::npos) << call << "\n" << ran.out;
    }
}

TEST(LabWindow, NamesTheNearestOption) {
    for (const char* wrong : {"--lnag de", "--lnag=de"}) {
        const Ran ran = shell("env -u DISPLAY " + program("braitenlab") + " " + wrong);
        EXPECT_EQ(ran.code, 2);
        EXPECT_NE(ran.out.find("'--lang'"), std::string::npos) << ran.out;
    }
}

// In a folder of its own: without the check these calls replace what they read.
TEST(LabWindow, WritesOverNoSceneRunOrArchive) {
    const Folder folder;
    const std::string scene = text_of(BRAITENLAB_SOURCE "/exercises/scenes/2b-aggressor.toml");
    const auto put_back = [&] {
        put_text(folder / "a.toml", scene), put_text(folder / "b.run", "{\"format\": 1}"),
            put_text(folder / "c.zip", "PK\x03\x04");
        put_text(folder / "old.json", "{\n \"mode\": \"paused\"}");
    };
    const std::string in =
        "cd " + folder.path.string() + " && env -u DISPLAY -u WAYLAND_DISPLAY " + program("braitenlab");
    for (const char* call :
         {"a.toml --screenshot a.toml", "a.toml --screenshot ./a.toml", "a.toml --clip a.toml --to 0.1",
          "a.toml --state a.toml", "a.toml --anchors a.toml", "--screenshot b.run", "--state b.run",
          "--screenshot c.zip", "--state d.json --anchors d.json"}) {
        put_back();
        const Ran ran = shell(in + " " + call);
        EXPECT_EQ(ran.code, 2) << call;
        EXPECT_NE(ran.out.find("give another one"), std::string::npos) << call << "\n" << ran.out;
        EXPECT_EQ(text_of(folder / "a.toml"), scene) << call;
    }
    put_back();
    EXPECT_EQ(shell(in + " --state old.json").out.find("give another one"), std::string::npos) << "its own is replaced";
}

TEST(LabWindow, AnswersVersionAndHelpWithoutADisplay) {
    EXPECT_EQ(shell("env -u DISPLAY " + program("braitenlab") + " --version").code, 0);
    const Ran help = shell("env -u DISPLAY " + program("braitenlab") + " --help");
    EXPECT_EQ(help.code, 0);
    EXPECT_NE(help.out.find("--screenshot"), std::string::npos);
    if (!std::filesystem::exists("/dev/full")) return;
    for (const char* option : {"--version", "--help"})
        EXPECT_EQ(shell(program("braitenlab") + " " + option + " > /dev/full").code, 2) << "exit code 0 means written";
}

TEST(LabWindow, OpensWithABrokenSceneAndReportsFileAndLine) {
    const Home home;
    const auto file = home.path / "broken.toml";
    std::ofstream(file) << "format = 1\n\n[ecology]\npopulatoin = 3\n";
    LabWindow lab({file.string(), "--size", "1280x800"}, home.path);
    EXPECT_EQ(lab.state()["opened"], "01-drive");
    for (const std::string& said : {lab.state()["notice"].get<std::string>(), lab.said()}) {
        EXPECT_NE(said.find("broken.toml:4:"), std::string::npos) << said;
        EXPECT_NE(said.find("population"), std::string::npos) << said;
    }
}

TEST(LabWindow, TakesNoPictureOfABrokenScene) {
    const Home home;
    const auto file = home.path / "broken.toml", picture = home.path / "picture.png";
    std::ofstream(file) << "format = 1\n\n[ecology]\npopulatoin = 3\n";
    const Ran ran = shell(fmt::format("{} {} --screenshot {}", program("braitenlab"), file.string(), picture.string()));
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.out.find("broken.toml:4:"), std::string::npos) << ran.out;
    EXPECT_FALSE(std::filesystem::exists(picture));
    EXPECT_EQ(shell(program("braitenlab") + " 2a-coward --set kind.unknown.brain.LL=1").code, 2);
}

TEST(LabWindow, ExitsByTheFileMenu) {
    LabWindow lab({"2a-coward", "--size", "1280x800"});
    lab.choose("file", "exit");
    EXPECT_EQ(lab.exit_code(), 0);
}

}  // namespace
}  // namespace braitenlab::tests::window_test

// The real window, driven by mouse and keyboard (xdotool) and judged by the state that it reports.
#pragma once

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <pwd.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/io/checked_json.h"

namespace braitenlab::tests {

using Json = nlohmann::json;

struct Point {
    int x = 0, y = 0;
};

// A shell command's output and exit code.
struct Ran {
    int code = -1;
    std::string out;
};
inline Ran shell(const std::string& command) {
    Ran ran;
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    if (!pipe) return ran;
    char buffer[4096];
    for (std::size_t n = 0; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;) ran.out.append(buffer, n);
    const int status = pclose(pipe);
    ran.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return ran;
}

inline std::string program(const char* name) { return std::string(BRAITENLAB_BINARY) + "/" + name; }

// A temporary folder of a new name; removed with the object.
class Home {
public:
    Home() = default;
    ~Home() { std::filesystem::remove_all(path); }
    Home(const Home&) = delete;
    Home& operator=(const Home&) = delete;

    std::filesystem::path path = make();

private:
    static std::filesystem::path make() {
        std::string name = (std::filesystem::temp_directory_path() / "braitenlab-XXXXXX").string();
        EXPECT_TRUE(mkdtemp(name.data())) << name;
        return name;
    }
};

// Set by packaging/test_windows.sh: the program for Windows, which then runs in wine; else empty.
inline std::string windows_program() {
    const char* path = std::getenv("BRAITENLAB_WINDOWS_PROGRAM");
    return path ? path : "";
}

// The text of a path for the program: wine has the whole file system as drive Z.
inline std::string path_for_program(const std::filesystem::path& path) {
    return (windows_program().empty() ? "" : "Z:") + path.string();
}

// Lets the user's folders of wine's Windows be those of the home folder.
inline void use_home_in_wine(const std::filesystem::path& home) {
    namespace fs = std::filesystem;
    const fs::path user = fs::path(std::getenv("WINEPREFIX")) / "drive_c" / "users" / getpwuid(getuid())->pw_name;
    for (const auto& [folder, place] : {std::pair{"AppData/Roaming/Braitenlab", "config/braitenlab"},
                                        {"AppData/Local/Braitenlab", "state/braitenlab"},
                                        {"Pictures", "Pictures"},
                                        {"Documents", "Documents"}}) {
        fs::remove_all(user / folder);
        fs::create_directories(home / place);
        fs::create_directory_symlink(home / place, user / folder);
    }
}

class LabWindow {
public:
    explicit LabWindow(std::vector<std::string> arguments, std::filesystem::path home = {}) {
        if (home.empty()) home = own_.path;
        if (const std::string windows = windows_program(); windows.empty()) {
            arguments.insert(arguments.begin(), program("braitenlab"));
        } else {
            use_home_in_wine(home);
            arguments.insert(arguments.begin(), {"wine", windows});
        }
        arguments.push_back("--watch-graphics");
        // Drawing in software takes most of the time of these tests.
        arguments.insert(arguments.end(), {"--frame-rate", "20"});
        if (std::find(arguments.begin(), arguments.end(), "--quality") == arguments.end())
            arguments.insert(arguments.end(), {"--quality", "low"});
        for (const char* file : {"anchors", "state"}) {
            arguments.push_back(std::string("--") + file);
            arguments.push_back((own_.path / (std::string(file) + ".json")).string());
        }
        pid_ = fork();
        if (pid_ == 0) {
            prctl(PR_SET_PDEATHSIG, SIGKILL);  // also if the test crashes
            setenv("HOME", home.c_str(), 1);
            setenv("XDG_CONFIG_HOME", (home / "config").c_str(), 1);
            setenv("XDG_STATE_HOME", (home / "state").c_str(), 1);
            std::vector<char*> argv;
            for (std::string& a : arguments) argv.push_back(a.data());
            argv.push_back(nullptr);
            if (!std::freopen((own_.path / "said").c_str(), "w", stderr)) _exit(126);
            execvp(argv[0], argv.data());
            _exit(127);
        }
        const bool came_up = eventually([this] { return !state().is_null() && !anchors().is_null(); }, 30);
        EXPECT_TRUE(came_up) << "no window came up: " << said();
        if (!came_up) return;
        window_ = shell(fmt::format("xdotool search --sync --onlyvisible --pid {} | tail -n 1", pid_)).out;
        while (!window_.empty() && window_.back() == '\n') window_.pop_back();
        xdotool("windowfocus --sync " + window_);
        xdotool(fmt::format("windowmove --sync {} 0 0", window_));
    }

    ~LabWindow() {
        const Json last = state();
        if (last.contains("graphics_errors")) {
            EXPECT_EQ(last["graphics_errors"], 0);
            EXPECT_EQ(last["graphics_watched"], true) << "the driver has not been watched";
        }
        if (pid_ > 0 && waitpid(pid_, nullptr, WNOHANG) == 0) {
            kill(pid_, SIGKILL);
            waitpid(pid_, nullptr, 0);
        }
        // Includes the frames after the last state was written, and the closing of the window.
        EXPECT_EQ(said().find("the graphics driver says"), std::string::npos) << said();
    }
    LabWindow(const LabWindow&) = delete;
    LabWindow& operator=(const LabWindow&) = delete;

    // The text written to stderr.
    std::string said() const {
        std::ifstream file(own_.path / "said");
        return {std::istreambuf_iterator<char>(file), {}};
    }

    // As last written; null before the first frame.
    Json state() const { return state_.read(own_.path / "state.json"); }
    Json anchors() const { return anchors_.read(own_.path / "anchors.json"); }

    void xdotool(const std::string& what) const {
        const Ran ran = shell("xdotool " + what);
        EXPECT_EQ(ran.code, 0) << "xdotool " << what << ": " << ran.out;
    }

    // The middle of a widget.
    Point at(const std::string& anchor) const {
        // A card measures itself in its first frame and shows its widgets from the next one.
        eventually([&] { return anchors().contains(anchor); }, 3);
        const Json all = anchors();
        if (!all.contains(anchor)) {
            ADD_FAILURE() << "the window has no anchor " << anchor;
            return {};
        }
        const auto r = all[anchor].get<std::vector<double>>();
        return {static_cast<int>(r[0] + r[2] / 2), static_cast<int>(r[1] + r[3] / 2)};
    }

    // After it the system has lost the picture in the window.
    void hide_and_show() const {
        xdotool(fmt::format("windowunmap --sync {0} windowmap --sync {0} windowfocus --sync {0}", window_));
    }

    void key(const std::string& name) const { xdotool("key --delay 30 " + name); }
    // Doubles or halves the speed of the simulated time by keys until it has this value.
    void set_speed(double wanted) const {
        for (double now = state()["time_scale"]; now != wanted; now = state()["time_scale"]) {
            key(now < wanted ? "equal" : "minus");
            if (eventually([&] { return state()["time_scale"] != now; })) continue;
            ADD_FAILURE() << "the speed stays " << now << ": " << state() << " " << anchors();
            return;
        }
    }
    // Each of these returns once a frame has seen the mouse there.
    void move(Point p) const {
        xdotool(fmt::format("mousemove --window {} {} {}", window_, p.x, p.y));
        EXPECT_TRUE(eventually([&] {
            return state()["pointer"] == Json{p.x, p.y};
        })) << state()["pointer"]
            << " instead of " << p.x << ", " << p.y;
    }
    void press(int button = 1) const {
        xdotool(fmt::format("mousedown {}", button));
        EXPECT_TRUE(eventually([&] { return state()["pressed"] == button; }));
    }
    void release(int button = 1) const {
        xdotool(fmt::format("mouseup {}", button));
        EXPECT_TRUE(eventually([&] { return state()["pressed"] == 0 || has_ended(); }));
        draw_frames();
    }
    // Returns once the window has drawn at least two frames that began after the call. The state file may be one period
    // old, so that its first change does not count.
    void draw_frames() const {
        for (int change = 0; change < 3; ++change) {
            const Json frames = state()["frames"];
            EXPECT_TRUE(eventually([&] { return state()["frames"] != frames || has_ended(); }));
        }
    }
    void click(Point p) const { move(p), press(), release(); }
    void click(const std::string& anchor) const { click(at(anchor)); }
    // A click, or a drag, after which the pointer moves on at once, often within one frame.
    void click_and_leave(Point at, Point then) const {
        xdotool(fmt::format("mousemove --window {0} {1} {2} mousedown 1 mouseup 1 mousemove --window {0} {3} {4}",
                            window_, at.x, at.y, then.x, then.y));
    }
    void drag_and_leave(Point from, Point to, Point then) const {
        xdotool(
            fmt::format("mousemove --window {0} {1} {2} mousedown 1 mousemove --window {0} {3} {4} mouseup 1 "
                        "mousemove --window {0} {5} {6}",
                        window_, from.x, from.y, to.x, to.y, then.x, then.y));
    }
    // Clicks a row of the menu bar: choose("file", "open").
    void choose(const std::string& menu, const std::string& row) const {
        click("menu." + menu);
        EXPECT_TRUE(eventually([&] { return state()["menu"] == menu; })) << menu;
        click("menu." + menu + "." + row);
    }
    void drag(Point from, Point to) const {
        move(from);
        press();
        for (int i = 1; i <= 8; ++i) move({from.x + (to.x - from.x) * i / 8, from.y + (to.y - from.y) * i / 8});
        release();
    }

    static void wait(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

    // Waits until the condition holds; false if it does not within `patience` seconds.
    static bool eventually(const std::function<bool()>& holds, double patience = 5) {
        const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(patience);
        while (std::chrono::steady_clock::now() < until) {
            if (holds()) return true;
            wait(0.01);
        }
        return holds();
    }

    // True once the program has ended, as after a click on its exit button.
    bool has_ended() const {
        siginfo_t info{};
        return pid_ < 0 ||
               (waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == pid_);
    }

    // Ends the program as a crash does.
    void kill_at_once() {
        kill(pid_, SIGKILL);
        waitpid(pid_, nullptr, 0);
        pid_ = -1;
    }

    void send(int signal) const { kill(pid_, signal); }
    bool is_on_screen() const { return shell("xwininfo -id " + window_).out.find("IsViewable") != std::string::npos; }

    // Memory of the program that is in use, in MB; on Linux.
    double resident_megabytes() const {
        std::ifstream file(fmt::format("/proc/{}/statm", pid_));
        double pages = 0;
        file >> pages >> pages;
        return pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
    }

    // The exit code once the program has ended; −1 if it does not end.
    int exit_code(double patience = 5) {
        int status = 0;
        if (!eventually([&] { return waitpid(pid_, &status, WNOHANG) == pid_; }, patience)) return -1;
        pid_ = -1;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

private:
    // The parsed value of a file that the program replaces; parsed again only if it is a new file. A test reads the
    // file much more often than the program writes it.
    struct Report {
        struct stat parsed {};
        Json value;

        const Json& read(const std::filesystem::path& path) {
            struct stat now {};
            if (stat(path.c_str(), &now) != 0) return value;
            const bool is_same = now.st_ino == parsed.st_ino && now.st_size == parsed.st_size &&
                                 now.st_mtim.tv_sec == parsed.st_mtim.tv_sec &&
                                 now.st_mtim.tv_nsec == parsed.st_mtim.tv_nsec;
            if (is_same) return value;
            std::ifstream file(path);
            parsed = now;
            return value = file ? Json::parse(file, nullptr, false) : Json();
        }
    };

    pid_t pid_ = -1;
    const Home own_;
    mutable Report state_, anchors_;
    std::string window_;
};

}  // namespace braitenlab::tests

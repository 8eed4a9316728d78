// The window for minutes under a seeded random user: `./dev soak MINUTES`. Skipped without BRAITENLAB_SOAK_MINUTES.
#include <array>
#include <random>

#include "tests/window/lab_window.h"

namespace braitenlab::tests::soak_test {
namespace {

namespace fs = std::filesystem;

constexpr int width = 1280, height = 800;

// Presses keys, clicks widgets and places, drags and turns the wheel. Never ends the program or opens another document.
class RandomUser {
public:
    RandomUser(const LabWindow& lab, unsigned seed) : lab_(lab), chance_(seed) {}

    void act() {
        switch (below(6)) {
            case 0:
            case 1:
                return lab_.xdotool(std::string("key ") + keys[below(keys.size())]);
            case 2:
                return at(widget(), "click 1");
            case 3:
                return at(place(), below(4) == 0 ? "click 3" : "click 1");
            case 4:
                return at(place(), below(2) == 0 ? "click 4" : "click 5");
            default:
                const Point to = place();
                at(place(), fmt::format("mousedown 1 mousemove {} {} mouseup 1", to.x, to.y));
        }
    }

private:
    static constexpr std::array keys{
        "space",  "period", "comma",  "less", "greater", "j",         "J",          "r",        "n",      "a",
        "A",      "f",      "Home",   "O",    "b",       "v",         "s",          "o",        "p",      "u",
        "m",      "k",      "i",      "e",    "w",       "W",         "d",          "R",        "L",      "g",
        "y",      "M",      "q",      "Q",    "l",       "minus",     "equal",      "Tab",      "x",      "Delete",
        "ctrl+d", "ctrl+z", "ctrl+y", "t",    "h",       "Insert",    "Menu",       "Return",   "Escape", "Left",
        "Right",  "Up",     "Down",   "1",    "2",       "3",         "4",          "F1",       "F10",    "ctrl+c",
        "ctrl+v", "ctrl+a", "C",      "c",    "Page_Up", "Page_Down", "ctrl+comma", "BackSpace"};

    std::size_t below(std::size_t count) { return chance_() % count; }

    static bool is_left_alone(const std::string& anchor) {
        for (const char* part :
             {"exit", "file", "exercise", "lecture", "course", "leaving", "full_screen", "take", "study"})
            if (anchor.find(part) != std::string::npos) return true;
        return false;
    }
    Point widget() {
        const Json anchors = lab_.anchors();
        std::vector<std::string> names;
        for (const auto& [name, rect] : anchors.items())
            if (!is_left_alone(name)) names.push_back(name);
        if (names.empty()) return place();
        const auto r = anchors[names[below(names.size())]].get<std::vector<double>>();
        return allowed({static_cast<int>(r[0] + r[2] / 2), static_cast<int>(r[1] + r[3] / 2)});
    }
    Point place() { return allowed({static_cast<int>(below(width)), static_cast<int>(below(height))}); }

    // The point of the window, or its middle where a widget that is left alone is there. Parts of a large diagram lie
    // beyond the window.
    Point allowed(Point p) const {
        p = {std::clamp(p.x, 0, width - 1), std::clamp(p.y, 0, height - 1)};
        const Json anchors = lab_.anchors();
        for (const auto& [name, rect] : anchors.items()) {
            const auto r = rect.get<std::vector<double>>();
            const bool is_there = p.x >= r[0] && p.x <= r[0] + r[2] && p.y >= r[1] && p.y <= r[1] + r[3];
            if (is_there && is_left_alone(name)) return {width / 2, height / 2};
        }
        return p;
    }
    void at(Point p, const std::string& what) const { lab_.xdotool(fmt::format("mousemove {} {} {}", p.x, p.y, what)); }

    const LabWindow& lab_;
    std::mt19937 chance_;
};

// Resident memory of the window, by the minute.
struct Memory {
    std::vector<double> minutes, megabytes;

    // MB an hour of the straight line through the values after `from` minutes, by least squares.
    double slope(double from) const {
        double n = 0, x = 0, y = 0, xx = 0, xy = 0;
        for (std::size_t i = 0; i < minutes.size(); ++i)
            if (const double hour = minutes[i] / 60; minutes[i] >= from)
                ++n, x += hour, y += megabytes[i], xx += hour * hour, xy += hour * megabytes[i];
        return n < 3 ? 0 : (n * xy - x * y) / (n * xx - x * x);
    }
};

// At 16 times real time, without a sheet and playing, whatever the user has done.
void go_on(const LabWindow& lab) {
    lab.xdotool("mouseup 1 key --delay 30 Escape Escape Escape");
    LabWindow::eventually([&] { return lab.state()["mode"] != "wiring"; });
    if (lab.state()["mode"] == "paused") lab.key("space");
    lab.set_speed(16);
}

fs::path newest_autosave(const Home& home) {
    fs::path newest;
    for (const auto& entry : fs::directory_iterator(home.path / "state" / "braitenlab" / "autosave"))
        if (entry.path().extension() == ".autosave" &&
            (newest.empty() || entry.last_write_time() > fs::last_write_time(newest)))
            newest = entry.path();
    return newest;
}

// The hash of the run that is on the disk, continued by braitenctl.
std::string hash_on_disk(const Home& home) {
    const fs::path run = home.path / "last.run";
    fs::copy_file(newest_autosave(home), run, fs::copy_options::overwrite_existing);
    std::string hash = shell(program("braitenctl") + " run " + run.string() + " --seconds 0 --hash").out;
    while (!hash.empty() && hash.back() == '\n') hash.pop_back();
    return hash;
}

TEST(Soak, TheWindowEnduresARandomUser) {
    const char* given = std::getenv("BRAITENLAB_SOAK_MINUTES");
    if (!given) GTEST_SKIP() << "run by ./dev soak MINUTES";
    const double minutes = std::atof(given);
    const char* chosen = std::getenv("BRAITENLAB_SOAK_SEED");
    const auto seed = static_cast<unsigned>(chosen ? std::atoi(chosen) : 1);
    const Home home;
    LabWindow lab({"predator-prey", "--size", fmt::format("{}x{}", width, height), "--play"}, home.path);
    RandomUser user(lab, seed);
    Memory memory;
    const auto began = std::chrono::steady_clock::now();
    const auto passed = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count() / 60;
    };
    int actions = 0;
    double slowest = 0;
    while (passed() < minutes && !lab.has_ended()) {
        go_on(lab);
        for (int i = 0; i < 40; ++i, ++actions) {
            user.act();
            slowest = std::max(slowest, lab.state()["frame_ms"].get<double>());
        }
        memory.minutes.push_back(passed()), memory.megabytes.push_back(lab.resident_megabytes());
    }
    ASSERT_FALSE(lab.has_ended()) << lab.said();
    const double settled = std::min(5.0, minutes / 2);
    fmt::print(
        "seed {}: {} actions in {:.1f} min; memory {:.1f} MB at first, {:.1f} MB at the end, {:+.1f} MB an hour "
        "after {:.1f} min; slowest frame seen {:.0f} ms; tick {}\n",
        seed, actions, passed(), memory.megabytes.front(), memory.megabytes.back(), memory.slope(settled), settled,
        slowest, lab.state()["tick"].dump());
    constexpr double noise = 10;  // MB, of buffers that come and go
    EXPECT_LT(memory.slope(settled) * (minutes - settled) / 60, noise);
    go_on(lab);
    lab.key("space");
    ASSERT_TRUE(LabWindow::eventually([&] { return lab.state()["mode"] == "paused"; }))
        << lab.state() << " " << lab.anchors();
    lab.draw_frames();
    EXPECT_TRUE(LabWindow::eventually([&] { return lab.state()["hash"] == hash_on_disk(home); }, 10))
        << hash_on_disk(home) << " on the disk, " << lab.state()["hash"];
    EXPECT_EQ(lab.said(), "");
}

// 2,000 vehicles that turn to a lamp in a corner.
constexpr const char* crowd = R"(format = 1
title = "Corner"
[arena]
width = 60
height = 60
[ecology]
population = 2000
[source.lamp]
x = 29
y = 29
[kind.k.sensor.SL]
x = 0.3
y = 0.24
angle = 35
field = 150
range = 100
[kind.k.sensor.SR]
x = 0.3
y = -0.24
angle = -35
field = 150
range = 100
[kind.k.brain]
LR = 1
RL = 1
LM = 0.4
RM = 0.4
)";

// Frames of a window, each seen once by its number.
struct Frames {
    int seen = 0, passed = 0;
    double slowest = 0;      // ms, of those that are seen
    double longest_gap = 0;  // ms of wall time between two that are seen, with the wait for the next one

    // Until the condition holds.
    void watch(const LabWindow& lab, const std::function<bool(const Json&)>& is_over) {
        using Clock = std::chrono::steady_clock;
        auto last = Clock::now();
        int number = lab.state()["frames"];
        for (Json state = lab.state(); !is_over(state) && !lab.has_ended(); state = lab.state()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(4));
            const int now = state["frames"];
            if (now == number) continue;
            ++seen, passed += now - number, number = now;
            slowest = std::max(slowest, state["frame_ms"].get<double>());
            longest_gap = std::max(longest_gap, std::chrono::duration<double>(Clock::now() - last).count() * 1000);
            last = Clock::now();
        }
    }
};

TEST(Soak, TwoThousandVehiclesInACornerAreShownWithoutALongFrame) {
    if (!std::getenv("BRAITENLAB_SOAK_MINUTES")) GTEST_SKIP() << "run by ./dev soak MINUTES";
    const Home home;
    const fs::path file = home.path / "corner.toml", gathered = home.path / "corner.run";
    std::ofstream(file) << crowd;
    const Ran ran =
        shell(fmt::format("{} run {} --seconds 40 --save {}", program("braitenctl"), file.string(), gathered.string()));
    ASSERT_EQ(ran.code, 0) << ran.out;
    LabWindow lab({gathered.string(), "--size", fmt::format("{}x{}", width, height), "--play"}, home.path);
    ASSERT_EQ(lab.state()["population"], 2000);
    const int first = lab.state()["tick"];
    const auto began = std::chrono::steady_clock::now();
    Frames frames;
    frames.watch(lab, [&](const Json&) { return std::chrono::steady_clock::now() - began > std::chrono::minutes(1); });
    ASSERT_FALSE(lab.has_ended()) << lab.said();
    fmt::print(
        "2,000 vehicles in a corner for 60 s: {} ticks; {} of {} frames seen, slowest {:.0f} ms, longest gap "
        "{:.0f} ms\n",
        lab.state()["tick"].get<int>() - first, frames.seen, frames.passed, frames.slowest, frames.longest_gap);
    constexpr double most = 250;  // ms
    EXPECT_LT(frames.slowest, most);
    EXPECT_GT(frames.seen, frames.passed / 2) << "too few frames are seen to judge them";
}

}  // namespace
}  // namespace braitenlab::tests::soak_test

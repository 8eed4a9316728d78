// Keys on the layouts of other countries, and the numeric keypad, in the real window.
#include "tests/window/lab_window.h"

namespace braitenlab::tests::keyboards_window_test {
namespace {

// Numbers of keys in X: 10 to 19 are the row of digits.
constexpr int keypad_7 = 79, keypad_4 = 83, keypad_1 = 87, keypad_decimal = 91, keypad_add = 86, num_lock = 77;

// A layout of this name and variant in the display of the test, from construction to destruction.
class Layout {
public:
    Layout(const std::string& name, const std::string& variant) { set(name + " -variant \"" + variant + "\""); }
    ~Layout() { set("us -variant \"\""); }
    Layout(const Layout&) = delete;
    Layout& operator=(const Layout&) = delete;

private:
    static void set(const std::string& arguments) {
        const Ran ran = shell("setxkbmap -layout " + arguments);
        EXPECT_EQ(ran.code, 0) << "install the package x11-xkb-utils: " << ran.out;
    }
};

// Presses keys by their numbers, so at their places: "50+59" is Shift with the key beside M.
void strike(const LabWindow& lab, const std::string& keys) { lab.xdotool("key --delay 30 " + keys); }

// `larger`: Ctrl and the key of +, with Shift where the layout needs it, as a person presses it.
struct Keys {
    const char *layout, *variant, *point, *faster, *larger;
};
constexpr Keys layouts[]{{"us", "", "60", "50+21", "37+50+21"},
                         {"de", "", "60", "35", "37+35"},
                         {"fr", "", "50+59", "50+21", "37+50+21"},
                         {"ch", "", "60", "50+10", "37+50+10"},
                         {"es", "", "60", "35", "37+35"},
                         {"cz", "", "60", "20", "37+10"},
                         {"us", "dvorak", "26", "50+35", "37+50+35"},
                         {"ru", "", "61", "50+21", "37+50+21"}};

TEST(KeyboardsWindow, DigitsAreAtTheirPlaceAndSignsAreWhatIsTypedOnEightLayouts) {
    if (!windows_program().empty()) GTEST_SKIP() << "the layouts of Windows are not those of X";
    for (const Keys& keys : layouts) {
        SCOPED_TRACE(keys.layout + std::string(" ") + keys.variant);
        const Layout layout(keys.layout, keys.variant);
        LabWindow lab({"2a-coward", "--size", "1280x800"});
        const char* sliders[]{"slider.LL", "slider.LR", "slider.RL", "slider.RR"};
        for (int digit = 1; digit <= 4; ++digit) {
            strike(lab, std::to_string(9 + digit));
            EXPECT_TRUE(LabWindow::eventually([&] { return lab.state()["focus"] == sliders[digit - 1]; }))
                << digit << ": " << lab.state()["focus"];
        }
        lab.key("Escape");
        ASSERT_TRUE(LabWindow::eventually([&] { return lab.state()["focus"] == ""; }));
        strike(lab, keys.point);
        EXPECT_TRUE(LabWindow::eventually([&] { return lab.state()["tick"] == 1; })) << "the point is a step";
        strike(lab, keys.faster);
        EXPECT_TRUE(LabWindow::eventually([&] { return lab.state()["time_scale"] == 2.0; })) << "plus is faster";
        strike(lab, keys.larger);
        EXPECT_TRUE(LabWindow::eventually([&] { return lab.state()["type_size"] == 1.125; })) << "larger type";
    }
}

TEST(KeypadWindow, HasDelEndAndArrowsWithoutNumLockAndDigitsWithIt) {
    if (!windows_program().empty()) GTEST_SKIP() << "the layouts of Windows are not those of X";
    LabWindow lab({"2a-coward", "--size", "1280x800"});
    lab.key("ctrl+shift+s");
    ASSERT_TRUE(LabWindow::eventually([&] { return lab.state()["typed"] == "2a-coward"; }));
    const auto typed = [&](const std::string& keys, const char* wanted) {
        strike(lab, keys);
        EXPECT_TRUE(LabWindow::eventually([&] { return lab.state()["typed"] == wanted; }))
            << wanted << ": " << lab.state()["typed"];
    };
    const auto keys = [](std::initializer_list<int> numbers) {
        std::string all;
        for (const int each : numbers) all += std::to_string(each) + " ";
        return all;
    };
    typed("ctrl+a x y", "xy");
    typed(keys({keypad_7, keypad_decimal}), "y");  // Home, Del
    typed(keys({keypad_1}) + "a b", "yab");        // End
    typed(keys({keypad_4}) + "BackSpace", "yb");   // Left
    strike(lab, std::to_string(num_lock));
    typed(keys({keypad_1, keypad_7, keypad_add}), "y17+b");
    strike(lab, std::to_string(num_lock));
    lab.key("Escape Escape");
    ASSERT_TRUE(LabWindow::eventually([&] { return !lab.anchors().contains("card.open"); }));
    strike(lab, std::to_string(keypad_add));
    EXPECT_TRUE(LabWindow::eventually([&] { return lab.state()["time_scale"] == 2.0; })) << "faster";
}

}  // namespace
}  // namespace braitenlab::tests::keyboards_window_test

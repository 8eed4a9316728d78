#include "core/export/robot.h"

#include <algorithm>
#include <array>

namespace braitenlab::robots {

namespace {

constexpr std::array all_robots{
    Robot{"any", "any robot that runs C", 60, 0, 0, ""},
    // 200 rpm at 6 V without load, wheel of 65 mm: 0.68 m/s; 0.60 under load is assumed, not measured.
    Robot{"tt2wd-ldr", "two-wheel chassis with TT motors 1:48, Arduino Uno and photoresistors", 50, 6, 0.60f,
          "Adafruit product 3777: 200 rpm at 6 V; 0.60 m/s under load is an assumption"},
    Robot{"thymio2", "Thymio II", 10, 0, 0.166f,
          "motor target 500 of the Thymio II documentation: 0.166 m/s to 0.20 m/s"},
    Robot{"microbit", "two-wheel chassis with a BBC micro:bit and a TB6612", 50, 3, 0, ""},
    Robot{"lm324", "circuit of operational amplifiers LM324 at 9 V", 60, 0, 0, ""},
};

}  // namespace

std::span<const Robot> robots() { return all_robots; }

const Robot* find_robot(std::string_view name) {
    const auto found =
        std::find_if(all_robots.begin(), all_robots.end(), [&](const Robot& r) { return r.name == name; });
    return found == all_robots.end() ? nullptr : &*found;
}

}  // namespace braitenlab::robots

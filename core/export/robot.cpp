#include "core/export/robot.h"

#include <algorithm>

namespace braitenlab::robots {

namespace {

constexpr std::array all_robots{
    Robot{"any", Target::c, 60},
    Robot{"tt2wd-ldr", Target::arduino, 50},     // exercises/robots/tt2wd-ldr.toml
    Robot{"thymio2", Target::thymio, 10, true},  // exercises/robots/thymio2.toml; the rate of its proximity sensors
    Robot{"thymio3", Target::micropython, 50, true},  // the rate of programs of others, see thymio3.cpp
    Robot{"microbit", Target::micropython, 50},       // a chassis with a BBC micro:bit and a TB6612
    Robot{"lm324", Target::opamp, 60},                // a circuit has no rate
};

}  // namespace

std::span<const Robot> robots() { return all_robots; }

const Robot* find_robot(std::string_view name) {
    const auto found =
        std::find_if(all_robots.begin(), all_robots.end(), [&](const Robot& r) { return r.name == name; });
    return found == all_robots.end() ? nullptr : &*found;
}

}  // namespace braitenlab::robots

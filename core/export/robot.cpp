#include "core/export/robot.h"

#include <algorithm>
#include <array>

namespace braitenlab::robots {

namespace {

constexpr std::array all_robots{
    Robot{"any", 60},      Robot{"tt2wd-ldr", 50},  // exercises/robots/tt2wd-ldr.toml
    Robot{"thymio2", 10},                           // exercises/robots/thymio2.toml; the rate of its proximity sensors
    Robot{"microbit", 50},                          // a chassis with a BBC micro:bit and a TB6612
    Robot{"lm324", 60},                             // a circuit has no rate
};

}  // namespace

std::span<const Robot> robots() { return all_robots; }

const Robot* find_robot(std::string_view name) {
    const auto found =
        std::find_if(all_robots.begin(), all_robots.end(), [&](const Robot& r) { return r.name == name; });
    return found == all_robots.end() ? nullptr : &*found;
}

}  // namespace braitenlab::robots

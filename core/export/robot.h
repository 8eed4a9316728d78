// Robots that brains are exported to. Pins, parts and limits are in the source of the target.
#pragma once

#include <span>
#include <string_view>

namespace braitenlab::robots {

struct Robot {
    std::string_view name;  // "tt2wd-ldr"
    int rate_hz;            // calls of the brain per second
};

// In the order of docs/robots.md. The first one is any robot that runs C.
std::span<const Robot> robots();

// The robot of this name, or null.
const Robot* find_robot(std::string_view name);

}  // namespace braitenlab::robots

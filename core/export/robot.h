// Robots that brains are exported to: what an exported program must know about them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace braitenlab::robots {

struct Robot {
    std::string_view name;    // "tt2wd-ldr"
    std::string_view title;   // "Two-wheel chassis with TT motors, Arduino Uno, photoresistors"
    int rate_hz;              // calls of the brain per second
    int analog_inputs;        // sensors that can be connected; 0: no limit
    float top_speed;          // m/s of a wheel at command 1; 0: unknown
    std::string_view source;  // of the top speed
};

// In the order of docs/robots.md. The first one is any robot that runs C.
std::span<const Robot> robots();

// The robot of this name, or null.
const Robot* find_robot(std::string_view name);

}  // namespace braitenlab::robots

// A wiring picture: sensors on the left, a board in the middle, a motor driver and two motors on the right.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/export/plan.h"
#include "core/export/sensor_parts.h"

namespace braitenlab::robots {

struct WiredPin {
    std::string board, driver;  // names printed on both
};

struct Wiring {
    std::string_view board, driver;   // titles of the two boxes
    Board kind;                       // whose parts the sensors are
    std::vector<std::string> inputs;  // pin of each sensor of the plan
    std::vector<WiredPin> pins;       // three of the left motor, three of the right one, others
    std::string button;               // pin of a button to ground; empty: none
    std::string_view left_outputs, right_outputs, motor_supply;  // of the driver
    // Where the motors' battery supplies the board, and the regulator between both; empty: the board has its own
    // supply.
    std::string_view board_supply{}, regulator{};
    std::string_view notes[2];
};

// A text element of SVG. `anchor`: start, middle, end. `style`: attributes, with a space before each.
std::string svg_label(int x, int y, std::string_view anchor, const std::string& text, std::string_view style = "");

// As SVG. Each sensor is the part of sensor_parts.h for its channel, with its resistors and its capacitor.
std::string wiring_svg(const Plan&, const Wiring&);

}  // namespace braitenlab::robots

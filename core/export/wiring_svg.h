// A wiring picture: sensors on the left, a board in the middle, a motor driver and two motors on the right.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/export/plan.h"

namespace braitenlab::robots {

struct WiredPin {
    std::string board, driver;  // names printed on both
};

struct Wiring {
    std::string_view board, driver;   // titles of the two boxes
    std::string_view volts;           // of the board's sensors: "5 V"
    std::vector<std::string> inputs;  // pin of each sensor of the plan
    std::vector<WiredPin> pins;       // three of the left motor, three of the right one, others
    std::string button;               // pin of a button to ground; empty: none
    std::string_view left_outputs, right_outputs, motor_supply;  // of the driver
    std::string_view board_supply;  // pin that the motors' battery supplies; empty: the board has its own supply
    std::string_view notes[2];
    std::string (*part_of)(const Input&) = nullptr;  // of a sensor; null: that of the Arduino
};

// How the part of a sensor (arduino.h) is connected. A divider: the supply, the part, the input, and a resistor to
// ground. Another part, a module, has three pins: supply, ground, output. `part` empty: there is none.
struct SensorWiring {
    std::string part, resistor;  // "photoresistor GL5528", "1.5 kΩ"; resistor empty: a module
};
SensorWiring sensor_wiring(const Input&);
SensorWiring sensor_wiring(const std::string& part);  // "photoresistor GL5528 to 3 V, 1.5 kΩ to ground"

// A text element of SVG. `anchor`: start, middle, end. `style`: attributes, with a space before each.
std::string svg_label(int x, int y, std::string_view anchor, const std::string& text, std::string_view style = "");

// As SVG. Each sensor is the part of arduino.h for its channel.
std::string wiring_svg(const Plan&, const Wiring&);

}  // namespace braitenlab::robots

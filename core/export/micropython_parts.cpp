// Wiring picture and shopping list of a micro:bit.
#include <cstddef>
#include <string_view>

#include <fmt/format.h>

#include "core/export/arduino.h"
#include "core/export/micropython.h"
#include "core/export/text.h"
#include "core/export/texts.h"
#include "core/export/wiring_svg.h"

namespace braitenlab::robots::micropython {

std::string part_of(const Input& input) {
    switch (input.channel.value_or(Channel::light)) {
        case Channel::obstacle:  // the GP2Y0A21 of the Arduino needs 4.5 V
            return "infrared distance sensor GP2Y0A60SZ, module for 3 V (10 cm to 150 cm)";
        case Channel::smell:  // its heater takes 0.9 W at 5 V
            return "gas sensor module MQ-3 with a supply of 5 V of its own, analog output through 10 kΩ, 15 kΩ to "
                   "ground";
        case Channel::energy:
            return "battery through a divider 20 kΩ : 10 kΩ";
        default:
            break;
    }
    std::string part(arduino::part_of(input).part);
    constexpr std::string_view five = " to 5 V";
    if (const std::size_t at = part.find(five); at != std::string::npos) part.replace(at, five.size(), " to 3 V");
    return part;
}

std::string parts_csv(const Plan& plan) {
    std::string sensors;
    for (const Input& input : plan.inputs)
        sensors += fmt::format("1,\"{}\",for sensor {}\n", part_of(input), comment_text(input.name));
    return filled(texts::micropython_parts_csv, {{"SENSORS", sensors}});
}

std::string wiring_svg(const Plan& plan) {
    Wiring wiring{.board = "BBC micro:bit",
                  .driver = "TB6612",
                  .volts = "3 V",
                  .pins = {{"P8", "PWMA"},
                           {"P12", "AIN1"},
                           {"P13", "AIN2"},
                           {"P16", "PWMB"},
                           {"P14", "BIN1"},
                           {"P15", "BIN2"},
                           {"3V", "VCC, STBY"}},
                  .left_outputs = "AO1, AO2",
                  .right_outputs = "BO1, BO2",
                  .motor_supply = "VM",
                  .notes = {"Each resistive sensor: from 3 V through the sensor to the input, from the input through "
                            "its resistor to GND. Modules: 3 V, GND, output to the input; an MQ-3 as parts.csv says.",
                            "The micro:bit has its own battery. Its GND is connected to that of the motors' battery."}};
    wiring.part_of = part_of;
    for (std::size_t i = 0; i < plan.inputs.size(); ++i) wiring.inputs.push_back(fmt::format("P{}", i));
    return robots::wiring_svg(plan, wiring);
}

}  // namespace braitenlab::robots::micropython

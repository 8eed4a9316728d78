// README and list of parts of the Arduino export.
#include <cmath>

#include <fmt/format.h>

#include "core/export/arduino.h"
#include "core/export/sensor_parts.h"
#include "core/export/text.h"
#include "core/export/texts.h"
#include "core/export/wiring_svg.h"

namespace braitenlab::robots::arduino {

namespace {

// Of the Uno and of the logic of a TB6612.
constexpr double uno_milliamperes = 52;

constexpr std::string_view warm_up_text =
    "\nHeated sensors read steadily after @MINUTES@ minutes only. At each start the light blinks slowly for that time, "
    "before it\n"
    "calibrates and before it drives; the button ends the wait when they are warm already. Their first start takes a "
    "day:\n"
    "leave a new sensor on for so long before you calibrate it.\n";

std::string pin_table() {
    std::string text = "| Pin | TB6612 | L298N | |\n|---|---|---|---|\n";
    for (const MotorPin& pin : motor_pins)
        text += fmt::format("| {} | {} | {} | `{}` |\n", pin.pin, pin.tb6612, pin.l298n.empty() ? "–" : pin.l298n,
                            pin.constant);
    return text + "| 5V | VCC | – | without it the driver does nothing |\n" +
           fmt::format("| {} | – | – | button to ground |\n", button_pin);
}

}  // namespace

std::string readme(const Plan& plan, int robot_rate) {
    const Cost cost = cost_of(plan);
    const std::string lowered =
        plan.rate_hz >= static_cast<float>(robot_rate)
            ? ""
            : fmt::format(
                  " Smaller brains are computed {} times per second; this one takes too long\nfor that, most of it for "
                  "sigmoids and humps (0.08 ms each). Memories and learning wires are those of the lower rate.",
                  robot_rate);
    std::string sensors;
    const std::vector<SensorPart> parts = parts_of(plan, Board::uno);
    for (std::size_t i = 0; i < parts.size(); ++i)
        sensors += fmt::format("| {} | {} | {} | {} | 0: {}, 1: {}{} |\n", table_cell(plan.inputs[i].name),
                               pin_of_input(i), place_text(plan.inputs[i]), joining_text(parts[i]), parts[i].zero,
                               parts[i].one, doubt_about(plan.inputs[i]));
    const int warm_up = warm_up_of(parts);
    const double load = uno_milliamperes + board_milliamperes(parts);
    return filled(
        texts::arduino_readme_md,
        {{"TITLE", comment_text(plan.title)},
         {"PINS", pin_table()},
         {"PLACES", places_text(plan, Board::uno)},
         {"SENSORS", sensors},
         {"LOAD", fmt::format("{:.0f}", std::ceil(load))},
         {"OWN_SUPPLY", own_supply_text(parts, "Arduino")},
         {"WARM_UP", warm_up == 0 ? "" : filled(warm_up_text, {{"MINUTES", fmt::format("{}", warm_up / 60)}})},
         {"RATE", fmt::format("{:g}", plan.rate_hz)},
         {"STEP", fmt::format("{:.1f}", cost.cycles / 16e3)},
         {"PERIOD", fmt::format("{:g}", 1000 / plan.rate_hz)},
         {"BYTES", std::to_string(cost.bytes)},
         {"LARGEST", std::to_string(largest_program)},
         {"LOWERED", lowered}});
}

std::string parts_csv(const Plan& plan) {
    const double load = uno_milliamperes + board_milliamperes(parts_of(plan, Board::uno));
    return filled(texts::arduino_parts_csv,
                  {{"SENSORS", sensor_rows(plan, Board::uno)}, {"LOAD", fmt::format("{:.0f}", std::ceil(load))}});
}

std::string wiring_svg(const Plan& plan) {
    Wiring wiring{
        .board = "Arduino Uno",
        .driver = "TB6612 or L298N",
        .kind = Board::uno,
        .button = std::to_string(button_pin),
        .left_outputs = "AO1, AO2 (OUT1, OUT2)",
        .right_outputs = "BO1, BO2 (OUT3, OUT4)",
        .motor_supply = "VM (12V)",
        .notes = {"All grounds are connected. The Arduino is supplied by USB; the battery supplies the motors alone.",
                  "L298N (names in brackets): remove the jumpers of ENA and ENB; 10 kΩ from each of them to GND. Leave "
                  "the 5 V jumper; nothing at its 5 V pin."}};
    for (std::size_t i = 0; i < plan.inputs.size(); ++i) wiring.inputs.push_back(pin_of_input(i));
    for (const MotorPin& pin : motor_pins)
        wiring.pins.push_back({std::to_string(pin.pin), pin.l298n.empty()
                                                            ? std::string(pin.tb6612)
                                                            : fmt::format("{} ({})", pin.tb6612, pin.l298n)});
    wiring.pins.push_back({"5V", "VCC (–)"});
    return robots::wiring_svg(plan, wiring);
}

}  // namespace braitenlab::robots::arduino

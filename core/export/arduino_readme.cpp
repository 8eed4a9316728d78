// README and list of parts of the Arduino export.
#include <fmt/format.h>

#include "core/export/arduino.h"
#include "core/export/sensor_parts.h"
#include "core/export/text.h"
#include "core/export/texts.h"
#include "core/export/wiring_svg.h"

namespace braitenlab::robots::arduino {

namespace {

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
    for (std::size_t i = 0; i < plan.inputs.size(); ++i) {
        const SensorPart part = part_of(plan.inputs[i], Board::uno);
        sensors += fmt::format("| {} | {} | {} | 0: {}, 1: {}{} |\n", table_cell(plan.inputs[i].name), pin_of_input(i),
                               joining_text(part), part.zero, part.one, doubt_about(plan.inputs[i]));
    }
    return filled(texts::arduino_readme_md, {{"TITLE", comment_text(plan.title)},
                                             {"PINS", pin_table()},
                                             {"SENSORS", sensors},
                                             {"RATE", fmt::format("{:g}", plan.rate_hz)},
                                             {"STEP", fmt::format("{:.1f}", cost.cycles / 16e3)},
                                             {"PERIOD", fmt::format("{:g}", 1000 / plan.rate_hz)},
                                             {"BYTES", std::to_string(cost.bytes)},
                                             {"LARGEST", std::to_string(largest_program)},
                                             {"LOWERED", lowered}});
}

std::string parts_csv(const Plan& plan) {
    return filled(texts::arduino_parts_csv, {{"SENSORS", sensor_rows(plan, Board::uno)}});
}

std::string wiring_svg(const Plan& plan) {
    Wiring wiring{
        .board = "Arduino Uno",
        .driver = "TB6612 (L298N)",
        .kind = Board::uno,
        .button = std::to_string(button_pin),
        .left_outputs = "AO1, AO2 (OUT1, OUT2)",
        .right_outputs = "BO1, BO2 (OUT3, OUT4)",
        .motor_supply = "VM (12V)",
        .board_supply = "",
        .notes = {"All grounds are connected. The Arduino is supplied by USB; the battery supplies the motors alone.",
                  "L298N: remove the jumpers of ENA and ENB, leave the 5 V jumper, and connect nothing to its "
                  "5 V pin. Names in brackets are those of an L298N."}};
    for (std::size_t i = 0; i < plan.inputs.size(); ++i) wiring.inputs.push_back(pin_of_input(i));
    for (const MotorPin& pin : motor_pins)
        wiring.pins.push_back({std::to_string(pin.pin), pin.l298n.empty()
                                                            ? std::string(pin.tb6612)
                                                            : fmt::format("{} ({})", pin.tb6612, pin.l298n)});
    wiring.pins.push_back({"5V", "VCC (–)"});
    return robots::wiring_svg(plan, wiring);
}

}  // namespace braitenlab::robots::arduino

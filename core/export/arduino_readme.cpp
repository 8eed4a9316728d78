// README and list of parts of the Arduino export.
#include <algorithm>

#include <fmt/format.h>

#include "core/export/arduino.h"
#include "core/export/text.h"
#include "core/export/texts.h"
#include "core/export/wiring_svg.h"
#include "core/messages.h"
#include "core/scene/enums.h"
#include "core/scene/nearest.h"

namespace braitenlab::robots::arduino {

namespace {

constexpr std::string_view photoresistor = "photoresistor GL5528 to 5 V, 1.5 kΩ to ground";
// Infrared light passes filters of colour, so the part must not see it.
constexpr std::string_view phototransistor =
    "phototransistor TEPT4400 (visible light only) behind a filter of this colour to 5 V, 10 kΩ to ground";

constexpr auto sensor_parts = std::to_array<SensorPart>({
    {Channel::light, photoresistor, "covered", "the lamp right in front of it"},
    {Channel::red, phototransistor, "covered", "a red LED lamp right in front of it"},
    {Channel::green, phototransistor, "covered", "a green LED lamp right in front of it"},
    {Channel::blue, phototransistor, "covered", "a blue LED lamp right in front of it"},
    {Channel::heat, "thermistor NTC 10 kΩ to 5 V, 10 kΩ to ground", "at room temperature",
     "the warm source in front of it"},
    {Channel::smell, "gas sensor module MQ-3, analog output; its heater takes 150 mA at 5 V and 5 minutes",
     "in clean air", "alcohol in front of it"},
    {Channel::oxygen, "", "", ""},
    {Channel::obstacle, "infrared distance sensor GP2Y0A21 (10 cm to 80 cm)", "nothing in front of it",
     "an obstacle at 10 cm"},
    {Channel::predator, "", "", ""},
    {Channel::prey, "", "", ""},
    {Channel::vehicle, "", "", ""},
    {Channel::memory, "", "", ""},
    {Channel::touch, "switch to 5 V, 10 kΩ to ground", "released", "pressed"},
    {Channel::floor, "reflective sensor TCRT5000 module, analog output, 3 mm above the floor", "above black",
     "above white"},
    {Channel::energy, "battery through a divider 10 kΩ : 10 kΩ", "an empty battery", "a full battery"},
    {Channel::random, "", "", ""},
});

// part_of() takes the row of a channel by its number.
static_assert([] {
    for (std::size_t i = 0; i < sensor_parts.size(); ++i)
        if (sensor_parts[i].channel != channel_table[i].value) return false;
    return sensor_parts.size() == channel_table.size();
}());

std::string pin_table() {
    std::string text = "| Pin | TB6612 | L298N | |\n|---|---|---|---|\n";
    for (const MotorPin& pin : motor_pins)
        text += fmt::format("| {} | {} | {} | `{}` |\n", pin.pin, pin.tb6612, pin.l298n.empty() ? "–" : pin.l298n,
                            pin.constant);
    return text + "| 5 V | VCC | – | without it the driver does nothing |\n" +
           fmt::format("| {} | – | – | button to ground |\n", button_pin);
}

// A text for a cell of a table in Markdown.
std::string cell(const std::string& text) {
    std::string clean = comment_text(text);
    std::replace(clean.begin(), clean.end(), '|', '/');
    return clean;
}

}  // namespace

std::string_view doubt_about(const Input& input) {
    return input.channel ? "" : "; the file does not say what it senses, so it is taken for an eye";
}

const SensorPart& part_of(const Input& input) {
    return sensor_parts[static_cast<std::size_t>(input.channel.value_or(Channel::light))];
}

std::optional<Error> sensor_fault(const Plan& plan, std::string_view board, int inputs) {
    for (const Input& input : plan.inputs)
        if (part_of(input).part.empty())
            return error_of(message_of("no_part", in_quotes(input.name), word(*input.channel)));
    const auto most = static_cast<std::size_t>(inputs);
    if (plan.inputs.size() <= most) return std::nullopt;
    return error_of(message_of("no_pin", in_quotes(plan.inputs[most].name), plan.inputs.size(), board, most));
}

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
        const SensorPart& part = part_of(plan.inputs[i]);
        sensors += fmt::format("| {} | {} | {}; 0: {}, 1: {}{} |\n", cell(plan.inputs[i].name), pin_of_input(i),
                               part.part, part.zero, part.one, doubt_about(plan.inputs[i]));
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
    std::string sensors;
    for (const Input& input : plan.inputs)
        sensors += fmt::format("1,\"{}\",\"for sensor {}\"\n", part_of(input).part, cell(input.name).c_str());
    return filled(texts::arduino_parts_csv, {{"SENSORS", sensors}});
}

std::string wiring_svg(const Plan& plan) {
    Wiring wiring{.board = "Arduino Uno",
                  .driver = "TB6612 (L298N)",
                  .volts = "5 V",
                  .button = std::to_string(button_pin),
                  .left_outputs = "AO1, AO2 (OUT1, OUT2)",
                  .right_outputs = "BO1, BO2 (OUT3, OUT4)",
                  .motor_supply = "VM (12V)",
                  .board_supply = "",
                  .notes = {"Each resistive sensor: from 5 V through the sensor to the input, from the input through "
                            "its resistor to GND. Modules: 5 V, GND, output to the input.",
                            "The Arduino is supplied by USB. TB6612: VCC to 5 V of the Arduino. L298N: remove the "
                            "jumpers of ENA and ENB."}};
    for (std::size_t i = 0; i < plan.inputs.size(); ++i) wiring.inputs.push_back(pin_of_input(i));
    for (const MotorPin& pin : motor_pins)
        wiring.pins.push_back({std::to_string(pin.pin), pin.l298n.empty()
                                                            ? std::string(pin.tb6612)
                                                            : fmt::format("{} ({})", pin.tb6612, pin.l298n)});
    return robots::wiring_svg(plan, wiring);
}

}  // namespace braitenlab::robots::arduino

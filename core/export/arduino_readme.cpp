// README and list of parts of the Arduino export.
#include <algorithm>

#include <fmt/format.h>

#include "core/export/arduino.h"
#include "core/export/text.h"
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

constexpr std::string_view readme_text = R"(# The brain "@TITLE@" on an Arduino Uno

Exported from Braitenlab. The program computes the same commands as the lab: it was compared with it in a simulator of the
processor. **This export has not been tried on a real robot yet**; please report what you find.

| File | Contents |
|---|---|
| `braitenberg/braitenberg.ino` | the sketch: eyes, motors, calibration |
| `braitenberg/brain.h` | the brain, one function that you can read |
| `wiring.svg` | the wiring |
| `parts.csv` | the shopping list |

## Wiring

![Wiring](wiring.svg)

@PINS@
| Sensor | Pin | Part |
|---|---|---|
@SENSORS@
All grounds are connected: battery, driver, Arduino. The driver's motor supply (VM of a TB6612, +12V of an L298N) is the battery, not the
5 V of the Arduino. Left motor: AO1, AO2 (OUT1, OUT2). Right motor: BO1, BO2 (OUT3, OUT4).
The Arduino gets its 5 V by USB, from a power bank or the computer, so that the sensors read the same while calibrated and while driving.
Its VIN needs 7 V or more; four cells give 4.8 V to 6 V, which are for the motors alone.
With an L298N remove the jumpers of ENA and ENB. It loses about 2 V, so take six cells instead of four.
The board works at 5 V and 16 MHz. On a board of 3.3 V the sensors of this list damage the inputs.
Solder a capacitor of 100 nF to the terminals of each motor; brushes disturb the sensors.

The list is that of the robot *tt2wd-ldr*. Wheels, track and top speed of your scene are no part of the export; the brain is the same.
The 1.5 kΩ of a photoresistor belong to eyes with `half_lux = 268`. For another value take 15 kΩ · (half_lux / 10)^−0.7.

## First start

1. Open `braitenberg/braitenberg.ino` in the Arduino program, choose *Arduino Uno*, upload. Open the serial monitor at 115200 baud:
   it says each step. Without a computer the light on the board blinks while it waits for the button.
2. **Wheels off the floor.** Swap the two wires of a motor that turns backwards.
3. **Sensors**, one after the other: the serial monitor says what to show it for the readings 0 and 1, as the table above does; press the
   button at each. An eye in the lab reaches 1 only right at the lamp, so hold the lamp as near as it goes. If both values are nearly
   the same, it asks again.
4. **Minimum PWM**, with the motors' battery on: press the button, the left wheel gets slowly more; press again as soon as it turns. Then
   the right one. Without this step small commands do not turn the wheels at all, and the brain seems dead.
5. **Straight run**: on the floor, press the button, step back. It drives for 3 s. Press once if it turned left, twice if it turned right, and
   it repeats with the faster wheel 2 % slower. Wait 5 s if it was straight.

The values are kept in the EEPROM. To calibrate again, hold the button during reset. A sketch with other sensors, or with the same ones in
another order, calibrates anew.

**Each start.** After power-on or reset the light on the board blinks and the wheels stand for 3 s: time to set the robot down. The button
starts it at once. `START_DELAY` in the sketch is this time. While it drives the button stops it, and starts it again.

## Rate and memory

The brain is computed @RATE@ times per second. A step takes up to @STEP@ ms of @PERIOD@ ms, the program up to @BYTES@ of @LARGEST@ bytes: estimates
from costs that were measured in a simulator of the processor.@LOWERED@

## What transfers and what does not

- Light seekers and light avoiders work with motors that differ by 20 %, with noise and with a latency of 0.3 s, because the eyes correct
  the course. What has no feedback drifts: a circle or a dance by biases alone will not close.
- The lamp must be brighter than the room at the eye: a torch, or a lamp within 0.5 m, and less than 20 lx otherwise (curtains).
- The speed of a wheel is not measured. PWM and speed are only roughly proportional.
)";

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
    return filled(readme_text, {{"TITLE", comment_text(plan.title)},
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
    std::string text =
        "number,part,note\n"
        "1,Arduino Uno,or a compatible board of 5 V and 16 MHz with an ATmega328P\n"
        "1,USB power bank,for the Arduino\n"
        "1,TB6612 board,or an L298N board with six cells\n"
        "1,chassis with two TT motors 1:48 and wheels of 65 mm,with a castor\n"
        "1,battery holder for four AA cells,for the motors; six with an L298N; with a switch\n"
        "2,capacitor 100 nF,at the terminals of each motor\n"
        "1,push button,\n";
    for (const Input& input : plan.inputs)
        text += fmt::format("1,\"{}\",\"for sensor {}\"\n", part_of(input).part, cell(input.name).c_str());
    return text + "1,set of jumper wires and a half breadboard,\n";
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

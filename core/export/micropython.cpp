#include "core/export/micropython.h"

#include <string_view>

#include <fmt/format.h>

#include "core/export/arduino.h"
#include "core/export/text.h"
#include "core/messages.h"
#include "core/scene/enums.h"
#include "core/scene/nearest.h"

namespace braitenlab::robots::micropython {

namespace {

// The response curves, as core/brain/curve.h defines them. An exponent above 80 gives the same float as 80.
struct Function {
    Response response;
    std::string_view text;
};
constexpr Function functions[] = {
    {Response::rectified, "def rectified(x):\n    return x if x > 0 else 0.0\n"},
    {Response::step, "def step(x, threshold):\n    return 1.0 if x >= threshold else 0.0\n"},
    {Response::sigmoid, "def sigmoid(x, centre, width):\n    return 1 / (1 + exp(min(80, -(x - centre) / width)))\n"},
    {Response::hump, "def hump(x, peak, width):\n    t = (x - peak) / width\n    return exp(-min(80, t * t))\n"},
    {Response::inverted, "def inverted(x):\n    return 1 - x\n"},
};

// Floats of the micro:bit have 22 significant bits and are cut, not rounded. What many small steps lose would add up,
// so it is carried to the next step (W. Kahan, Communications of the ACM 8, 1965).
constexpr std::string_view added_text =
    "\n\n# The sum, and what a float is too short for: it is added to the next step.\n"
    "def added(value, step):\n    total = value + step\n    return total, step - (total - value)\n";

std::string through(const Curve& curve, const std::string& x) {
    const ResponseTraits& row = traits(curve.response);
    if (curve.response == Response::linear) return x;
    std::string text = fmt::format("{}({}", row.word, x);
    if (row.has_peak) text += ", " + number(curve.peak);
    if (row.has_width) text += ", " + number(curve.width);
    return text + ")";
}

// Values of the previous step are global; those of this step have "new_" before their name.
std::string reading(const Plan& plan, const PlanTap& tap) {
    const auto index = static_cast<std::size_t>(tap.source);
    if (tap.reads == Reads::sensor) return plan.inputs[index].id;
    return (tap.reads == Reads::now ? "new_" : "") + plan.units[index].id;
}

std::string product(const Plan& plan, const PlanTap& tap) {
    std::string x = reading(plan, tap);
    if (tap.threshold > 0) x = fmt::format("masked({}, {})", x, number(tap.threshold));
    const std::string weight =
        tap.learned_id.empty() ? number(tap.weight) : fmt::format("({} + {})", number(tap.weight), tap.learned_id);
    return fmt::format("    s += {} * {}\n", weight, through(tap.curve, x));
}

std::string lines_of(const Plan& plan, const PlanUnit& unit, bool motor) {
    std::string text = fmt::format("    # {} {}\n    s = {}\n", motor ? "motor" : "neuron", comment_text(unit.name),
                                   number(unit.bias));
    for (const PlanTap& tap : unit.taps) text += product(plan, tap);
    const std::string result = "new_" + unit.id;
    std::string value = through(unit.curve, "s");
    if (unit.follow < 1) {
        text += fmt::format("    {0}, rest_{1} = added({1}, {2} * ({3} - {1}) + rest_{1})\n", result, unit.id,
                            number(unit.follow), value);
        value = result;
    }
    if (unit.value.low <= -largest_value || unit.value.high >= largest_value)
        value = fmt::format("max(-1000.0, min(1000.0, {}))", value);
    return value == result ? text : text + fmt::format("    {} = {}\n", result, value);
}

std::string learning(const Plan& plan) {
    std::string text;
    for (const PlanUnit& unit : plan.units)
        for (const PlanTap& tap : unit.taps) {
            if (tap.learned_id.empty()) continue;
            text += fmt::format(
                "    # learns while both ends are active, and fades\n"
                "    {0}, rest_{0} = added({0}, ({1} * {2} * new_{3} - {4} * {0}) / RATE_HZ + rest_{0})\n"
                "    {0} = max({5}, min({6}, {0}))\n",
                tap.learned_id, number(tap.learning_rate), reading(plan, tap), unit.id, number(tap.decay),
                number(-limits::weight - tap.weight), number(limits::weight - tap.weight));
        }
    return text;
}

constexpr std::string_view main_text =
    R"(# The brain "@TITLE@" on a micro:bit. Exported from Braitenlab. README.md has the pins.
# Button A: drive, and stop. Button B: print the sensors.
from microbit import *
import brain

# Calibration: write your own values. Button B prints what a sensor reads.
DARK = [@DARK@]  # of each sensor, at its reading 0
BRIGHT = [@BRIGHT@]  # at its reading 1
MINIMUM = [180, 180]  # of 1023: PWM from which the left and the right wheel turn
FASTEST = [1023, 1023]  # less for the faster motor, so that it drives straight

EYES = [@EYES@]
MOTORS = [[pin8, pin12, pin13], [pin16, pin14, pin15]]  # left and right: PWM, forwards, backwards
STEP = 1000 // brain.RATE_HZ  # ms


def eye(i):  # 0 to 1
    return max(0, min(1, (EYES[i].read_analog() - DARK[i]) / (BRIGHT[i] - DARK[i])))


def drive(wheel, command):  # -1 to 1
    size = abs(command)
    pwm = 0 if size < @SMALLEST@ else int(MINIMUM[wheel] + size * (FASTEST[wheel] - MINIMUM[wheel]) + 0.5)
    MOTORS[wheel][1].write_digital(1 if command > 0 else 0)
    MOTORS[wheel][2].write_digital(1 if command < 0 else 0)
    MOTORS[wheel][0].write_analog(pwm)


display.off()  # its pins are free then
for wheel in MOTORS:
    wheel[0].set_analog_period(4)  # ms; without it 20, as long as a step
driving = False
due = running_time()
try:
    while True:
        if button_a.was_pressed():
            driving = not driving
        if button_b.was_pressed():
            print([e.read_analog() for e in EYES])
        left, right = brain.think(@ARGUMENTS@)
        drive(0, left if driving else 0)
        drive(1, right if driving else 0)
        due = max(due + STEP, running_time() - STEP)  # of the next step, so that errors of sleep() do not add up
        sleep(max(0, due - running_time()))
finally:  # the motors stop when the program does
    for wheel in MOTORS:
        wheel[0].write_analog(0)
)";

constexpr std::string_view readme_text = R"(# The brain "@TITLE@" on a micro:bit

Exported from Braitenlab. `brain.py` was compared with the lab in MicroPython 1.9.2 for the micro:bit, in an emulator. **Pins, motors and
eyes (`main.py`) have not been tried on a real robot**; please report what you find.

| File | Contents |
|---|---|
| `brain.py` | the brain, one function that you can read: @BYTES@ bytes |
| `main.py` | pins, calibration values, the loop |
| `wiring.svg` | the wiring picture |
| `parts.csv` | the shopping list |

Copy both files to the micro:bit, for example with the editor Mu.

| Pin | TB6612 | |
|---|---|---|
| P8, P12, P13 | PWMA, AIN1, AIN2 | left motor |
| P16, P14, P15 | PWMB, BIN1, BIN2 | right motor |
| 3V | VCC, STBY | |
| GND | GND | also the battery's |

| Sensor | Pin | Part |
|---|---|---|
@SENSORS@
The pins take 3 V. A sensor that is built for 5 V does not work at 3 V, and 5 V at a pin damage the board: take the parts of this list.

Calibrate by writing values into `main.py`: button B prints what the sensors read. `DARK` is the value at the reading 0, `BRIGHT` that at
the reading 1; the table says what to show each sensor.
Raise `MINIMUM` until each wheel just turns; lower `FASTEST` of the faster motor until it drives straight. Button A starts and stops.

Numbers on the micro:bit have 30 bits and are cut, not rounded, so a command differs from the lab's by less than 0.0001.
)";

}  // namespace

std::optional<Error> refusal(const Plan& plan) {
    if (auto fault = arduino::sensor_fault(plan, "micro:bit", analog_inputs)) return fault;
    const std::size_t bytes = brain_py(plan).size();
    if (bytes > static_cast<std::size_t>(largest_brain)) return too_large(plan, bytes, "micro:bit", largest_brain);
    return std::nullopt;
}

Error too_large(const Plan& plan, std::size_t bytes, std::string_view robot, int largest) {
    std::size_t most = 0;
    const PlanUnit* longest = &plan.units.front();
    for (std::size_t u = 0; u < plan.units.size(); ++u)
        if (const std::size_t part = lines_of(plan, plan.units[u], u >= plan.hidden()).size(); part > most)
            most = part, longest = &plan.units[u];
    return error_of(message_of("program_bytes", bytes, most, in_quotes(longest->name), robot, largest));
}

bool needs_exp(const Plan& plan) { return has_response(plan, Response::sigmoid) || has_response(plan, Response::hump); }

std::string think_py(const Plan& plan) {
    std::string text = fmt::format("RATE_HZ = {:g}\n", plan.rate_hz);
    std::string kept, stored;
    bool any_sum = false;
    const auto keep = [&](const std::string& id) {
        text += id + " = 0.0\n";
        kept += (kept.empty() ? "" : ", ") + id;
    };
    const auto keep_sum = [&](const std::string& id) {
        keep(id), keep("rest_" + id);
        any_sum = true;
    };
    for (const PlanUnit& unit : plan.units) {
        if (!unit.is_kept) continue;
        unit.follow < 1 ? keep_sum(unit.id) : keep(unit.id);
        stored += fmt::format("    {0} = new_{0}\n", unit.id);
    }
    for (const PlanUnit& unit : plan.units)
        for (const PlanTap& tap : unit.taps)
            if (!tap.learned_id.empty()) keep_sum(tap.learned_id);
    if (any_sum) text += added_text;
    if (has_threshold(plan)) text += "\n\ndef masked(x, threshold):\n    return 0.0 if abs(x) < threshold else x\n";
    for (const Function& function : functions)
        if (has_response(plan, function.response)) text += "\n\n" + std::string(function.text);
    std::string parameters;
    for (const Input& input : plan.inputs) parameters += (parameters.empty() ? "" : ", ") + input.id;
    text += fmt::format(
        "\n\n# Sensors 0 to 1; returns the commands of the left and the right wheel, -1 to 1.\n"
        "def think({}):\n",
        parameters);
    if (!kept.empty()) text += fmt::format("    global {}\n", kept);
    for (std::size_t u = 0; u < plan.units.size(); ++u) text += lines_of(plan, plan.units[u], u >= plan.hidden());
    text += learning(plan) + stored;
    return text + fmt::format("    return max(-1, min(1, new_{})), max(-1, min(1, new_{}))\n",
                              plan.units[plan.hidden()].id, plan.units[plan.hidden() + 1].id);
}

std::string brain_py(const Plan& plan) {
    return fmt::format("# The brain \"{}\", exported from Braitenlab. Call think() {:g} times per second.\n{}{}",
                       comment_text(plan.title), plan.rate_hz, needs_exp(plan) ? "from math import exp\n\n" : "",
                       think_py(plan));
}

std::string main_py(const Plan& plan) {
    std::string dark, bright, eyes, arguments;
    for (std::size_t i = 0; i < plan.inputs.size(); ++i) {
        const std::string comma = i > 0 ? ", " : "";
        dark += comma + "100", bright += comma + "900";
        eyes += fmt::format("{}pin{}", comma, i), arguments += fmt::format("{}eye({})", comma, i);
    }
    return filled(main_text, {{"TITLE", comment_text(plan.title)},
                              {"DARK", dark},
                              {"BRIGHT", bright},
                              {"EYES", eyes},
                              {"ARGUMENTS", arguments},
                              {"SMALLEST", number(arduino::smallest_command)}});
}

std::string readme(const Plan& plan) {
    std::string sensors;
    for (std::size_t i = 0; i < plan.inputs.size(); ++i) {
        const arduino::SensorPart& shown = arduino::part_of(plan.inputs[i]);
        sensors += fmt::format("| {} | P{} | {}; 0: {}, 1: {}{} |\n", comment_text(plan.inputs[i].name), i,
                               part_of(plan.inputs[i]), shown.zero, shown.one, arduino::doubt_about(plan.inputs[i]));
    }
    return filled(
        readme_text,
        {{"TITLE", comment_text(plan.title)}, {"BYTES", std::to_string(brain_py(plan).size())}, {"SENSORS", sensors}});
}

}  // namespace braitenlab::robots::micropython

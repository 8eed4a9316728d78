// The sketch for an Arduino Uno. The brain itself is brain.h, see c_header.cpp.
#include <fmt/format.h>

#include "core/export/arduino.h"
#include "core/export/sensor_parts.h"
#include "core/export/text.h"
#include "core/export/texts.h"
#include "core/maths/fnv.h"
#include "core/scene/enums.h"

namespace braitenlab::robots::arduino {

namespace {

constexpr std::string_view eye_pins = R"(const byte EYES = @EYES@;
const byte EYE_PIN[] = {@PINS@};
const char *const EYE_NAME[] = {@NAMES@};
)";

constexpr std::string_view eye_fields =
    "  int16_t dark[EYES];   // analogRead() at the reading 0\n"
    "  int16_t bright[EYES]; // analogRead() at the reading 1\n";

std::string pin_constants() {
    std::string text;
    for (const MotorPin& pin : motor_pins)
        text += fmt::format("{:<32}  // {}{}\n", fmt::format("const byte {} = {};", pin.constant, pin.pin),
                            "TB6612 " + std::string(pin.tb6612),
                            pin.l298n.empty() ? "" : ", L298N " + std::string(pin.l298n));
    text.pop_back();
    return text;
}

}  // namespace

std::string pin_of_input(std::size_t input) { return fmt::format("A{}", input); }

unsigned calibration_mark(const Plan& plan) {
    std::uint64_t hash = maths::fnv_start;
    for (const Input& input : plan.inputs)
        hash = maths::fnv(fmt::format("{} {};", input.name, word(input.channel.value_or(Channel::light))), hash);
    // Erased memory reads 0xFFFF.
    return static_cast<unsigned>(hash % 0xFFFFU);
}

std::string sketch(const Plan& plan) {
    std::string pins, names, read, calibrate;
    const std::vector<SensorPart> parts = parts_of(plan, Board::uno);
    const int warm_up = warm_up_of(parts);
    for (std::size_t i = 0; i < plan.inputs.size(); ++i) {
        pins += (i > 0 ? ", " : "") + pin_of_input(i);
        names +=
            fmt::format("{}\"{}\"", i > 0 ? ", " : "", plan.inputs[i].id.substr(std::string_view("sensor_").size()));
        read += fmt::format("  brain.{} = eye({});\n", plan.inputs[i].id, i);
        const SensorPart& part = parts[i];
        calibrate +=
            fmt::format("      case {0}: calibrateEye({0}, F(\"{1}\"), F(\"{2}\")); break;\n", i, part.zero, part.one);
    }
    // A brain without sensors has no code for eyes.
    const auto with_eyes = [&](std::string_view part) {
        return plan.inputs.empty() ? std::string() : std::string(part);
    };
    const std::string count = std::to_string(plan.inputs.size());
    return filled(texts::braitenberg_ino,
                  {{"TITLE", comment_text(plan.title)},
                   {"RATE", fmt::format("{:g}", plan.rate_hz)},
                   {"PINS", pin_constants()},
                   {"MARK", fmt::format("0x{:04X}", calibration_mark(plan))},
                   {"BUTTON", std::to_string(button_pin)},
                   {"EYE_PINS", with_eyes(filled(eye_pins, {{"EYES", count}, {"PINS", pins}, {"NAMES", names}}))},
                   {"EYE_FIELDS", with_eyes(eye_fields)},
                   {"EYE_FUNCTIONS", with_eyes(texts::braitenberg_eyes_ino)},
                   {"EYE_CALIBRATION", with_eyes(texts::braitenberg_eye_calibration_ino)},
                   {"CALL_EYES", calibrate},
                   {"WARM_UP",
                    warm_up == 0 ? "" : filled(texts::braitenberg_warm_up_ino, {{"SECONDS", std::to_string(warm_up)}})},
                   {"CALL_WARM_UP", warm_up == 0 ? "" : "  warmUp();\n"},
                   {"STEPS", std::to_string(plan.inputs.size() + 3)},
                   {"SMALLEST", number(smallest_command)},
                   {"READ", read}});
}

}  // namespace braitenlab::robots::arduino

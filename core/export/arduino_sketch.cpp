// The sketch for an Arduino Uno. The brain itself is brain.h, see c_header.cpp.
#include <fmt/format.h>

#include "core/export/arduino.h"
#include "core/export/text.h"
#include "core/maths/fnv.h"
#include "core/scene/enums.h"

namespace braitenlab::robots::arduino {

namespace {

constexpr std::string_view sketch_text = R"(// The brain "@TITLE@" on a robot with two motors and an Arduino Uno.
// Exported from Braitenlab. README.md has the wiring and the calibration.
//
// Each 1/@RATE@ s: read the eyes, compute the brain (brain.h), set the motors.

#include <EEPROM.h>
#include "brain.h"

// ---- Pins ------------------------------------------------------------------

// The same pins serve a TB6612 and an L298N; only the TB6612 has a standby pin.
@PINS@
const byte BUTTON = @BUTTON@;            // to ground, pressed: LOW

@EYE_PINS@
// ---- Calibration, kept in the EEPROM ---------------------------------------

struct Calibration {
  uint16_t mark;        // shows that the EEPROM holds a calibration
@EYE_FIELDS@  byte minimum[2];      // PWM from which the left and the right wheel turn
  byte fastest[2];      // PWM at the command 1; less for the faster motor, so that it drives straight
};
const uint16_t MARK = @MARK@;  // of these sensors in this order: the calibration of other ones is not used
Calibration calibration;

const byte LEFT = 0, RIGHT = 1;
const float SMALLEST_COMMAND = @SMALLEST@;  // below it the wheel stands
const unsigned long START_DELAY = 3000;     // milliseconds from power-on to the first movement

// ---- Motors ----------------------------------------------------------------

void setWheel(byte wheel, int pwm) {  // -255 (backwards) to 255 (forwards)
  const byte forward = wheel == LEFT ? LEFT_FORWARD : RIGHT_FORWARD;
  const byte back = wheel == LEFT ? LEFT_BACK : RIGHT_BACK;
  digitalWrite(forward, pwm > 0);
  digitalWrite(back, pwm < 0);
  analogWrite(wheel == LEFT ? LEFT_PWM : RIGHT_PWM, abs(pwm));
}

// A motor does not turn below its minimum PWM. Commands use the range above it.
void drive(byte wheel, float command) {  // -1 to 1
  const float size = fabs(command);
  int pwm = 0;
  if (size >= SMALLEST_COMMAND) {
    const float least = calibration.minimum[wheel], most = calibration.fastest[wheel];
    pwm = least + size * (most - least) + 0.5;  // rounded
  }
  setWheel(wheel, command < 0 ? -pwm : pwm);
}

@EYE_FUNCTIONS@// ---- Calibration -----------------------------------------------------------

void waitForRelease() {
  delay(30);
  while (digitalRead(BUTTON) == LOW) {}
  delay(30);
}

void waitForButton() {
  while (digitalRead(BUTTON) == HIGH) digitalWrite(LED_BUILTIN, millis() / 250 % 2);  // blinks while it waits
  waitForRelease();
  digitalWrite(LED_BUILTIN, LOW);
}

@EYE_CALIBRATION@void calibrateMinimum(byte wheel) {
  Serial.println(wheel == LEFT ? F("Left wheel: press the button. It starts slowly; press again as soon as it turns.")
                               : F("Right wheel: press the button. It starts slowly; press again as soon as it turns."));
  int pwm;
  do {
    waitForButton();
    pwm = 0;
    while (pwm < 200 && digitalRead(BUTTON) == HIGH) {
      setWheel(wheel, ++pwm);
      delay(60);
    }
    setWheel(wheel, 0);
    if (pwm == 200) Serial.println(F("  Is the battery of the motors on? Press the button to try again."));
  } while (pwm == 200);
  if (digitalRead(BUTTON) == LOW) waitForRelease();  // it may be released already
  calibration.minimum[wheel] = pwm;
  Serial.print(F("  Minimum PWM: "));
  Serial.println(pwm);
}

byte pressesWithin(unsigned long time) {
  byte presses = 0;
  const unsigned long start = millis();
  while (millis() - start < time)
    if (digitalRead(BUTTON) == LOW) {
      presses++;
      waitForButton();
    }
  return presses;
}

void calibrateStraight() {
  for (;;) {
    Serial.println(F("Straight run: set it on the floor, press the button, step back. It drives for 3 s."));
    Serial.println(F("  Then within 5 s: press once if it turned left, twice if it turned right, else wait."));
    waitForButton();
    delay(1000);
    drive(LEFT, 0.6);
    drive(RIGHT, 0.6);
    delay(3000);
    drive(LEFT, 0);
    drive(RIGHT, 0);
    digitalWrite(LED_BUILTIN, HIGH);
    const byte presses = pressesWithin(5000);
    digitalWrite(LED_BUILTIN, LOW);
    if (presses == 0) return;
    const byte faster = presses == 1 ? RIGHT : LEFT;
    if (calibration.fastest[faster] > calibration.minimum[faster] + 10) calibration.fastest[faster] -= 5;
  }
}

void calibrate() {
  calibration.minimum[LEFT] = calibration.minimum[RIGHT] = 0;
  calibration.fastest[LEFT] = calibration.fastest[RIGHT] = 255;
@CALL_EYES@  calibrateMinimum(LEFT);
  calibrateMinimum(RIGHT);
  calibrateStraight();
  calibration.mark = MARK;
  EEPROM.put(0, calibration);
  Serial.println(F("Done. The values are kept. To calibrate again, hold the button during reset."));
}

// ---- Program ---------------------------------------------------------------

Brain brain;  // all values start at 0
unsigned long lastStep;
const unsigned long PERIOD = 1000000UL / BRAIN_RATE_HZ;  // microseconds

// The light blinks and the wheels stand for START_DELAY, or until the button is pressed: time to set the robot down.
void waitBeforeStart() {
  const unsigned long start = millis();
  while (millis() - start < START_DELAY && digitalRead(BUTTON) == HIGH) digitalWrite(LED_BUILTIN, millis() / 125 % 2);
  if (digitalRead(BUTTON) == LOW) waitForRelease();
  digitalWrite(LED_BUILTIN, LOW);
}

void stopUntilButton() {
  setWheel(LEFT, 0);
  setWheel(RIGHT, 0);
  waitForRelease();
  waitForButton();
  lastStep = micros();
}

void setup() {
  const byte outputs[] = {LEFT_PWM, LEFT_FORWARD, LEFT_BACK, RIGHT_PWM, RIGHT_FORWARD, RIGHT_BACK, STANDBY, LED_BUILTIN};
  for (byte i = 0; i < sizeof outputs; i++) pinMode(outputs[i], OUTPUT);
  digitalWrite(STANDBY, HIGH);
  pinMode(BUTTON, INPUT_PULLUP);
  delay(10);
  Serial.begin(115200);
  EEPROM.get(0, calibration);
  if (calibration.mark != MARK || digitalRead(BUTTON) == LOW) calibrate();
  waitBeforeStart();
  lastStep = micros();
}

void loop() {
  if (micros() - lastStep < PERIOD) return;
  lastStep += PERIOD;
  if (digitalRead(BUTTON) == LOW) stopUntilButton();
@READ@  brain_think(&brain);
  drive(LEFT, brain.left);
  drive(RIGHT, brain.right);
}
)";

constexpr std::string_view eye_pins = R"(const byte EYES = @EYES@;
const byte EYE_PIN[] = {@PINS@};
const char *const EYE_NAME[] = {@NAMES@};
)";

constexpr std::string_view eye_fields =
    "  int16_t dark[EYES];   // analogRead() at the reading 0\n"
    "  int16_t bright[EYES]; // analogRead() at the reading 1\n";

constexpr std::string_view eye_functions =
    R"(// ---- Eyes ------------------------------------------------------------------

// 0 at the eye's dark value, 1 at its bright value.
float eye(byte i) {
  const float reading = (analogRead(EYE_PIN[i]) - calibration.dark[i]) / (float)(calibration.bright[i] - calibration.dark[i]);
  return constrain(reading, 0.0f, 1.0f);
}

int meanOfEye(byte i) {
  long sum = 0;
  for (byte n = 0; n < 32; n++) {
    sum += analogRead(EYE_PIN[i]);
    delay(5);  // 160 ms: several periods of mains light
  }
  return sum / 32;
}

)";

constexpr std::string_view eye_calibration =
    R"(// What the eye measures once the button is pressed, while it is shown this.
int measured(byte i, const __FlashStringHelper *shown) {
  Serial.print(shown);
  Serial.println(F(". Press the button."));
  waitForButton();
  const int mean = meanOfEye(i);
  Serial.print(F("  Measured: "));
  Serial.println(mean);
  return mean;
}

// `zero` and `one`: what the sensor is shown for the readings 0 and 1.
void calibrateEye(byte i, const __FlashStringHelper *zero, const __FlashStringHelper *one) {
  do {
    Serial.print(F("Sensor "));
    Serial.print(EYE_NAME[i]);
    Serial.print(F(", reading 0: "));
    calibration.dark[i] = measured(i, zero);
    Serial.print(F("  Reading 1: "));
    calibration.bright[i] = measured(i, one);
  } while (abs(calibration.bright[i] - calibration.dark[i]) < 20);  // too close: again
}

)";

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
    for (std::size_t i = 0; i < plan.inputs.size(); ++i) {
        pins += (i > 0 ? ", " : "") + pin_of_input(i);
        names +=
            fmt::format("{}\"{}\"", i > 0 ? ", " : "", plan.inputs[i].id.substr(std::string_view("sensor_").size()));
        read += fmt::format("  brain.{} = eye({});\n", plan.inputs[i].id, i);
        const SensorPart& part = part_of(plan.inputs[i]);
        calibrate += fmt::format("  calibrateEye({}, F(\"{}\"), F(\"{}\"));\n", i, part.zero, part.one);
    }
    // A brain without sensors has no code for eyes.
    const auto with_eyes = [&](std::string_view part) {
        return plan.inputs.empty() ? std::string() : std::string(part);
    };
    const std::string count = std::to_string(plan.inputs.size());
    return filled(sketch_text,
                  {{"TITLE", comment_text(plan.title)},
                   {"RATE", fmt::format("{:g}", plan.rate_hz)},
                   {"PINS", pin_constants()},
                   {"MARK", fmt::format("0x{:04X}", calibration_mark(plan))},
                   {"BUTTON", std::to_string(button_pin)},
                   {"EYE_PINS", with_eyes(filled(eye_pins, {{"EYES", count}, {"PINS", pins}, {"NAMES", names}}))},
                   {"EYE_FIELDS", with_eyes(eye_fields)},
                   {"EYE_FUNCTIONS", with_eyes(eye_functions)},
                   {"EYE_CALIBRATION", with_eyes(eye_calibration)},
                   {"CALL_EYES", calibrate},
                   {"SMALLEST", number(smallest_command)},
                   {"READ", read}});
}

}  // namespace braitenlab::robots::arduino

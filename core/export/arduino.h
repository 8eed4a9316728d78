// What the sketch, the README and the wiring picture of the Arduino export share: pins and costs.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/export/plan.h"

namespace braitenlab::robots::arduino {

// A pin of the Uno and what it connects to on each motor driver. The PWM pins 5 and 6 have one timer, so both motors
// get the same frequency (980 Hz).
struct MotorPin {
    int pin;
    std::string_view constant;       // of the sketch
    std::string_view tb6612, l298n;  // names printed on the driver boards; empty: not connected
};
inline constexpr std::array motor_pins{
    MotorPin{6, "LEFT_PWM", "PWMA", "ENA"},      MotorPin{7, "LEFT_FORWARD", "AIN1", "IN1"},
    MotorPin{8, "LEFT_BACK", "AIN2", "IN2"},     MotorPin{5, "RIGHT_PWM", "PWMB", "ENB"},
    MotorPin{9, "RIGHT_FORWARD", "BIN1", "IN3"}, MotorPin{10, "RIGHT_BACK", "BIN2", "IN4"},
    MotorPin{4, "STANDBY", "STBY", ""},
};
inline constexpr int button_pin = 2;
inline constexpr int analog_inputs = 6;        // A0 to A5
inline constexpr int most_neurons = 60;        // memory of 2 KB
inline constexpr int largest_program = 32256;  // bytes: 32 KB less the boot loader
// A smaller command stops the wheel. Others begin at the wheel's minimum PWM, so that there is no dead band.
inline constexpr float smallest_command = 0.02f;

// Estimates of the whole sketch: not less than avr-gcc 5.4 and simavr give, and at most 30 % more bytes. Terms that
// are equal count once, as the compiler computes them once.
struct Cost {
    int cycles = 0;  // of one step, at 16 MHz
    int bytes = 0;   // of program memory
};
Cost cost_of(const Plan&);

// The largest rate, `robot_rate` or less, at which a step ends in time; nullopt: there is none of 10 per second or
// more.
std::optional<int> rate_for(const Cost&, int robot_rate);
inline constexpr int lowest_rate = 10;

// Of these sensors in this order, so that a sketch does not use the calibration of another brain's sensors.
unsigned calibration_mark(const Plan&);

// "A0"
std::string pin_of_input(std::size_t input);

std::string sketch(const Plan&);
std::string readme(const Plan&, int robot_rate);
std::string parts_csv(const Plan&);
std::string wiring_svg(const Plan&);

}  // namespace braitenlab::robots::arduino

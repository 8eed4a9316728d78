// A brain as a circuit of operational amplifiers: one buffer for each sensor, one differential summer for each motor.
//
// 5 V stand for 1. With a feedback resistor Rf, an input through the resistor Rf/|w| to the inverting input adds −|w|,
// one to the other input +w, if the conductances at both inputs are equal; a balance resistor to ground makes them so
// (the differential summer of any textbook of operational amplifiers).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/export/plan.h"
#include "core/result.h"

namespace braitenlab::robots::opamp {

inline constexpr double feedback_ohms = 100e3;

// An LM324 sinks 12 µA at least near 0 V (data sheet of Texas Instruments, IOL at VO = 200 mV), less than resistors
// from other outputs bring. Resistors to ground take the rest: one from each buffer, and those of each motor.
inline constexpr double pull_down_ohms = 1e3;

// From each motor's output of up to 8.2 V (7.5 V at 9 V, more with a fresh battery) a resistor to a diode, which holds
// that point at 0.7 V above 5 V, and from there a divider to the input of the driver. The command 1, 5 V, becomes 3.6
// V, and no output more than 5.1 V.
inline constexpr double limit_ohms = 510, divider_ohms = 270, driver_pull_down_ohms = 2e3;
inline constexpr double share_of_driver = driver_pull_down_ohms / (limit_ohms + divider_ohms + driver_pull_down_ohms);
// From 5 V to ground: takes what the two diodes bring (2.5 mA each at 8.2 V), which a regulator does not sink.
inline constexpr double load_ohms = 1e3;

// The inputs of the motor drivers. TB6612 (data sheet of Toshiba): low to 0.3 VCC, high from 0.7 VCC to VCC + 0.2 V,
// with the 5 V of this circuit at VCC. L298 (data sheet of ST) at 5 V of its own: low to 1.5 V, high from 2.3 V.
inline constexpr double low_volts = 1.5, tb6612_high_volts = 3.5, l298_high_volts = 2.3, largest_driver_volts = 5.2;

// The 5 V of an L7805 are 4.8 V to 5.2 V (data sheet of Texas Instruments), a divider of 1 % is off by 0.6 %, and
// resistors of 1 % change a command by up to 0.02 (shipped brains in ngspice).
inline constexpr double least_5_volts = 4.8, most_5_volts = 5.2, divider_error = 0.006, command_error = 0.02;

// The commands below which no driver turns a wheel, and from which each one does, whatever the parts are within their
// tolerances. The threshold of a TB6612 follows the 5 V.
inline constexpr double stands_below =
    low_volts / (most_5_volts * share_of_driver * (1 + divider_error)) - command_error;
inline constexpr double l298_turns_from =
    l298_high_volts / (least_5_volts * share_of_driver * (1 - divider_error)) + command_error;
inline constexpr double tb6612_turns_from =
    tb6612_high_volts / (5 * share_of_driver * (1 - divider_error)) + command_error;

// A block battery of 9 V gives more than this for a short time only.
inline constexpr double block_milliamperes = 100;

struct Resistor {
    std::string from, to;  // nodes of the netlist: "buffered_SL", "left_minus", "left_limit", "v5", "0" (ground)
    double exact = 0;      // ohms
    // Ohms, of the series E24: the nearest value, or two values in parallel where that one would change a command by
    // more than 0.4 %.
    std::vector<double> e24{};
    std::vector<std::string> names{};  // of the parts of `e24`: "R3"; given by circuit_of()
};

// The resistors of one motor. `side`: "left" or "right".
std::vector<Resistor> summer(const Plan&, const PlanUnit& motor, const std::string& side);

// The first part that the circuit cannot hold, with its name: sensors without a part, neurons, thresholds, curves,
// memories, learning wires, weights for which there is no resistor.
std::optional<Error> refusal(const Plan&);

// Largest error of a command, as a share of 1, that the E24 values cause for readings 0..1; resistors without
// tolerance.
double e24_error(const Plan&);

// What a sensor's reading 0 counts as at most with an amplifier that sinks nothing: its inputs are at 5 V at most, and
// each resistor of weight w brings up to 5 V·|w|/Rf into the buffer's resistor to ground.
double largest_reading_of_dark(const Plan&);

// The commands of a motor for the readings of its sensors without a calibration: SensorPart::readings, and what an eye
// reads of the room.
Range commands_of(const Plan&, const PlanUnit& motor);

// The command of a motor while its sensors sense nothing but the room without a lamp: Input::in_room, and
// SensorPart::readings.low.
double command_at_rest(const Plan&, const PlanUnit& motor);

// The reading of a wire's sensor that gives this command to its motor while all others sense nothing else; nullopt:
// none does.
std::optional<double> reading_for(const Plan&, const PlanUnit& motor, const PlanTap&, double command);

// Wheels that no command turns for certain, with both drivers; wheels that stand in the room without a lamp, where the
// lab's vehicle drives; sensors that read less where the lab's read more.
std::vector<Error> warnings(const Plan&);

// Largest current from 9 V with a TB6612 at 5 V; that of 5 V is a part of it. Without sensors that have a supply of
// their own.
double milliamperes_at_9_volts(const Plan&);

struct PinOfNode {
    std::string node;
    int pin = 0;
};

// One of the four amplifiers of an LM324.
struct Amplifier {
    std::size_t chip = 0;  // index; the name is chip_name()
    char letter = 'A';     // A to D
    PinOfNode plus{}, minus{}, out{};
    std::string name() const;  // "U1A"
};

struct Connector {
    std::string name, value;         // "J2", "motor driver"
    std::vector<std::string> nodes;  // of its pins, from pin 1
};

// A capacitor, or a diode from its anode to its cathode.
struct TwoPole {
    std::string name, value;  // "C1", "330 nF"; "D1", "1N4148"
    std::string from, to;     // nodes
};

// The E24 circuit with the names of its parts. Every file of the export is written from it.
struct Circuit {
    // Of the summers, the left motor's first, then of the buffers, of the inputs of the motor driver and of 5 V.
    std::vector<Resistor> resistors;
    std::vector<TwoPole> capacitors;  // C1 and C2 of the regulator, then one of each LM324
    std::vector<TwoPole> diodes;      // of the left and of the right motor
    // A buffer for each sensor, the left summer, the right one, then those that are left over: 0 V at their output, so
    // that they do not oscillate.
    std::vector<Amplifier> amplifiers;
    std::size_t used_amplifiers = 0;
    // J1: 9 V ("v9"), J2: the motor driver, then one for each sensor.
    std::vector<Connector> connectors;
    std::size_t chips() const { return amplifiers.size() / 4; }
};
Circuit circuit_of(const Plan&);

std::string chip_name(std::size_t chip);
std::string sensor_connector(std::size_t input);  // "J3"
inline constexpr int lm324_supply_pin = 4, lm324_ground_pin = 11;
std::string regulator_name(const Circuit&);  // after the LM324s: "U2"
inline constexpr std::string_view regulator_value = "L7805";
inline constexpr int regulator_in_pin = 1, regulator_ground_pin = 2, regulator_out_pin = 3;

std::string buffered(const Input&);                 // node of the sensor's buffer: "buffered_SL"
std::string limited(const std::string& side);       // node of the diode: "left_limit"
std::string driver_input(const std::string& side);  // node of the motor driver's input: "left_driver"

// For ngspice and LTspice, to be included in a deck of its user: a subcircuit whose name begins with "brain_" and
// differs, also without case, from that of every other brain, so that several fit into one deck. It sets no options.
std::string netlist(const Plan&, bool exact);

// The E24 circuit with its LM324, regulator and connectors as a netlist of KiCad (s-expressions, version E;
// "Intermediate Netlist Structure" in KiCad's manual of Eeschema), with footprints for through-hole parts.
std::string kicad_netlist(const Plan&);
std::string readme(const Plan&);
std::string parts_csv(const Plan&);

// The robot: the board of this circuit as a box with its sensors, the motor driver, the motors and the batteries.
std::string robot_svg(const Plan&);

// The schematic as sheets of A4, each an SVG: one for a brain of few sensors and wires. Its texts are the names and
// values of circuit_of().
std::vector<std::string> wiring_sheets(const Plan&);

}  // namespace braitenlab::robots::opamp

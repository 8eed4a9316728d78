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
// from other outputs bring. These resistors take the rest: one from each buffer to ground, and at each motor a divider
// from the output of up to 8.2 V (7.5 V at 9 V, more with a fresh battery) to the input of the driver, which takes 6 V
// (TB6612) or 7 V (L298) at most. 5 V, the command 1, become 3.6 V, above the 3.5 V at which a TB6612 at 5 V reads
// high.
inline constexpr double pull_down_ohms = 1e3, limit_ohms = 390;

struct Resistor {
    std::string from, to;  // nodes of the netlist: "buffered_SL", "left_minus", "left_driver", "v5", "0" (ground)
    double exact = 0;      // ohms
    // Ohms, of the series E24: the nearest value, or two values in parallel where that one would change a command by
    // more than 0.4 %.
    std::vector<double> e24{};
    std::vector<std::string> names{};  // of the parts of `e24`: "R3"; given by circuit_of()
};

// The resistors of one motor. `side`: "left" or "right".
std::vector<Resistor> summer(const Plan&, const PlanUnit& motor, const std::string& side);

// The nearest value of the series E24 (IEC 60063), by ratio.
double nearest_e24(double ohms);

// The first part that the circuit cannot hold, with its name: neurons, thresholds, curves, memories, learning wires,
// weights for which there is no resistor.
std::optional<Error> refusal(const Plan&);

// Largest error of a command, as a share of 1, that the E24 values cause for readings 0..1; resistors without
// tolerance.
double e24_error(const Plan&);

// What a sensor's reading 0 counts as at most with an amplifier that sinks nothing: its inputs are at 5 V at most, and
// each resistor of weight w brings up to 5 V·|w|/Rf into the buffer's resistor to ground.
double largest_reading_of_dark(const Plan&);

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
    std::string name, value;         // "J2", "sensors"
    std::vector<std::string> nodes;  // of its pins, from pin 1
};

// The E24 circuit with the names of its parts. Every file of the export is written from it.
struct Circuit {
    // Of the summers, the left motor's first, then of the buffers and of the inputs of the motor driver.
    std::vector<Resistor> resistors;
    // A buffer for each sensor, the left summer, the right one, then those that are left over: 0 V at their output, so
    // that they do not oscillate.
    std::vector<Amplifier> amplifiers;
    std::size_t used_amplifiers = 0;
    std::vector<Connector> connectors;  // "v9": supply of 9 V
    std::size_t chips() const { return amplifiers.size() / 4; }
};
Circuit circuit_of(const Plan&);

std::string chip_name(std::size_t chip);
inline constexpr int lm324_supply_pin = 4, lm324_ground_pin = 11;
// An L7805.
inline constexpr std::string_view regulator_name = "U99";
inline constexpr int regulator_in_pin = 1, regulator_ground_pin = 2, regulator_out_pin = 3;

std::string buffered(const Input&);                 // node of the sensor's buffer: "buffered_SL"
std::string driver_input(const std::string& side);  // node of the motor driver's input: "left_driver"
std::string ohms_text(double ohms);                 // "120 kΩ"

// For ngspice and LTspice, to be included in a deck of its user: a subcircuit whose name begins with "brain_" and
// differs, also without case, from that of every other brain, so that several fit into one deck. It sets no options.
std::string netlist(const Plan&, bool exact);

// The E24 circuit with its LM324, regulator and connectors as a netlist of KiCad (s-expressions, version E;
// "Intermediate Netlist Structure" in KiCad's manual of Eeschema), with footprints for through-hole parts.
std::string kicad_netlist(const Plan&);
std::string readme(const Plan&);
std::string parts_csv(const Plan&);

// The schematic as sheets of A4, each an SVG: one for a brain of few sensors and wires. Its texts are the names and
// values of circuit_of().
std::vector<std::string> wiring_sheets(const Plan&);

}  // namespace braitenlab::robots::opamp

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

struct Resistor {
    std::string from, to;  // nodes of the netlist: "buffered_SL", "left_minus", "v5", "0" (ground)
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
    std::vector<Resistor> resistors;  // of the left motor, then of the right one
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

std::string buffered(const Input&);  // node of the sensor's buffer: "buffered_SL"
std::string ohms_text(double ohms);  // "120 kΩ"

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

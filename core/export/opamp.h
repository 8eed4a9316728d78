// A brain as a circuit of operational amplifiers: one buffer for each sensor, one differential summer for each motor.
//
// 5 V stand for 1. With a feedback resistor Rf, an input through the resistor Rf/|w| to the inverting input adds −|w|,
// one to the other input +w, if the conductances at both inputs are equal; a balance resistor to ground makes them so
// (the differential summer of any textbook of operational amplifiers).
#pragma once

#include <optional>
#include <string>
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

std::string netlist(const Plan&, bool exact);

// The E24 circuit with its LM324, regulator and connectors as a netlist of KiCad (s-expressions, version E;
// "Intermediate Netlist Structure" in KiCad's manual of Eeschema), with footprints for through-hole parts.
std::string kicad_netlist(const Plan&);
std::string readme(const Plan&);
std::string parts_csv(const Plan&);

}  // namespace braitenlab::robots::opamp

// The parts of the circuit with their names and pins.
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "core/export/opamp.h"

namespace braitenlab::robots::opamp {

namespace {

// Pins of the four amplifiers of an LM324 (data sheet of Texas Instruments).
struct AmplifierPins {
    char letter;
    int out, minus, plus;
};
constexpr AmplifierPins pins_of_lm324[] = {{'A', 1, 2, 3}, {'B', 7, 6, 5}, {'C', 8, 9, 10}, {'D', 14, 13, 12}};

void add_amplifier(Circuit& circuit, const std::string& plus, const std::string& minus, const std::string& out) {
    const std::size_t number = circuit.amplifiers.size(), in_chip = std::size(pins_of_lm324);
    const AmplifierPins& pins = pins_of_lm324[number % in_chip];
    circuit.amplifiers.push_back(
        {number / in_chip, pins.letter, {plus, pins.plus}, {minus, pins.minus}, {out, pins.out}});
}

void add_resistor(Circuit& circuit, int& number, Resistor r) {
    for (std::size_t part = 0; part < r.e24.size(); ++part) r.names.push_back(fmt::format("R{}", ++number));
    circuit.resistors.push_back(std::move(r));
}

}  // namespace

std::string buffered(const Input& input) { return "buffered_" + input.id.substr(std::string_view("sensor_").size()); }

std::string limited(const std::string& side) { return side + "_limit"; }

std::string driver_input(const std::string& side) { return side + "_driver"; }

std::string Amplifier::name() const { return chip_name(chip) + letter; }

std::string chip_name(std::size_t chip) { return fmt::format("U{}", chip + 1); }

std::string regulator_name(const Circuit& circuit) { return chip_name(circuit.chips()); }

std::string sensor_connector(std::size_t input) { return fmt::format("J{}", input + 3); }

Circuit circuit_of(const Plan& plan) {
    Circuit circuit;
    for (const Input& input : plan.inputs) {
        add_amplifier(circuit, input.id, buffered(input), buffered(input));
    }
    int number = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        const std::string side = i == 0 ? "left" : "right";
        bool has_plus = false;
        for (Resistor& r : summer(plan, plan.units[plan.hidden() + i], side)) {
            has_plus |= r.to == side + "_plus";
            add_resistor(circuit, number, std::move(r));
        }
        add_amplifier(circuit, has_plus ? side + "_plus" : "0", side + "_minus", side);
    }
    for (const Input& input : plan.inputs)
        add_resistor(circuit, number, {buffered(input), "0", pull_down_ohms, {pull_down_ohms}});
    for (const char* side : {"left", "right"}) {
        add_resistor(circuit, number, {side, limited(side), limit_ohms, {limit_ohms}});
        add_resistor(circuit, number, {limited(side), driver_input(side), divider_ohms, {divider_ohms}});
        add_resistor(circuit, number, {driver_input(side), "0", driver_pull_down_ohms, {driver_pull_down_ohms}});
        circuit.diodes.push_back({fmt::format("D{}", circuit.diodes.size() + 1), "1N4148", limited(side), "v5"});
    }
    add_resistor(circuit, number, {"v5", "0", load_ohms, {load_ohms}});
    circuit.used_amplifiers = circuit.amplifiers.size();
    for (int unused = 1; circuit.amplifiers.size() % std::size(pins_of_lm324) != 0; ++unused) {
        const std::string node = fmt::format("unused_{}", unused);
        add_amplifier(circuit, "0", node, node);
    }
    circuit.capacitors = {{"C1", "330 nF", "v9", "0"}, {"C2", "100 nF", "v5", "0"}};
    for (std::size_t chip = 0; chip < circuit.chips(); ++chip)
        circuit.capacitors.push_back({fmt::format("C{}", chip + 3), "100 nF", "v9", "0"});
    circuit.connectors = {{"J1", "9V", {"v9", "0"}},
                          {"J2", "motor driver", {driver_input("left"), driver_input("right"), "v5", "0"}}};
    for (std::size_t i = 0; i < plan.inputs.size(); ++i)
        circuit.connectors.push_back({sensor_connector(i), "sensor", {"v5", "0", plan.inputs[i].id}});
    return circuit;
}

}  // namespace braitenlab::robots::opamp

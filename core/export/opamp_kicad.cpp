// The circuit as a netlist of KiCad.
#include <map>
#include <utility>

#include <fmt/format.h>

#include "core/export/opamp.h"
#include "core/export/text.h"

namespace braitenlab::robots::opamp {

namespace {

constexpr std::string_view resistor_footprint = "Resistor_THT:R_Axial_DIN0207_L6.3mm_D2.5mm_P10.16mm_Horizontal";

std::string kicad_value(double ohms) {
    if (ohms >= 1e6) return fmt::format("{:.4g}M", ohms / 1e6);
    return ohms >= 1e3 ? fmt::format("{:.4g}k", ohms / 1e3) : fmt::format("{:.4g}", ohms);
}

std::string net_of(const std::string& node) {
    if (node == "0") return "GND";
    if (node == "v9") return "+9V";
    return node == "v5" ? "+5V" : node;
}

class KicadBoard {
public:
    void part(const std::string& ref, std::string_view value, std::string_view footprint) {
        components_ +=
            fmt::format("    (comp (ref \"{}\") (value \"{}\") (footprint \"{}\"))\n", ref, value, footprint);
    }
    void join(const std::string& net, const std::string& ref, int pin) { nets_[net].emplace_back(ref, pin); }

    void resistor(const std::string& ref, const Resistor& r, double ohms) {
        part(ref, kicad_value(ohms), resistor_footprint);
        join(net_of(r.from), ref, 1);
        join(net_of(r.to), ref, 2);
    }

    // `first`, `second`: nodes of the pins 1 and 2.
    void two_pole(const TwoPole& pole, std::string_view footprint, const std::string& first,
                  const std::string& second) {
        part(pole.name, pole.value, footprint);
        join(net_of(first), pole.name, 1);
        join(net_of(second), pole.name, 2);
    }

    void amplifier(const Amplifier& amplifier) {
        const std::string ref = chip_name(amplifier.chip);
        if (amplifier.letter == 'A') {
            part(ref, "LM324", "Package_DIP:DIP-14_W7.62mm");
            join("+9V", ref, lm324_supply_pin);
            join("GND", ref, lm324_ground_pin);
        }
        for (const PinOfNode* pin : {&amplifier.plus, &amplifier.minus, &amplifier.out})
            join(net_of(pin->node), ref, pin->pin);
    }

    void connector(const Connector& connector) {
        part(connector.name, connector.value,
             fmt::format("Connector_PinHeader_2.54mm:PinHeader_1x{:02}_P2.54mm_Vertical", connector.nodes.size()));
        for (std::size_t i = 0; i < connector.nodes.size(); ++i)
            join(net_of(connector.nodes[i]), connector.name, static_cast<int>(i) + 1);
    }

    std::string text(std::string_view title) const {
        std::string nets;
        int code = 0;
        for (const auto& [net, pins] : nets_) {
            nets += fmt::format("    (net (code \"{}\") (name \"{}\")", ++code, net);
            for (const auto& [ref, pin] : pins)
                nets += fmt::format("\n      (node (ref \"{}\") (pin \"{}\"))", ref, pin);
            nets += ")\n";
        }
        return fmt::format(
            "(export (version \"E\")\n  (design (source \"{}\") (tool \"Braitenlab\"))\n  (components\n{})\n"
            "  (nets\n{}))\n",
            title, components_, nets);
    }

private:
    std::string components_;
    std::map<std::string, std::vector<std::pair<std::string, int>>> nets_;
};

// Strings in a netlist have no quotes and no backslashes.
std::string plain(std::string text) {
    for (char& c : text)
        if (c == '"' || c == '\\') c = '\'';
    return text;
}

}  // namespace

std::string kicad_netlist(const Plan& plan) {
    KicadBoard board;
    const Circuit circuit = circuit_of(plan);
    for (const Resistor& r : circuit.resistors)
        for (std::size_t part = 0; part < r.e24.size(); ++part) board.resistor(r.names[part], r, r.e24[part]);
    for (const Amplifier& amplifier : circuit.amplifiers) board.amplifier(amplifier);
    for (const Connector& connector : circuit.connectors) board.connector(connector);
    for (const TwoPole& capacitor : circuit.capacitors)
        board.two_pole(capacitor, "Capacitor_THT:C_Disc_D5.0mm_W2.5mm_P5.00mm", capacitor.from, capacitor.to);
    for (const TwoPole& diode : circuit.diodes)  // pin 1 is the cathode
        board.two_pole(diode, "Diode_THT:D_DO-35_SOD27_P7.62mm_Horizontal", diode.to, diode.from);
    const std::string regulator = regulator_name(circuit);
    board.part(regulator, regulator_value, "Package_TO_SOT_THT:TO-220-3_Vertical");
    board.join("+9V", regulator, regulator_in_pin);
    board.join("GND", regulator, regulator_ground_pin);
    board.join("+5V", regulator, regulator_out_pin);
    return board.text(plain(comment_text(plan.title)));
}

}  // namespace braitenlab::robots::opamp

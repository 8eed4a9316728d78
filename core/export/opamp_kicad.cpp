// The circuit as a netlist of KiCad.
#include <map>
#include <utility>

#include <fmt/format.h>

#include "core/export/opamp.h"
#include "core/export/text.h"

namespace braitenlab::robots::opamp {

namespace {

// Pins of an LM324 (data sheet of Texas Instruments).
struct Amplifier {
    int out, minus, plus;
};
constexpr Amplifier amplifiers[] = {{1, 2, 3}, {7, 6, 5}, {8, 9, 10}, {14, 13, 12}};
constexpr int supply_pin = 4, ground_pin = 11;

constexpr std::string_view resistor_footprint = "Resistor_THT:R_Axial_DIN0207_L6.3mm_D2.5mm_P10.16mm_Horizontal";

std::string kicad_value(double ohms) {
    if (ohms >= 1e6) return fmt::format("{:.4g}M", ohms / 1e6);
    return ohms >= 1e3 ? fmt::format("{:.4g}k", ohms / 1e3) : fmt::format("{:.4g}", ohms);
}

std::string net_of(const std::string& node) {
    if (node == "0") return "GND";
    return node == "v5" ? "+5V" : node;
}

class Board {
public:
    void part(const std::string& ref, std::string_view value, std::string_view footprint) {
        components_ +=
            fmt::format("    (comp (ref \"{}\") (value \"{}\") (footprint \"{}\"))\n", ref, value, footprint);
    }
    void join(const std::string& net, const std::string& ref, int pin) { nets_[net].emplace_back(ref, pin); }

    void resistor(const std::string& from, const std::string& to, double ohms) {
        const std::string ref = fmt::format("R{}", ++resistors_);
        part(ref, kicad_value(ohms), resistor_footprint);
        join(net_of(from), ref, 1);
        join(net_of(to), ref, 2);
    }

    void amplifier(const std::string& plus, const std::string& minus, const std::string& out) {
        const int unit = used_++ % 4;
        const std::string ref = fmt::format("U{}", (used_ - 1) / 4 + 1);
        if (unit == 0) {
            part(ref, "LM324", "Package_DIP:DIP-14_W7.62mm");
            join("+9V", ref, supply_pin);
            join("GND", ref, ground_pin);
        }
        join(plus, ref, amplifiers[unit].plus);
        join(minus, ref, amplifiers[unit].minus);
        join(out, ref, amplifiers[unit].out);
    }

    // The amplifiers that are left over: 0 V at their output, so that they do not oscillate.
    void end_amplifiers() {
        for (int number = 1; used_ % 4 != 0; ++number) {
            const std::string net = fmt::format("unused_{}", number);
            amplifier("GND", net, net);
        }
    }

    // Pins in this order.
    void connector(const std::string& ref, std::string_view value, const std::vector<std::string>& nets) {
        part(ref, value, fmt::format("Connector_PinHeader_2.54mm:PinHeader_1x{:02}_P2.54mm_Vertical", nets.size()));
        for (std::size_t i = 0; i < nets.size(); ++i) join(nets[i], ref, static_cast<int>(i) + 1);
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
    int resistors_ = 0, used_ = 0;
};

// Strings in a netlist have no quotes and no backslashes.
std::string plain(std::string text) {
    for (char& c : text)
        if (c == '"' || c == '\\') c = '\'';
    return text;
}

}  // namespace

std::string kicad_netlist(const Plan& plan) {
    Board board;
    std::vector<std::string> sensors{"+5V", "GND"};
    for (const Input& input : plan.inputs) {
        const std::string buffered = "buffered_" + input.id.substr(std::string_view("sensor_").size());
        board.amplifier(input.id, buffered, buffered);
        sensors.push_back(input.id);
    }
    for (std::size_t i = 0; i < 2; ++i) {
        const std::string side = i == 0 ? "left" : "right";
        bool has_plus = false;
        for (const Resistor& r : summer(plan, plan.units[plan.hidden() + i], side)) {
            has_plus |= r.to == side + "_plus";
            for (const double ohms : r.e24) board.resistor(r.from, r.to, ohms);
        }
        board.amplifier(has_plus ? side + "_plus" : "GND", side + "_minus", side);
    }
    board.end_amplifiers();
    board.connector("J1", "9V", {"+9V", "GND"});
    board.connector("J2", "sensors", sensors);
    board.connector("J3", "motors", {"left", "right", "GND"});
    board.part("U99", "L7805", "Package_TO_SOT_THT:TO-220-3_Vertical");
    board.join("+9V", "U99", 1);
    board.join("GND", "U99", 2);
    board.join("+5V", "U99", 3);
    return board.text(plain(comment_text(plan.title)));
}

}  // namespace braitenlab::robots::opamp

#include "core/export/opamp.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/export/e24.h"
#include "core/export/sensor_parts.h"
#include "core/export/text.h"
#include "core/export/texts.h"
#include "core/maths/fnv.h"
#include "core/messages.h"
#include "core/plain_letters.h"
#include "core/scene/enums.h"
#include "core/scene/nearest.h"

namespace braitenlab::robots::opamp {

namespace {

constexpr double largest_ohms = 10e6;
constexpr double largest_error = 0.004;  // of a command, by a single resistor
constexpr double least_weight = feedback_ohms / largest_ohms;

const Input& input_of(const Plan& plan, const PlanTap& tap) {
    return plan.inputs[static_cast<std::size_t>(tap.source)];
}

// Of its voltage by 5 V. The light of the room adds to that of the lamp.
Range readings_of(const Input& input) {
    const Range readings = part_of(input, Board::circuit).readings;
    return {readings.low, std::max(readings.high, input.in_room)};
}

// While it senses nothing but the room.
float reading_at_rest(const Input& input) { return std::max(readings_of(input).low, input.in_room); }

bool is_dark(const Plan& plan) {
    return std::all_of(plan.inputs.begin(), plan.inputs.end(), [](const Input& i) { return i.in_room <= 0; });
}

// "total darkness", "the scene's room of 30 lx": where nothing but the room is sensed.
std::string room_text(const Plan& plan) {
    if (plan.lux > 0 && !is_dark(plan))
        return fmt::format("the scene's room of {}", lux_text(static_cast<double>(plan.lux)));
    return is_dark(plan) ? "total darkness" : "the ambient light of the scene's room";
}

// Conductances are in units of 1/Rf.
double exact_share(const Resistor& r) { return feedback_ohms / r.exact; }
double e24_share(const Resistor& r) {
    double share = 0;
    for (const double ohms : r.e24) share += feedback_ohms / ohms;
    return share;
}

// The conductance at the inverting input minus that at the other one.
double imbalance(const std::vector<Resistor>& resistors, const std::string& side, double (*share)(const Resistor&)) {
    double difference = 0;
    for (const Resistor& r : resistors) difference += (r.to == side + "_minus" ? 1 : -1) * share(r);
    return difference;
}

// The next value of E24 that is not smaller.
double e24_above(double ohms) {
    const double nearest = nearest_e24(ohms);
    return nearest >= ohms ? nearest : nearest_e24(nearest * 1.1);
}

std::vector<double> e24_of(double ohms) {
    const double single = nearest_e24(ohms);
    if (feedback_ohms * std::fabs(1 / single - 1 / ohms) <= largest_error) return {single};
    const double first = e24_above(ohms), rest = 1 / (1 / ohms - 1 / first);
    if (!(rest <= largest_ohms)) return {first};
    return {first, nearest_e24(rest)};
}

// What the circuit computes with its E24 values: the weight of each node that drives it.
std::map<std::string, double> e24_weights(const std::vector<Resistor>& resistors, const std::string& side) {
    double minus = 0, plus = 0, feedback = 1;
    for (const Resistor& r : resistors) {
        (r.to == side + "_minus" ? minus : plus) += e24_share(r);
        if (r.from == side) feedback = e24_share(r);
    }
    std::map<std::string, double> weights;
    for (const Resistor& r : resistors) {
        if (r.from == side || r.from == "0") continue;
        // Both inputs have one voltage: at the non-inverting one the mean of its nodes, weighted by conductance.
        weights[r.from] += e24_share(r) * (r.to == side + "_minus" ? -1 / feedback : minus / (plus * feedback));
    }
    return weights;
}

std::string e24_text(const Resistor& r) {
    return ohms_text(r.e24[0]) + (r.e24.size() > 1 ? " ∥ " + ohms_text(r.e24[1]) : "");
}

std::string names_text(const Resistor& r) { return fmt::format("{}", fmt::join(r.names, " ∥ ")); }

std::vector<std::pair<std::string, const PlanUnit*>> motors_of(const Plan& plan) {
    return {{"left", &plan.units[plan.hidden()]}, {"right", &plan.units[plan.hidden() + 1]}};
}

// SPICE ignores a second subcircuit of the same name, and the case of names. The digits are those of the contents, so
// that brains of the same title differ.
std::string subcircuit_name(const std::string& title, const std::string& contents) {
    const std::string name = lower_case(Identifiers().make("brain_", title).substr(0, 40));
    return fmt::format("{}_{:06x}", name, maths::fnv(contents) & 0xffffffU);
}

std::string node_text(const std::string& node) {
    if (node == "0") return "ground";
    if (node == "v5") return "5 V";
    if (node == "v9") return "9 V";
    return node;
}

constexpr int sensor_pin = 3;  // of a sensor's connector, after 5 V and ground

// What a driver that turns a wheel from this command on does with commands of this range.
std::string_view verdict_on(const Range& commands, double turns_from) {
    if (static_cast<double>(commands.high) <= stands_below) return "never turns";
    return static_cast<double>(commands.high) < turns_from ? "may never turn" : "turns";
}

constexpr std::string_view either_text =
    " Between them it may do either; the table below says \"may\" where that matters.";
constexpr std::string_view either_driver = "Both drivers turn each wheel; the list of parts has a TB6612.";
constexpr std::string_view only_l298n =
    "A TB6612 does not turn each wheel for certain. The list of parts has an L298N, which needs lower commands.";
constexpr std::string_view no_driver =
    "**Neither driver turns each wheel for certain.** The list of parts has an L298N, which needs the lower commands: "
    "build it\nafter the brain gives each wheel at least the command from which it turns.";

constexpr std::string_view enough_of_a_block =
    "A block battery of 9 V gives that for a test; six alkaline AA cells in series, also 9 V,\nlast longer.";
constexpr std::string_view too_much_for_a_block =
    "That is more than a block battery of 9 V gives (about 100 mA for minutes):\ntake six alkaline AA cells in series, "
    "and screw the regulator to a heat sink.";

// TT motors are for 3 V to 6 V; an L298N loses about 2 V.
constexpr std::string_view board_rows =
    "1,stripboard or perfboard,for DIP parts,,,\n"
    "1,solder and insulated wire,,,,\n";
constexpr std::string_view rows_for_tb6612 =
    "1,holder for four AA cells with a switch,for the motors,VM,,\n"
    "4,alkaline AA cell,for the motors,,,\n";
constexpr std::string_view rows_for_l298n =
    "1,holder for six AA cells with a switch,for the motors,12V,,\n"
    "6,NiMH AA cell,for the motors,,,\n";
constexpr std::string_view motor_rows =
    "2,motor,TT motor 1:48 with a wheel of 65 mm,the outputs of the driver,,\n"
    "2,capacitor,100 nF,at the terminals of each motor,,\n"
    "1,chassis,for two TT motors with a castor,,,\n"
    "1,breadboard,half,J2,,\n"
    "1,set of jumper wires,,,,\n";

bool turns_each_wheel(const Plan& plan, double turns_from) {
    return std::all_of(plan.units.begin(), plan.units.end(), [&](const PlanUnit& motor) {
        return static_cast<double>(commands_of(plan, motor).high) >= turns_from;
    });
}

// A TB6612 where it turns each wheel, else an L298N.
bool takes_tb6612(const Plan& plan) { return turns_each_wheel(plan, tb6612_turns_from); }
double turns_from(const Plan& plan) { return takes_tb6612(plan) ? tb6612_turns_from : l298_turns_from; }

std::string_view driver_text(const Plan& plan) {
    if (takes_tb6612(plan)) return either_driver;
    return turns_each_wheel(plan, l298_turns_from) ? only_l298n : no_driver;
}

// A limit that is certain is rounded to the safe side.
std::string rounded_up(double value) { return fmt::format("{:.2f}", std::ceil(100 * value) / 100); }
std::string rounded_down(double value) { return fmt::format("{:.2f}", std::floor(100 * value) / 100); }

// The weight and the bias that give the lab's effect to a wire of a sensor that reads less than 0 to 1.
std::string scaled_wire(const PlanUnit& motor, const PlanTap& tap, const Range& readings) {
    const double old = static_cast<double>(tap.weight), low = static_cast<double>(readings.low),
                 wanted = old / static_cast<double>(readings.high - readings.low),
                 most = static_cast<double>(limits::weight), weight = std::clamp(wanted, -most, most);
    std::string text = fmt::format("  - to {}: {:.2f} instead of {:.2f}, and {:+.2f} to the bias",
                                   table_cell(motor.name), weight, old, -weight * low);
    if (weight != wanted)
        text += fmt::format(". The same effect would take {:.1f}, but a weight ends at ±{:g}: it has {:.0f} % of it",
                            wanted, most, 100 * weight / wanted);
    return text + "\n";
}

std::string scale_text(const Plan& plan) {
    std::string text;
    for (std::size_t i = 0; i < plan.inputs.size(); ++i) {
        const Range readings = part_of(plan.inputs[i], Board::circuit).readings;
        // A photoresistor has the curve of the lab's photocell.
        if (readings == Range{0, 1} || is_photoresistor(plan.inputs[i])) continue;
        text += fmt::format(
            "- {}: it reads {:.2g} to {:.2g}, not 0 to 1. Weights of its wires with the lab's effect:\n",
            table_cell(plan.inputs[i].name), static_cast<double>(readings.low), static_cast<double>(readings.high));
        for (const PlanUnit& motor : plan.units)
            for (const PlanTap& tap : motor.taps)
                if (tap.source == static_cast<int>(i)) text += scaled_wire(motor, tap, readings);
    }
    return text.empty()
               ? text
               : "\n" + text +
                     "\nSet them once: this text is written from the weights of the export, and a second export "
                     "says the same again.\n";
}

// "SR 0.61 (510 lx)": the sensor that turns a wheel with the least reading, and for an eye the light that gives it.
std::string reading_text(const Plan& plan, const PlanUnit& motor) {
    const double command = turns_from(plan);
    if (command_at_rest(plan, motor) >= command) return "any reading";
    double least = 2;
    std::string text;
    for (const PlanTap& tap : motor.taps) {
        const std::optional<double> reading = reading_for(plan, motor, tap, command);
        if (!reading || *reading >= least) continue;
        const Input& input = input_of(plan, tap);
        least = *reading;
        text = fmt::format("{} {}", table_cell(input.name), rounded_up(least));
        if (is_photoresistor(input)) text += fmt::format(" ({})", lux_text(lux_at(input, least)));
    }
    if (!text.empty()) return text;
    return static_cast<double>(commands_of(plan, motor).high) < command ? "no reading" : "several sensors together";
}

// The changes of the bias or of one weight, each alone, that raise a command to this one. `reading` is what a sensor
// reads then.
template <class Reading>
std::string changes_to(const Plan& plan, const PlanUnit& motor, double now, double wanted, Reading reading) {
    if (now >= wanted) return "as it is";
    std::vector<std::string> changes;
    const auto add = [&](const std::string& what, float value, double share, float most) {
        const double changed = std::ceil(100 * (static_cast<double>(value) + (wanted - now) / share)) / 100;
        if (changed > static_cast<double>(most)) return;
        changes.push_back(fmt::format("{} {:.2f} (now {:.2f})", what, changed, value));
    };
    add("bias", motor.bias, 1, limits::bias);
    for (const PlanTap& tap : motor.taps)
        if (const double share = static_cast<double>(reading(input_of(plan, tap))); tap.weight > 0 && share > 0)
            add("weight of " + table_cell(input_of(plan, tap).name), tap.weight, share, limits::weight);
    return changes.empty() ? "no bias or weight alone" : fmt::format("{}", fmt::join(changes, " or "));
}

// The smallest change of each wheel that its driver does not turn yet; empty if there is none.
std::string changes_text(const Plan& plan) {
    const double wanted = turns_from(plan);
    std::string rows;
    for (const auto& [side, motor] : motors_of(plan)) {
        const double rest = command_at_rest(plan, *motor), most = static_cast<double>(commands_of(plan, *motor).high);
        if (std::min(rest, most) >= wanted) continue;
        rows += fmt::format("| {} ({}) | {} | {} |\n", side, table_cell(motor->name),
                            changes_to(plan, *motor, rest, wanted, reading_at_rest),
                            changes_to(plan, *motor, most, wanted, [](const Input& i) { return readings_of(i).high; }));
    }
    if (rows.empty()) return rows;
    return fmt::format(
               "\nThe smallest change with which the {} turns a wheel for certain, set in the lab before the export; "
               "with the best readings\nthose sensors that add read most, and those that subtract least:\n\n"
               "| Wheel | In {}, while they sense nothing else | With the best readings |\n|---|---|---|\n",
               takes_tb6612(plan) ? "TB6612" : "L298N", room_text(plan)) +
           rows;
}

// The command that tells in a table that a wheel stands at rest.
std::string rest_text(const Plan& plan, const PlanUnit& motor) {
    const double command = command_at_rest(plan, motor);
    const std::string_view verdict = command <= stands_below      ? "stands"
                                     : command < turns_from(plan) ? "may stand"
                                                                  : "turns";
    return fmt::format("{:.2f}: {}", command, verdict);
}

// Where a driver has this limit: nominally, for a meter, and whatever the parts are within their tolerances.
std::string limit_row(std::string_view name, double volts, const std::string& certain) {
    return fmt::format("| {} | {:.1f} V | {:.1f} V | {:.2f} | {} |\n", name, volts, volts / share_of_driver,
                       volts / share_of_driver / 5, certain);
}

// The volts of a summer's output while all sensors have 0 V.
std::string test_volts(const PlanUnit& motor) {
    return fmt::format("{:.1f}", std::clamp(5 * static_cast<double>(motor.bias), 0.0, 7.5));
}

}  // namespace

std::vector<Resistor> summer(const Plan& plan, const PlanUnit& motor, const std::string& side) {
    std::vector<Resistor> resistors;
    const auto add = [&](const std::string& from, double weight) {
        const double ohms = feedback_ohms / std::fabs(weight);
        resistors.push_back({from, side + (weight < 0 ? "_minus" : "_plus"), ohms, e24_of(ohms)});
    };
    resistors.push_back({side, side + "_minus", feedback_ohms, {feedback_ohms}});
    for (const PlanTap& tap : motor.taps) add(buffered(input_of(plan, tap)), tap.weight);
    if (motor.bias != 0) add("v5", motor.bias);
    // The balance of the E24 circuit makes up for what the other values are off.
    const double exact = imbalance(resistors, side, exact_share), e24 = imbalance(resistors, side, e24_share);
    // A motor without a positive part has its other input at ground.
    if (std::fabs(exact) < least_weight) return resistors;
    resistors.push_back({"0", side + (exact > 0 ? "_plus" : "_minus"), feedback_ohms / std::fabs(exact),
                         e24_of(feedback_ohms / std::max(exact > 0 ? e24 : -e24, least_weight))});
    return resistors;
}

std::optional<Error> refusal(const Plan& plan) {
    if (plan.hidden() > 0) return error_of(message_of("circuit_neuron", in_quotes(plan.units[0].name)));
    if (auto fault = part_fault(plan)) return fault;
    for (const PlanUnit& motor : plan.units) {
        const std::string name = in_quotes(motor.name);
        if (motor.curve.response != Response::linear)
            return error_of(message_of("circuit_motor_curve", name, word(motor.curve.response)));
        if (motor.follow < 1) return error_of(message_of("circuit_memory", name));
        if (motor.bias != 0 && std::fabs(motor.bias) < least_weight) return error_of(message_of("circuit_bias", name));
        for (const PlanTap& tap : motor.taps) {
            if (tap.reads != Reads::sensor) return error_of(message_of("circuit_motor_wire", name));
            const std::string from = in_quotes(input_of(plan, tap).name);
            if (tap.learning_rate > 0) return error_of(message_of("circuit_learns", from, name));
            if (tap.threshold > 0) return error_of(message_of("circuit_threshold", from, name));
            if (tap.curve.response != Response::linear)
                return error_of(message_of("circuit_wire_curve", from, name, word(tap.curve.response)));
            if (std::fabs(tap.weight) < least_weight)
                return error_of(message_of("circuit_weak", from, name, fmt::format("{:g}", least_weight)));
        }
    }
    return std::nullopt;
}

double e24_error(const Plan& plan) {
    double worst = 0;
    for (const auto& [side, motor] : motors_of(plan)) {
        std::map<std::string, double> off = e24_weights(summer(plan, *motor, side), side);
        for (const PlanTap& tap : motor->taps) off[buffered(input_of(plan, tap))] -= static_cast<double>(tap.weight);
        if (motor->bias != 0) off["v5"] -= static_cast<double>(motor->bias);
        // The bias is always on; each reading is 0 to 1.
        double high = off["v5"], low = off["v5"];
        for (const auto& [node, error] : off)
            if (node != "v5") (error > 0 ? high : low) += error;
        worst = std::max({worst, high, -low});
    }
    return worst;
}

double largest_reading_of_dark(const Plan& plan) {
    std::map<int, double> weights;  // of each input: the sum of their sizes
    for (const auto& [side, motor] : motors_of(plan))
        for (const PlanTap& tap : motor->taps) weights[tap.source] += std::fabs(static_cast<double>(tap.weight));
    double most = 0;
    for (const auto& [input, weight] : weights) most = std::max(most, weight * pull_down_ohms / feedback_ohms);
    return most;
}

Range commands_of(const Plan& plan, const PlanUnit& motor) {
    Range commands{motor.bias, motor.bias};
    for (const PlanTap& tap : motor.taps) {
        const Range readings = readings_of(input_of(plan, tap));
        commands.low += tap.weight * (tap.weight < 0 ? readings.high : readings.low);
        commands.high += tap.weight * (tap.weight < 0 ? readings.low : readings.high);
    }
    return commands;
}

double command_at_rest(const Plan& plan, const PlanUnit& motor) {
    double command = static_cast<double>(motor.bias);
    for (const PlanTap& tap : motor.taps)
        command += static_cast<double>(tap.weight * reading_at_rest(input_of(plan, tap)));
    return command;
}

std::optional<double> reading_for(const Plan& plan, const PlanUnit& motor, const PlanTap& tap, double command) {
    if (tap.weight <= 0) return std::nullopt;
    const Input& input = input_of(plan, tap);
    const double reading = static_cast<double>(reading_at_rest(input)) +
                           (command - command_at_rest(plan, motor)) / static_cast<double>(tap.weight);
    return reading <= static_cast<double>(readings_of(input).high) ? std::optional(reading) : std::nullopt;
}

std::vector<Error> warnings(const Plan& plan) {
    const auto text = [](double value, const std::string& limit) {
        return told_apart(value, std::stod(limit), Digits::behind_point, 2).first;
    };
    std::vector<Error> found;
    for (const auto& [side, motor] : motors_of(plan)) {
        const double most = static_cast<double>(commands_of(plan, *motor).high), rest = command_at_rest(plan, *motor);
        const std::string name = in_quotes(motor->name);
        if (most < l298_turns_from) {
            const std::string l298 = rounded_up(l298_turns_from), tb6612 = rounded_up(tb6612_turns_from);
            const std::string bias = rounded_up(static_cast<double>(motor->bias) + l298_turns_from - most);
            found.push_back(error_of(
                most <= stands_below ? message_of("circuit_stands", name, text(most, l298), l298, tb6612, bias)
                                     : message_of("circuit_may_stand", name, text(most, l298), l298, tb6612, bias)));
        } else if (const double least = turns_from(plan); rest >= 0.005 && rest < least) {
            const std::string turns = rounded_up(least);
            const std::string command = text(rest, turns), driver = takes_tb6612(plan) ? "TB6612" : "L298N";
            found.push_back(error_of(is_dark(plan) ? message_of("circuit_rest", name, command, driver, turns)
                                                   : message_of("circuit_rest_in_room", name, command, driver, turns)));
        }
    }
    for (const Input& input : plan.inputs)
        if (part_of(input, Board::circuit).is_inverted)
            found.push_back(error_of(message_of("circuit_inverted", in_quotes(input.name))));
    return found;
}

double milliamperes_at_9_volts(const Plan& plan) {
    // At most: 3 mA of an LM324 and 8 mA of an L7805 (data sheets of Texas Instruments), 2.2 mA of a TB6612 at 5 V
    // (data sheet of Toshiba), 3.5 mA of each motor's resistors at 7.5 V.
    double sum = 3 * static_cast<double>(circuit_of(plan).chips()) + 8 + 2.2 + 2 * 3.5 + 5e3 / load_ohms;
    sum += board_milliamperes(parts_of(plan, Board::circuit));
    return sum + static_cast<double>(plan.inputs.size()) * 5e3 / pull_down_ohms;
}

// The amplifier has one pole: 1 MHz of gain times bandwidth (1 mS / (2 π 160 pF)) and a slew rate of 0.4 V/µs (64 µA
// into 160 pF), both of an LM324. Its output without a limit would not converge in a transient where it leaves a rail.
// The gain, 10^6, is ten times that of an LM324, so that a command is off by its resistors only.
std::string netlist(const Plan& plan, bool exact) {
    std::string pins, parts;
    for (const Input& input : plan.inputs) pins += input.id + " ";
    pins += "left right left_driver right_driver v5";
    const Circuit circuit = circuit_of(plan);
    for (const Resistor& r : circuit.resistors)
        for (std::size_t part = 0; part < (exact ? 1 : r.e24.size()); ++part)
            parts += fmt::format("{} {} {} {:.7g}\n", r.names[part], r.from, r.to, exact ? r.exact : r.e24[part]);
    const std::string name = subcircuit_name(plan.title, pins + parts);
    for (const TwoPole& diode : circuit.diodes)
        parts += fmt::format("{} {} {} {}_diode\n", diode.name, diode.from, diode.to, name);
    for (std::size_t i = 0; i < circuit.used_amplifiers; ++i) {
        const Amplifier& amplifier = circuit.amplifiers[i];
        parts += fmt::format("X{} {} {} {} {}_opamp\n", amplifier.name(), amplifier.plus.node, amplifier.minus.node,
                             amplifier.out.node, name);
    }
    return filled(texts::opamp_cir, {{"TITLE", comment_text(plan.title)},
                                     {"VALUES", exact ? "exact values" : "nearest of E24"},
                                     {"NAME", name},
                                     {"PINS", pins},
                                     {"PARTS", parts}});
}

std::string readme(const Plan& plan) {
    std::string rows, sensors, wheels;
    const Circuit circuit = circuit_of(plan);
    for (const Resistor& r : circuit.resistors)
        rows += fmt::format("| {} | {} | {} | {} | {} |\n", names_text(r), node_text(r.from), node_text(r.to),
                            ohms_text(r.exact), e24_text(r));
    const std::vector<SensorPart> parts = parts_of(plan, Board::circuit);
    for (std::size_t i = 0; i < parts.size(); ++i)
        sensors += fmt::format("| {} | `{}`, pin {} of {} | {} | {}{} | {} |\n", table_cell(plan.inputs[i].name),
                               plan.inputs[i].id, sensor_pin, sensor_connector(i), place_text(plan.inputs[i]),
                               joining_text(parts[i]), doubt_about(plan.inputs[i]), parts[i].uncalibrated);
    for (const auto& [side, motor] : motors_of(plan)) {
        const Range commands = commands_of(plan, *motor);
        wheels += fmt::format("| {} ({}) | {:.2f} to {:.2f} | {} | {} | {} | {} |\n", side, table_cell(motor->name),
                              static_cast<double>(commands.low), static_cast<double>(commands.high),
                              verdict_on(commands, tb6612_turns_from), verdict_on(commands, l298_turns_from),
                              rest_text(plan, *motor), reading_text(plan, *motor));
    }
    std::string warned;
    for (const Error& warning : warnings(plan)) warned += fmt::format("**Warning: {}.**\n", warning.what);
    const double load = milliamperes_at_9_volts(plan);
    const std::size_t count = wiring_sheets(plan).size();
    std::string sheets =
        "| `robot.svg` | this board as a box with its sensors, the driver, the motors and their battery; not the 9 V "
        "at J1 |\n"
        "| `wiring.svg` | the schematic of the board with the E24 values, to be printed on A4 |\n";
    for (std::size_t sheet = 2; sheet <= count; ++sheet)
        sheets += fmt::format("| `wiring-{}.svg` | its sheet {} |\n", sheet, sheet);
    return filled(
        texts::opamp_readme_md,
        {{"TITLE", comment_text(plan.title)},
         {"CHIPS", std::to_string(circuit.chips())},
         {"SHEETS", sheets},
         {"PLACES", places_text(plan, Board::circuit)},
         {"SENSORS", sensors},
         {"SCALES", scale_text(plan)},
         {"OWN_SUPPLY", own_supply_text(parts, "circuit")},
         {"WHEELS", wheels},
         {"DRIVER", std::string(driver_text(plan))},
         {"LISTED", takes_tb6612(plan) ? "TB6612" : "L298N"},
         {"LIMITS", limit_row("below which a wheel stands", low_volts, rounded_down(stands_below)) +
                        limit_row("from which an L298 turns it", l298_high_volts, rounded_up(l298_turns_from)) +
                        limit_row("from which a TB6612 turns it", tb6612_high_volts, rounded_up(tb6612_turns_from))},
         {"EITHER", wheels.find(" may ") == std::string::npos ? "" : std::string(either_text)},
         {"LEFT_TEST", test_volts(plan.units[plan.hidden()])},
         {"RIGHT_TEST", test_volts(plan.units[plan.hidden() + 1])},
         {"ROOM", room_text(plan)},
         {"CHANGES", changes_text(plan)},
         {"WARNINGS", warned.empty() ? "" : warned + "\n"},
         {"LOAD", fmt::format("{:.0f}", std::ceil(load))},
         {"SUPPLY", std::string(load > block_milliamperes ? too_much_for_a_block : enough_of_a_block)},
         {"ROWS", rows},
         {"ERROR", fmt::format("{:.1f}", 100 * e24_error(plan))},
         {"RAISED", fmt::format("{:.3f}", largest_reading_of_dark(plan))}});
}

std::string parts_csv(const Plan& plan) {
    std::string text = "number,part,value or use,from,to,name\n";
    const Circuit circuit = circuit_of(plan);
    std::map<double, std::vector<std::string>> resistors;  // names of equal ones
    for (const Resistor& r : circuit.resistors)
        for (std::size_t part = 0; part < r.e24.size(); ++part) resistors[r.e24[part]].push_back(r.names[part]);
    for (const auto& [ohms, names] : resistors)
        text += fmt::format("{},resistor 1 %,{},,,{}\n", names.size(), ohms_text(ohms), fmt::join(names, " "));
    for (const TwoPole& c : circuit.capacitors)
        text += fmt::format("1,capacitor,{},{},{},{}\n", c.value, node_text(c.from), node_text(c.to), c.name);
    for (const TwoPole& d : circuit.diodes)
        text += fmt::format("1,diode,{},{},{},{}\n", d.value, node_text(d.from), node_text(d.to), d.name);
    for (std::size_t chip = 0; chip < circuit.chips(); ++chip)
        text += fmt::format("1,operational amplifier,LM324,9 V,ground,{}\n", chip_name(chip));
    text += fmt::format("{},socket DIP-14,for each LM324,,,\n", circuit.chips());
    text += fmt::format("1,regulator,{},9 V,5 V,{}\n", regulator_value, regulator_name(circuit));
    const double load = milliamperes_at_9_volts(plan);
    if (load > block_milliamperes) text += "1,heat sink,for a TO-220 case,,,for the regulator\n";
    for (const Connector& connector : circuit.connectors)
        text += fmt::format("1,connector,{} pins,{},,{}\n", connector.nodes.size(), connector.value, connector.name);
    const bool has_tb6612 = takes_tb6612(plan);
    text += fmt::format("1,motor driver,{},J2,,\n", has_tb6612 ? "TB6612 board" : "L298N board");
    text += load > block_milliamperes
                ? "1,holder for six AA cells with a switch,9 V,J1,,\n6,alkaline AA cell,9 V,J1,,\n"
                : "1,block battery with clip and switch,9 V,J1,,\n";
    return text + std::string(board_rows) + std::string(has_tb6612 ? rows_for_tb6612 : rows_for_l298n) +
           std::string(motor_rows) + sensor_rows(plan, Board::circuit, ",,,");
}

}  // namespace braitenlab::robots::opamp

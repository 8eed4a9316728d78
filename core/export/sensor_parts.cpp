#include "core/export/sensor_parts.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <fmt/format.h>

#include "core/export/e24.h"
#include "core/export/text.h"
#include "core/io/csv.h"
#include "core/messages.h"
#include "core/scene/enums.h"
#include "core/scene/nearest.h"

namespace braitenlab::robots {

namespace {

// Infrared light passes filters of colour, so the part must not see it: a TEPT4400 sees visible light only.
SensorPart eye_for(Channel colour, std::string_view part, std::string_view lamp) {
    return {.channel = colour,
            .part = part,
            .supply = "5 V",
            .to_ground = "10 kΩ",
            .supply_terminal = "C",
            .input_terminal = "E",
            .milliamperes = 0.5,
            .symbol = PartSymbol::phototransistor,
            .zero = "covered",
            .one = lamp,
            .note = "its collector (C) is at the supply, its emitter (E) at the input",
            .uncalibrated = "0 in the dark, more with light; change the 10 kΩ until the lamp gives nearly 1"};
}
constexpr std::string_view own_supply = "5 V of its own";

SensorPart none_for(Channel channel) { return {.channel = channel, .part = "", .supply = "", .zero = "", .one = ""}; }

// Currents at 5 V: of a divider with the part at 0 Ω; of a GP2Y0A21 40 mA at most (data sheet of Sharp), of the heater
// of an MQ-3 180 mA (900 mW, data sheet of Winsen; 750 mW in that of Hanwei), of a TCRT5000 module its LED through
// 220 Ω and a lamp: 20 mA. Voltages of a GP2Y0A21: 0.4 V at 80 cm, 1.9 V more at 10 cm (data sheet of Sharp, typical);
// resistance of a thermistor of B = 3950 K at 60 °C: 2.5 kΩ.
const auto& parts_at_5_volts() {
    static const auto parts = std::to_array<SensorPart>({
        {.channel = Channel::light,
         .part = "photoresistor GL5528",
         .supply = "5 V",
         .symbol = PartSymbol::photoresistor,
         .zero = "covered",
         .one = "the lamp right in front of it",
         .readings = {0, 0.9f}},
        eye_for(Channel::red, "phototransistor TEPT4400 behind a red filter", "a red LED lamp right in front of it"),
        eye_for(Channel::green, "phototransistor TEPT4400 behind a green filter",
                "a green LED lamp right in front of it"),
        eye_for(Channel::blue, "phototransistor TEPT4400 behind a blue filter", "a blue LED lamp right in front of it"),
        {.channel = Channel::heat,
         .part = "thermistor NTC 10 kΩ",
         .supply = "5 V",
         .to_ground = "10 kΩ",
         .milliamperes = 0.5,
         .zero = "at room temperature",
         .one = "the warm source in front of it",
         .uncalibrated = "0.5 at 25 °C, 0.8 at 60 °C",
         .readings = {0.5f, 0.8f}},
        {.channel = Channel::smell,
         .part = "gas sensor module MQ-3, analog output",
         .supply = "5 V",
         .joining = Joining::module,
         .milliamperes = 180,
         .warm_up = 300,
         .zero = "in clean air",
         .one = "alcohol in front of it",
         .note = "its heater takes up to 180 mA at 5 V; it reads steadily after 5 minutes, a new one after a day",
         .uncalibrated =
             "more than 0 in clean air; measure its output there, and subtract weight · V / 5 of each of its "
             "wires from the bias of the wire's motor"},
        none_for(Channel::oxygen),
        {.channel = Channel::obstacle,
         .part = "infrared distance sensor GP2Y0A21 (10 cm to 80 cm)",
         .supply = "5 V",
         .joining = Joining::module,
         .capacitor = "10 µF",
         .milliamperes = 40,
         .zero = "nothing in front of it",
         .one = "an obstacle at 10 cm",
         .note = "nearer than 10 cm it reads less again; it may sit further back than its place in the scene, so that "
                 "nothing "
                 "comes nearer",
         .uncalibrated = "0.08 (0.4 V) at 80 cm to 0.46 (2.3 V) at 10 cm",
         .readings = {0.08f, 0.46f},
         .range = 0.8f},
        none_for(Channel::predator),
        none_for(Channel::prey),
        none_for(Channel::vehicle),
        none_for(Channel::memory),
        {.channel = Channel::touch,
         .part = "switch",
         .supply = "5 V",
         .to_ground = "10 kΩ",
         .milliamperes = 0.5,
         .symbol = PartSymbol::button,
         .zero = "released",
         .one = "pressed",
         .uncalibrated = "0 released, 1 pressed"},
        {.channel = Channel::floor,
         .part = "reflective sensor TCRT5000 module, analog output",
         .supply = "5 V",
         .joining = Joining::module,
         .milliamperes = 20,
         .zero = "above black",
         .one = "above white",
         .note = "3 mm above the floor",
         .uncalibrated =
             "inverted: most modules give nearly 1 above black and less above white. Give its wires the other "
             "sign, and add their old weight to the bias of the wire's motor",
         .is_inverted = true},
        {.channel = Channel::energy,
         .part = "battery of the motors",
         .supply = "battery +",
         .joining = Joining::battery,
         .to_ground = "10 kΩ",
         .in_series = "10 kΩ",
         .zero = "an empty battery",
         .one = "a full battery",
         .uncalibrated = "0.6 at 6 V, 0.4 at 4 V",
         .readings = {0.4f, 0.96f}},
        none_for(Channel::random),
    });
    static_assert(std::tuple_size_v<decltype(parts)> == channel_table.size());
    return parts;
}

constexpr double photoresistor_ohms = 15e3, photoresistor_lux = 10, photoresistor_exponent = 0.7, least_ohms = 220;

double ohms_to_ground(const Input& eye) {
    const double lux = static_cast<double>(eye.half_lux) / photoresistor_lux;
    return nearest_e24(std::max(photoresistor_ohms * std::pow(lux, -photoresistor_exponent), least_ohms));
}

SensorPart with_resistor(SensorPart part, const Input& eye) {
    const double ohms = ohms_to_ground(eye);
    part.to_ground = ohms_text(ohms);
    part.milliamperes = 5e3 / ohms;
    part.uncalibrated =
        fmt::format("0 in the dark, 0.5 at {}, 0.9 at {}", lux_text(lux_at(eye, 0.5)), lux_text(lux_at(eye, 0.9)));
    return part;
}

// What differs at 3 V: a pin takes no more. 5 V through 10 kΩ : 15 kΩ give 3 V; a battery of 6.4 V through
// 20 kΩ : 10 kΩ gives 2.1 V, one of six cells 3.2 V.
SensorPart at_3_volts(SensorPart part) {
    switch (part.channel) {
        case Channel::obstacle:  // the GP2Y0A21 needs 4.5 V
            part.part = "infrared distance sensor GP2Y0A60SZ for 3 V (10 cm to 150 cm)";
            part.milliamperes = 50;  // at most (data sheet of Sharp)
            part.range = 1.5f;
            break;
        case Channel::smell:
            part.supply = own_supply, part.has_own_supply = true;
            part.in_series = "10 kΩ", part.to_ground = "15 kΩ";
            part.note =
                "its heater takes up to 180 mA at 5 V, which the micro:bit does not give; it reads steadily after 5 "
                "minutes, a new one after a day; the two resistors keep the pin at 3 V";
            return part;
        case Channel::energy:
            part.in_series = "20 kΩ";
            return part;
        default:
            break;
    }
    part.supply = "3 V";
    return part;
}

std::string csv_cell(std::string_view text) {
    std::string cell;
    io::add_quoted(cell, text);
    return cell;
}

}  // namespace

SensorPart part_of(const Input& input, Board board) {
    const Channel channel = input.channel.value_or(Channel::light);
    SensorPart part = parts_at_5_volts()[static_cast<std::size_t>(channel)];
    assert(part.channel == channel);
    if (is_photoresistor(input)) part = with_resistor(std::move(part), input);
    return board == Board::microbit ? at_3_volts(std::move(part)) : part;
}

bool is_photoresistor(const Input& input) { return input.channel.value_or(Channel::light) == Channel::light; }

double lux_at(const Input& eye, double reading) {
    const double ohms = ohms_to_ground(eye) * (1 / reading - 1);
    return photoresistor_lux * std::pow(ohms / photoresistor_ohms, -1 / photoresistor_exponent);
}

std::string lux_text(double lux) {
    if (lux < 10) return fmt::format("{:.2g} lx", lux);
    if (lux < 1000) return fmt::format("{:.0f} lx", lux);
    const double step = std::pow(10, std::floor(std::log10(lux)) - 1);  // two digits
    const auto whole = static_cast<long long>(std::round(lux / step) * step);
    return fmt::format("{},{:03} lx", whole / 1000, whole % 1000);
}

std::vector<SensorPart> parts_of(const Plan& plan, Board board) {
    // An Uno has a fuse of 500 mA and takes 50 mA itself; six AA cells give the circuit as much.
    constexpr double most = 440;
    std::vector<SensorPart> parts;
    for (const Input& input : plan.inputs) parts.push_back(part_of(input, board));
    if (board != Board::microbit && board_milliamperes(parts) > most)
        for (SensorPart& part : parts)
            if (part.joining == Joining::module) part.supply = own_supply, part.has_own_supply = true;
    return parts;
}

double board_milliamperes(const std::vector<SensorPart>& parts) {
    double sum = 0;
    for (const SensorPart& part : parts) sum += part.has_own_supply ? 0 : part.milliamperes;
    return sum;
}

double own_milliamperes(const std::vector<SensorPart>& parts) {
    double sum = 0;
    for (const SensorPart& part : parts) sum += part.has_own_supply ? part.milliamperes : 0;
    return sum;
}

int warm_up_of(const std::vector<SensorPart>& parts) {
    int longest = 0;
    for (const SensorPart& part : parts) longest = std::max(longest, part.warm_up);
    return longest;
}

std::vector<Error> place_warnings(const Plan& plan, Board board) {
    std::string beyond, further;
    float part_range = 0;
    const auto add = [](std::string& list, const std::string& text) { list += (list.empty() ? "" : ", ") + text; };
    constexpr float edge = 0.55f;  // a sensor at the edge sticks out a little
    for (const Input& input : plan.inputs) {
        const SensorPart part = part_of(input, board);
        if (input.place && input.place->is_share &&
            std::max(std::fabs(input.place->x), std::fabs(input.place->y)) > edge)
            add(beyond, in_quotes(input.name));
        if (part.range > 0 && input.range > part.range)
            add(further, fmt::format("{} {} m", in_quotes(input.name), input.range)), part_range = part.range;
    }
    std::vector<Error> found;
    if (!beyond.empty()) found.push_back(error_of(message_of("part_beyond", beyond)));
    if (!further.empty()) found.push_back(error_of(message_of("part_range", part_range, further)));
    return found;
}

std::string places_text(const Plan& plan, Board board) {
    std::string text;
    for (const Error& warning : place_warnings(plan, board)) text += fmt::format("**Warning: {}.**\n\n", warning.what);
    return text + std::string(about_places);
}

std::string place_text(const Input& input) {
    if (!input.place) return "at the front, on the side of its name (L, R); the file has a brain alone";
    const auto distance = [&](float value, std::string_view of, std::string_view positive, std::string_view negative) {
        const double size = static_cast<double>(std::fabs(value));
        if (size < 0.005) return std::string();
        return (input.place->is_share ? fmt::format("{:.0f} % of the {} ", 100 * size, of)
                                      : fmt::format("{:.2f} m ", size)) +
               std::string(value > 0 ? positive : negative);
    };
    const std::string along = distance(input.place->x, "length", "ahead of the middle", "behind the middle"),
                      across = distance(input.place->y, "width", "to the left", "to the right");
    const std::string at = along.empty() && across.empty()
                               ? "in the middle"
                               : along + (along.empty() || across.empty() ? "" : ", ") + across;
    const long degrees = std::lround(input.place->angle * 180 / std::numbers::pi_v<float>);
    if (degrees == 0) return at + "; it looks ahead";
    if (std::abs(degrees) == 180) return at + "; it looks back";
    return fmt::format("{}; it looks {}° to the {}", at, std::abs(degrees), degrees > 0 ? "left" : "right");
}

std::string own_supply_text(const std::vector<SensorPart>& parts, std::string_view board) {
    const double sum = own_milliamperes(parts);
    if (sum == 0) return "";
    return fmt::format(
        "\nSensors with \"{}\" take up to {:.0f} mA in sum, more than the {} gives: connect them to a supply of 5 V "
        "for "
        "that\ncurrent, and its ground to all other grounds. Its + goes to these sensors alone. Switch it on after the "
        "{} "
        "and off before it:\na sensor that is on brings current into the pins of a board that is off.\n",
        own_supply, std::ceil(sum), board, board);
}

std::string joining_text(const SensorPart& part) {
    std::string text(part.part);
    if (part.joining == Joining::divider) text += fmt::format(" from {} to the input", part.supply);
    if (part.joining == Joining::module)
        text += fmt::format(
            ": {}, ground, output {}", part.supply,
            part.in_series.empty() ? "to the input" : fmt::format("through {} to the input", part.in_series));
    if (part.joining == Joining::battery) text += fmt::format(": its + through {} to the input", part.in_series);
    if (!part.to_ground.empty()) text += fmt::format("; {} from the input to ground", part.to_ground);
    if (!part.capacitor.empty()) text += fmt::format("; {} between its supply and ground", part.capacitor);
    return part.note.empty() ? text : fmt::format("{}; {}", text, part.note);
}

std::string sensor_rows(const Plan& plan, Board board, std::string_view row_end) {
    struct Row {
        std::string part, use;
        std::vector<std::string> sensors;
    };
    std::vector<Row> rows;
    const auto add = [&](const std::string& part, const std::string& use, const Input& input) {
        auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& r) { return r.part == part && r.use == use; });
        if (row == rows.end()) row = rows.insert(rows.end(), {part, use, {}});
        row->sensors.push_back(comment_text(input.name));
    };
    const std::vector<SensorPart> parts = parts_of(plan, board);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Input& input = plan.inputs[i];
        const SensorPart& part = parts[i];
        if (part.joining != Joining::battery) add(std::string(part.part), "for", input);
        const std::string from = part.joining == Joining::battery
                                     ? "from + of the battery of the motors to the input of"
                                     : "from the output to the input of";
        if (!part.in_series.empty()) add("resistor " + part.in_series, from, input);
        if (!part.to_ground.empty()) add("resistor " + part.to_ground, "from the input to ground, of", input);
        if (!part.capacitor.empty())
            add("capacitor " + std::string(part.capacitor), "between supply and ground of", input);
    }
    std::string text;
    for (const Row& row : rows) {
        std::string names;
        for (const std::string& name : row.sensors) names += (names.empty() ? "" : ", ") + name;
        text += fmt::format("{},{},{}{}\n", row.sensors.size(), csv_cell(row.part),
                            csv_cell(fmt::format("{} sensor{} {}", row.use, row.sensors.size() > 1 ? "s" : "", names)),
                            row_end);
    }
    if (const double sum = own_milliamperes(parts); sum > 0)
        text += fmt::format("1,\"supply of 5 V, {:.0f} mA\",\"for the sensors with {}; grounds connected\"{}\n",
                            std::ceil(sum), own_supply, row_end);
    return text;
}

std::optional<Error> part_fault(const Plan& plan) {
    for (const Input& input : plan.inputs)
        if (part_of(input, Board::uno).part.empty())
            return error_of(message_of("no_part", in_quotes(input.name), word(*input.channel)));
    return std::nullopt;
}

std::optional<Error> pin_fault(const Plan& plan, std::string_view board, int analog_inputs) {
    if (auto fault = part_fault(plan)) return fault;
    const auto most = static_cast<std::size_t>(analog_inputs);
    if (plan.inputs.size() <= most) return std::nullopt;
    return error_of(message_of("no_pin", in_quotes(plan.inputs[most].name), plan.inputs.size(), board, most));
}

std::string_view doubt_about(const Input& input) {
    return input.channel ? "" : "; the file does not say what it senses, so it is taken for an eye";
}

std::string table_cell(const std::string& text) {
    std::string clean = comment_text(text);
    std::replace(clean.begin(), clean.end(), '|', '/');
    return clean;
}

}  // namespace braitenlab::robots

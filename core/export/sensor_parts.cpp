#include "core/export/sensor_parts.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/export/text.h"
#include "core/io/csv.h"
#include "core/messages.h"
#include "core/scene/enums.h"
#include "core/scene/nearest.h"

namespace braitenlab::robots {

namespace {

// Infrared light passes filters of colour, so the part must not see it: a TEPT4400 sees visible light only.
constexpr SensorPart eye_for(Channel colour, std::string_view part, std::string_view lamp) {
    return {.channel = colour,
            .part = part,
            .supply = "5 V",
            .to_ground = "10 kΩ",
            .supply_terminal = "C",
            .input_terminal = "E",
            .milliamperes = 0.5,
            .zero = "covered",
            .one = lamp,
            .note = "its collector (C) is at the supply, its emitter (E) at the input",
            .uncalibrated = "0 in the dark, more with light; change the 10 kΩ until the lamp gives nearly 1"};
}
constexpr SensorPart none_for(Channel channel) {
    return {.channel = channel, .part = "", .supply = "", .zero = "", .one = ""};
}

// Currents at 5 V: of a divider with the part at 0 Ω; of a GP2Y0A21 40 mA at most (data sheet of Sharp), of the heater
// of an MQ-3 150 mA (data sheet of Hanwei), of a TCRT5000 module its LED through 220 Ω and a lamp: 20 mA.
constexpr auto parts_at_5_volts = std::to_array<SensorPart>({
    {.channel = Channel::light,
     .part = "photoresistor GL5528",
     .supply = "5 V",
     .to_ground = "1.5 kΩ",
     .milliamperes = 3.3,
     .zero = "covered",
     .one = "the lamp right in front of it",
     .uncalibrated = "0 in the dark, 0.5 at 268 lx"},
    eye_for(Channel::red, "phototransistor TEPT4400 behind a red filter", "a red LED lamp right in front of it"),
    eye_for(Channel::green, "phototransistor TEPT4400 behind a green filter", "a green LED lamp right in front of it"),
    eye_for(Channel::blue, "phototransistor TEPT4400 behind a blue filter", "a blue LED lamp right in front of it"),
    {.channel = Channel::heat,
     .part = "thermistor NTC 10 kΩ",
     .supply = "5 V",
     .to_ground = "10 kΩ",
     .milliamperes = 0.5,
     .zero = "at room temperature",
     .one = "the warm source in front of it",
     .uncalibrated = "0.5 at 25 °C, more in the heat; for 0 at room temperature subtract half of each weight of its "
                     "wires from the bias of the wire's motor"},
    {.channel = Channel::smell,
     .part = "gas sensor module MQ-3, analog output",
     .supply = "5 V",
     .joining = Joining::module,
     .milliamperes = 150,
     .zero = "in clean air",
     .one = "alcohol in front of it",
     .note = "its heater takes 150 mA at 5 V and 5 minutes",
     .uncalibrated = "more than 0 in clean air; measure its output there, and subtract weight · V / 5 of each of its "
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
     .note = "nearer than 10 cm it reads less again, so it sits 10 cm behind the front of the robot",
     .uncalibrated = "0.08 (0.4 V) with nothing in front of it to 0.62 (3.1 V) at 10 cm"},
    none_for(Channel::predator),
    none_for(Channel::prey),
    none_for(Channel::vehicle),
    none_for(Channel::memory),
    {.channel = Channel::touch,
     .part = "switch",
     .supply = "5 V",
     .to_ground = "10 kΩ",
     .milliamperes = 0.5,
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
     .uncalibrated = "inverted: most modules give nearly 1 above black and less above white. Give its wires the other "
                     "sign, and add their old weight to the bias of the wire's motor"},
    {.channel = Channel::energy,
     .part = "battery of the motors",
     .supply = "battery +",
     .joining = Joining::battery,
     .to_ground = "10 kΩ",
     .in_series = "10 kΩ",
     .zero = "an empty battery",
     .one = "a full battery",
     .uncalibrated = "0.6 at 6 V, 0.4 at 4 V"},
    none_for(Channel::random),
});

// part_of() takes the row of a channel by its number.
static_assert([] {
    for (std::size_t i = 0; i < parts_at_5_volts.size(); ++i)
        if (parts_at_5_volts[i].channel != channel_table[i].value) return false;
    return parts_at_5_volts.size() == channel_table.size();
}());

// What differs at 3 V: a pin takes no more. 5 V through 10 kΩ : 15 kΩ give 3 V; a battery of 6.4 V through
// 20 kΩ : 10 kΩ gives 2.1 V, one of six cells 3.2 V.
SensorPart at_3_volts(SensorPart part) {
    switch (part.channel) {
        case Channel::obstacle:  // the GP2Y0A21 needs 4.5 V
            part.part = "infrared distance sensor GP2Y0A60SZ, module for 3 V (10 cm to 150 cm)";
            break;
        case Channel::smell:
            part.supply = "5 V of its own", part.has_own_supply = true;
            part.in_series = "10 kΩ", part.to_ground = "15 kΩ";
            part.note =
                "its heater takes 150 mA at 5 V, which the micro:bit does not give, and 5 minutes; the two resistors "
                "keep the pin at 3 V";
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
    const SensorPart& part = parts_at_5_volts[static_cast<std::size_t>(input.channel.value_or(Channel::light))];
    return board == Board::microbit ? at_3_volts(part) : part;
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
    for (const Input& input : plan.inputs) {
        const SensorPart part = part_of(input, board);
        if (part.joining != Joining::battery) add(std::string(part.part), "for", input);
        const std::string from = part.joining == Joining::battery
                                     ? "from + of the battery of the motors to the input of"
                                     : "from the output to the input of";
        if (!part.in_series.empty()) add("resistor " + std::string(part.in_series), from, input);
        if (!part.to_ground.empty())
            add("resistor " + std::string(part.to_ground), "from the input to ground, of", input);
        if (!part.capacitor.empty())
            add("capacitor " + std::string(part.capacitor), "between supply and ground of", input);
        if (part.has_own_supply) add("supply of 5 V, 200 mA", "grounds connected, for", input);
    }
    std::string text;
    for (const Row& row : rows) {
        std::string names;
        for (const std::string& name : row.sensors) names += (names.empty() ? "" : ", ") + name;
        text += fmt::format("{},{},{}{}\n", row.sensors.size(), csv_cell(row.part),
                            csv_cell(fmt::format("{} sensor{} {}", row.use, row.sensors.size() > 1 ? "s" : "", names)),
                            row_end);
    }
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

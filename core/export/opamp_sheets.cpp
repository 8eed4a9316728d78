// The schematic: sensors and their buffers on the left, the summer of each motor on the right. On one sheet, a vertical
// wire for each buffer joins both. What needs more sheets has the names of its nets at the ends of its wires instead.
//
// Wires of different nets cross but never lie on each other: rows of resistors are a multiple of `row` below the first
// sensor, outputs of buffers half a row more.
#include <algorithm>
#include <array>
#include <functional>
#include <map>

#include <fmt/format.h>

#include "core/export/e24.h"
#include "core/export/opamp.h"
#include "core/export/opamp_symbols.h"
#include "core/export/sensor_parts.h"
#include "core/export/wiring_svg.h"

namespace braitenlab::robots::opamp {

namespace {

constexpr int row = 30, sensor_pitch = 4 * row, first_y = 130, last_y = 1050;
constexpr int buffer_x = 200, first_rail_x = 374, rail_pitch = 12;            // left column
constexpr int supply_x = 446, resistor_x = 468, bus_x = 530, summer_x = 624;  // right column
constexpr std::size_t most_rails = 5;
constexpr int second_column = 380;

// A part of a resistor of the circuit.
struct Part {
    std::string label, from;  // "R3 120 kΩ"
};

// The summer of a motor, or what continues it on another sheet.
struct Summer {
    std::string side;
    std::vector<Part> minus, plus;
    std::string feedback{}, limit{}, divider{}, pull_down{}, diode{};  // labels
    const Amplifier* amplifier = nullptr;                              // null: continued
    bool goes_on = false;                                              // on the next sheet

    // From the first row to the row below the last one.
    int rows_above() const { return std::max(static_cast<int>(minus.size()), amplifier ? 2 : 0); }
    int rows() const { return rows_above() + std::max(static_cast<int>(plus.size()), amplifier ? 5 : 0); }
};

// The vertical wire of a buffer's output.
struct Rail {
    int x = 0, from_y = 0, to_y = 0;
    bool passes(int y) const { return from_y < y && y < to_y; }
    void reach(int y) { from_y = std::min(from_y, y), to_y = std::max(to_y, y); }
};
using Rails = std::map<std::string, Rail>;  // by node; empty: none

std::string pin_text(const Circuit& circuit, const std::string& node) {
    for (const Connector& connector : circuit.connectors)
        for (std::size_t i = 0; i < connector.nodes.size(); ++i)
            if (connector.nodes[i] == node) return fmt::format("{} pin {}", connector.name, i + 1);
    return "";
}

std::string ground_pin_of(const Connector& connector) {
    const auto found = std::find(connector.nodes.begin(), connector.nodes.end(), "0");
    return fmt::format("{} pin {}", connector.name, found - connector.nodes.begin() + 1);
}

Summer summer_of(const Circuit& circuit, const std::string& side) {
    Summer summer{side, {}, {}};
    for (const Resistor& r : circuit.resistors)
        for (std::size_t i = 0; i < r.e24.size(); ++i) {
            const std::string label = r.names[i] + " " + ohms_text(r.e24[i]);
            if (r.to == limited(side))
                summer.limit = label;
            else if (r.to == driver_input(side))
                summer.divider = label;
            else if (r.from == driver_input(side))
                summer.pull_down = label;
            else if (r.from == side)
                summer.feedback = label;
            else if (r.to == side + "_minus")
                summer.minus.push_back({label, r.from});
            else if (r.to == side + "_plus")
                summer.plus.push_back({label, r.from});
        }
    for (const TwoPole& diode : circuit.diodes)
        if (diode.from == limited(side)) summer.diode = diode.name + " " + diode.value;
    for (const Amplifier& amplifier : circuit.amplifiers)
        if (amplifier.out.node == side) summer.amplifier = &amplifier;
    return summer;
}

// ---- The left column ----

void draw_sensor(Sheet& sheet, int x, int y, const Input& input, const SensorPart& sensor) {
    const int part_x = x + 40;
    std::string text(sensor.part);
    if (!sensor.capacitor.empty()) text += fmt::format("; {} at its supply", sensor.capacitor);
    if (!sensor.supply_terminal.empty()) text += fmt::format("; {} at {}", sensor.supply_terminal, sensor.supply);
    sheet.name(x + 52, y - 45, "start", input.name, 250);
    sheet.text(x + 52, y - 31, "start", text, 280);
    if (sensor.has_own_supply) text += fmt::format("; {}", sensor.supply);
    // The battery has another supply than 5 V.
    if (sensor.joining == Joining::battery)
        sheet.text(part_x - 8, y - 43, "end", "+"), sheet.wire(part_x, y - 40, "v-4");
    else
        sheet.supply(part_x, y - 40, "5 V");
    if (sensor.joining == Joining::module) {
        sheet.wire(part_x, y - 40, "v24");
        sheet.box(part_x - 24, y - 16, 48, 32);
        sheet.text(part_x, y + 4, "middle", "module");
        sheet.wire(part_x, y + 16, "v27");
        sheet.wire(part_x + 24, y, "h10");
    } else {
        sheet.part_down(part_x, y - 40, sensor.symbol);
        if (!sensor.in_series.empty()) sheet.text(part_x + 12, y - 18, "start", std::string(sensor.in_series));
        sheet.wire(part_x, y - 12, "v24");
        sheet.dot(part_x, y);
        sheet.wire(part_x, y, "h34");
        sheet.resistor_down(part_x, y + 12);
        sheet.wire(part_x, y + 40, "v3");
        sheet.text(part_x + 12, y + 30, "start", std::string(sensor.to_ground));
    }
    sheet.ground(part_x, y + 43);
}

// An amplifier whose output is its inverting input; its output ends at x + 72.
void draw_follower(Sheet& sheet, int x, int y, const Amplifier& amplifier) {
    sheet.amplifier(x, y, amplifier, true);
    const int out = x + Sheet::amplifier_width + 20;
    sheet.wire(x + Sheet::amplifier_width + 12, y, "h8");
    sheet.wire(out, y, fmt::format("v37H{}V{}", x - 12, y + Sheet::amplifier_input));
}

// The resistor to ground of a buffer.
std::string pull_down_of(const Circuit& circuit, const std::string& node) {
    for (const Resistor& r : circuit.resistors)
        if (r.from == node && r.to == "0") return r.names[0] + " " + ohms_text(r.e24[0]);
    return "";
}

// A resistor below a wire; its wire ends at y + 40.
void draw_resistor_below(Sheet& sheet, int x, int y, const std::string& label) {
    sheet.wire(x, y, "v8");
    sheet.resistor_down(x, y + 8);
    sheet.wire(x, y + 36, "v4");
    sheet.text(x + 10, y + 26, "start", label, 50);
}

// A sensor and its buffer. `y`: the sensor's wire. The output reaches to `end_x`.
void draw_buffer(Sheet& sheet, int x, int y, const Circuit& circuit, const Input& input, const SensorPart& part,
                 const Amplifier& amplifier, int end_x) {
    draw_sensor(sheet, x, y, input, part);
    const int first = x + 74, in = x + buffer_x - Sheet::margin, yc = y + Sheet::amplifier_input;
    sheet.terminal(first + 3, y);
    sheet.wire(first + 6, y, fmt::format("H{}", in - 12));
    sheet.net(first + 12, y, 66, amplifier.plus.node);
    sheet.text(first + 12, y + 13, "start", pin_text(circuit, amplifier.plus.node), 66);
    draw_follower(sheet, in, yc, amplifier);
    const int out = in + Sheet::amplifier_width + 20;
    sheet.dot(out, yc);
    sheet.wire(out, yc, fmt::format("H{}", end_x));
    sheet.net(out + 6, yc, 88, amplifier.out.node);
    const int down = out + 38;
    sheet.dot(down, yc);
    draw_resistor_below(sheet, down, yc, pull_down_of(circuit, amplifier.out.node));
    sheet.ground(down, yc + 40);
}

// ---- The right column ----

// A resistor from its node to the bus.
void draw_row(Sheet& sheet, int y, const Part& part, const Rails& rails) {
    const auto rail = rails.find(part.from);
    int from = supply_x;
    if (part.from == "0") {
        sheet.ground(supply_x, y);
    } else if (part.from == "v5") {
        sheet.text(supply_x - 4, y + 4, "end", "5 V");
        sheet.wire(supply_x, y, "m0 -5v10");
    } else if (rail != rails.end()) {
        from = rail->second.x;
        if (rail->second.passes(y)) sheet.dot(from, y);
    } else {
        sheet.text(supply_x - 4, y + 4, "end", part.from, 190);
    }
    sheet.wire(from, y, fmt::format("H{}", resistor_x));
    sheet.resistor(resistor_x, y);
    sheet.text(resistor_x + Sheet::resistor_length / 2, y - 9, "middle", part.label, 74);
    sheet.wire(resistor_x + Sheet::resistor_length, y, fmt::format("H{}", bus_x));
}

// The rows of one input of the amplifier, from `y` on, and the wire that joins them with each other and with `pin_y`.
void draw_rows(Sheet& sheet, int y, int pin_y, const std::vector<Part>& parts, const Rails& rails,
               bool has_dot_at_top) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const int row_y = y + row * static_cast<int>(i);
        draw_row(sheet, row_y, parts[i], rails);
        const bool ends = (row_y == y && row_y != pin_y && !has_dot_at_top) ||
                          (i + 1 == parts.size() && row_y > pin_y) || (parts.size() == 1 && row_y == pin_y);
        if (!ends) sheet.dot(bus_x, row_y);
    }
    const int last = y + row * (static_cast<int>(parts.size()) - 1);
    if (const int end = std::max(last, pin_y); end > y) sheet.wire(bus_x, y, fmt::format("V{}", end));
}

void draw_output(Sheet& sheet, int y0, int y, const Circuit& circuit, const Summer& summer) {
    const int out = summer_x + Sheet::amplifier_width + 18, rect = summer_x + 8;
    sheet.amplifier(summer_x, y, *summer.amplifier, false);
    sheet.wire(bus_x, y0, fmt::format("H{}", rect));
    sheet.resistor(rect, y0);
    sheet.text(rect + Sheet::resistor_length / 2, y0 - 9, "middle", summer.feedback, 74);
    sheet.wire(rect + Sheet::resistor_length, y0, fmt::format("H{}V{}", out, y));
    sheet.wire(out - 6, y, fmt::format("H{}", out));
    sheet.dot(out, y);
    sheet.name(out + 9, y + 4, "start", summer.side, 52);
    draw_resistor_below(sheet, out, y, summer.limit);
    const int limit_y = y + 48, driver_y = limit_y + 48, cathode = out - 90, supply = out - 109;
    sheet.wire(out, y + 40, fmt::format("V{}", limit_y));
    sheet.dot(out, limit_y);
    sheet.net(cathode + Sheet::diode_length + 6, limit_y, 66, limited(summer.side));
    sheet.wire(out, limit_y, fmt::format("H{}", cathode + Sheet::diode_length));
    sheet.diode(cathode, limit_y);
    sheet.text(cathode + Sheet::diode_length / 2, limit_y + 18, "middle", summer.diode, 74);
    sheet.wire(cathode, limit_y, fmt::format("H{}", supply));
    sheet.supply(supply, limit_y, "5 V");
    draw_resistor_below(sheet, out, limit_y, summer.divider);
    sheet.wire(out, limit_y + 40, fmt::format("V{}", driver_y));
    sheet.dot(out, driver_y);
    sheet.wire(out, driver_y, "h11");
    sheet.terminal(out + 14, driver_y);
    sheet.name(out + 20, driver_y + 2, "start", driver_input(summer.side), 60);
    sheet.text(out + 20, driver_y + 13, "start", pin_text(circuit, driver_input(summer.side)), 60);
    draw_resistor_below(sheet, out, driver_y, summer.pull_down);
    sheet.ground(out, driver_y + 40);
}

void draw_summer(Sheet& sheet, int y0, const Circuit& circuit, const Summer& summer, const Rails& rails) {
    const int minus_y = y0 + row * (summer.rows_above() - 1), plus_y = minus_y + row;
    sheet.name(Sheet::width - Sheet::margin, y0 - 26, "end",
               summer.side + (summer.amplifier ? " motor" : " motor, continued"));
    // Of an amplifier, the resistors of an input may all be on the next sheet.
    const bool has_minus = !summer.minus.empty() || summer.amplifier;
    const bool has_plus = !summer.plus.empty() || (summer.amplifier && summer.amplifier->plus.node != "0");
    if (has_minus) draw_rows(sheet, y0, minus_y, summer.minus, rails, summer.amplifier != nullptr);
    if (!summer.plus.empty()) draw_rows(sheet, plus_y, plus_y, summer.plus, rails, false);
    const int end = summer.amplifier ? summer_x - 12 : bus_x + 76;
    const auto draw_net = [&](bool is_there, int y, const char* input) {
        if (!is_there) return;
        sheet.wire(bus_x, y, fmt::format("H{}", end));
        sheet.net(bus_x + 6, y, 70, summer.side + input);
    };
    draw_net(has_minus, minus_y, "_minus");
    draw_net(has_plus, plus_y, "_plus");
    if (!summer.amplifier) return;
    if (!has_plus) sheet.ground(summer_x - 12, plus_y);
    draw_output(sheet, y0, minus_y + Sheet::amplifier_input, circuit, summer);
    if (summer.goes_on)
        sheet.text(Sheet::width - Sheet::margin, y0 + row * summer.rows() + row / 2, "end",
                   fmt::format("{0}_minus, {0}_plus: more resistors follow", summer.side), 320);
}

// ---- The supply ----

constexpr int chips_x = 460, chip_pitch = 104, chips_in_row = 3, chip_row = 100, unused_height = 3 * row;

int supply_height(const Circuit& circuit) {
    const int chip_rows = static_cast<int>((circuit.chips() - 1) / chips_in_row) + 1;
    return 50 + std::max(110, chip_rows * chip_row) +
           (circuit.amplifiers.size() > circuit.used_amplifiers ? unused_height : 0);
}

// A capacitor in an upright wire from `y` to `end`; its label is two lines where it has less room than 60.
void draw_capacitor(Sheet& sheet, int x, int y, int end, const TwoPole& capacitor, int room) {
    const int plate = (y + end - Sheet::capacitor_drop) / 2;
    sheet.wire(x, y, fmt::format("V{}", plate));
    sheet.capacitor_down(x, plate);
    sheet.wire(x, plate + Sheet::capacitor_drop, fmt::format("V{}", end));
    sheet.text(x + 11, plate + 2, "start", capacitor.name, room);
    sheet.text(x + 11, plate + 13, "start", capacitor.value, room);
}

void draw_regulator(Sheet& sheet, int y, const Circuit& circuit) {
    const int x = Sheet::margin + 10, low = y + 55, box = 216, box_width = 60, capacitors[] = {130, 366}, end = 394;
    sheet.terminal(x, y);
    sheet.text(x, y - 9, "start", pin_text(circuit, "v9") + ", battery +", 130);
    sheet.wire(x + 3, y, fmt::format("H{}", box));
    sheet.dot(186, y);
    sheet.supply(186, y, "9 V");
    sheet.box(box, y - 20, box_width, 40);
    sheet.text(box + box_width / 2, y - 3, "middle", regulator_name(circuit));
    sheet.text(box + box_width / 2, y + 10, "middle", std::string(regulator_value));
    sheet.text(box - 4, y - 4, "end", std::to_string(regulator_in_pin));
    sheet.text(box + box_width + 4, y - 4, "start", std::to_string(regulator_out_pin));
    sheet.text(box + box_width / 2 + 5, y + 31, "start", std::to_string(regulator_ground_pin));
    sheet.wire(box + box_width / 2, y + 20, "v14");
    sheet.ground(box + box_width / 2, y + 34);
    sheet.wire(box + box_width, y, fmt::format("H{}", end - 3));
    sheet.dot(290, y);
    draw_resistor_below(sheet, 290, y, pull_down_of(circuit, "v5"));
    sheet.ground(290, y + 40);
    sheet.dot(324, y);
    sheet.supply(324, y, "5 V");
    sheet.terminal(end, y);
    const std::size_t sensors = circuit.connectors.size() - 2;
    // The pins of all connectors of sensors on this net.
    const auto sensor_pins = [&](int text_y, int pin) {
        if (sensors > 0)
            sheet.text(end + 10, text_y, "start",
                       sensor_connector(0) + (sensors > 1 ? "–" + sensor_connector(sensors - 1) : "") +
                           fmt::format(" pin {}", pin),
                       44);
    };
    sheet.text(end + 10, y + 4, "start", pin_text(circuit, "v5"), 60);
    sensor_pins(y + 16, 1);
    for (std::size_t i = 0; i < 2; ++i) {
        sheet.dot(capacitors[i], y);
        sheet.dot(capacitors[i], low);
        draw_capacitor(sheet, capacitors[i], y, low, circuit.capacitors[i], 44);
    }
    sheet.terminal(x, low);
    sheet.text(x, low - 9, "start", ground_pin_of(circuit.connectors[0]) + ", battery −", 86);
    sheet.wire(x + 3, low, "H186");
    sheet.ground(186, low);
    sheet.wire(324, low, fmt::format("H{}", end - 3));
    sheet.ground(324, low);
    sheet.terminal(end, low);
    sheet.text(end + 10, low + 4, "start", ground_pin_of(circuit.connectors[1]), 60);
    sensor_pins(low + 16, 2);
}

void draw_supply(Sheet& sheet, int y, const Circuit& circuit) {
    sheet.name(Sheet::margin, y + 8, "start", "Supply");
    draw_regulator(sheet, y + 60, circuit);
    for (std::size_t chip = 0; chip < circuit.chips(); ++chip) {
        const int x = chips_x + chip_pitch * static_cast<int>(chip % chips_in_row), capacitor_x = x + 58,
                  yc = y + 60 + chip_row * static_cast<int>(chip / chips_in_row);
        sheet.box(x, yc - 18, 44, 36);
        sheet.text(x + 22, yc - 3, "middle", chip_name(chip));
        sheet.text(x + 22, yc + 10, "middle", "LM324", 40);
        sheet.wire(x + 22, yc - 18, "v-8");
        sheet.supply(x + 22, yc - 26, "9 V");
        sheet.dot(x + 22, yc - 26);
        sheet.text(x + 17, yc - 21, "end", std::to_string(lm324_supply_pin));
        sheet.wire(x + 22, yc - 26, fmt::format("H{}", capacitor_x));
        draw_capacitor(sheet, capacitor_x, yc - 26, yc + 30, circuit.capacitors[chip + 2], 34);
        sheet.wire(x + 22, yc + 30, fmt::format("H{}", capacitor_x));
        sheet.wire(x + 22, yc + 18, "v12");
        sheet.ground(x + 22, yc + 30);
        sheet.text(x + 17, yc + 29, "end", std::to_string(lm324_ground_pin));
    }
    const int unused_y = y + supply_height(circuit) - 60;
    for (std::size_t i = circuit.used_amplifiers; i < circuit.amplifiers.size(); ++i) {
        const int x = 160 + 150 * static_cast<int>(i - circuit.used_amplifiers);
        if (i == circuit.used_amplifiers) sheet.text(Sheet::margin, unused_y + 4, "start", "Unused amplifiers:");
        draw_follower(sheet, x, unused_y, circuit.amplifiers[i]);
        sheet.wire(x - 12, unused_y - Sheet::amplifier_input, "h-14");
        sheet.ground(x - 26, unused_y - Sheet::amplifier_input);
    }
}

// ---- Sheets ----

void draw_frame(Sheet& sheet, const Plan& plan, std::size_t number, std::size_t count) {
    const int right = Sheet::width - Sheet::margin;
    sheet.name(Sheet::margin, 40, "start", "Circuit: " + plan.title, 600);
    if (count > 1) sheet.name(right, 40, "end", fmt::format("sheet {} of {}", number, count));
    constexpr std::array notes = {
        "Lines that cross without a dot are not connected. Wires with the same name are connected.",
        "Names are those of README.md; resistors: 1 %. J1: battery. J2: motor driver, not motors. J3 and on: sensors; "
        "what "
        "is left of them is at the sensor.",
        "5 V stand for the command 1. Amplifiers give 0 V to 7.5 V; a negative command gives 0 V. J2 has 0.72 of it.",
    };
    for (std::size_t i = 0; i < notes.size(); ++i)
        sheet.text(Sheet::margin, 1072 + 14 * static_cast<int>(i), "start", notes[i], right - Sheet::margin);
}

int sensor_y(std::size_t sensor) { return first_y + sensor_pitch * static_cast<int>(sensor); }

// `summer_y`: the first row of each summer.
Rails rails_of(const Plan& plan, const std::array<Summer, 2>& summers, const std::array<int, 2>& summer_y) {
    Rails rails;
    for (std::size_t i = 0; i < plan.inputs.size(); ++i) {
        const int out_y = sensor_y(i) + Sheet::amplifier_input;
        rails[buffered(plan.inputs[i])] = {first_rail_x + rail_pitch * static_cast<int>(i), out_y, out_y};
    }
    const auto reach = [&](const std::vector<Part>& parts, int y) {
        for (const Part& part : parts) {
            if (const auto found = rails.find(part.from); found != rails.end()) found->second.reach(y);
            y += row;
        }
    };
    for (std::size_t side = 0; side < 2; ++side) {
        reach(summers[side].minus, summer_y[side]);
        reach(summers[side].plus, summer_y[side] + row * summers[side].rows_above());
    }
    return rails;
}

// Nothing where it does not fit.
std::vector<Sheet> one_sheet(const Plan& plan, const Circuit& circuit, const std::array<Summer, 2>& summers) {
    const int right_y = first_y + row * (summers[0].rows() + 2);
    const int end = std::max(sensor_y(plan.inputs.size()) - row, right_y + row * summers[1].rows()) + row / 2;
    if (plan.inputs.size() > most_rails || end + supply_height(circuit) > last_y) return {};
    Sheet sheet;
    const Rails rails = rails_of(plan, summers, {first_y, right_y});
    const std::vector<SensorPart> parts = parts_of(plan, Board::circuit);
    for (std::size_t i = 0; i < plan.inputs.size(); ++i) {
        const Rail& rail = rails.at(buffered(plan.inputs[i]));
        const int y = sensor_y(i), out_y = y + Sheet::amplifier_input;
        draw_buffer(sheet, Sheet::margin, y, circuit, plan.inputs[i], parts[i], circuit.amplifiers[i], rail.x);
        sheet.wire(rail.x, rail.from_y, fmt::format("V{}", rail.to_y));
        if (rail.passes(out_y)) sheet.dot(rail.x, out_y);
    }
    draw_summer(sheet, first_y, circuit, summers[0], rails);
    draw_summer(sheet, right_y, circuit, summers[1], rails);
    draw_supply(sheet, end, circuit);
    return {sheet};
}

// A part of a sheet; `draw` gets its upper edge.
struct Block {
    int height;
    std::function<void(Sheet&, int y)> draw;
};

// The summer in parts of at most this many rows.
std::vector<Summer> parts_of(const Summer& whole) {
    constexpr std::size_t most_rows = 24;
    std::vector<Summer> parts;
    std::size_t minus = 0, plus = 0;
    while (parts.empty() || minus < whole.minus.size() || plus < whole.plus.size()) {
        Summer part{whole.side, {}, {}};
        if (parts.empty()) {
            part = whole;
            part.minus.clear(), part.plus.clear();
        }
        while (minus < whole.minus.size() && part.minus.size() < most_rows) part.minus.push_back(whole.minus[minus++]);
        while (plus < whole.plus.size() && part.rows() < static_cast<int>(most_rows))
            part.plus.push_back(whole.plus[plus++]);
        parts.push_back(part);
    }
    parts[0].goes_on = parts.size() > 1;
    return parts;
}

std::vector<Block> blocks_of(const Plan& plan, const Circuit& circuit, const std::array<Summer, 2>& summers) {
    std::vector<Block> blocks;
    for (std::size_t i = 0; i < plan.inputs.size(); i += 2)
        blocks.push_back({sensor_pitch, [&plan, &circuit, i](Sheet& sheet, int y) {
                              for (std::size_t at = i; at < std::min(i + 2, plan.inputs.size()); ++at) {
                                  const int x = Sheet::margin + (at == i ? 0 : second_column);
                                  draw_buffer(sheet, x, y + 2 * row, circuit, plan.inputs[at],
                                              parts_of(plan, Board::circuit)[at], circuit.amplifiers[at], x + 336);
                              }
                          }});
    for (const Summer& summer : summers)
        for (const Summer& part : parts_of(summer))
            blocks.push_back({row * (part.rows() + 3), [&circuit, part](Sheet& sheet, int y) {
                                  draw_summer(sheet, y + 2 * row, circuit, part, {});
                              }});
    blocks.push_back({supply_height(circuit), [&circuit](Sheet& sheet, int y) { draw_supply(sheet, y, circuit); }});
    return blocks;
}

std::vector<Sheet> sheets_of(const std::vector<Block>& blocks) {
    std::vector<Sheet> sheets;
    int y = last_y;
    for (const Block& block : blocks) {
        if (y + block.height > last_y) {
            sheets.emplace_back();
            y = first_y - 2 * row;
        }
        block.draw(sheets.back(), y);
        y += block.height;
    }
    return sheets;
}

}  // namespace

std::string robot_svg(const Plan& plan) {
    Wiring wiring{
        .board = "circuit",
        .driver = "TB6612 or L298N",
        .kind = Board::circuit,
        .pins = {{"J2 pin 1", "PWMA (ENA)"},
                 {"J2 pin 3: 5 V", "AIN1 (IN1)"},
                 {"J2 pin 4: ground", "AIN2 (IN2)"},
                 {"J2 pin 2", "PWMB (ENB)"},
                 {"J2 pin 3: 5 V", "BIN1 (IN3)"},
                 {"J2 pin 4: ground", "BIN2 (IN4)"},
                 {"J2 pin 3: 5 V", "STBY, VCC (–)"}},
        .left_outputs = "AO1, AO2 (OUT1, OUT2)",
        .right_outputs = "BO1, BO2 (OUT3, OUT4)",
        .motor_supply = "VM (12V)",
        .notes = {
            "All grounds are connected. Only the battery of the motors is drawn; that of the circuit, 9 V, is at J1. "
            "Pins of sensors: 1 is 5 V, 2 ground, 3 the input.",
            "L298N: remove the jumpers of ENA and ENB, leave the 5 V jumper, and connect nothing to its 5 V pin. "
            "Names in brackets are those of an L298N."}};
    for (std::size_t i = 0; i < plan.inputs.size(); ++i)
        wiring.inputs.push_back(fmt::format("{} pin 3", sensor_connector(i)));
    return robots::wiring_svg(plan, wiring);
}

std::vector<std::string> wiring_sheets(const Plan& plan) {
    const Circuit circuit = circuit_of(plan);
    const std::array summers{summer_of(circuit, "left"), summer_of(circuit, "right")};
    std::vector<Sheet> sheets = one_sheet(plan, circuit, summers);
    if (sheets.empty()) sheets = sheets_of(blocks_of(plan, circuit, summers));
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        draw_frame(sheets[i], plan, i + 1, sheets.size());
        texts.push_back(sheets[i].svg());
    }
    return texts;
}

}  // namespace braitenlab::robots::opamp

// The part that senses a channel, and how it is joined to an input of a board. Every list of parts, drawing and README
// is written from it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/export/plan.h"
#include "core/result.h"

namespace braitenlab::robots {

// Boards by the supply of their sensors: an Arduino Uno and the circuit of amplifiers 5 V, a micro:bit 3 V.
enum class Board { uno, circuit, microbit };

enum class Joining {
    divider,  // the part from the supply to the input
    module,   // pins for the supply and ground, and an output
    battery   // the motors' battery itself
};

struct SensorPart {
    Channel channel;
    std::string_view part;    // "photoresistor GL5528"; empty: there is none
    std::string_view supply;  // "5 V"
    Joining joining = Joining::divider;
    std::string_view to_ground{};                          // resistor from the input to ground; empty: none
    std::string_view in_series{};                          // resistor from the part to the input; empty: a wire
    std::string_view supply_terminal{}, input_terminal{};  // of a divider whose part has two different terminals
    std::string_view capacitor{};                          // from the part's supply to ground; empty: none
    double milliamperes = 0;                               // at most, from its supply
    bool has_own_supply = false;                           // of 5 V, which the board does not give
    std::string_view zero, one;                            // what is shown for the readings 0 and 1
    std::string_view note{};                               // of its place and its use; empty: none
    std::string_view uncalibrated{};                       // what it reads as its voltage by 5 V
};
SensorPart part_of(const Input&, Board);  // a sensor of unknown channel is an eye

// "photoresistor GL5528 from 5 V to the input; 1.5 kΩ from the input to ground"
std::string joining_text(const SensorPart&);

// Rows of a list of parts: number, part, note, `row_end`. Equal parts are one row with the names of their sensors.
std::string sensor_rows(const Plan&, Board, std::string_view row_end = "");

// The error if a sensor has no part, or the board has fewer analog inputs than the brain has sensors.
std::optional<Error> part_fault(const Plan&);
std::optional<Error> pin_fault(const Plan&, std::string_view board, int analog_inputs);

// What a table of sensors adds to a sensor of unknown channel; empty for the others.
std::string_view doubt_about(const Input&);

// A text for a cell of a table in Markdown.
std::string table_cell(const std::string&);

}  // namespace braitenlab::robots

// The part that senses a channel, and how it is joined to an input of a board. Every list of parts, drawing and README
// is written from it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

enum class PartSymbol { resistor, photoresistor, phototransistor, button };  // of a divider, in a schematic

struct SensorPart {
    Channel channel;
    std::string_view part;    // "photoresistor GL5528"; empty: there is none
    std::string_view supply;  // "5 V"
    Joining joining = Joining::divider;
    std::string to_ground{};                               // resistor from the input to ground; empty: none
    std::string in_series{};                               // resistor from the part to the input; empty: a wire
    std::string_view supply_terminal{}, input_terminal{};  // of a divider whose part has two different terminals
    std::string_view capacitor{};                          // from the part's supply to ground; empty: none
    double milliamperes = 0;                               // at most, from its supply
    bool has_own_supply = false;                           // of 5 V, which the board does not give
    PartSymbol symbol = PartSymbol::resistor;
    int warm_up = 0;             // s, until it reads steadily; 0: at once
    std::string_view zero, one;  // what is shown for the readings 0 and 1
    std::string_view note{};     // of its place and its use; empty: none
    std::string uncalibrated{};  // what it reads as its voltage by 5 V
    Range readings{0, 1};        // of its voltage by 5 V, where they are known; of an eye by a torch at 0.1 m
    bool is_inverted = false;    // its voltage is high for the reading 0 of the lab
    float range = 0;             // m, from which it reads; 0: not known
};
SensorPart part_of(const Input&, Board);  // a sensor of unknown channel is an eye

// A photoresistor GL5528 has 15 kOhm at 10 lx and the exponent 0.7 (data sheet: 10 kOhm to 20 kOhm, 0.7). The resistor
// to ground is the value of E24 that gives half of the supply at the sensor's half_lux, at least 220 Ohm, with which
// the photoresistor takes 30 mW.
bool is_photoresistor(const Input&);
double lux_at(const Input&, double reading);  // that gives this reading, 0 to 1; precondition: it is a photoresistor
std::string lux_text(double lux);             // "6,200 lx"

// The parts of the sensors of a plan. Where they take more current than the board gives, modules have a supply of
// their own.
std::vector<SensorPart> parts_of(const Plan&, Board);

// At most, that the sensors take from the board, and from the supply of their own.
double board_milliamperes(const std::vector<SensorPart>&);
double own_milliamperes(const std::vector<SensorPart>&);

// The longest warm-up of the sensors, in s.
int warm_up_of(const std::vector<SensorPart>&);

// Sensors that are beyond the chassis, and sensors whose part does not read as far as the lab does.
std::vector<Error> place_warnings(const Plan&, Board);

// "45 % of the length ahead of the middle, 33 % of the width to the left; it looks 35° to the left", and what a README
// says below a table of places, without and with its warnings.
std::string place_text(const Input&);
std::string places_text(const Plan&, Board);
inline constexpr std::string_view about_places =
    "Left and right are those of someone who sits on the robot and looks ahead. Places and angles are those of the "
    "vehicle in\n"
    "the scene. A robot whose left and right eyes are swapped does the opposite of the brain: an aggressor becomes a "
    "coward.\n";

// What a README says of the supply that some parts have of their own; empty if none has one.
std::string own_supply_text(const std::vector<SensorPart>&, std::string_view board);

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

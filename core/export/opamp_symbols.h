// Symbols of a schematic, drawn in black on one sheet of A4. Lengths are 1/96 inch, y is down.
#pragma once

#include <string>
#include <string_view>

#include "core/export/opamp.h"
#include "core/export/sensor_parts.h"

namespace braitenlab::robots::opamp {

class Sheet {
public:
    static constexpr int width = 794, height = 1123, margin = 30;

    // `path`: SVG path data that begin at x, y: "h20v10".
    void wire(int x, int y, std::string_view path);
    // A text that is narrowed to `room` where it would be wider; room 0: any width. `style`: attributes of SVG.
    void text(int x, int y, std::string_view anchor, const std::string&, int room = 0, std::string_view style = "");
    void name(int x, int y, std::string_view anchor, const std::string&, int room = 0);  // in bold
    // A net's name above a wire of this length, in two lines where it is long.
    void net(int x, int y, int room, const std::string&);
    void dot(int x, int y);       // wires are connected
    void terminal(int x, int y);  // pin of a connector
    void ground(int x, int y);
    void supply(int x, int y, const std::string& volts);  // above this point
    void resistor(int x, int y);                          // from x to x + resistor_length
    void resistor_down(int x, int y);                     // from y to y + resistor_drop
    void part_down(int x, int y, PartSymbol);             // from y to y + resistor_drop
    void capacitor_down(int x, int y);                    // from y to y + capacitor_drop
    void diode(int x, int y);                             // from its cathode at x to its anode at x + diode_length
    void box(int x, int y, int box_width, int box_height);
    // Tip at x + amplifier_width, y. Its inputs are at x − 12 and y ∓ amplifier_input: the inverting one is above the
    // other, or below with `minus_below`. Has its name and the numbers of its pins.
    void amplifier(int x, int y, const Amplifier&, bool minus_below);

    static constexpr int resistor_length = 44, resistor_drop = 28, capacitor_drop = 6, diode_length = 12,
                         amplifier_width = 52, amplifier_input = 15;

    // The whole sheet.
    std::string svg() const;

private:
    std::string drawn_;
};

}  // namespace braitenlab::robots::opamp

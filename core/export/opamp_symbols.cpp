#include "core/export/opamp_symbols.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/export/wiring_svg.h"
#include "core/utf8.h"

namespace braitenlab::robots::opamp {

namespace {

constexpr std::string_view bold = " class=\"name\"";
constexpr int line_height = 10;
constexpr double smallest_font = 0.8;  // of the usual size

// Width of a text of 10 units, or of a bold one of 12: that of a wide font.
double width_of(std::string_view text, bool is_bold) {
    double width = 0;
    for (const char c : text) {
        const bool is_square = static_cast<unsigned char>(c) >= 0xe3;  // as characters of East Asia
        if (!continues_character(c)) width += is_square ? 10 : 6.2;
    }
    return is_bold ? 1.35 * width : width;
}

// A UTF-8 text in two parts at a character's beginning.
std::size_t middle_of(std::string_view text) {
    std::size_t at = (text.size() + 1) / 2;
    while (at < text.size() && continues_character(text[at])) ++at;
    return at;
}

}  // namespace

void Sheet::wire(int x, int y, std::string_view path) { drawn_ += fmt::format("<path d=\"M{} {}{}\"/>\n", x, y, path); }

void Sheet::text(int x, int y, std::string_view anchor, const std::string& words, int room, std::string_view style) {
    std::string all(style);
    const double natural = width_of(words, style == bold);
    // By a smaller font, then by narrower characters: a text that is stretched to its room looks wrong.
    if (room > 0 && natural > room)
        all += fmt::format(" style=\"font-size:{:.2g}px\"",
                           (style == bold ? 12 : 10) * std::max(room / natural, smallest_font));
    if (room > 0 && natural * smallest_font > room)
        all += fmt::format(" textLength=\"{}\" lengthAdjust=\"spacingAndGlyphs\"", room);
    drawn_ += svg_label(x, y, anchor, words, all);
}

void Sheet::name(int x, int y, std::string_view anchor, const std::string& words, int room) {
    text(x, y, anchor, words, room, bold);
}

void Sheet::net(int x, int y, int room, const std::string& words) {
    const bool one_line = width_of(words, false) <= 1.3 * room;
    const std::size_t middle = one_line ? 0 : middle_of(words);
    if (!one_line) text(x, y - 5 - line_height, "start", words.substr(0, middle), room);
    text(x, y - 5, "start", words.substr(middle), room);
}

void Sheet::dot(int x, int y) {
    drawn_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"2.6\" class=\"dot\"/>\n", x, y);
}

void Sheet::terminal(int x, int y) { drawn_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"3\"/>\n", x, y); }

void Sheet::ground(int x, int y) { wire(x, y, "v4m-7 0h14m-11 3h8m-5 3h2"); }

void Sheet::supply(int x, int y, const std::string& volts) {
    wire(x, y, "v-6m-7 0h14");
    text(x, y - 9, "middle", volts);
}

void Sheet::resistor(int x, int y) { box(x, y - 6, resistor_length, 12); }

void Sheet::resistor_down(int x, int y) { box(x - 6, y, 12, resistor_drop); }

void Sheet::part_down(int x, int y, PartSymbol symbol) {
    if (symbol == PartSymbol::button) return wire(x, y, "v8m-9 1l9 11v8");
    if (symbol == PartSymbol::phototransistor)
        wire(x, y, "v7l-8 4m0 -4v12m0 -4l8 4v9m0 -9l-4.5 -0.2m4.5 0.2l-2.4 -3.6");  // its emitter is below
    else
        resistor_down(x, y);
    if (symbol == PartSymbol::resistor) return;
    for (const int below : {2, 10}) wire(x - 26, y + below, "l13 6m-5 -4.5l5 4.5l-6.5 0.5");  // light
}

void Sheet::capacitor_down(int x, int y) { wire(x, y, "m-8 0h16m-16 6h16"); }

void Sheet::diode(int x, int y) { wire(x, y, "l12 -6v12l-12 -6m0 -6v12"); }

void Sheet::box(int x, int y, int box_width, int box_height) {
    drawn_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", x, y, box_width, box_height);
}

void Sheet::amplifier(int x, int y, const Amplifier& amplifier, bool minus_below) {
    wire(x, y - 30, fmt::format("v60l{} -30z", amplifier_width));
    const int minus = minus_below ? y + amplifier_input : y - amplifier_input, plus = 2 * y - minus;
    for (const int input : {minus, plus}) wire(x, input, "h-12");
    wire(x + 4, minus, "h6");
    wire(x + 4, plus, "h6m-3 -3v6");
    text(x + 21, y + 4, "middle", amplifier.name(), 28);
    text(x - 3, minus - 4, "end", std::to_string(amplifier.minus.pin));
    text(x - 3, plus - 4, "end", std::to_string(amplifier.plus.pin));
    wire(x + amplifier_width, y, "h12");
    text(x + amplifier_width + 1, y - 5, "start", std::to_string(amplifier.out.pin));
}

std::string Sheet::svg() const {
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"210mm\" height=\"297mm\">\n"
               "<style>@page{{size:A4;margin:0}} text{{font:10px Arial,Helvetica,sans-serif;fill:#000}}\n"
               ".name{{font-size:12px;font-weight:bold}} path,rect,circle{{fill:none;stroke:#000;stroke-width:1.2}}\n"
               "circle{{fill:#fff}} .dot{{fill:#000}}</style>\n"
               "<rect width=\"{0}\" height=\"{1}\" style=\"fill:#fff;stroke:none\"/>\n",
               width, height) +
           drawn_ + "</svg>\n";
}

}  // namespace braitenlab::robots::opamp

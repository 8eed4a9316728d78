#include "core/export/wiring_svg.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/utf8.h"
#include "core/xml_text.h"

namespace braitenlab::robots {

namespace {

constexpr int row_height = 34, sensor_height = 92, board_x = 330, board_width = 200, driver_x = 650, driver_width = 150,
              top = 100;
constexpr std::string_view small = " class=\"small\"";

std::string box(int x, int y, int width, int height, const std::string& title) {
    return fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"6\" class=\"part\"/>\n", x, y, width,
                       height) +
           svg_label(x + width / 2, y - 10, "middle", title, " class=\"title\"");
}

// A label that is narrowed to `room` where it would be wider.
std::string fitted(int x, int y, const std::string& text, int room, bool is_bold) {
    const double character = is_bold ? 8.5 : 6;
    const auto count = std::count_if(text.begin(), text.end(), [](char c) { return !continues_character(c); });
    std::string style = is_bold ? " class=\"title\"" : std::string(small);
    if (character * static_cast<double>(count) > room)
        style += fmt::format(" textLength=\"{}\" lengthAdjust=\"spacingAndGlyphs\"", room);
    return svg_label(x, y, "start", text, style);
}

// A small text in as many lines as it needs, the last one at y. Its words are narrower than the room.
std::string lines_above(int x, int y, const std::string& text, int room) {
    constexpr int character = 6, line_height = 12;
    const auto most = static_cast<std::size_t>(room / character);
    if (text.size() <= most) return svg_label(x, y, "start", text, small);
    const std::size_t space = text.rfind(' ', most);
    if (space == std::string::npos) return fitted(x, y, text, room, false);
    return svg_label(x, y - line_height, "start", text.substr(0, space), small) +
           lines_above(x, y, text.substr(space + 1), room);
}

// A resistor in a wire of level y, or at the end of a branch to ground.
std::string resistor(int x, int y, std::string_view ohms, int label_y) {
    return fmt::format("<rect x=\"{}\" y=\"{}\" width=\"36\" height=\"12\" class=\"part\"/>\n", x, y - 6) +
           svg_label(x + 18, label_y, "middle", std::string(ohms), small);
}

// From the left: the supply, the part, a resistor to the input, and below a resistor to ground, where the part has
// them.
std::string sensor_row(const Input& input, const SensorPart& part, std::size_t i, const std::string& pin) {
    const int y = top + 70 + static_cast<int>(i) * sensor_height, part_x = 98, room = board_x - 30;
    const bool is_module = part.joining == Joining::module, is_battery = part.joining == Joining::battery;
    std::string text = fitted(20, y - 40, input.name, room, true) +
                       lines_above(20, y - 16, std::string(part.part), room) +
                       svg_label(part_x - 4, is_module ? y - 2 : y + 4, "end",
                                 part.has_own_supply ? "own 5 V" : std::string(part.supply), small) +
                       fmt::format("<path d=\"M{} {}H{}\" stroke=\"#0072b2\"/>\n", part_x, y, board_x) +
                       svg_label(board_x + 8, y + 5, "start", pin);
    if (is_module) text += svg_label(part_x - 4, y + 10, "end", "GND", small);
    if (!is_battery)
        text += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"48\" height=\"20\" class=\"part\"/>\n", part_x, y - 10);
    if (!part.supply_terminal.empty())
        text += svg_label(part_x + 5, y + 4, "start", std::string(part.supply_terminal), small) +
                svg_label(part_x + 43, y + 4, "end", std::string(part.input_terminal), small);
    if (!part.capacitor.empty())
        text += svg_label(part_x, y + 24, "start", fmt::format("{}: {} to GND", part.capacitor, part.supply), small);
    if (!part.in_series.empty()) text += resistor(160, y, part.in_series, y + 18);
    if (part.to_ground.empty()) return text;
    return text +
           fmt::format("<circle cx=\"214\" cy=\"{0}\" r=\"3.5\"/><path d=\"M214 {0}v16H228\" stroke=\"#555\"/>\n", y) +
           resistor(228, y + 16, part.to_ground, y + 35) + svg_label(268, y + 20, "start", "GND", small);
}

std::string motor(int y, const char* name, std::string_view outputs) {
    const int x = driver_x + driver_width;
    return fmt::format("<path d=\"M{} {}H{}M{} {}H{}\" stroke=\"#555\"/>\n", x, y - 6, x + 70, x, y + 6, x + 70) +
           fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"26\" class=\"part\"/>\n", x + 90, y) +
           svg_label(x + 90, y + 5, "middle", "M") + svg_label(x + 90, y + 46, "middle", name) +
           svg_label(x + 90, y + 62, "middle", std::string(outputs), " class=\"small\"");
}

// Battery to the driver and, where it supplies the board, to that; all grounds together.
std::string supply(const Wiring& wiring, int bottom) {
    const int red = bottom + 30, black = bottom + 60;
    const bool both = !wiring.board_supply.empty();
    const std::string to_board = both ? fmt::format("M{} {}V{}", board_x + 60, red, bottom) : "";
    std::string text =
        fmt::format("<path d=\"M40 {0}H{1}V{2}{3}\" stroke=\"#c00\"/>\n", red, driver_x + 50, bottom, to_board) +
        fmt::format("<path d=\"M40 {0}H{1}V{2}M{3} {0}V{2}\" stroke=\"#000\"/>\n", black, driver_x + 100, bottom,
                    board_x + 120) +
        svg_label(40, red - 8, "start", "battery +") + svg_label(40, black - 8, "start", "battery −");
    if (both)
        text += svg_label(board_x + 54, bottom - 8, "middle", std::string(wiring.board_supply), small) +
                fmt::format("<rect x=\"{}\" y=\"{}\" width=\"44\" height=\"16\" class=\"part\"/>\n", board_x + 38,
                            bottom + 6) +
                svg_label(board_x + 60, bottom + 18, "middle", std::string(wiring.regulator), small) +
                fmt::format("<path d=\"M{0} {1}H{2}\" stroke=\"#000\"/>\n", board_x + 82, bottom + 14, board_x + 120);
    return text + svg_label(board_x + 120, bottom - 8, "middle", both ? "−, GND" : "GND", small) +
           svg_label(driver_x + 46, bottom - 8, "middle", std::string(wiring.motor_supply), small) +
           svg_label(driver_x + 108, bottom - 8, "middle", "GND", small);
}

}  // namespace

std::string svg_label(int x, int y, std::string_view anchor, const std::string& text, std::string_view style) {
    return fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor, style, xml_text(text));
}

std::string wiring_svg(const Plan& plan, const Wiring& wiring) {
    const int height = std::max(static_cast<int>(plan.inputs.size()) * sensor_height,
                                (static_cast<int>(wiring.pins.size()) + 1) * row_height) +
                       50;
    const int bottom = top + height;
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 980 {0}\" width=\"980\" height=\"{0}\">\n"
        "<style>text{{font:14px sans-serif;fill:#222}} .title{{font-weight:bold}} .small{{font-size:11px;fill:#555}}\n"
        ".part{{fill:#f4f1ea;stroke:#444}} path{{fill:none;stroke-width:2}}</style>\n"
        "<rect width=\"980\" height=\"{0}\" fill=\"#fff\"/>\n",
        bottom + 140);
    text += fitted(20, 34, "Wiring: " + plan.title, 940, true);
    text += box(board_x, top, board_width, height, std::string(wiring.board));
    text += box(driver_x, top, driver_width, height, std::string(wiring.driver));
    if (!plan.inputs.empty()) text += svg_label(20, top - 10, "start", "Sensors", " class=\"title\"");
    const std::vector<SensorPart> parts = parts_of(plan, wiring.kind);
    for (std::size_t i = 0; i < plan.inputs.size(); ++i)
        text += sensor_row(plan.inputs[i], parts[i], i, wiring.inputs[i]);
    for (std::size_t i = 0; i < wiring.pins.size(); ++i) {
        const int y = top + 40 + static_cast<int>(i) * row_height;
        text += fmt::format("<path d=\"M{} {}H{}\" stroke=\"{}\"/>\n", board_x + board_width, y, driver_x,
                            i < 3   ? "#d55e00"
                            : i < 6 ? "#009e73"
                                    : "#555");
        text += svg_label(board_x + board_width - 8, y + 5, "end", wiring.pins[i].board) +
                svg_label(driver_x + 8, y + 5, "start", wiring.pins[i].driver);
    }
    const int button_y = top + 40 + static_cast<int>(wiring.pins.size()) * row_height;
    if (!wiring.button.empty())
        text += svg_label(board_x + board_width - 8, button_y + 5, "end", wiring.button) +
                fmt::format("<path d=\"M{} {}h20\" stroke=\"#555\"/>\n", board_x + board_width, button_y) +
                svg_label(board_x + board_width + 26, button_y + 5, "start", "button to GND", " class=\"small\"");
    text += motor(top + 70, "left motor", wiring.left_outputs) + motor(top + 210, "right motor", wiring.right_outputs);
    return text + supply(wiring, bottom) + fitted(40, bottom + 92, std::string(wiring.notes[0]), 920, false) +
           fitted(40, bottom + 110, std::string(wiring.notes[1]), 920, false) +
           (own_milliamperes(parts) > 0
                ? fitted(40, bottom + 128, "Sensors at \"own 5 V\" have another supply, see README.md.", 920, false)
                : "") +
           "</svg>\n";
}

}  // namespace braitenlab::robots

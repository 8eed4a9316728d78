// Names and ranges of the robot's module `thymio` are those of its firmware and of programs for it:
// - PROXIMITY(0..6).value(): higher when closer; normalized_value() of the firmware's MicroPython is 100 at 3500. 0 and
// 1
//   are on the left, 2 in the middle, 3 and 4 on the right (demo/src/thymio-python-intellisense.js of
//   github.com/Mobsya/thymio3-ts-api, python.ts and main/stm32_spi.c of github.com/Mobsya/thymio3-firmware-esp32).
// - GROUND(0..1).value(): lower when darker, left and right; normalized_value() is 100 at 1024.
// - MOTORS().set_speed(left, right): integers from -1000 to 1000. 500 is the fastest of the robot's own explorer
//   (main/explorer.c) and about 0.2 m/s (src/trajectory.js of github.com/FrancescoMondada/thymio3-cockpit).
// - BUTTONS().get_status(): 1 where pressed, in the order backward, left, centre, forward, right.
// - time.ticks_ms(), ticks_diff() and sleep_ms(), 50 steps per second (src/thymio/on-robot-ann.js of
//   github.com/FrancescoMondada/Thymio3-ANN-Edu).
#include "core/export/thymio3.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include <fmt/format.h>

#include "core/export/micropython.h"
#include "core/export/text.h"
#include "core/export/texts.h"
#include "core/export/thymio_places.h"

namespace braitenlab::robots::thymio3 {

namespace {

struct Part {
    std::string_view ids, name;  // for the program and for the table
};

Part part_of(thymio::Place place) {
    constexpr std::array<Part, 3> front{
        {{"(0, 1)", "the two on the left"}, {"(3, 4)", "the two on the right"}, {"(2,)", "the middle one in front"}}};
    constexpr std::array<Part, 3> ground{
        {{"(0,)", "the left one below"}, {"(1,)", "the right one below"}, {"(0, 1)", "both below"}}};
    static_assert(front.size() == thymio::side_count && ground.size() == thymio::side_count);
    return (place.is_ground ? ground : front)[static_cast<std::size_t>(place.side)];
}

bool has_place(const Plan& plan, bool is_ground) {
    return std::any_of(plan.inputs.begin(), plan.inputs.end(),
                       [&](const Input& input) { return thymio::place_of(input)->is_ground == is_ground; });
}

// What the README says of the numbers of each kind of sensor.
constexpr std::string_view about_proximity =
    "`FAR` and `NEAR` are what a proximity sensor reads with nothing and with a hand in front of it. Two lines print "
    "it:\n\n"
    "    import thymio\n"
    "    print([thymio.PROXIMITY(i).value() for i in range(5)])\n";
constexpr std::string_view about_ground =
    "\n`WHITE` is what a ground sensor reads on the brightest floor. Two lines print it:\n\n"
    "    import thymio\n"
    "    print([thymio.GROUND(i).value() for i in range(2)])\n";

std::string argument(const Input& input) {
    const thymio::Place place = *thymio::place_of(input);
    return fmt::format("                read(thymio.{}, {}, {}),\n", place.is_ground ? "GROUND" : "PROXIMITY",
                       part_of(place).ids, place.is_ground ? "0, WHITE" : "FAR, NEAR");
}

std::string commented_program(const Plan& plan) {
    std::string calibration, arguments;
    if (has_place(plan, false)) calibration += "FAR, NEAR = 0, 3500  # of a proximity sensor\n";
    if (has_place(plan, true)) calibration += "WHITE = 1024  # of a ground sensor\n";
    for (const Input& input : plan.inputs) arguments += argument(input);
    return filled(texts::thymio3_head_py, {{"TITLE", comment_text(plan.title)},
                                           {"EXP", micropython::needs_exp(plan) ? "from math import exp\n" : ""},
                                           {"CALIBRATION", calibration}}) +
           micropython::think_py(plan) + filled(texts::thymio3_loop_py, {{"ARGUMENTS", arguments}});
}

// The same program without comments and empty lines, indented by one space.
std::string short_program(std::string_view text) {
    std::string lines = "# Exported from Braitenlab. Comments are left out to fit.\n";
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at);
        std::string_view line = text.substr(at, end - at);
        at = end + 1;
        line = line.substr(0, line.find('#'));
        line = line.substr(0, line.find_last_not_of(' ') + 1);
        if (line.empty()) continue;
        const std::size_t indent = line.find_first_not_of(' ');
        lines += std::string(indent / 4, ' ') + std::string(line.substr(indent)) + "\n";
    }
    return lines;
}

bool is_too_large(std::string_view text) { return text.size() > static_cast<std::size_t>(largest_program); }

}  // namespace

std::optional<Error> refusal(const Plan& plan) {
    if (auto error = thymio::sensor_refusal(plan)) return error;
    const std::string text = program(plan);
    if (is_too_large(text)) return micropython::too_large(plan, text.size(), "Thymio 3", largest_program);
    return std::nullopt;
}

std::string program(const Plan& plan) {
    const std::string text = commented_program(plan);
    return is_too_large(text) ? short_program(text) : text;
}

std::string readme(const Plan& plan) {
    std::string sensors;
    for (const Input& input : plan.inputs)
        sensors += fmt::format("| {} | {} |\n", comment_text(input.name), part_of(*thymio::place_of(input)).name);
    return filled(texts::thymio3_readme_md,
                  {{"TITLE", comment_text(plan.title)},
                   {"BYTES", std::to_string(program(plan).size())},
                   {"LIMIT", std::to_string(largest_program)},
                   {"SHORT", is_too_large(commented_program(plan)) ? ", without comments to fit" : ""},
                   {"SENSORS", sensors},
                   {"CALIBRATION", (has_place(plan, false) ? std::string(about_proximity) : "") +
                                       (has_place(plan, true) ? std::string(about_ground) : "")}});
}

}  // namespace braitenlab::robots::thymio3

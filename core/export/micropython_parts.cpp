// Wiring picture and shopping list of a micro:bit.
#include <cstddef>

#include <fmt/format.h>

#include "core/export/micropython.h"
#include "core/export/text.h"
#include "core/export/texts.h"
#include "core/export/wiring_svg.h"

namespace braitenlab::robots::micropython {

std::string parts_csv(const Plan& plan) {
    const bool any = board_milliamperes(parts_of(plan, Board::microbit)) <= version_1_milliamperes;
    return filled(texts::micropython_parts_csv,
                  {{"SENSORS", sensor_rows(plan, Board::microbit)},
                   {"VERSION", any ? "version 1 or 2" : "version 2: version 1 does not give enough current"}});
}

std::string wiring_svg(const Plan& plan) {
    Wiring wiring{.board = "BBC micro:bit",
                  .driver = "TB6612",
                  .kind = Board::microbit,
                  .pins = {{"P8", "PWMA"},
                           {"P12", "AIN1"},
                           {"P13", "AIN2"},
                           {"P16", "PWMB"},
                           {"P14", "BIN1"},
                           {"P15", "BIN2"},
                           {"3V", "VCC, STBY"}},
                  .left_outputs = "AO1, AO2",
                  .right_outputs = "BO1, BO2",
                  .motor_supply = "VM",
                  .board_supply = "battery socket +",
                  .regulator = "3.3 V",
                  .notes = {"The pins take 3 V. All grounds are connected: battery, driver, regulator, and − of the "
                            "micro:bit's socket.",
                            "The battery supplies the motors, and through a regulator of 3.3 V the battery socket. "
                            "Measure + and − of its "
                            "plug first: colours differ."}};
    for (std::size_t i = 0; i < plan.inputs.size(); ++i) wiring.inputs.push_back(fmt::format("P{}", i));
    return robots::wiring_svg(plan, wiring);
}

}  // namespace braitenlab::robots::micropython

// README of the export to a Thymio II.
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "core/export/text.h"
#include "core/export/thymio.h"
#include "core/export/thymio_places.h"

namespace braitenlab::robots::thymio {

namespace {

constexpr std::string_view readme_text = R"(# The brain "@TITLE@" on a Thymio II

Exported from Braitenlab. `brain.aesl` is the whole program. It was compared with the lab in Aseba's virtual machine. **It has not been tried
on a real Thymio II yet**; please report what you find.

1. Connect the robot by cable or radio and open `brain.aesl` in Aseba Studio (Thymio Suite: *Aseba Studio*).
2. Set the robot on the floor or hold its wheels free. *Load*, then *Run*: it drives at once; the centre button stops it, the forward button starts it again.
3. To keep the program without the computer, write it into the robot (a command of Aseba Studio's menu *Tools*).

| Sensor of the brain | Sensors of the robot | 0 | 1 |
|---|---|---|---|
@SENSORS@
A Thymio sees obstacles, not lamps: a hand takes the place of the lamp.

There is little to calibrate. Proximity sensors read about 1000 where they begin to see and 4300 near by; a dark or shiny obstacle reads less.
Ground sensors read up to 1000 on a bright floor: `prox.ground.reflected` in Aseba Studio shows what yours read. Change these numbers under
`# ---- Eyes ----`. The command 1 is the speed 500, about 0.2 m/s.
)";

struct Row {
    std::string_view name, zero, one;
};

Row row_of(Place place) {
    constexpr std::array<std::string_view, 3> front{"the two on the left", "the two on the right",
                                                    "the middle one in front"};
    constexpr std::array<std::string_view, 3> ground{"the left one below", "the right one below", "both below"};
    const auto side = static_cast<std::size_t>(place.side);
    if (place.is_ground) return {ground[side], "0, dark floor", "1000, bright floor"};
    return {front[side], "1000, nothing", "4300, a hand close to it"};
}

}  // namespace

std::string readme(const Plan& plan) {
    std::string sensors;
    for (const Input& input : plan.inputs) {
        const Row row = row_of(*place_of(input));
        sensors += fmt::format("| {} | {} | {} | {} |\n", comment_text(input.name), row.name, row.zero, row.one);
    }
    if (sensors.empty()) sensors = "| none | | | |\n";
    return filled(readme_text, {{"TITLE", comment_text(plan.title)}, {"SENSORS", sensors}});
}

}  // namespace braitenlab::robots::thymio

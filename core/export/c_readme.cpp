// README of the C export.
#include <string_view>

#include <fmt/format.h>

#include "core/export/export.h"
#include "core/export/text.h"
#include "core/scene/enums.h"

namespace braitenlab::robots {

namespace {

constexpr std::string_view readme_text = R"(# The brain "@TITLE@" in C

Exported from Braitenlab. `brain.h` is the whole brain: C99 without dependencies but `math.h`, also valid in C++11. It was compared with the
lab. **It has not been tried on a real robot yet**; please report what you find.

    #include "brain.h"

    Brain brain = {0};                  /* all values start at 0 */
    for (;;) {                          /* @RATE@ times per second */
@SET@        brain_think(&brain);
        set_wheels(brain.left, brain.right);   /* -1 (backwards) to 1 (forwards) */
    }

| Sensor of the brain | Field | Senses |
|---|---|---|
@SENSORS@
Three things are yours:

1. **Rate.** Call `brain_think()` @RATE@ times per second (`BRAIN_RATE_HZ`): memories and learning wires count time by calls.
2. **Sensors.** A reading is a number from 0 to 1. Read the sensor with nothing in front of it (or in the dark) and with what it senses in front of it,
   and scale: `(raw - dark) / (bright - dark)`, limited to 0 … 1.
3. **Wheels.** The command 1 is the fastest speed. A motor that does not turn at small commands needs a least value: find it, and use the
   range above it.

`braitenctl think BRAIN --rate @RATE@ --vectors vectors.csv` writes readings and the commands that the lab computes from them, to test your
program with.
)";

}  // namespace

std::string c_readme(const Plan& plan) {
    std::string sensors, set;
    for (const Input& input : plan.inputs) {
        const std::string_view channel = input.channel ? word(*input.channel) : "not known: the file has a brain alone";
        sensors += fmt::format("| {} | `{}` | {} |\n", comment_text(input.name), input.id, channel);
        set += fmt::format("        brain.{} = ...;\n", input.id);
    }
    if (sensors.empty()) sensors = "| none | | |\n";
    return filled(readme_text, {{"TITLE", comment_text(plan.title)},
                                {"RATE", fmt::format("{:g}", plan.rate_hz)},
                                {"SET", set},
                                {"SENSORS", sensors}});
}

}  // namespace braitenlab::robots

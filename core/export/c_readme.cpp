// README of the C export.
#include <string_view>

#include <fmt/format.h>

#include "core/export/export.h"
#include "core/export/sensor_parts.h"
#include "core/export/text.h"
#include "core/export/texts.h"
#include "core/scene/enums.h"

namespace braitenlab::robots {

std::string c_readme(const Plan& plan) {
    std::string sensors, set;
    for (const Input& input : plan.inputs) {
        const std::string_view channel = input.channel ? word(*input.channel) : "not known: the file has a brain alone";
        sensors +=
            fmt::format("| {} | `{}` | {} | {} |\n", comment_text(input.name), input.id, channel, place_text(input));
        set += fmt::format("        brain.{} = ...;\n", input.id);
    }
    if (sensors.empty()) sensors = "| none | | | |\n";
    return filled(texts::c_readme_md, {{"TITLE", comment_text(plan.title)},
                                       {"RATE", fmt::format("{:g}", plan.rate_hz)},
                                       {"SET", set},
                                       {"PLACES", std::string(about_places)},
                                       {"SENSORS", sensors}});
}

}  // namespace braitenlab::robots

// README of the export to a Thymio II.
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "core/export/text.h"
#include "core/export/texts.h"
#include "core/export/thymio.h"
#include "core/export/thymio_places.h"

namespace braitenlab::robots::thymio {

namespace {

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
    return filled(texts::thymio_readme_md, {{"TITLE", comment_text(plan.title)}, {"SENSORS", sensors}});
}

}  // namespace braitenlab::robots::thymio

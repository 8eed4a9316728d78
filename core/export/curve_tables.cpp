#include "core/export/curve_tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "core/export/text.h"
#include "core/export/texts.h"

namespace braitenlab::robots {

namespace {

// The table of a response, by the distance from the peak in widths. Its function is marked as const, because the
// compiler cannot see that it is: it then computes equal terms once.
struct CurveTable {
    Response response;
    int steps_per_width, last;  // number of steps up to where the curve is constant
    double (*value)(double);    // 0 to below 1
    std::string_view text;
};

constexpr auto curve_tables = std::to_array<CurveTable>({
    {Response::sigmoid, 32, 12 * 32, [](double t) { return 1 / (1 + std::exp(-t)) - 0.5; }, texts::brain_sigmoid_h},
    {Response::hump, 128, 448, [](double t) { return std::exp(-t * t); }, texts::brain_hump_h},
});

const CurveTable* table_of_curve(Response response) {
    const auto found = std::find_if(curve_tables.begin(), curve_tables.end(),
                                    [&](const CurveTable& table) { return table.response == response; });
    return found == curve_tables.end() ? nullptr : found;
}

constexpr int parts_of_step = 65536;

}  // namespace

std::string table_lookup() { return std::string(texts::brain_looked_up_h); }

std::optional<std::string> table_function(Response response) {
    const CurveTable* table = table_of_curve(response);
    if (!table) return std::nullopt;
    std::string values;
    for (int i = 0; i <= table->last; ++i) {
        const double exact = table->value(static_cast<double>(i) / table->steps_per_width);
        values += fmt::format("{}{},", i % 16 == 0 ? (i > 0 ? "\n    " : "    ") : " ",
                              std::min(65535L, std::lround(exact * 65536)));
    }
    return filled(table->text, {{"STEPS", std::to_string(table->steps_per_width)},
                                {"VALUES", values + "\n"},
                                {"END", fmt::format("{}.0f", table->last * parts_of_step)}});
}

float table_scale(const Curve& curve) {
    const CurveTable* table = table_of_curve(curve.response);
    return table ? static_cast<float>(table->steps_per_width * parts_of_step) / curve.width : curve.width;
}

}  // namespace braitenlab::robots

#include "core/export/curve_tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "core/export/text.h"

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
    {Response::sigmoid, 32, 12 * 32, [](double t) { return 1 / (1 + std::exp(-t)) - 0.5; },
     R"(/* Sigmoid: rises smoothly from 0 to 1; 0.5 at the centre. Its values above the centre less 0.5, in steps of 1/@STEPS@
 * of its width; `scale`: @STEPS@ * 65536 / width. */
static const uint16_t brain_sigmoid_values[] PROGMEM = {
@VALUES@};
__attribute__((const)) static float brain_sigmoid(float x, float centre, float scale) {
    const float t = (x - centre) * scale, size = t < 0.0f ? -t : t;
    const float y = size < @END@ ? brain_looked_up(brain_sigmoid_values, (uint32_t)size) : 0.5f;
    return t < 0.0f ? 0.5f - y : 0.5f + y;
}
)"},
    {Response::hump, 128, 448, [](double t) { return std::exp(-t * t); },
     R"(/* Hump: 1 at the peak, less on both sides. Its values from the peak on, in steps of 1/@STEPS@ of its width; `scale`:
 * @STEPS@ * 65536 / width. */
static const uint16_t brain_hump_values[] PROGMEM = {
@VALUES@};
__attribute__((const)) static float brain_hump(float x, float peak, float scale) {
    const float t = (x - peak) * scale, size = t < 0.0f ? -t : t;
    return size < @END@ ? brain_looked_up(brain_hump_values, (uint32_t)size) : 0.0f;
}
)"},
});

const CurveTable* table_of_curve(Response response) {
    const auto found = std::find_if(curve_tables.begin(), curve_tables.end(),
                                    [&](const CurveTable& table) { return table.response == response; });
    return found == curve_tables.end() ? nullptr : found;
}

constexpr int parts_of_step = 65536;

}  // namespace

std::string table_lookup() {
    return "/* The value at a place in a table in program memory, 65536 of a step, between two of its values. */\n"
           "static float brain_looked_up(const uint16_t *values, uint32_t place) {\n"
           "    const uint16_t *at = values + (place >> 16);\n"
           "    const uint16_t low = pgm_read_word(at), high = pgm_read_word(at + 1);\n"
           "    const int32_t more = (int32_t)(int16_t)(high - low) * (uint16_t)place;\n"
           "    return (((uint32_t)low << 16) + more) * 2.3283064e-10f;  /* 2^-32 */\n"
           "}\n\n";
}

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

// The tables of an Arduino's sigmoids and humps, compiled for this computer.
#include "core/export/curve_tables.h"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/export/text.h"
#include "tests/folder.h"
#include "tests/shell.h"

namespace braitenlab::tests::curve_tables_test {
namespace {

// Its largest difference from the curve for inputs from -40 to 40.
double largest_error(const Curve& curve) {
    const Folder folder;
    const bool is_sigmoid = curve.response == Response::sigmoid;
    const std::string program = fmt::format(
        "#include <math.h>\n#include <stdint.h>\n#include <stdio.h>\n"
        "#define PROGMEM\n#define pgm_read_word(at) (*(at))\n{}{}"
        "int main(void) {{\n"
        "    double worst = 0;\n"
        "    for (int i = -400000; i <= 400000; ++i) {{\n"
        "        const float x = i * 1e-4f;\n"
        "        const double t = ((double)x - {:.9g}) / {:.9g}, exact = {};\n"
        "        worst = fmax(worst, fabs({}(x, {}, {}) - exact));\n"
        "    }}\n"
        "    printf(\"%.9f\\n\", worst);\n"
        "}}\n",
        robots::table_lookup(), *robots::table_function(curve.response), curve.peak, curve.width,
        is_sigmoid ? "1 / (1 + exp(-t))" : "exp(-t * t)", is_sigmoid ? "brain_sigmoid" : "brain_hump",
        robots::c_number(curve.peak), robots::c_number(robots::table_scale(curve)));
    put_text(folder / "table.c", program);
    const Ran ran = shell(
        fmt::format("cd '{}' && gcc -O2 -Wall -Wextra -Werror table.c -o table -lm && ./table", folder.path.string()));
    EXPECT_EQ(ran.code, 0) << ran.out;
    return ran.code == 0 ? std::stod(ran.out) : INFINITY;
}

TEST(CurveTables, DifferFromTheirCurvesByLessThanThreeIn100000) {
    for (const Response response : {Response::sigmoid, Response::hump})
        for (const float width : {0.15f, 1.0f, 10.0f}) {
            const Curve curve{response, 0.4f, width};
            EXPECT_LT(largest_error(curve), 3e-5) << word(response) << " " << width;
        }
}

TEST(CurveTables, AreOfCurvesWithAnExponentialOnly) {
    EXPECT_FALSE(robots::table_function(Response::step));
    EXPECT_FALSE(robots::table_function(Response::inverted));
}

}  // namespace
}  // namespace braitenlab::tests::curve_tables_test

#include "ui/widgets/plot.h"

#include <cmath>

#include <gtest/gtest.h>

namespace braitenlab::tests::plot_test {

using namespace ui;

TEST(Plot, DividesAnAxisAtRoundNumbers) {
    EXPECT_FLOAT_EQ(round_step(10, 5), 2);
    EXPECT_FLOAT_EQ(round_step(1, 4), 0.5f);
    EXPECT_FLOAT_EQ(round_step(60, 6), 10);
    EXPECT_FLOAT_EQ(round_step(61, 6), 20);
    EXPECT_FLOAT_EQ(round_step(0.07f, 4), 0.02f);
    for (float span = 0.01f; span < 1000; span *= 1.17f)
        for (int most = 1; most < 12; ++most)
            EXPECT_LE(span / round_step(span, most), static_cast<float>(most) * 1.001f);
}

TEST(Plot, PutsLowAtTheBottomLeftAndHighAtTheTopRight) {
    const Rect r{100, 50, 200, 80};
    const Axis x{10, 20}, y{-1, 1};
    EXPECT_FLOAT_EQ(plot_point(r, x, y, 10, -1).x, 100);
    EXPECT_FLOAT_EQ(plot_point(r, x, y, 10, -1).y, 130);
    EXPECT_FLOAT_EQ(plot_point(r, x, y, 20, 1).x, 300);
    EXPECT_FLOAT_EQ(plot_point(r, x, y, 20, 1).y, 50);
    EXPECT_FLOAT_EQ(plot_point(r, x, y, 15, 7).y, 50) << "a value above the range is clamped";
}

}  // namespace braitenlab::tests::plot_test

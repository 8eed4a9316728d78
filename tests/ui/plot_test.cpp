#include "ui/widgets/plot.h"

#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "desk.h"

namespace braitenlab::tests::plot_test {

using namespace ui;

TEST(Plot, DividesAnAxisAtRoundNumbers) {
    EXPECT_DOUBLE_EQ(round_step(10, 5), 2);
    EXPECT_DOUBLE_EQ(round_step(1, 4), 0.5);
    EXPECT_DOUBLE_EQ(round_step(60, 6), 10);
    EXPECT_DOUBLE_EQ(round_step(61, 6), 20);
    EXPECT_DOUBLE_EQ(round_step(0.07, 4), 0.02);
    for (double span = 0.01; span < 1000; span *= 1.17)
        for (int most = 1; most < 12; ++most) EXPECT_LE(span / round_step(span, most), most * 1.001);
}

TEST(Plot, PutsLowAtTheBottomLeftAndHighAtTheTopRight) {
    const Rect r{100, 50, 200, 80};
    const Axis x{10, 20}, y{-1, 1};
    EXPECT_FLOAT_EQ(plot_point(r, x, y, {10, -1}).x, 100);
    EXPECT_FLOAT_EQ(plot_point(r, x, y, {10, -1}).y, 130);
    EXPECT_FLOAT_EQ(plot_point(r, x, y, {20, 1}).x, 300);
    EXPECT_FLOAT_EQ(plot_point(r, x, y, {20, 1}).y, 50);
    EXPECT_FLOAT_EQ(plot_point(r, x, y, {15, 7}).y, 50) << "a value above the range is clamped";
}

TEST(Plot, PutsAMomentOfARunOfWeeksWhereOneOfANewRunIs) {
    const Rect r{100, 50, 200, 80};
    const Axis y{-1, 1};
    for (const double start : {3600.0, 86400.0, 50 * 86400.0})
        for (double seconds = 0; seconds <= 10; seconds += 0.05) {
            const float young = plot_point(r, {0, 10}, y, {seconds, 0}).x;
            EXPECT_NEAR(plot_point(r, {start, start + 10}, y, {start + seconds, 0}).x, young, 1e-3f) << start;
        }
}

namespace {

// Draws in one frame of Dear ImGui.
template <class Draw>
void draw_once(Desk& desk, Draw draw) {
    desk.frame(2);
    desk.anchors.begin();
    desk.written.clear();
    Ui ui{desk.strings, palette(Theme::dark), test_fonts(1).loaded.fonts, 1, desk.anchors, desk.asked};
    ui.written = &desk.written;
    ImGui::NewFrame();
    draw(ui);
    ImGui::Render();
}

}  // namespace

TEST(Plot, DrawsALineWithPeaksWithinItsRectangle) {
    Desk desk(1280, 800, 1, true);
    const Rect r{100, 100, 300, 200};
    constexpr float thickness = 3.6f, smooth = 1;  // pixels; `smooth`: of the antialiased edge
    draw_once(desk, [&](const Ui& ui) {
        const ImVector<ImDrawVert>& vertices = ImGui::GetWindowDrawList()->VtxBuffer;
        const int before = vertices.Size;  // of the window itself
        plot_line(ui, r, {0, 1}, {0, 10}, 101, palette(Theme::dark).text, thickness, [](std::size_t i) {
            return PlotPoint{static_cast<double>(i) / 100, i % 5 == 0 ? 10.0 : i % 7 == 0 ? 0.0 : 5.0};
        });
        ASSERT_GT(vertices.Size, before + 200);
        for (int i = before; i < vertices.Size; ++i) {
            const ImDrawVert& v = vertices[i];
            EXPECT_GE(v.pos.y, r.y - thickness / 2 - smooth);
            EXPECT_LE(v.pos.y, r.y + r.h + thickness / 2 + smooth);
            EXPECT_GE(v.pos.x, r.x - thickness / 2 - smooth);
            EXPECT_LE(v.pos.x, r.x + r.w + thickness / 2 + smooth);
        }
    });
}

TEST(Plot, WritesNoNumberOfAnAxisTwice) {
    constexpr double days = 86400;
    for (const double span : {0.05, 0.3, 1.0, 2.0, 4.32, 5.0, 7.0, 31.0, 700.0})
        for (const auto& [low, decimals] : {std::pair{3.0, 0}, {3.0, 1}, {50 * days + 3, 0}, {50 * days + 3, 1}}) {
            Desk desk(1280, 800, 1, true);
            const Axis x{low, low + span, " s", decimals}, y{0, span, "", decimals};
            std::multiset<std::string> numbers;
            draw_once(desk, [&](const Ui& ui) { plot_ground(ui, {100, 100, 900, 500}, x, y); });
            for (const Written& w : desk.written) numbers.insert(w.words);
            for (const std::string& number : numbers)
                EXPECT_EQ(numbers.count(number), 1u) << number << " on an axis of " << span;
            if (span > 2) {
                EXPECT_GE(numbers.size(), 4u) << span;
            }
        }
}

}  // namespace braitenlab::tests::plot_test

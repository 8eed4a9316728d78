#include "ui/widgets/plot.h"

#include <array>
#include <cmath>
#include <set>

#include "desk.h"

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
            return ImVec2{static_cast<float>(i) / 100, i % 5 == 0 ? 10.0f : i % 7 == 0 ? 0.0f : 5.0f};
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
    for (const float span : {0.05f, 0.3f, 1.0f, 2.0f, 4.32f, 5.0f, 7.0f, 31.0f, 700.0f})
        for (const int decimals : {0, 1}) {
            Desk desk(1280, 800, 1, true);
            const Axis x{3, 3 + span, " s", decimals}, y{0, span, "", decimals};
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

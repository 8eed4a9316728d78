#include "ui/widgets/paint.h"

#include <algorithm>

#include "desk.h"

namespace braitenlab::tests::paint_test {

using namespace ui;

namespace {

// The clip rectangles in which the shadow of this box is drawn, each once.
std::vector<Rect> parts_of_shadow(Rect box, Corner corner) {
    Desk desk;
    desk.frame(2);
    desk.anchors.begin();
    desk.written.clear();
    Ui ui{desk.strings, palette(Theme::dark), test_fonts(1).loaded.fonts, 1, desk.anchors, desk.asked};
    ui.written = &desk.written;
    ImGui::NewFrame();
    ImDrawList& draw = *ImGui::GetForegroundDrawList();
    shadow_box(ui, draw, box, corner, {3, 2, 0.1f});
    std::vector<Rect> parts;
    for (const ImDrawCmd& each : draw.CmdBuffer) {
        if (each.ElemCount == 0) continue;
        const ImVec4 c = each.ClipRect;
        parts.push_back({c.x, c.y, c.z - c.x, c.w - c.y});
    }
    ImGui::EndFrame();
    return parts;
}

bool contains(const std::vector<Rect>& parts, float x, float y) {
    return std::any_of(parts.begin(), parts.end(), [&](const Rect& each) {
        return x >= each.x && x < each.x + each.w && y >= each.y && y < each.y + each.h;
    });
}

}  // namespace

TEST(Paint, DrawsTheShadowOfABoxAroundItAndNotBelowIt) {
    for (const Corner corner : {Corner::square, Corner::bar, Corner::box, Corner::round}) {
        const Rect box{300.5f, 200.25f, 240, 160};
        const std::vector<Rect> parts = parts_of_shadow(box, corner);
        ASSERT_FALSE(parts.empty());
        EXPECT_EQ(contains(parts, 420, 280), corner == Corner::round) << "below the box, but for round ends";
        for (const float beyond : {0.5f, 3.0f, 6.0f}) {
            EXPECT_TRUE(contains(parts, box.x - beyond, 280)) << beyond;
            EXPECT_TRUE(contains(parts, box.x + box.w + beyond, 280)) << beyond;
            EXPECT_TRUE(contains(parts, 420, box.y - beyond)) << beyond;
            EXPECT_TRUE(contains(parts, 420, box.y + box.h + beyond)) << beyond;
            EXPECT_TRUE(contains(parts, box.x - beyond, box.y - beyond)) << beyond;
            EXPECT_TRUE(contains(parts, box.x + box.w + beyond, box.y + box.h + beyond)) << beyond;
        }
    }
}

TEST(Paint, DrawsNoPixelOfAShadowTwice) {
    for (const Corner corner : {Corner::box, Corner::round}) {
        const std::vector<Rect> parts = parts_of_shadow({300.5f, 200.25f, 240, 160}, corner);
        for (float x = 280.5f; x < 560; ++x)
            for (float y = 180.5f; y < 380; ++y) {
                const auto here = std::count_if(parts.begin(), parts.end(), [&](const Rect& each) {
                    return x >= each.x && x < each.x + each.w && y >= each.y && y < each.y + each.h;
                });
                ASSERT_LE(here, 1) << x << ' ' << y;
            }
    }
}

}  // namespace braitenlab::tests::paint_test

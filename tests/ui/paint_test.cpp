#include "ui/widgets/paint.h"

#include <algorithm>
#include <cmath>

#include "desk.h"
#include "ui/widgets/drawn.h"

namespace braitenlab::tests::paint_test {

using namespace ui;

namespace {

// Never called: no test draws with OpenGL.
void fill_by_clearing(const ImDrawList*, const ImDrawCmd*) {}

// What `paint_it` adds to a list: the clip rectangles of its commands, and the colours of those that clear.
struct Painted {
    std::vector<Rect> drawn, cleared;
    std::vector<ImU32> colours;
    std::optional<std::uint64_t> hash;
};
template <class PaintIt>
Painted painted(const PaintIt& paint_it) {
    Desk desk;
    desk.frame(2);
    desk.anchors.begin();
    Ui ui{desk.strings, palette(Theme::dark), test_fonts(1).loaded.fonts, 1, desk.anchors, desk.asked};
    ui.fill_clip = fill_by_clearing;
    ImGui::NewFrame();
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({1280, 800});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::Begin("painted", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    paint_it(ui, draw);
    Painted result;
    for (const ImDrawCmd& each : draw.CmdBuffer) {
        const ImVec4 c = each.ClipRect;
        const Rect clip{c.x, c.y, c.z - c.x, c.w - c.y};
        if (each.UserCallback == fill_by_clearing) {
            result.cleared.push_back(clip);
            result.colours.push_back(static_cast<ImU32>(reinterpret_cast<std::uintptr_t>(each.UserCallbackData)));
        } else if (each.ElemCount > 0) {
            result.drawn.push_back(clip);
        }
    }
    ImGui::End();
    ImGui::PopStyleVar();
    ImGui::Render();
    result.hash = hash_of_drawn(*ImGui::GetDrawData());
    return result;
}

// The clip rectangles in which the shadow of this box is drawn, each once.
std::vector<Rect> parts_of_shadow(Rect box, Corner corner) {
    return painted([&](const Ui& ui, ImDrawList& draw) { shadow_box(ui, draw, box, corner, {3, 2, 0.1f}); }).drawn;
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
        EXPECT_FALSE(contains(parts, 420, 280)) << "below the box";
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

TEST(Paint, ClearsTheInsideOfALargeOpaqueBoxAndDrawsItsRim) {
    constexpr Colour colour{0.2f, 0.4f, 0.6f, 1};
    for (const Corner corner : {Corner::square, Corner::bar, Corner::box, Corner::round}) {
        const Rect box{300.5f, 200.25f, 240, 160};
        const Painted parts = painted([&](const Ui& ui, ImDrawList&) { fill_box(ui, box, colour, corner); });
        ASSERT_EQ(parts.cleared.size(), 1u);
        EXPECT_EQ(parts.colours.front(), paint(colour));
        const Rect inside = parts.cleared.front();
        EXPECT_GT(inside.w * inside.h, (corner == Corner::round ? 0.5f : 0.9f) * box.w * box.h);
        // In the middle of a corner the arc is nearest to the middle of the box.
        const float radius = corner == Corner::round ? 80 : corner == Corner::box ? 6 : corner == Corner::bar ? 2 : 0;
        EXPECT_GE(std::min(inside.x - box.x, inside.y - box.y), radius * (1 - std::sqrt(0.5f)) - 0.01f);
        for (float x = box.x; x < box.x + box.w; x += 0.5f)
            for (float y = box.y; y < box.y + box.h; y += 0.5f) {
                const auto here = std::count_if(parts.drawn.begin(), parts.drawn.end(),
                                                [&](const Rect& each) { return each.contains(x, y); });
                ASSERT_TRUE(here == 1 || contains(parts.cleared, x, y)) << x << ' ' << y;
            }
    }
}

TEST(Paint, DrawsABoxThatIsSmallOrShowsWhatIsBelowIt) {
    const auto cleared = [](Rect box, float alpha) {
        return painted([&](const Ui& ui, ImDrawList&) { fill_box(ui, box, Colour{0, 0, 0, alpha}); }).cleared;
    };
    EXPECT_TRUE(cleared({300, 200, 40, 30}, 1).empty());
    EXPECT_TRUE(cleared({300, 200, 240, 160}, 0.9f).empty());
    EXPECT_EQ(cleared({300, 200, 240, 160}, 1).size(), 1u);
}

TEST(Paint, AnotherColourOfAClearedBoxIsAnotherPicture) {
    const auto hash = [](float red) {
        const Rect box{300, 200, 240, 160};  // its rim is of the first colour
        return painted([&](const Ui& ui, ImDrawList& draw) {
                   fill_box(ui, box, Colour{0, 0, 0, 1});
                   for (ImDrawCmd& each : draw.CmdBuffer)
                       if (each.UserCallback)
                           each.UserCallbackData =
                               reinterpret_cast<void*>(static_cast<std::uintptr_t>(paint(Colour{red, 0, 0, 1})));
               })
            .hash;
    };
    ASSERT_TRUE(hash(0));
    EXPECT_EQ(hash(0.5f), hash(0.5f));
    EXPECT_NE(hash(0), hash(0.5f));
}

}  // namespace braitenlab::tests::paint_test

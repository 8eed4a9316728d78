#include "app/applied_theme.h"

#include <gtest/gtest.h>

namespace braitenlab::tests::applied_theme_test {
namespace {

// Dear ImGui's built-in font, which needs no file.
struct BuiltIn {
    BuiltIn() {
        font = atlas.AddFontDefault();
        atlas.Build();
    }
    ImFontAtlas atlas;
    ImFont* font = nullptr;
};

TEST(AppliedTheme, TheLabelFontFallsBackToTheFontOfTheWindow) {
    BuiltIn own;
    LabelFont made = label_font([](char32_t) { return std::string{}; }, 13, *own.font);
    EXPECT_NE(made.warning.find("no font"), std::string::npos) << made.warning;
    const render::Glyph& letter = made.lettering.glyph(U'H');
    ASSERT_GT(letter.height, 4);
    EXPECT_GT(letter.advance, 3);
    EXPECT_LT(letter.top, 0);
    int ink = 0;
    for (int y = 0; y < letter.height; ++y)
        for (int x = 0; x < letter.width; ++x)
            ink +=
                made.lettering
                    .sheet()[static_cast<std::size_t>((letter.y + y) * render::Lettering::side + letter.x + x)] > 128;
    EXPECT_GT(ink, 8);
    EXPECT_EQ(set_line(made.lettering, "HH").width, 2 * set_line(made.lettering, "H").width);
}

TEST(AppliedTheme, TheLabelFontPrefersTheFontsOfTheSystem) {
    BuiltIn own;
    const LabelFont made = label_font(render::find_font, 20, *own.font);
    EXPECT_EQ(made.warning, "");
    EXPECT_EQ(made.lettering.pixels(), 20);
}

}  // namespace
}  // namespace braitenlab::tests::applied_theme_test

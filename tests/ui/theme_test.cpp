#include "ui/widgets/theme.h"

#include <filesystem>

#include <gtest/gtest.h>
#include <imgui_internal.h>

#include "core/scene/file_kind.h"
#include "desk.h"
#include "ui/imgui_compat.h"

namespace braitenlab::tests::theme_test {

using namespace ui;

TEST(Theme, MeasuresContrastByTheGuidelines) {
    EXPECT_NEAR(contrast(rgb(0xFFFFFF), rgb(0x000000)), 21, 0.01f);
    EXPECT_NEAR(contrast(rgb(0x777777), rgb(0xFFFFFF)), 4.48f, 0.01f);
}

TEST(Theme, HasReadableTextEverywhere) {
    for (const Theme theme : {Theme::dark, Theme::light}) {
        const Palette p = palette(theme);
        for (const Colour ground : {p.ground, p.panel, p.raised}) {
            EXPECT_GE(contrast(p.text, ground), 4.5f);
            EXPECT_GE(contrast(p.second_text, ground), 4.5f);
            EXPECT_GE(contrast(legible(p.warning, ground, p.text), ground), 4.5f);
        }
        EXPECT_GE(contrast(p.on_accent, p.accent), 4.5f);
        EXPECT_GE(contrast(p.warning, p.panel), 4.5f);
        EXPECT_GE(contrast(p.accent, p.panel), 4.5f);
    }
}

TEST(Theme, HasScrollBarsThatAreSeen) {
    ImGui::CreateContext();
    for (const Theme theme : {Theme::dark, Theme::light}) {
        apply_theme(theme, 1);
        const ImVec4& bar = ImGui::GetStyle().Colors[ImGuiCol_ScrollbarGrab];
        EXPECT_GE(contrast({bar.x, bar.y, bar.z, bar.w}, palette(theme).panel), 3);
    }
    ImGui::DestroyContext();
}

TEST(Theme, MovesAColourTowardsTheTextAsLittleAsNecessary) {
    const Palette p = palette(Theme::light);
    EXPECT_EQ(legible(p.text, p.panel, p.text), p.text);
    const Colour moved = legible(p.memory, p.panel, p.text);
    EXPECT_GE(contrast(moved, p.panel), 4.5f);
    EXPECT_LT(contrast(moved, p.panel), 6);
}

TEST(Theme, HasDigitsAndTheMinusSignInEveryFace) {
    const Desk desk(1280, 800, 1, true);  // builds the glyphs
    const Fonts& fonts = test_fonts(1).loaded.fonts;
    for (ImFont* face :
         {fonts.text, fonts.strong, fonts.title, fonts.display, fonts.small, fonts.label, fonts.caption}) {
        ASSERT_TRUE(face);
        for (const ImWchar sign : {ImWchar{0x2212}, ImWchar{'0'}, ImWchar{','}})
            EXPECT_TRUE(compat::has_glyph(face, sign)) << sign << " at " << compat::size_of(face);
    }
}

// Of the window's words, and of what exercises, scenes and lectures say.
TEST(Theme, HasEveryLetterOfTheShippedTexts) {
    const Desk desk(1280, 800, 1, true);  // builds the glyphs
    ImFont* text = test_fonts(1).loaded.fonts.text;
    const std::filesystem::path root = BRAITENLAB_SOURCE;
    std::size_t files = 0;
    for (const char* folder : {"ui/strings", "exercises/words", "exercises/guided", "exercises/scenes",
                               "exercises/robots", "exercises/lectures"})
        for (const auto& entry : std::filesystem::directory_iterator(root / folder)) {
            if (entry.path().extension() != ".toml") continue;
            ++files;
            const std::string words = *read_text(entry.path());
            const char *at = words.c_str(), *end = at + words.size();
            while (at < end) {
                unsigned int letter = 0;
                at += ImTextCharFromUtf8(&letter, at, end);
                const bool is_drawn = letter < 0x20 || compat::has_glyph(text, static_cast<ImWchar>(letter));
                EXPECT_TRUE(is_drawn) << "U+" << std::hex << letter << " in " << entry.path();
            }
        }
    EXPECT_GT(files, 50u);
}

TEST(Theme, ReplacesMissingFonts) {
    ImFontAtlas atlas;
    const LoadedFonts loaded = load_fonts(atlas, 1, {"/nowhere/a.ttf", "", "", {}});
    EXPECT_NE(loaded.warning.find("/nowhere/a.ttf"), std::string::npos);
    EXPECT_TRUE(loaded.fonts.text && loaded.fonts.title && loaded.fonts.strong && loaded.fonts.small);
    EXPECT_TRUE(atlas.Build());
}

}  // namespace braitenlab::tests::theme_test

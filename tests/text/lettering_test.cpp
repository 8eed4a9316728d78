#include "render/text/lettering.h"

#include <filesystem>

#include <gtest/gtest.h>

namespace braitenlab::tests::lettering_test {
namespace {

using namespace render;

// A font with a kern table, which Noto Sans does not have. Empty if it is not installed.
std::string dejavu() {
    for (const char* file :
         {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/dejavu/DejaVuSans.ttf",
          "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf"})
        if (std::filesystem::exists(file)) return file;
    return {};
}

Lettering from(const FindFont& find, int pixels) {
    auto made = Lettering::from_fonts(find, pixels);
    EXPECT_TRUE(made) << made.error().text();
    return std::move(*made);
}

TEST(Lettering, ReadsOneToFourBytes) {
    EXPECT_EQ(decode_utf8("Aé→😀"), U"Aé→😀");
    EXPECT_EQ(decode_utf8(""), U"");
}

TEST(Lettering, ReplacesMalformedBytes) {
    EXPECT_EQ(decode_utf8("a\xFF"
                          "b"),
              U"a\xFFFD"
              U"b");
    EXPECT_EQ(decode_utf8("a\xC3"), U"a\xFFFD");
    EXPECT_EQ(decode_utf8("\xC0\xAF"), U"\xFFFD\xFFFD");            // overlong
    EXPECT_EQ(decode_utf8("\xED\xA0\x80"), U"\xFFFD\xFFFD\xFFFD");  // half a surrogate pair
    EXPECT_EQ(decode_utf8("\xE2\x86z"), U"\xFFFDz");                // cut short
}

TEST(Lettering, RasterisesACharacterOnceWithAMargin) {
    Lettering lettering = from(find_font, 24);
    const Glyph h = lettering.glyph(U'H');
    EXPECT_GT(h.height, 12);
    EXPECT_LT(h.height, 24);
    EXPECT_EQ(h.top, -h.height);  // it is on the baseline
    EXPECT_GE(h.x, Lettering::room);
    const auto drawn = lettering.take_changes();
    EXPECT_LT(drawn.first, drawn.end);
    lettering.glyph(U'H');
    const auto again = lettering.take_changes();
    EXPECT_EQ(again.first, again.end);
    for (int x = h.x - Lettering::room; x < h.x + h.width + Lettering::room; ++x)
        EXPECT_EQ(lettering.sheet()[static_cast<std::size_t>((h.y - 1) * Lettering::side + x)], 0);
}

TEST(Lettering, FindsCharactersThatTheDefaultFontLacks) {
    // Thai and Georgian come with fonts-noto-core, each in a separate font.
    ASSERT_NE(find_font(U'ก'), find_font(0)) << "install fonts-noto-core";
    ASSERT_NE(find_font(U'ა'), find_font(U'ก')) << "install fonts-noto-core";
    Lettering lettering = from(find_font, 24);
    const auto picture = [&](char32_t c) {
        const Glyph g = lettering.glyph(c);
        std::vector<std::uint8_t> grey;
        for (int y = g.y; y < g.y + g.height; ++y)
            for (int x = g.x; x < g.x + g.width; ++x)
                grey.push_back(lettering.sheet()[static_cast<std::size_t>(y * Lettering::side + x)]);
        return grey;
    };
    const auto missing = picture(U'\U0010FFFD');  // the empty box for a character that no font has
    for (const char32_t c : {U'ก', U'ა', U'θ', U'→'}) {
        EXPECT_GT(lettering.glyph(c).width, 4);
        EXPECT_NE(picture(c), missing) << static_cast<std::uint32_t>(c);
    }
    EXPECT_NE(picture(U'ก'), picture(U'ა'));
}

TEST(Lettering, KernsWhereTheFontHasAKernTable) {
    ASSERT_FALSE(dejavu().empty()) << "install fonts-dejavu-core";
    Lettering lettering = from([](char32_t) { return dejavu(); }, 48);
    EXPECT_LT(lettering.kerning(U'A', U'V'), -1);
    EXPECT_EQ(lettering.kerning(U'H', U'H'), 0);
    const int apart = set_line(lettering, "A").width + set_line(lettering, "V").width;
    EXPECT_LT(set_line(lettering, "AV").width, apart);
}

TEST(Lettering, PlacesCharactersOnWholePixels) {
    Lettering lettering = from(find_font, 17);
    const SetLine line = set_line(lettering, "vehicle");
    ASSERT_EQ(line.characters.size(), 7U);
    for (std::size_t i = 1; i < line.characters.size(); ++i) EXPECT_GT(line.characters[i].x, line.characters[i - 1].x);
}

TEST(Lettering, ReportsAMissingFont) {
    const auto none = Lettering::from_fonts([](char32_t) { return std::string{}; }, 16);
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().text().find("install"), std::string::npos);
    const auto broken = Lettering::from_fonts([](char32_t) { return std::string(__FILE__); }, 16);
    ASSERT_FALSE(broken);
    EXPECT_EQ(broken.error().file, __FILE__);
}

TEST(Lettering, ReturnsAnEmptyGlyphWhenTheSheetIsFull) {
    Lettering lettering(16);
    const std::vector<std::uint8_t> grey(200 * 200, 255);
    char32_t next = 1;
    while (lettering.add(next, 200, 200, grey.data(), 200, 0, -200, 200)) ++next;
    EXPECT_EQ(next, 26U);  // five by five
    EXPECT_EQ(lettering.glyph(next).width, 0);
    EXPECT_EQ(lettering.glyph(1).width, 200);
}

}  // namespace
}  // namespace braitenlab::tests::lettering_test

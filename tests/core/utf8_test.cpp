#include "core/utf8.h"

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace braitenlab::tests::utf8_test {
namespace {

// The code points, with their sizes in bytes.
std::vector<std::pair<char32_t, std::size_t>> code_points(std::string_view text) {
    std::vector<std::pair<char32_t, std::size_t>> found;
    while (!text.empty()) {
        const CodePoint first = first_code_point(text);
        EXPECT_EQ(first.is_valid, is_utf8(text.substr(0, first.size)));
        found.emplace_back(first.code, first.size);
        text.remove_prefix(first.size);
    }
    return found;
}

TEST(Utf8, ReadsTheFirstAndLastCodePointOfEachLength) {
    const std::string text = "\x01\x7F\xC2\x80\xDF\xBF\xE0\xA0\x80\xEF\xBF\xBF\xF0\x90\x80\x80\xF4\x8F\xBF\xBF";
    EXPECT_TRUE(is_utf8(text));
    const std::vector<std::pair<char32_t, std::size_t>> expected{{1, 1},     {0x7F, 1},   {0x80, 2},    {0x7FF, 2},
                                                                 {0x800, 3}, {0xFFFF, 3}, {0x10000, 4}, {0x10FFFF, 4}};
    EXPECT_EQ(code_points(text), expected);
    EXPECT_EQ(count_characters(text), expected.size());
}

TEST(Utf8, ReplacesEachBeginningOfACharacterAndEachOtherByte) {
    struct Case {
        std::string bytes;
        std::vector<std::size_t> sizes;
    };
    for (const auto& [bytes, sizes] : {Case{"\xFF", {1}}, Case{"\xC0\xAF", {1, 1}},  // overlong
                                       Case{"\xE0\x80\x80", {1, 1, 1}},              // overlong
                                       Case{"\xED\xA0\x80", {1, 1, 1}},              // half of a surrogate pair
                                       Case{"\xF4\x90\x80\x80", {1, 1, 1, 1}},       // beyond the last code point
                                       Case{"\xC3", {1}}, Case{"\xE2\x86", {2}}, Case{"\xF0\x9F\x98", {3}}}) {
        EXPECT_FALSE(is_utf8(bytes));
        std::vector<std::size_t> found;
        for (const auto& [code, size] : code_points(bytes)) {
            EXPECT_EQ(code, char32_t{0xFFFD});
            found.push_back(size);
        }
        EXPECT_EQ(found, sizes);
    }
    EXPECT_TRUE(is_utf8("\xEF\xBF\xBD")) << "the replacement itself";
}

TEST(Utf8, CutsBetweenCharacters) {
    EXPECT_EQ(utf8_cut("aé→", 7), "aé→");
    EXPECT_EQ(utf8_cut("aé→", 5), "aé");
    EXPECT_EQ(utf8_cut("aé→", 3), "aé");
    EXPECT_EQ(utf8_cut("aé→", 2), "a");
    EXPECT_EQ(utf8_cut("→", 2), "");
    EXPECT_EQ(character_start("aé→", 4), 3u);
    EXPECT_EQ(character_start("aé→", 99), 6u);
}

}  // namespace
}  // namespace braitenlab::tests::utf8_test

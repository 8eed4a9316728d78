// GIF files, read by ImageMagick.
#include "app/pictures/gif.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/maths/random.h"
#include "tests/folder.h"

namespace braitenlab::tests::gif_test {
namespace {

constexpr int width = 203, height = 151;
using Pixels = std::vector<unsigned char>;

Pixels plain(Rgb colour) {
    Pixels rgb;
    for (int i = 0; i < width * height; ++i) rgb.insert(rgb.end(), colour.begin(), colour.end());
    return rgb;
}

Pixels with_box(Pixels rgb, int left, int top, Rgb colour) {
    for (int y = top; y < top + 9; ++y)
        for (int x = left; x < left + 11; ++x)
            std::copy(colour.begin(), colour.end(), rgb.begin() + (y * width + x) * 3);
    return rgb;
}

bool has_imagemagick() {
    static const bool found = std::system("identify -version") == 0;
    return found;
}

// The pictures of a file as a viewer shows them, one after the other.
std::vector<Pixels> shown(const Folder& folder, const std::string& gif) {
    put_text(folder / "a.gif", gif);
    const std::string raw = (folder / "raw").string();
    const std::string line = fmt::format("convert {} -coalesce -depth 8 rgb:{}", (folder / "a.gif").string(), raw);
    EXPECT_EQ(std::system(line.c_str()), 0);
    const std::string bytes = text_of(raw);
    std::vector<Pixels> pictures;
    constexpr std::size_t size = std::size_t{width} * height * 3;
    for (std::size_t at = 0; at + size <= bytes.size(); at += size)
        pictures.emplace_back(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                              bytes.begin() + static_cast<std::ptrdiff_t>(at + size));
    return pictures;
}

std::string gif_of(const std::vector<Pixels>& pictures) {
    ColourCount colours;
    for (const Pixels& rgb : pictures) colours.add(rgb);
    GifWriter writer(width, height, colours.choose(255), 5);
    std::string gif = writer.begin();
    for (const Pixels& rgb : pictures) gif += writer.picture(rgb);
    return gif + GifWriter::end();
}

int largest_difference(const Pixels& a, const Pixels& b) {
    int largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(int{a[i]} - int{b[i]}));
    return largest;
}

TEST(Gif, ShowsEachPictureAsItWas) {
    if (!has_imagemagick()) GTEST_SKIP() << "ImageMagick is not installed";
    const Folder folder;
    const Pixels ground = plain({20, 40, 90});
    std::vector<Pixels> pictures{ground};
    for (int i = 0; i < 6; ++i) pictures.push_back(with_box(ground, 5 + 7 * i, 3 + 5 * i, {250, 200, 30}));
    const auto seen = shown(folder, gif_of(pictures));
    ASSERT_EQ(seen.size(), pictures.size());
    for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_LE(largest_difference(seen[i], pictures[i]), 3) << i;
}

// The table of sequences is filled and cleared many times.
TEST(Gif, KeepsNoise) {
    if (!has_imagemagick()) GTEST_SKIP() << "ImageMagick is not installed";
    const Folder folder;
    maths::Random chance(3, 0);
    const auto colours =
        std::to_array<Rgb>({{10, 10, 10}, {250, 10, 10}, {10, 250, 10}, {10, 10, 250}, {250, 250, 250}});
    std::vector<Pixels> pictures;
    for (int i = 0; i < 3; ++i) {
        Pixels rgb;
        for (int p = 0; p < width * height; ++p) {
            const Rgb& colour = colours[chance.next() % colours.size()];
            rgb.insert(rgb.end(), colour.begin(), colour.end());
        }
        pictures.push_back(rgb);
    }
    const auto seen = shown(folder, gif_of(pictures));
    ASSERT_EQ(seen.size(), 3U);
    EXPECT_LE(largest_difference(seen[0], pictures[0]), 3);
}

TEST(Gif, StoresOnlyWhatChanges) {
    const Pixels ground = plain({20, 40, 90});
    const std::string still = gif_of({ground, ground, ground});
    const std::string moving = gif_of({ground, with_box(ground, 5, 5, {250, 200, 30}), ground});
    const std::string one = gif_of({ground});
    EXPECT_LT(still.size(), one.size() + 80) << "a picture that does not change takes some thirty bytes";
    EXPECT_GT(moving.size(), still.size());
    EXPECT_LT(moving.size(), still.size() + 200);
}

TEST(Gif, BringsSmallDifferencesAtLastWhereMuchChanges) {
    if (!has_imagemagick()) GTEST_SKIP() << "ImageMagick is not installed";
    const Folder folder;
    maths::Random chance(7, 0);
    std::vector<Pixels> pictures;
    for (int i = 0; i < 90; ++i) {  // noise in the upper half; a small change of the lower half
        Pixels rgb = plain({static_cast<std::uint8_t>(i < 20 ? 60 : 68), 60, 60});
        for (int p = 0; p < width * (height / 2) * 3; ++p)
            rgb[static_cast<std::size_t>(p)] = chance.next() % 2 == 0 ? 0 : 255;
        pictures.push_back(rgb);
    }
    const auto seen = shown(folder, gif_of(pictures));
    ASSERT_EQ(seen.size(), pictures.size());
    const std::size_t below = std::size_t{width} * (height / 2 + 1) * 3;
    for (std::size_t i = below; i < seen.back().size(); i += 3) ASSERT_NEAR(seen.back()[i], 68, 3) << "pixel " << i / 3;
    const std::size_t noise = std::size_t{width} * (height / 2) * 3 / 8;  // bytes of a picture, at least
    EXPECT_LT(gif_of(pictures).size(), noise * pictures.size()) << "every other picture is left out";
}

TEST(Gif, TellsItsSizeTheTimeOfAPictureAndThatItRepeats) {
    const std::string gif = gif_of({plain({1, 2, 3}), plain({200, 2, 3})});
    EXPECT_EQ(gif.substr(0, 6), "GIF89a");
    EXPECT_EQ(static_cast<unsigned char>(gif[6]), width);
    EXPECT_EQ(static_cast<unsigned char>(gif[8]), height);
    EXPECT_NE(gif.find("NETSCAPE2.0"), std::string::npos);
    EXPECT_NE(gif.find(std::string("\x21\xf9\x04\x05\x05\x00", 6)), std::string::npos) << "5 hundredths of a second";
    EXPECT_EQ(gif.back(), ';');
}

}  // namespace
}  // namespace braitenlab::tests::gif_test

#include "app/files/png.h"

#include <cstdlib>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <zlib.h>

namespace braitenlab::tests::png_test {
namespace {

std::size_t number_at(const std::string& file, std::size_t at) {
    std::size_t number = 0;
    for (std::size_t i = 0; i < 4; ++i) number = number << 8 | static_cast<unsigned char>(file[at + i]);
    return number;
}

// The pixels of a file with one chunk of data, by the rules of the recommendation for the filters 1 and 2.
std::vector<unsigned char> pixels_of(const std::string& file, std::size_t width, std::size_t height) {
    std::size_t at = 8;
    std::vector<unsigned char> rows(height * (1 + 3 * width)), rgb;
    for (std::string type; type != "IEND";) {
        const std::size_t size = number_at(file, at);
        type = file.substr(at + 4, 4);
        const auto* checked = reinterpret_cast<const Bytef*>(file.data()) + at + 4;
        EXPECT_EQ(crc32(0, checked, static_cast<uInt>(size + 4)), number_at(file, at + 8 + size)) << type;
        auto room = static_cast<uLongf>(rows.size());
        if (type == "IHDR") {
            EXPECT_EQ(number_at(file, at + 8), width);
            EXPECT_EQ(number_at(file, at + 12), height);
        } else if (type == "IDAT") {
            EXPECT_EQ(uncompress(rows.data(), &room, checked + 4, static_cast<uLong>(size)), Z_OK);
            EXPECT_EQ(room, rows.size());
        }
        at += 12 + size;
    }
    EXPECT_EQ(at, file.size());
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t i = 0; i < 3 * width; ++i) {
            const unsigned char filter = rows[y * (1 + 3 * width)];
            EXPECT_TRUE(filter == 1 || filter == 2);
            const int left = i < 3 ? 0 : rgb[rgb.size() - 3], up = y == 0 ? 0 : rgb[rgb.size() - 3 * width];
            rgb.push_back(static_cast<unsigned char>(rows[y * (1 + 3 * width) + 1 + i] + (filter == 1 ? left : up)));
        }
    return rgb;
}

TEST(Png, HoldsThePixels) {
    constexpr std::size_t width = 7, height = 5;
    std::vector<unsigned char> rgb(3 * width * height);
    unsigned state = 1;
    for (unsigned char& byte : rgb) byte = static_cast<unsigned char>((state = state * 1664525u + 1013904223u) >> 24u);
    const std::string file = png(width, height, rgb);
    EXPECT_EQ(file.substr(0, 8), "\x89PNG\r\n\x1a\n");
    EXPECT_EQ(pixels_of(file, width, height), rgb);
}

TEST(Png, IsSmallForAnEvenPicture) {
    EXPECT_LT(png(640, 480, std::vector<unsigned char>(640 * 480 * 3, 90)).size(), 4000u);
}

}  // namespace
}  // namespace braitenlab::tests::png_test

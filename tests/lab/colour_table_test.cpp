// Few colours for many.
#include "app/pictures/colour_table.h"

#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

namespace braitenlab::tests::colour_table_test {
namespace {

int distance(const Rgb& a, const Rgb& b) {
    int most = 0;
    for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(int{a[c]} - int{b[c]}));
    return most;
}

std::vector<unsigned char> repeated(Rgb colour, int times) {
    std::vector<unsigned char> rgb;
    for (int i = 0; i < times; ++i) rgb.insert(rgb.end(), colour.begin(), colour.end());
    return rgb;
}

TEST(ColourTable, KeepsFewColoursAsTheyAre) {
    const std::vector<Rgb> few{{0, 0, 0}, {255, 255, 255}, {17, 90, 200}, {200, 40, 30}};
    ColourCount count;
    for (const Rgb& colour : few) count.add(repeated(colour, 50));
    const std::vector<Rgb> chosen = count.choose(255);
    EXPECT_EQ(chosen.size(), few.size());
    for (const Rgb& colour : few) EXPECT_NE(std::find(chosen.begin(), chosen.end(), colour), chosen.end());
}

TEST(ColourTable, KeepsTheColourOfASmallThingBesideALargeGround) {
    ColourCount count;
    for (int i = 0; i < 256; ++i) {
        const auto grey = static_cast<std::uint8_t>(i);
        count.add(repeated({grey, grey, grey}, 20000));
    }
    const Rgb small{250, 30, 200};
    count.add(repeated(small, 20));
    const std::vector<Rgb> chosen = count.choose(32);
    EXPECT_EQ(chosen.size(), 32U);
    EXPECT_TRUE(std::any_of(chosen.begin(), chosen.end(), [&](const Rgb& c) { return distance(c, small) < 3; }));
}

TEST(ColourTable, FindsTheNearestColour) {
    ColourTable table({{0, 0, 0}, {100, 100, 100}, {200, 200, 200}, {200, 0, 0}});
    EXPECT_EQ(table.nearest({8, 3, 5}, 0, 0), 0);
    EXPECT_EQ(table.nearest({190, 205, 199}, 1, 0), 2);
    EXPECT_EQ(table.nearest({160, 20, 30}, 2, 3), 3);
    EXPECT_EQ(table.nearest({160, 20, 30}, 2, 3), 3) << "the second time from what is known";
}

TEST(ColourTable, DithersByPlaceAndNotByTime) {
    ColourTable table({{100, 100, 100}, {104, 104, 104}});
    int first = 0, second = 0;
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) {
            const int number = table.nearest({102, 102, 102}, x, y);
            EXPECT_EQ(table.nearest({102, 102, 102}, x, y), number);
            EXPECT_EQ(table.nearest({102, 102, 102}, x + 4, y + 8), number);
            ++(number == 0 ? first : second);
        }
    EXPECT_GT(first, 3);
    EXPECT_GT(second, 3);
    EXPECT_EQ(table.nearest({112, 112, 112}, 1, 1), 1) << "only by a few levels";
}

}  // namespace
}  // namespace braitenlab::tests::colour_table_test

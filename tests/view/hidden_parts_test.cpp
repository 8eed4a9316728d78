#include "render/view/hidden_parts.h"

#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace braitenlab::tests::hidden_parts_test {
namespace {

TEST(HiddenParts, EachPixelIsHiddenOrInOneVisiblePart) {
    std::mt19937 random(7);
    const auto upto = [&](int most) { return static_cast<float>(random() % static_cast<unsigned>(most)); };
    const Rect window{0, 0, 64, 48};
    for (int round = 0; round < 200; ++round) {
        std::vector<Rect> hidden;
        for (int i = 0; i < round % 8; ++i) hidden.push_back({upto(64) - 8, upto(48) - 8, 1 + upto(40), 1 + upto(40)});
        const std::vector<Rect> visible = visible_parts(window, hidden);
        for (float y = 0.5f; y < window.h; ++y)
            for (float x = 0.5f; x < window.w; ++x) {
                const auto has = [&](const Rect& part) { return part.contains(x, y); };
                const auto parts = std::count_if(visible.begin(), visible.end(), has);
                ASSERT_EQ(parts, std::none_of(hidden.begin(), hidden.end(), has)) << "round " << round;
            }
    }
}

TEST(HiddenParts, LeaveOutTheRoundCornersOfCards) {
    Picture picture;
    picture.opaque = {{10, 20, 30, 40}, {0, 0, 9, 9}};
    EXPECT_EQ(hidden_parts(picture), (std::vector<Rect>{{15, 25, 20, 30}}));
    picture.pixel_scale = 2;
    EXPECT_EQ(hidden_parts(picture), (std::vector<Rect>{{20, 30, 10, 20}}));
}

}  // namespace
}  // namespace braitenlab::tests::hidden_parts_test

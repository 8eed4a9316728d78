#include "core/brain/curve.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "core/brain/graph.h"

namespace braitenlab::tests::curve_test {
namespace {

TEST(Curve, EveryResponseHasAUniqueWord) {
    std::set<std::string_view> seen;
    for (const ResponseTraits& row : responses) {
        EXPECT_FALSE(row.word.empty());
        EXPECT_TRUE(seen.insert(row.word).second) << row.word;
    }
}

TEST(Curve, EveryResponseStaysInItsRangeForInputsOfOne) {
    for (const ResponseTraits& row : responses)
        for (int i = -20; i <= 20; ++i) {
            const float y = respond({row.value}, static_cast<float>(i) / 20);
            EXPECT_GE(y, row.low) << row.word << " at " << i;
            EXPECT_LE(y, row.high) << row.word << " at " << i;
        }
}

// Whether respond() differs for some input when the curve is replaced.
bool differ(const Curve& one, const Curve& other) {
    for (int i = -40; i <= 40; ++i) {
        const float x = static_cast<float>(i) / 20;
        if (respond(one, x) != respond(other, x)) return true;
    }
    return false;
}

TEST(Curve, PeakAndWidthChangeOnlyTheResponsesThatHaveThem) {
    for (const ResponseTraits& row : responses) {
        EXPECT_EQ(differ({row.value, 0.5f, 0.2f}, {row.value, -0.25f, 0.2f}), row.has_peak) << row.word;
        EXPECT_EQ(differ({row.value, 0.5f, 0.2f}, {row.value, 0.5f, 0.7f}), row.has_width) << row.word;
    }
}

TEST(Curve, EveryResponseIsFiniteAtTheEndsOfItsParameters) {
    for (const ResponseTraits& row : responses)
        for (const float peak : {-limits::peak, limits::peak})
            for (const float width : {limits::least_width, limits::width})
                for (const float x : {-1e3f, -1.0f, 0.0f, 1.0f, 1e3f})
                    EXPECT_TRUE(std::isfinite(respond({row.value, peak, width}, x))) << row.word << " at " << x;
}

TEST(Curve, HumpDecreasesOnBothSidesOfItsPeak) {
    const Curve hump{Response::hump, 0.5f, 0.2f};
    EXPECT_EQ(respond(hump, 0.5f), 1);
    EXPECT_NEAR(respond(hump, 0.7f), std::exp(-1.0f), 1e-6f);
    EXPECT_FLOAT_EQ(respond(hump, 0.3f), respond(hump, 0.7f));
}

TEST(Curve, StepIsOneAndSigmoidIsHalfAtThePeak) {
    EXPECT_EQ(respond({Response::step, 0.5f}, 0.49f), 0);
    EXPECT_EQ(respond({Response::step, 0.5f}, 0.5f), 1);
    EXPECT_FLOAT_EQ(respond({Response::sigmoid, 0.5f}, 0.5f), 0.5f);
}

}  // namespace
}  // namespace braitenlab::tests::curve_test

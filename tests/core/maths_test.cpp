#include <cmath>

#include <gtest/gtest.h>

#include "core/maths/angle.h"
#include "core/maths/geometry.h"
#include "core/maths/mat4.h"
#include "core/maths/portable.h"
#include "core/maths/random.h"

namespace braitenlab::maths {
namespace {

TEST(Portable, SineAgreesWithTheLibraryInFloatPrecision) {
    for (float a = -50; a < 50; a += 0.0137f) {
        EXPECT_NEAR(sine(a), std::sin(static_cast<double>(a)), 6e-8) << a;
        EXPECT_NEAR(cosine(a), std::cos(static_cast<double>(a)), 6e-8) << a;
    }
}

TEST(Portable, ArcTangentAgreesWithTheLibraryInAllQuadrants) {
    for (float a = -3.14f; a < 3.14f; a += 0.0113f)
        for (const float r : {1e-3f, 1.0f, 250.0f}) {
            const float x = r * std::cos(a), y = r * std::sin(a);
            EXPECT_NEAR(arctangent2(y, x), std::atan2(static_cast<double>(y), static_cast<double>(x)), 3e-7) << a;
        }
    EXPECT_EQ(arctangent2(0, 0), 0);
}

TEST(Portable, ExponentialAgreesWithTheLibraryAndNeverOverflows) {
    for (float x = -80; x < 80; x += 0.37f)
        EXPECT_NEAR(exponential(x) / std::exp(static_cast<double>(x)), 1, 2e-7) << x;
    EXPECT_TRUE(std::isfinite(exponential(1e9f)));
    EXPECT_EQ(exponential(-1e9f), 0);
    for (float x = 1e-30f; x < 1e30f; x *= 1.37f)
        EXPECT_NEAR(logarithm(x), std::log(static_cast<double>(x)), 1e-12 * (1 + std::fabs(std::log(x)))) << x;
    for (const float p : {0.3f, 0.7f, 1.0f, 2.5f})
        for (float x = 1e-6f; x < 1e6f; x *= 1.9f)
            EXPECT_NEAR(power(x, p) / std::pow(static_cast<double>(x), static_cast<double>(p)), 1, 3e-6) << x;
    EXPECT_EQ(power(0, 0.7f), 0);
    EXPECT_TRUE(std::isfinite(power(3e38f, 3)));
}

TEST(Angle, WrapAngleKeepsTheDirection) {
    for (float a = -20; a < 20; a += 0.31f) {
        const float wrapped = wrap_angle(a);
        EXPECT_GE(wrapped, -pi);
        EXPECT_LT(wrapped, pi + 1e-6f);
        EXPECT_NEAR(std::cos(wrapped), std::cos(a), 1e-5f);
    }
}

TEST(Mat4, TheInverseUndoesAView) {
    const mat4 m = orthographic(-3, 4, -2, 5, 0.1f, 100) * look_at({3, 4, 5}, {0, 0, 0}, {0, 1, 0});
    const mat4 identity = m * inverse(m);
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) EXPECT_NEAR(identity[c][r], c == r ? 1 : 0, 2e-3f);
}

TEST(Random, RepeatsForEqualSeedsAndDiffersBetweenStreams) {
    Random a(7, 1), b(7, 1), c(7, 2);
    const auto first = a.next();
    EXPECT_EQ(first, b.next());
    EXPECT_NE(first, c.next());
    for (int i = 0; i < 10000; ++i) {
        const float x = a.uniform(-2, 3);
        EXPECT_GE(x, -2);
        EXPECT_LT(x, 3);
    }
}

}  // namespace
}  // namespace braitenlab::maths

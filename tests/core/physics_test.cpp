#include "core/world/physics.h"

#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "core/maths/random.h"
#include "tests/core/scenes.h"

namespace braitenlab {
namespace {

// On other systems Box2D has the C library's sine and cosine; see core/world/physics.cpp.
#if defined(__ELF__)
TEST(Box2D, TurnsBodiesByOurOwnSineAndCosineSoThatNoProcessorChangesARun) {
    const Scene scene;
    maths::Random chance{5, 1};
    for (int i = 0; i < 2000; ++i) {
        Physics physics(scene, {});
        const float heading = chance.uniform(-40, 40);
        physics.add(0, 0, Body{}, at_rest({0, 0, heading}));
        const Motion now = physics.motion(0);
        EXPECT_EQ(now.ahead, maths::direction(heading)) << heading;
    }
}
#endif

TEST(Box2D, SineAndCosineOfTheWholeProgramAreExactFarOutAndForWhatIsNoNumber) {
    for (const float angle : {0.0f, 1e-7f, 3.0f, 12345.6f, 1e5f, 3e8f, 1e30f}) {
        EXPECT_FLOAT_EQ(std::sin(angle), static_cast<float>(std::sin(static_cast<double>(angle)))) << angle;
        EXPECT_FLOAT_EQ(std::cos(-angle), static_cast<float>(std::cos(static_cast<double>(angle)))) << angle;
    }
    EXPECT_TRUE(std::isnan(std::sin(INFINITY)));
    EXPECT_TRUE(std::isnan(std::cos(NAN)));
    EXPECT_TRUE(std::signbit(std::sin(-0.0f)));
}

}  // namespace
}  // namespace braitenlab

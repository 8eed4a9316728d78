#include "core/maths/degrees.h"

#include <string>

#include <gtest/gtest.h>

#include "core/maths/angle.h"
#include "core/scene/toml_writer.h"

namespace braitenlab::tests::degrees_test {
namespace {

TEST(Degrees, OfAnEditedObjectAreWholeInAFile) {
    for (int degrees = -180; degrees <= 180; ++degrees) {
        EXPECT_EQ(toml_text::degrees(maths::from_degrees(degrees)), std::to_string(degrees));
        const float near = maths::radians(static_cast<float>(degrees) + 0.4f);
        EXPECT_EQ(toml_text::degrees(maths::to_degree_steps(near)), std::to_string(degrees));
    }
}

TEST(Degrees, GoToTheNearestStep) {
    EXPECT_EQ(maths::to_degree_steps(maths::radians(38), 15), maths::from_degrees(45));
    EXPECT_EQ(maths::to_degree_steps(maths::radians(-8), 15), maths::from_degrees(-15));
}

}  // namespace
}  // namespace braitenlab::tests::degrees_test

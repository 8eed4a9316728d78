#include "ui/widgets/number.h"

#include <cmath>

#include <gtest/gtest.h>

namespace braitenlab::tests::number_test {

using namespace ui;

TEST(Number, KeepTheirDigits) {
    EXPECT_EQ(fixed(0.8f, 2), "0.80");
    EXPECT_EQ(fixed(12.4f, 1), "12.4");
    EXPECT_EQ(with_sign(0.8f, 2), "+0.80");
    EXPECT_EQ(with_sign(-0.8f, 2), "−0.80");
}

TEST(Number, HaveTheDecimalMarkOfTheLanguage) {
    EXPECT_EQ(fixed(0.8f, 2, ','), "0,80");
    EXPECT_EQ(with_sign(-12.5f, 1, ','), "−12,5");
    EXPECT_EQ(with_sign(-0.001f, 2, ','), "0,00");
    EXPECT_EQ(as_factor(-1, 2, ','), "(−1,00)");
}

TEST(Number, AreInBracketsAsANegativeFactor) {
    EXPECT_EQ(as_factor(0.4f, 2), "0.40");
    EXPECT_EQ(as_factor(-1, 2), "(−1.00)");
    EXPECT_EQ(as_factor(-0.001f, 2), "0.00");
}

TEST(Number, ShowZeroWithoutASign) {
    EXPECT_EQ(with_sign(-0.0f, 2), "0.00");
    EXPECT_EQ(with_sign(-0.001f, 2), "0.00");
    EXPECT_EQ(fixed(-0.001f, 2), "0.00");
}

TEST(Number, ShowADashForNonFiniteValues) {
    EXPECT_EQ(fixed(INFINITY, 2), "—");
    EXPECT_EQ(fixed(NAN, 2), "—");
    EXPECT_EQ(with_sign(INFINITY, 2), "—");
}

TEST(Number, AcceptUsualNotationAndRefuseOtherText) {
    EXPECT_FLOAT_EQ(typed_number("0,5").value(), 0.5f);
    EXPECT_FLOAT_EQ(typed_number(" −1.25 ").value(), -1.25f);
    EXPECT_FLOAT_EQ(typed_number("+.5").value(), 0.5f);
    for (const char* invalid : {"", "-", "1.2.3", "abc", "1e99", "nan", "inf"})
        EXPECT_FALSE(typed_number(invalid)) << invalid;
}

}  // namespace braitenlab::tests::number_test

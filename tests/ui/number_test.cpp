#include "ui/widgets/number.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/maths/angle.h"
#include "desk.h"
#include "ui/widgets/paint.h"

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

TEST(Number, AreNotBrokenAtTheDecimalMark) {
    Desk desk;
    desk.frame(2);
    Anchors anchors;
    Outbox outbox;
    const Ui ui{desk.strings, {}, {}, 1, anchors, outbox};
    const std::string words = "Linkes Rad schneller: RL·SL = 0,31 und 12,5";
    for (float width = 60; width < 400; width += 1) {
        const std::string lines = wrapped_at_spaces(ui, Face::text, words, width);
        EXPECT_EQ(lines.size(), words.size());
        std::size_t begin = 0;
        for (std::size_t end = 0; end != lines.npos; begin = end + 1) {
            end = lines.find('\n', begin);
            const std::string line = lines.substr(begin, end == lines.npos ? end : end - begin);
            EXPECT_TRUE(text_width(ui, Face::text, line) <= width || line.find(' ') == line.npos) << line;
        }
    }
    EXPECT_EQ(wrapped_at_spaces(ui, Face::text, "a b, c", 1), "a b, c") << "Dear ImGui breaks it";
}

TEST(Number, AcceptUsualNotationAndRefuseOtherText) {
    EXPECT_FLOAT_EQ(typed_number("0,5").value(), 0.5f);
    EXPECT_FLOAT_EQ(typed_number(" −1.25 ").value(), -1.25f);
    EXPECT_FLOAT_EQ(typed_number("+.5").value(), 0.5f);
    for (const char* invalid : {"", "-", "1.2.3", "abc", "1e99", "nan", "inf"})
        EXPECT_FALSE(typed_number(invalid)) << invalid;
}

TEST(Number, MayHaveTheUnitOfTheFieldOrOneOfTheSameKind) {
    EXPECT_FLOAT_EQ(typed_number("0.35 m/s", "m/s").value(), 0.35f);
    EXPECT_FLOAT_EQ(typed_number("35 cm/s", " m/s").value(), 0.35f);
    EXPECT_FLOAT_EQ(typed_number("350mm/s", "m/s").value(), 0.35f);
    EXPECT_FLOAT_EQ(typed_number("12,5 cm", "m").value(), 0.125f);
    EXPECT_FLOAT_EQ(typed_number("20 ms", "s").value(), 0.02f);
    EXPECT_FLOAT_EQ(typed_number("850 g", "kg").value(), 0.85f);
    EXPECT_FLOAT_EQ(typed_number("5 %", "").value(), 0.05f);
    EXPECT_FLOAT_EQ(typed_number("45°", "°").value(), 45);
    EXPECT_FLOAT_EQ(typed_number("0.5 1/s", "1/s").value(), 0.5f);
    EXPECT_FLOAT_EQ(typed_number("7", "m/s").value(), 7);
}

TEST(Number, InAnotherUnitIsRefused) {
    for (const auto& [typed, unit] : {std::pair{"35 kg", "m/s"},
                                      {"35 cm", "m/s"},
                                      {"126 km/h", "m/s"},
                                      {"5 m", ""},
                                      {"5 d", "cd"},
                                      {"5 cm/s²", "m/s²"},
                                      {"5 %", "m"},
                                      {"1 2", ""},
                                      {"5 min", "s"}})
        EXPECT_FALSE(typed_number(typed, unit)) << typed << " in " << unit;
}

TEST(Number, HaveTheDecimalsThatWriteThemExactly) {
    EXPECT_EQ(decimals_of(0.5f, 2, 4), 2);
    EXPECT_EQ(decimals_of(0.005f, 2, 4), 3);
    EXPECT_EQ(decimals_of(0.1735f, 2, 4), 4);
    EXPECT_EQ(decimals_of(1.7945172f, 2, 4), 2) << "a computed number";
    EXPECT_EQ(decimals_of(maths::degrees(maths::radians(45.5f)), 0, 4), 1);
    EXPECT_EQ(decimals_of(268, 0, 4), 0);
    EXPECT_EQ(decimals_of(1234.56f, 2, 4), 2) << "five digits are enough";
}

}  // namespace braitenlab::tests::number_test

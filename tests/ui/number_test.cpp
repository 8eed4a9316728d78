#include "ui/widgets/number.h"

#include <cmath>

#include <gtest/gtest.h>

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

}  // namespace braitenlab::tests::number_test

#include "core/plain_letters.h"

#include <gtest/gtest.h>

namespace braitenlab::tests::plain_letters_test {
namespace {

TEST(PlainLetters, AreSmallWithoutAccents) {
    EXPECT_EQ(plain_letters("Año 2, Ça É", Umlauts::as_vowels), "ano 2, ca e");
    EXPECT_EQ(plain_letters("Übermäßig Öl Æ Þ ÿ ×", Umlauts::as_vowels), "ubermassig ol ae th y -");
    EXPECT_EQ(plain_letters("Ākić İnci Łoś Œuf Řezáč Şen Űj Žižek ſ", Umlauts::spelled),
              "akic inci los ouf rezac sen uj zizek s");
}

TEST(PlainLetters, SpellUmlautsWhereAsked) {
    EXPECT_EQ(plain_letters("Übermäßig Öl Åse", Umlauts::spelled), "uebermaessig oel ase");
}

TEST(PlainLetters, AreTheSameWhereTheAccentIsACharacterOfItsOwn) {
    const std::string decomposed = "U\u0308ber Mu\u0308ller A\u030Ase\u0301 \u0308";
    EXPECT_EQ(plain_letters(decomposed, Umlauts::as_vowels), plain_letters("Über Müller Åsé ", Umlauts::as_vowels));
    EXPECT_EQ(plain_letters(decomposed, Umlauts::spelled), plain_letters("Über Müller Åsé ", Umlauts::spelled));
}

TEST(PlainLetters, LeaveOtherLettersAndBytesAsTheyAre) {
    EXPECT_EQ(plain_letters("Ж→\xC3", Umlauts::spelled), "Ж→\xC3");
}

}  // namespace
}  // namespace braitenlab::tests::plain_letters_test

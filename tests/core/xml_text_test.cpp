#include "core/xml_text.h"

#include <gtest/gtest.h>

namespace braitenlab::tests::xml_text_test {
namespace {

TEST(XmlText, EscapesTheFiveSignsOfXml) {
    EXPECT_EQ(xml_text("<a b=\"c\" d='e'> & ä"), "&lt;a b=&quot;c&quot; d=&#39;e&#39;&gt; &amp; ä");
}

TEST(XmlText, ReplacesBytesThatAreNoUtf8AndControlCharacters) {
    const std::string sign = "\xEF\xBF\xBD";
    EXPECT_EQ(xml_text("a\x01z\n"), "a z\n");
    EXPECT_EQ(xml_text("a\xFFz"), "a" + sign + "z");
    EXPECT_EQ(xml_text("a\xC3"), "a" + sign) << "half of a character";
    EXPECT_EQ(xml_text("\xC0\xAF"), sign + sign) << "a slash in two bytes";
    EXPECT_EQ(xml_text("\xED\xA0\x80"), sign + sign + sign) << "a surrogate";
    EXPECT_EQ(xml_text("\xEF\xBF\xBE"), sign) << "no character of XML";
    EXPECT_EQ(xml_text("a\u202Eb\u2066"), "a" + sign + "b" + sign) << "no mark that turns the order of a line";
    EXPECT_EQ(xml_text("a\x7F\u0085z"), "a  z");
    EXPECT_EQ(xml_text("\xF0\x9F\x98\x80"), "\xF0\x9F\x98\x80");
}

}  // namespace
}  // namespace braitenlab::tests::xml_text_test

#include "app/reports/html.h"

#include <gtest/gtest.h>

namespace braitenlab::tests::html_test {

TEST(Html, EscapesTheFiveSignsOfXml) {
    EXPECT_EQ(html::escaped("<a b=\"c\" d='e'> & ä"), "&lt;a b=&quot;c&quot; d=&#39;e&#39;&gt; &amp; ä");
    EXPECT_EQ(html::with_breaks("1 < 2\n3"), "1 &lt; 2<br/>3");
    EXPECT_EQ(html::element("td", "a<", "good"), "<td class=\"good\">a&lt;</td>");
}

TEST(Html, ReplacesBytesThatAreNoUtf8AndControlCharacters) {
    const std::string sign = "\xEF\xBF\xBD";
    EXPECT_EQ(html::escaped("a\x01z"), "a z");
    EXPECT_EQ(html::escaped("a\xFFz"), "a" + sign + "z");
    EXPECT_EQ(html::escaped("a\xC3"), "a" + sign) << "half of a character";
    EXPECT_EQ(html::escaped("\xC0\xAF"), sign + sign) << "a slash in two bytes";
    EXPECT_EQ(html::escaped("\xED\xA0\x80"), sign + sign + sign) << "a surrogate";
    EXPECT_EQ(html::escaped("\xEF\xBF\xBE"), sign + sign + sign) << "no character of XML";
    EXPECT_EQ(html::escaped("\xF0\x9F\x98\x80"), "\xF0\x9F\x98\x80");
}

}  // namespace braitenlab::tests::html_test

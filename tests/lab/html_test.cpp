#include "app/reports/html.h"

#include <gtest/gtest.h>

namespace braitenlab::tests::html_test {

TEST(Html, EscapesText) {
    EXPECT_EQ(html::with_breaks("1 < 2\n3"), "1 &lt; 2<br/>3");
    EXPECT_EQ(html::element("td", "a<", "good"), "<td class=\"good\">a&lt;</td>");
}

}  // namespace braitenlab::tests::html_test

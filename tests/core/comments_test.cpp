#include "core/scene/comments.h"

#include <gtest/gtest.h>

namespace braitenlab::tests::comments_test {
namespace {

const std::string written =
    "format = 1\ntitle = \"A # in a text\"\n\n[arena]\nwidth = 3\n\n[kind.a.body]\nmass = 0.5\n\n"
    "[[kind.a.body.wheel]]\ny = 0.1\n\n[[kind.a.body.wheel]]\ny = -0.1\n";

TEST(Comments, StandWhereTheyStood) {
    const std::string old =
        "# What it is.\n# (A): assumed\nformat = 1\n[arena]\nwidth = 4  # m\n\n# The body,\n\n# from the data "
        "sheet.\n[kind.a.body]\nmass = 0.6 # kg\n           # (A)\n[[kind.a.body.wheel]]\ny = 0.2\n"
        "[[kind.a.body.wheel]]\ny = -0.2  # half the track\n# The end.\n";
    EXPECT_EQ(with_comments(written, old),
              "# What it is.\n# (A): assumed\nformat = 1\ntitle = \"A # in a text\"\n\n[arena]\nwidth = 3  # m\n\n"
              "# The body,\n\n# from the data sheet.\n[kind.a.body]\nmass = 0.5  # kg\n           # (A)\n\n"
              "[[kind.a.body.wheel]]\ny = 0.1\n\n[[kind.a.body.wheel]]\ny = -0.1  # half the track\n\n# The end.\n");
}

TEST(Comments, OfAKeyThatIsNotWrittenStandBelowItsTable) {
    const std::string old =
        "format = 1\n[arena]\nheight = 6 # as wide\n[kind.a]\nbody.friction = 2 # on wood\n[zone.ice]\n# slippery\nx = "
        "1\n";
    EXPECT_EQ(with_comments(written, old),
              "format = 1\n# slippery\ntitle = \"A # in a text\"\n\n[arena]\n# height: as wide\nwidth = 3\n\n"
              "[kind.a.body]\n# friction: on wood\nmass = 0.5\n\n[[kind.a.body.wheel]]\ny = 0.1\n\n"
              "[[kind.a.body.wheel]]\ny = -0.1\n");
}

TEST(Comments, ASignWithinATextIsNone) {
    EXPECT_EQ(with_comments(written, "title = \"No. #1\"\nstory = \"\"\"\n# not one\nx = 1 # nor this\n\"\"\"\n"),
              written);
    EXPECT_EQ(with_comments(written, ""), written);
}

}  // namespace
}  // namespace braitenlab::tests::comments_test

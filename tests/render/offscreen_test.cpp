// A framebuffer beside the window's.
#include "render/gl/offscreen.h"

#include <utility>

#include "tests/render/stage.h"

namespace braitenlab::render::offscreen_test {
namespace {

TEST(Offscreen, TakesAPictureLargerThanTheWindow) {
    Stage stage(64, 48);
    ASSERT_TRUE(stage.ready()) << stage.problem();
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    Offscreen canvas(3840, 2160);
    ASSERT_TRUE(canvas.ready());
    canvas.bind();
    glViewport(0, 0, 3840, 2160);
    glClearColor(1, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 2160 - 10, 20, 10);  // the upper left corner
    glClearColor(0, 1, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
    canvas.release();
    const auto rgb = canvas.pixels();
    ASSERT_EQ(rgb.size(), std::size_t{3840} * 2160 * 3);
    EXPECT_EQ(rgb[1], 255) << "rows begin at the top";
    EXPECT_EQ(rgb[(std::size_t{3840} * 2159 + 3839) * 3], 255);
    EXPECT_EQ(rgb[(std::size_t{3840} * 2159 + 3839) * 3 + 1], 0);
    EXPECT_EQ(stage.pixel({5, 5}).r, 0) << "the window is left alone";
}

TEST(Offscreen, IsNotReadyBeyondTheLimitOfTheDriver) {
    Stage stage(64, 48);
    ASSERT_TRUE(stage.ready()) << stage.problem();
    EXPECT_GE(Offscreen::largest(), 3840);
    EXPECT_FALSE(Offscreen(Offscreen::largest() + 1, 10).ready());
}

TEST(Offscreen, CanBeMoved) {
    Stage stage(64, 48);
    ASSERT_TRUE(stage.ready()) << stage.problem();
    Offscreen first(8, 8);
    Offscreen second = std::move(first);
    second.bind();
    glClearColor(0, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    second.release();
    EXPECT_EQ(second.pixels()[2], 255);
}

}  // namespace
}  // namespace braitenlab::render::offscreen_test

// Counting errors of the graphics driver, as every window test does.
#include <GL/glew.h>
// GLFW after GLEW: both declare OpenGL, and GLEW insists on being first.
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "app/window.h"

namespace braitenlab::tests::graphics_watch_test {
namespace {

constexpr GLenum no_such_thing = 0xDEAD;

TEST(Window, CountsErrorsOfTheGraphicsDriver) {
    auto window =
        Window::open({.title = "watch", .width = 640, .height = 480, .visible = false, .watch_graphics = true});
    ASSERT_TRUE(window) << window.error().text();
    ASSERT_TRUE(window->watches_graphics()) << "this driver cannot be watched; other tests would miss errors";
    EXPECT_EQ(window->graphics_errors(), 0);
    glEnable(no_such_thing);
    glBindTexture(no_such_thing, 1);
    EXPECT_EQ(window->graphics_errors(), 2);
    auto moved = std::move(*window);
    glEnable(no_such_thing);
    EXPECT_EQ(moved.graphics_errors(), 3) << "also after it has moved";
}

TEST(Window, ReportsThatTheDriverIsNotWatched) {
    auto window = Window::open({.title = "blind", .width = 640, .height = 480, .visible = false});
    ASSERT_TRUE(window) << window.error().text();
    EXPECT_FALSE(window->watches_graphics());
}

}  // namespace
}  // namespace braitenlab::tests::graphics_watch_test

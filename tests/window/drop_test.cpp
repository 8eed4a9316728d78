// Files dropped onto the window and its close button, through the callbacks of GLFW.
#include <GL/glew.h>
// GLFW after GLEW: both declare OpenGL, and GLEW insists on being first.
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include "app/window.h"

namespace braitenlab::tests::drop_test {
namespace {

TEST(Window, ReturnsEachDroppedFileOnceAndInOrder) {
    auto window = Window::open({.title = "drop", .width = 640, .height = 480, .visible = false});
    ASSERT_TRUE(window) << window.error().text();
    GLFWwindow* native = glfwGetCurrentContext();
    const GLFWdropfun drop = glfwSetDropCallback(native, nullptr);
    ASSERT_TRUE(drop);
    const char* files[]{"/tmp/one.toml", "/tmp/zwei ä.run"};
    drop(native, 2, files);
    EXPECT_EQ(window->take_dropped_files(), (std::vector<std::string>{"/tmp/one.toml", "/tmp/zwei ä.run"}));
    EXPECT_TRUE(window->take_dropped_files().empty());
    const char* another[]{"/tmp/three.toml"};
    drop(native, 1, files);
    drop(native, 1, another);
    EXPECT_EQ(window->take_dropped_files().size(), 2u) << "two drops within a frame are two files";
}

TEST(Window, DrawsListsOfManyVertices) {
    auto window = Window::open({.title = "lists", .width = 640, .height = 480, .visible = false});
    ASSERT_TRUE(window) << window.error().text();
    const bool has_offset = ImGui::GetIO().BackendFlags & ImGuiBackendFlags_RendererHasVtxOffset;
    EXPECT_TRUE(has_offset || sizeof(ImDrawIdx) == 4) << "indices of 16 bits end at 65,536 vertices";
}

TEST(Window, CanRefuseToClose) {
    auto window = Window::open({.title = "close", .width = 640, .height = 480, .visible = false});
    ASSERT_TRUE(window) << window.error().text();
    EXPECT_FALSE(window->close_requested());
    glfwSetWindowShouldClose(glfwGetCurrentContext(), GLFW_TRUE);  // as the close button does
    EXPECT_TRUE(window->close_requested());
    window->refuse_close();
    EXPECT_FALSE(window->close_requested());
}

}  // namespace
}  // namespace braitenlab::tests::drop_test

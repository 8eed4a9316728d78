// A hidden window to draw into, and its pixels.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <GL/glew.h>
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "core/maths/vec.h"
#include "render/view/palette.h"

namespace braitenlab::render {

class Stage {
public:
    // Without a display ready() is false and problem() has the reason; run under xvfb-run then.
    Stage(int width, int height, int samples = 0) : width_(width), height_(height) {
        if (!glfwInit()) {
            problem_ = "no display: run the tests under xvfb-run";
            return;
        }
        glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_SAMPLES, samples);
        glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, GLFW_TRUE);
        window_ = glfwCreateWindow(width, height, "stage", nullptr, nullptr);
        if (!window_) {
            problem_ = "no OpenGL 3.3 context: install Mesa's software renderer (libgl1-mesa-dri)";
            return;
        }
        glfwMakeContextCurrent(window_);
        glfwSwapInterval(0);
        glewExperimental = GL_TRUE;
        if (glewInit() != GLEW_OK) problem_ = "GLEW finds no functions";
        glGetError();  // GLEW calls a function that core contexts do not have; clear the error
        listen();
    }
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;
    ~Stage() {
        if (!complaints_.empty()) ADD_FAILURE() << "OpenGL error: " << complaints_;
        if (window_) glfwDestroyWindow(window_);
    }

    bool ready() const { return problem_.empty(); }
    const std::string& problem() const { return problem_; }
    GLFWwindow* window() const { return window_; }

    // Errors reported by the driver since the last call, one per line.
    std::string complaints() { return std::exchange(complaints_, {}); }

    // Rows from the top, three bytes per pixel.
    std::vector<unsigned char> pixels() const {
        const auto row = static_cast<std::size_t>(width_) * 3;
        std::vector<unsigned char> up(row * static_cast<std::size_t>(height_)), down(up.size());
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, up.data());
        for (std::size_t y = 0; y < static_cast<std::size_t>(height_); ++y)
            std::copy_n(&up[(static_cast<std::size_t>(height_) - 1 - y) * row], row, &down[y * row]);
        return down;
    }

    // y down from the top.
    Colour pixel(maths::vec2 at) const {
        unsigned char rgb[3] = {};
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(static_cast<int>(at.x), height_ - 1 - static_cast<int>(at.y), 1, 1, GL_RGB, GL_UNSIGNED_BYTE, rgb);
        return {static_cast<float>(rgb[0]) / 255, static_cast<float>(rgb[1]) / 255, static_cast<float>(rgb[2]) / 255};
    }

private:
    void listen() {
        if (!GLEW_KHR_debug) return;
        glEnable(GL_DEBUG_OUTPUT);
        glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        glDebugMessageCallback(
            [](GLenum source, GLenum type, GLuint, GLenum, GLsizei, const GLchar* text, const void* self) {
                if (source != GL_DEBUG_SOURCE_API) return;  // errors in shaders are returned as Error
                if (type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR)
                    const_cast<Stage*>(static_cast<const Stage*>(self))->complaints_ += std::string(text) + "\n";
            },
            this);
    }

    GLFWwindow* window_ = nullptr;
    int width_, height_;
    std::string problem_, complaints_;
};

}  // namespace braitenlab::render

#include "render/gl/multisample.h"

#include <algorithm>

#include "render/gl/opengl.h"

namespace braitenlab::render {

Multisample::Multisample() {
    glGenFramebuffers(1, &framebuffer_);
    glGenRenderbuffers(1, &colours_);
    glGenRenderbuffers(1, &depths_);
    GLint most = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    samples_ = std::min(most, 4);
}

Multisample::~Multisample() {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteRenderbuffers(1, &colours_);
    glDeleteRenderbuffers(1, &depths_);
}

void Multisample::begin(const Rect& window) {
    GLint has = 0;
    glGetIntegerv(GL_SAMPLES, &has);
    active_ = samples_ > 1 && has == 0;
    if (!active_) return;
    window_ = window;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound_before_);
    const int width = static_cast<int>(window.x + window.w), height = static_cast<int>(window.y + window.h);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    if (width == width_ && height == height_) return;
    width_ = width, height_ = height;
    glBindRenderbuffer(GL_RENDERBUFFER, colours_);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, GL_RGBA8, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colours_);
    glBindRenderbuffer(GL_RENDERBUFFER, depths_);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, GL_DEPTH_COMPONENT24, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depths_);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return;
    samples_ = 0, active_ = false;  // for example too little memory: from now on draw into the window itself
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(bound_before_));
}

void Multisample::end() {
    if (!active_) return;
    active_ = false;
    const auto x0 = static_cast<GLint>(window_.x), y0 = static_cast<GLint>(window_.y);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(bound_before_));
    glBlitFramebuffer(x0, y0, width_, height_, x0, y0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(bound_before_));
}

}  // namespace braitenlab::render

#include "render/gl/resampling.h"

#include <algorithm>
#include <cmath>

#include "render/gl/opengl.h"

namespace braitenlab::render {

Resampling::Resampling() {
    glGenFramebuffers(1, &framebuffer_);
    glGenRenderbuffers(1, &colours_);
    glGenRenderbuffers(1, &depths_);
    GLint most = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    most_samples_ = std::min(most, 4);
    glGetIntegerv(GL_SAMPLES, &samples_of_window_);
}

Resampling::~Resampling() {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteRenderbuffers(1, &colours_);
    glDeleteRenderbuffers(1, &depths_);
}

bool Resampling::begin_smooth(const Rect& window) {
    from_ = to_ = window;
    return most_samples_ > 1 &&
           begin(static_cast<int>(window.x + window.w), static_cast<int>(window.y + window.h), most_samples_);
}

bool Resampling::begin_coarse(const Rect& window, float share) {
    to_ = window;
    from_ = {0, 0, std::max(1.0f, std::round(window.w * share)), std::max(1.0f, std::round(window.h * share))};
    if (!begin(static_cast<int>(from_.w), static_cast<int>(from_.h), 0)) return false;
    glViewport(0, 0, width_, height_);
    return true;
}

bool Resampling::begin(int width, int height, int samples) {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound_before_);
    GLint has = samples_of_window_;
    if (bound_before_ != 0) glGetIntegerv(GL_SAMPLES, &has);  // in a browser it waits for the last frame
    if (has > 0 || no_memory_) return false;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    if (width != width_ || height != height_ || samples != samples_) {
        width_ = width, height_ = height, samples_ = samples;
        glBindRenderbuffer(GL_RENDERBUFFER, colours_);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA8, width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colours_);
        glBindRenderbuffer(GL_RENDERBUFFER, depths_);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH_COMPONENT24, width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depths_);
        glBindRenderbuffer(GL_RENDERBUFFER, 0);
        no_memory_ = glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE;
    }
    active_ = !no_memory_;  // else: from now on draw into the window itself
    if (no_memory_) glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(bound_before_));
    return active_;
}

void Resampling::end() {
    if (!active_) return;
    active_ = false;
    const auto left = [](const Rect& r) { return static_cast<GLint>(r.x); };
    const auto low = [](const Rect& r) { return static_cast<GLint>(r.y); };
    const auto right = [](const Rect& r) { return static_cast<GLint>(r.x + r.w); };
    const auto high = [](const Rect& r) { return static_cast<GLint>(r.y + r.h); };
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(bound_before_));
    glBlitFramebuffer(left(from_), low(from_), right(from_), high(from_), left(to_), low(to_), right(to_), high(to_),
                      GL_COLOR_BUFFER_BIT, from_ == to_ ? GL_NEAREST : GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(bound_before_));
}

}  // namespace braitenlab::render

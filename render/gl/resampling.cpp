#include "render/gl/resampling.h"

#include <algorithm>
#include <cmath>

#include "render/gl/opengl.h"

namespace braitenlab::render {

Resampling::Resampling() {
    GLint most = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    most_samples_ = std::min(most, 4);
    glGetIntegerv(GL_SAMPLES, &samples_of_window_);
}

bool Resampling::begin_smooth(const Rect& window) {
    window_ = window;
    return most_samples_ > 1 &&
           begin(static_cast<int>(window.x + window.w), static_cast<int>(window.y + window.h), most_samples_);
}

bool Resampling::begin_coarse(const Rect& window, float share) {
    const auto side = [share](float pixels) { return std::max(1, static_cast<int>(std::lround(pixels * share))); };
    if (!begin(side(window.w), side(window.h), 0)) return false;
    glViewport(0, 0, target_->width(), target_->height());
    return true;
}

bool Resampling::begin(int width, int height, int samples) {
    GLint bound = 0, has = samples_of_window_;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    if (bound != 0) glGetIntegerv(GL_SAMPLES, &has);  // in a browser it waits for the last frame
    if (has > 0) return false;
    if (!target_ || target_->width() != width || target_->height() != height || target_->samples() != samples)
        target_.emplace(width, height, samples);
    active_ = target_->ready();  // else: from now on draw into the window itself, until its size changes
    if (active_) target_->bind();
    return active_;
}

void Resampling::end() {
    if (!active_) return;
    active_ = false;
    target_->release();
    if (target_->samples() == 0) return;
    const auto left = static_cast<GLint>(window_.x), low = static_cast<GLint>(window_.y);
    const auto right = static_cast<GLint>(window_.x + window_.w), high = static_cast<GLint>(window_.y + window_.h);
    GLint bound = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, target_->framebuffer());
    glBlitFramebuffer(left, low, right, high, left, low, right, high, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(bound));
}

}  // namespace braitenlab::render

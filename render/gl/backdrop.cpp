#include "render/gl/backdrop.h"

#include <cstring>

#include "render/gl/opengl.h"

namespace braitenlab::render {

namespace {

// The frame block with the values cleared that the ground does not depend on: time and lamps that do not light it.
FrameBlock ground_of(FrameBlock frame) {
    frame.arena.z = 0;
    frame.counts.x = 0;
    for (std::size_t i = static_cast<std::size_t>(frame.law.z); i < frame.lamps.size(); ++i) frame.lamps[i] = {};
    return frame;
}

FrameBlock upside_down(FrameBlock frame) {
    for (int column = 0; column < 4; ++column) frame.view_projection[column].y = -frame.view_projection[column].y;
    return frame;
}

bool same(const std::optional<FrameBlock>& a, const FrameBlock& b) { return a && std::memcmp(&*a, &b, sizeof b) == 0; }

}  // namespace

Backdrop::Backdrop() { glGenFramebuffers(1, &framebuffer_); }

Backdrop::~Backdrop() { glDeleteFramebuffers(1, &framebuffer_); }

Backdrop::Ground Backdrop::look(const FrameBlock& frame) {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound_);
    if (mirrored_ != (bound_ == 0)) forget();
    mirrored_ = bound_ == 0;
    const FrameBlock ground = ground_of(frame);
    const bool rests = same(last_, ground);
    last_ = ground;
    return same(painted_, ground) ? Ground::kept : rests ? Ground::rests : Ground::moves;
}

FrameBlock Backdrop::begin_painting() {
    const int width = static_cast<int>(last_->window.x), height = static_cast<int>(last_->window.y);
    glGetIntegerv(GL_VIEWPORT, viewport_before_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
    if (width != width_ || height != height_) {
        picture_.resize(width, height);
        glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture_.id(), 0);
        width_ = width, height_ = height;
    }
    glViewport(0, 0, width, height);
    glFrontFace(mirrored_ ? GL_CW : GL_CCW);
    return mirrored_ ? upside_down(*last_) : *last_;
}

void Backdrop::end_painting() {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(bound_));
    glFrontFace(GL_CCW);
    glViewport(viewport_before_[0], viewport_before_[1], viewport_before_[2], viewport_before_[3]);
    painted_ = last_;
}

void Backdrop::copy() const {
    const int left = static_cast<int>(last_->window.z), low = static_cast<int>(last_->window.w);
    const int first = mirrored_ ? height_ : 0, last = height_ - first;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    glBlitFramebuffer(0, first, width_, last, left, low, left + width_, low + height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(bound_));
}

void Backdrop::forget() { painted_.reset(); }

}  // namespace braitenlab::render

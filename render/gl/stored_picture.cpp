#include "render/gl/stored_picture.h"

#include <cstring>

#include "render/gl/opengl.h"

namespace braitenlab::render {

namespace {

FrameBlock upside_down(FrameBlock frame) {
    for (int column = 0; column < 4; ++column) frame.view_projection[column].y = -frame.view_projection[column].y;
    return frame;
}

}  // namespace

FrameBlock ground_of(FrameBlock frame) {
    frame.arena.z = 0;
    frame.counts.x = 0;
    for (std::size_t i = static_cast<std::size_t>(frame.law.z); i < frame.lamps.size(); ++i) frame.lamps[i] = {};
    return frame;
}

StoredPicture::StoredPicture(int frames_of_rest) : frames_of_rest_(frames_of_rest) {
    glGenFramebuffers(1, &framebuffer_);
}

StoredPicture::~StoredPicture() { glDeleteFramebuffers(1, &framebuffer_); }

bool StoredPicture::same(const std::optional<Key>& a, const Key& b) {
    return a && a->instances == b.instances && std::memcmp(&a->frame, &b.frame, sizeof b.frame) == 0;
}

StoredPicture::Content StoredPicture::look(const FrameBlock& frame, std::uint64_t instances) {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound_);
    if (mirrored_ != (bound_ == 0)) forget();
    mirrored_ = bound_ == 0;
    const Key now{frame, instances};
    rested_ = same(last_, now) ? rested_ + 1 : 0;
    last_ = now;
    return same(stored_, now) ? Content::kept : rested_ >= frames_of_rest_ ? Content::rests : Content::moves;
}

void StoredPicture::fit() {
    const int width = static_cast<int>(last_->frame.window.x), height = static_cast<int>(last_->frame.window.y);
    if (width == width_ && height == height_) return;
    picture_.resize(width, height);
    glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture_.id(), 0);
    width_ = width, height_ = height;
}

FrameBlock StoredPicture::begin_painting() {
    glGetIntegerv(GL_VIEWPORT, viewport_before_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
    fit();
    glViewport(0, 0, width_, height_);
    glFrontFace(mirrored_ ? GL_CW : GL_CCW);
    return mirrored_ ? upside_down(last_->frame) : last_->frame;
}

void StoredPicture::end_painting() {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(bound_));
    glFrontFace(GL_CCW);
    glViewport(viewport_before_[0], viewport_before_[1], viewport_before_[2], viewport_before_[3]);
    stored_ = last_;
}

void StoredPicture::store() {
    const int left = static_cast<int>(last_->frame.window.z), low = static_cast<int>(last_->frame.window.w);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(bound_));
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
    fit();
    const int first = mirrored_ ? height_ : 0, last = height_ - first;
    glBlitFramebuffer(left, low, left + width_, low + height_, 0, first, width_, last, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(bound_));
    stored_ = last_;
}

void StoredPicture::copy(std::span<const Rect> parts) const {
    const int left = static_cast<int>(last_->frame.window.z), low = static_cast<int>(last_->frame.window.w);
    const auto row = [this](int y) { return mirrored_ ? height_ - y : y; };
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    for (const Rect& part : parts) {
        const int x0 = static_cast<int>(part.x), x1 = static_cast<int>(part.x + part.w);
        const int y0 = height_ - static_cast<int>(part.y + part.h), y1 = height_ - static_cast<int>(part.y);
        glBlitFramebuffer(x0, row(y0), x1, row(y1), left + x0, low + y0, left + x1, low + y1, GL_COLOR_BUFFER_BIT,
                          GL_NEAREST);
    }
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(bound_));
}

void StoredPicture::forget() { stored_.reset(); }

}  // namespace braitenlab::render

#include "render/gl/offscreen.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "render/gl/opengl.h"

namespace braitenlab::render {

int Offscreen::largest() {
    GLint texture = 0, buffer = 0;
    std::array<GLint, 2> viewport{};
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &buffer);
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
    return std::min({texture, buffer, viewport[0], viewport[1]});
}

Offscreen::Offscreen(int width, int height, int samples) : width_(width), height_(height), samples_(samples) {
    if (std::max(width, height) > largest()) return;
    GLint before = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before);
    glGenFramebuffers(1, &framebuffer_);
    glGenRenderbuffers(1, &depths_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    if (samples == 0) {
        colours_ = std::make_unique<Texture>(Texture::Kind::picture, width, height);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colours_->id(), 0);
    } else {
        glGenRenderbuffers(1, &samples_of_colours_);
        glBindRenderbuffer(GL_RENDERBUFFER, samples_of_colours_);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA8, width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, samples_of_colours_);
    }
    glBindRenderbuffer(GL_RENDERBUFFER, depths_);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH_COMPONENT24, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depths_);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    ready_ = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(before));
}

Offscreen::Offscreen(Offscreen&& other) noexcept : width_(0), height_(0), samples_(0) { *this = std::move(other); }

Offscreen& Offscreen::operator=(Offscreen&& other) noexcept {
    std::swap(width_, other.width_);
    std::swap(height_, other.height_);
    std::swap(samples_, other.samples_);
    std::swap(framebuffer_, other.framebuffer_);
    std::swap(samples_of_colours_, other.samples_of_colours_);
    std::swap(colours_, other.colours_);
    std::swap(depths_, other.depths_);
    std::swap(bound_before_, other.bound_before_);
    std::swap(ready_, other.ready_);
    return *this;
}

Offscreen::~Offscreen() {
    glDeleteFramebuffers(1, &framebuffer_);  // 0 is ignored
    glDeleteRenderbuffers(1, &samples_of_colours_);
    glDeleteRenderbuffers(1, &depths_);
}

void Offscreen::bind() {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound_before_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
}

void Offscreen::release() { glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(bound_before_)); }

std::vector<unsigned char> Offscreen::pixels() const {
    const auto width = static_cast<std::size_t>(width_), height = static_cast<std::size_t>(height_);
    std::vector<std::uint8_t> rgba(width * height * 4);
    GLint before = 0;
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &before);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(before));
    std::vector<unsigned char> rgb(width * height * 3);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x)
            std::copy_n(&rgba[((height - 1 - y) * width + x) * 4], 3, &rgb[(y * width + x) * 3]);
    return rgb;
}

}  // namespace braitenlab::render

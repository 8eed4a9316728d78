#include "render/gl/texture.h"

#include <utility>

#include <GL/glew.h>

namespace braitenlab {

Texture::Texture(Kind kind, int width, int height) {
    const bool numbers = kind == Kind::numbers;
    const GLint filter = numbers ? GL_LINEAR : GL_NEAREST;
    glGenTextures(1, &id_);
    bind();
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexImage2D(GL_TEXTURE_2D, 0, numbers ? GL_R16F : GL_R8, width, height, 0, GL_RED,
                 numbers ? GL_FLOAT : GL_UNSIGNED_BYTE, nullptr);
    glBindTexture(GL_TEXTURE_2D, 0);
}

Texture::Texture(Texture&& other) noexcept : id_(std::exchange(other.id_, 0)) {}

Texture::~Texture() {
    if (id_) glDeleteTextures(1, &id_);
}

void Texture::fill(int first_row, int width, int rows, const std::uint8_t* values) {
    bind();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, first_row, width, rows, GL_RED, GL_UNSIGNED_BYTE, values);
}

void Texture::fill(int first_row, int width, int rows, const float* values) {
    bind();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, first_row, width, rows, GL_RED, GL_FLOAT, values);
}

void Texture::bind() const {
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, id_);
}

}  // namespace braitenlab

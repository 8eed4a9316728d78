#include "render/gl/texture.h"

#include <algorithm>
#include <utility>

#include "render/gl/opengl.h"

namespace braitenlab::render {

Texture::Texture(Kind kind, int width, int height) : kind_(kind) {
    const GLint filter = kind == Kind::bytes ? GL_NEAREST : GL_LINEAR;
    glGenTextures(1, &id_);
    bind();
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, kind == Kind::smooth ? GL_LINEAR_MIPMAP_LINEAR : filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    resize(width, height);
    glBindTexture(GL_TEXTURE_2D, 0);
}

Texture::Texture(Texture&& other) noexcept : kind_(other.kind_), id_(std::exchange(other.id_, 0)) {}

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

void Texture::make_smaller_copies() {
    bind();
    glGenerateMipmap(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, 0);
}

void Texture::resize(int width, int height) {
    struct Storage {
        GLint inside;
        GLenum channels, type;
    };
#ifdef BRAITENLAB_OPENGL_ES
    const Storage picture{GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
#else
    const Storage picture{GL_RGBA, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV};  // the format of most windows
#endif
    const Storage storage = kind_ == Kind::bytes     ? Storage{GL_R8, GL_RED, GL_UNSIGNED_BYTE}
                            : kind_ == Kind::numbers ? Storage{GL_R16F, GL_RED, GL_FLOAT}
                            : kind_ == Kind::picture ? picture
                                                     : Storage{GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
    bind();
    glTexImage2D(GL_TEXTURE_2D, 0, storage.inside, std::max(width, 1), std::max(height, 1), 0, storage.channels,
                 storage.type, nullptr);
}

void Texture::bind() const {
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, id_);
}

}  // namespace braitenlab::render

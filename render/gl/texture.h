// A 2D texture.
#pragma once

#include <cstdint>

namespace braitenlab::render {

class Texture {
public:
    enum class Kind {
        bytes,    // one channel of 0..1 in 8 bits
        numbers,  // one channel of half floats, interpolated linearly
        picture,  // colours, interpolated linearly; a render target, in the window's format where the driver has it
        smooth,   // colours; a render target, interpolated between its smaller copies
    };

    // Precondition until destruction: a current GL context.
    Texture(Kind, int width, int height);
    Texture(Texture&& other) noexcept;
    Texture& operator=(Texture&&) = delete;
    ~Texture();

    // Replaces `rows` rows from `first_row` on, the first `width` samples of each.
    void fill(int first_row, int width, int rows, const std::uint8_t*);
    void fill(int first_row, int width, int rows, const float*);

    // Call after the content of a smooth texture has changed.
    void make_smaller_copies();

    // Discards the content. Sizes below 1 become 1.
    void resize(int width, int height);

    unsigned id() const { return id_; }
    void bind() const;  // to texture unit 0, which all shaders use

private:
    Kind kind_;
    unsigned id_ = 0;
};

}  // namespace braitenlab::render

// A texture of one channel, made once and filled anew as often as needed.
#pragma once

#include <cstdint>

namespace braitenlab {

class Texture {
public:
    enum class Kind { bytes, numbers };  // 8 bits of 0..1; half floats, smooth between samples

    // Needs a current context for its whole life.
    Texture(Kind, int width, int height);
    Texture(Texture&& other) noexcept;
    Texture& operator=(Texture&&) = delete;
    ~Texture();

    // Replaces the rows from `first_row` on, `width` samples of each.
    void fill(int first_row, int width, int rows, const std::uint8_t*);
    void fill(int first_row, int width, int rows, const float*);

    void bind() const;  // to unit 0, which all shaders read from

private:
    unsigned id_ = 0;
};

}  // namespace braitenlab

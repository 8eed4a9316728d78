// A texture, made once and filled anew as often as needed.
#pragma once

#include <cstdint>

namespace braitenlab::render {

class Texture {
public:
    enum class Kind {
        bytes,    // one channel of 0..1 in 8 bits
        numbers,  // one channel of half floats, smooth between samples
        picture,  // colours, to draw into
    };

    // Needs a current context for its whole life.
    Texture(Kind, int width, int height);
    Texture(Texture&& other) noexcept;
    Texture& operator=(Texture&&) = delete;
    ~Texture();

    // Replaces the rows from `first_row` on, `width` samples of each.
    void fill(int first_row, int width, int rows, const std::uint8_t*);
    void fill(int first_row, int width, int rows, const float*);

    // Forgets what is in it. Zero is taken as one.
    void resize(int width, int height);

    unsigned id() const { return id_; }
    void bind() const;  // to unit 0, which all shaders read from

private:
    Kind kind_;
    unsigned id_ = 0;
};

}  // namespace braitenlab::render

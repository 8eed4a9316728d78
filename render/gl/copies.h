// A mesh drawn once per instance without instances of OpenGL: its corners are copied, each with the values of its
// instance.
//
// SwiftShader, with which a browser draws WebGL where there is no graphics hardware, draws each instance as a call of
// its own: 450 instances of a square took eight times as long as their copies.
#pragma once

#include <cstddef>
#include <span>

#include "render/view/shapes.h"

namespace braitenlab::render {

// Creates its GL objects in the constructor. Precondition until destruction: a current GL context.
class Copies {
public:
    // `vectors`: number of vec4 per instance. Shader locations: as Batch.
    Copies(Shape, int vectors);
    Copies(const Copies&) = delete;
    Copies& operator=(const Copies&) = delete;
    ~Copies();

    // Draws the mesh once per instance, in one call. `instances`: all of them, at least one.
    void draw(std::span<const maths::vec4> instances);

private:
    void make_room(std::size_t count);

    Shape shape_;
    std::size_t vectors_;
    unsigned array_ = 0, corners_ = 0, indices_ = 0, values_ = 0;
    std::size_t capacity_ = 0;  // copies in the buffers of corners and indices
};

}  // namespace braitenlab::render

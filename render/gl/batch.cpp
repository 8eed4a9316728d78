#include "render/gl/batch.h"

#include <algorithm>
#include <cassert>

#include <GL/glew.h>

namespace braitenlab {

namespace {

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

constexpr GLuint first_instance_location = 4;

}  // namespace

Batch::Batch(const Shape& shape, int vectors)
    : index_count_(static_cast<int>(shape.indices.size())),
      stride_(static_cast<std::size_t>(vectors) * sizeof(maths::vec4)) {
    glGenVertexArrays(1, &array_);
    glBindVertexArray(array_);

    glGenBuffers(1, &corners_);
    glBindBuffer(GL_ARRAY_BUFFER, corners_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(shape.corners.size() * sizeof(Corner)), shape.corners.data(),
                 GL_STATIC_DRAW);
    const GLsizei corner = sizeof(Corner);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, corner, offset(offsetof(Corner, place)));
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, corner, offset(offsetof(Corner, normal)));
    glEnableVertexAttribArray(2);
    glVertexAttribPointer(2, 1, GL_FLOAT, GL_FALSE, corner, offset(offsetof(Corner, paint)));

    glGenBuffers(1, &indices_);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(shape.indices.size() * sizeof(shape.indices[0])),
                 shape.indices.data(), GL_STATIC_DRAW);

    glGenBuffers(1, &instances_);
    glBindBuffer(GL_ARRAY_BUFFER, instances_);
    for (int i = 0; i < vectors; ++i) {
        const GLuint location = first_instance_location + static_cast<GLuint>(i);
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, 4, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride_),
                              offset(static_cast<std::size_t>(i) * sizeof(maths::vec4)));
        glVertexAttribDivisor(location, 1);
    }
    glBindVertexArray(0);
}

Batch::Batch(Batch&& other) noexcept
    : array_(other.array_),
      corners_(other.corners_),
      indices_(other.indices_),
      instances_(other.instances_),
      index_count_(other.index_count_),
      stride_(other.stride_),
      capacity_(other.capacity_) {
    other.array_ = other.corners_ = other.indices_ = other.instances_ = 0;
}

Batch::~Batch() {
    if (!array_) return;
    for (const GLuint buffer : {corners_, indices_, instances_}) glDeleteBuffers(1, &buffer);
    glDeleteVertexArrays(1, &array_);
}

int Batch::draw(const void* data, std::size_t count, std::size_t size) {
    assert(size == stride_);
    if (count == 0) return 0;
    glBindVertexArray(array_);
    glBindBuffer(GL_ARRAY_BUFFER, instances_);
    // Room for half as many again, so that a growing population does not ask for new memory every time. Giving the old
    // storage up first lets the driver hand out fresh memory instead of waiting for the frame before.
    if (count * size > capacity_) capacity_ = count * size * 3 / 2;
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(capacity_), nullptr, GL_STREAM_DRAW);
    glBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(count * size), data);
    glDrawElementsInstanced(GL_TRIANGLES, index_count_, GL_UNSIGNED_SHORT, nullptr, static_cast<GLsizei>(count));
    return 1;
}

}  // namespace braitenlab

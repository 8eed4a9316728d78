#include "render/gl/copies.h"

#include <cstdint>
#include <utility>
#include <vector>

#include "render/gl/batch.h"
#include "render/gl/opengl.h"

namespace braitenlab::render {

namespace {

template <class Value>
void store(GLenum target, const std::vector<Value>& values, GLenum use) {
    glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(Value)), values.data(), use);
}

}  // namespace

Copies::Copies(Shape shape, int vectors) : shape_(std::move(shape)), vectors_(static_cast<std::size_t>(vectors)) {
    glGenVertexArrays(1, &array_);
    for (GLuint* buffer : {&corners_, &indices_, &values_}) glGenBuffers(1, buffer);
    glBindVertexArray(array_);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
    glBindBuffer(GL_ARRAY_BUFFER, corners_);
    read_corners();
    glBindBuffer(GL_ARRAY_BUFFER, values_);
    read_instances(vectors, 0);
    glBindVertexArray(0);
}

Copies::~Copies() {
    for (const GLuint buffer : {corners_, indices_, values_}) glDeleteBuffers(1, &buffer);
    glDeleteVertexArrays(1, &array_);
}

// Precondition: the array is bound.
void Copies::make_room(std::size_t count) {
    if (count <= capacity_) return;
    capacity_ = count * 3 / 2;
    std::vector<Corner> corners;
    std::vector<std::uint32_t> indices;
    corners.reserve(capacity_ * shape_.corners.size()), indices.reserve(capacity_ * shape_.indices.size());
    for (std::size_t copy = 0; copy < capacity_; ++copy) {
        const auto first = static_cast<std::uint32_t>(corners.size());
        corners.insert(corners.end(), shape_.corners.begin(), shape_.corners.end());
        for (const std::uint16_t index : shape_.indices) indices.push_back(first + index);
    }
    glBindBuffer(GL_ARRAY_BUFFER, corners_);
    store(GL_ARRAY_BUFFER, corners, GL_STATIC_DRAW);
    store(GL_ELEMENT_ARRAY_BUFFER, indices, GL_STATIC_DRAW);
}

void Copies::draw(std::span<const maths::vec4> instances) {
    const std::size_t count = instances.size() / vectors_;
    glBindVertexArray(array_);
    make_room(count);
    std::vector<maths::vec4> values;
    values.reserve(instances.size() * shape_.corners.size());
    for (std::size_t copy = 0; copy < count; ++copy) {
        const auto own = instances.subspan(copy * vectors_, vectors_);
        for (std::size_t corner = 0; corner < shape_.corners.size(); ++corner)
            values.insert(values.end(), own.begin(), own.end());
    }
    glBindBuffer(GL_ARRAY_BUFFER, values_);
    store(GL_ARRAY_BUFFER, values, GL_STREAM_DRAW);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(count * shape_.indices.size()), GL_UNSIGNED_INT, nullptr);
}

}  // namespace braitenlab::render

#include "render/gl/batch.h"

#include <array>
#include <cassert>
#include <utility>

#include "render/gl/opengl.h"

namespace braitenlab::render {

namespace {

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

constexpr GLuint first_instance_location = 4;

}  // namespace

Instances::Instances(int vectors, bool copied) : copied_(copied), vectors_(vectors) { glGenBuffers(1, &buffer_); }

Instances::Instances(Instances&& other) noexcept
    : buffer_(std::exchange(other.buffer_, 0)),
      copied_(other.copied_),
      values_(other.values_),
      vectors_(other.vectors_),
      count_(other.count_),
      capacity_(other.capacity_) {}

Instances::~Instances() {
    if (buffer_) glDeleteBuffers(1, &buffer_);
}

void Instances::upload(const void* data, std::size_t count, std::size_t size) {
    assert(size == static_cast<std::size_t>(vectors_) * sizeof(maths::vec4));
    count_ = static_cast<int>(count);
    if (count == 0) return;
    if (copied_) {
        values_ = {static_cast<const maths::vec4*>(data), count * static_cast<std::size_t>(vectors_)};
        return;
    }
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    // The capacity is 1.5 times the need, so that a growing population reallocates rarely. Discarding the old storage
    // lets the driver return new memory instead of waiting for the previous frame.
    if (count * size > capacity_) capacity_ = count * size * 3 / 2;
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(capacity_), nullptr, GL_STREAM_DRAW);
    glBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(count * size), data);
}

void read_corners() {
    const GLsizei corner = sizeof(Corner);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, corner, offset(offsetof(Corner, place)));
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, corner, offset(offsetof(Corner, normal)));
    glEnableVertexAttribArray(2);
    glVertexAttribPointer(2, 1, GL_FLOAT, GL_FALSE, corner, offset(offsetof(Corner, paint)));
}

void read_instances(int vectors, unsigned divisor) {
    const std::size_t stride = static_cast<std::size_t>(vectors) * sizeof(maths::vec4);
    for (int i = 0; i < vectors; ++i) {
        const GLuint location = first_instance_location + static_cast<GLuint>(i);
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, 4, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                              offset(static_cast<std::size_t>(i) * sizeof(maths::vec4)));
        glVertexAttribDivisor(location, divisor);
    }
}

Batch::Batch(const Shape& shape, const Instances& instances) : index_count_(static_cast<int>(shape.indices.size())) {
    if (instances.copied_) {
        copies_ = std::make_unique<Copies>(shape, instances.vectors_);
        return;
    }
    glGenVertexArrays(1, &array_);
    glBindVertexArray(array_);

    glGenBuffers(1, &corners_);
    glBindBuffer(GL_ARRAY_BUFFER, corners_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(shape.corners.size() * sizeof(Corner)), shape.corners.data(),
                 GL_STATIC_DRAW);
    read_corners();

    glGenBuffers(1, &indices_);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(shape.indices.size() * sizeof(shape.indices[0])),
                 shape.indices.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, instances.buffer_);
    read_instances(instances.vectors_, 1);
    glBindVertexArray(0);
}

Batch Batch::points(const Instances& instances) {
    Batch batch;
    glGenVertexArrays(1, &batch.array_);
    glBindVertexArray(batch.array_);
    glBindBuffer(GL_ARRAY_BUFFER, instances.buffer_);
    read_instances(instances.vectors_, 0);
    glBindVertexArray(0);
    return batch;
}

Batch::Batch(Batch&& other) noexcept
    : array_(std::exchange(other.array_, 0)),
      corners_(std::exchange(other.corners_, 0)),
      indices_(std::exchange(other.indices_, 0)),
      index_count_(other.index_count_),
      copies_(std::move(other.copies_)) {}

Batch::~Batch() {
    if (!array_) return;
    for (const GLuint buffer : {corners_, indices_})
        if (buffer) glDeleteBuffers(1, &buffer);
    glDeleteVertexArrays(1, &array_);
}

int Batch::draw(const Instances& instances) const {
    if (instances.count() == 0) return 0;
    if (copies_) return copies_->draw(instances.values_), 1;
    glBindVertexArray(array_);
    if (index_count_ == 0)
        glDrawArrays(GL_POINTS, 0, instances.count());
    else
        glDrawElementsInstanced(GL_TRIANGLES, index_count_, GL_UNSIGNED_SHORT, nullptr, instances.count());
    return 1;
}

Shape quad() {
    Shape shape;
    for (const auto& [x, y] : {std::pair{-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}})
        shape.corners.push_back({{x, y, 0}, {0, 0, 1}, 0});
    shape.indices = {0, 1, 2, 0, 2, 3};
    return shape;
}

namespace {

// A strip with corners at these x.
Shape strip_at(std::span<const float> along) {
    Shape shape;
    for (const float x : along)
        for (const float y : {-1.0f, 1.0f}) shape.corners.push_back({{x, y, 0}, {0, 0, 1}, 0});
    for (std::size_t i = 0; i + 1 < along.size(); ++i)
        for (const std::size_t k : {0U, 2U, 3U, 0U, 3U, 1U})
            shape.indices.push_back(static_cast<std::uint16_t>(2 * i + k));
    return shape;
}

}  // namespace

Shape strip(int squares) {
    std::vector<float> along;
    for (int i = 0; i <= squares; ++i) along.push_back(static_cast<float>(i) / static_cast<float>(squares));
    return strip_at(along);
}

Shape wire_strip() {
    static constexpr std::array along{0.0f, 0.25f, 0.5f, 0.7f, 0.75f, 0.81f, 0.9f, 1.0f};
    return strip_at(along);
}

Shape fan() {
    Shape shape;
    for (const float i : {0.0f, 1.0f, 2.0f, 3.0f}) shape.corners.push_back({{i, 0, 0}, {0, 0, 1}, 0});
    shape.indices = {0, 1, 2, 0, 2, 3};
    return shape;
}

Shape prism() {
    // As the levels of block.vert: foot of the side, then the rounded edge from the side to the top face.
    constexpr int foot = 0, shoulder = 1, inner = shoulder + prism_edge_steps, top_face = inner + 1;
    Shape shape;
    const auto corner = [&](int edge, int end, int level) {
        shape.corners.push_back(
            {{static_cast<float>(edge), static_cast<float>(end), static_cast<float>(level)}, {}, 0});
    };
    for (int edge = 0; edge < 8; ++edge)
        for (int low = foot; low < inner; ++low) {
            const auto first = static_cast<int>(shape.corners.size());
            for (const auto& [end, level] : {std::pair{0, low}, {1, low}, {1, low + 1}, {0, low + 1}})
                corner(edge, end, level);
            for (const int k : {0, 1, 2, 0, 2, 3}) shape.indices.push_back(static_cast<std::uint16_t>(first + k));
        }
    const auto top = static_cast<int>(shape.corners.size());
    for (int edge = 0; edge < 8; ++edge) corner(edge, 0, top_face);
    for (int edge = 1; edge < 7; ++edge)
        for (const int k : {0, edge, edge + 1}) shape.indices.push_back(static_cast<std::uint16_t>(top + k));
    return shape;
}

Shape skirt() {
    Shape shape;
    for (int edge = 0; edge < 8; ++edge) {
        for (const auto& [end, level] : {std::pair{0, -2}, {1, -2}, {1, -1}, {0, -1}})
            shape.corners.push_back(
                {{static_cast<float>(edge), static_cast<float>(end), static_cast<float>(level)}, {}, 0});
        for (const int k : {0, 1, 2, 0, 2, 3}) shape.indices.push_back(static_cast<std::uint16_t>(4 * edge + k));
    }
    return shape;
}

}  // namespace braitenlab::render

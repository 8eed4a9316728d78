// A mesh drawn once per instance in one draw call, and the meshes whose corners hold numbers: the shaders compute the
// positions.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "render/gl/copies.h"
#include "render/view/shapes.h"

namespace braitenlab::render {

// The instances of one type in graphics memory, uploaded once per frame. Several batches may draw the same instances.
// Creates its GL objects in the constructor. Precondition until destruction: a current GL context.
class Instances {
public:
    // `vectors`: number of vec4 per instance. `copied`: batches draw them as copies (copies.h).
    explicit Instances(int vectors, bool copied = false);
    Instances(Instances&& other) noexcept;
    Instances& operator=(Instances&&) = delete;
    ~Instances();

    // Copied instances stay where they are: the vector is not changed before they are drawn.
    template <class Instance>
    void upload(const std::vector<Instance>& instances) {
        upload(instances.data(), instances.size(), sizeof(Instance));
    }

    int count() const { return count_; }

private:
    friend class Batch;
    void upload(const void* data, std::size_t count, std::size_t size);

    unsigned buffer_ = 0;
    bool copied_ = false;
    std::span<const maths::vec4> values_;  // of copied instances
    int vectors_ = 0, count_ = 0;
    std::size_t capacity_ = 0;  // bytes
};

// A mesh with the layout of its instances. Creates its GL objects in the constructor, as above.
//
// Shader locations: 0 corner, 1 normal, 2 paint, 4 and following the instance's vectors.
class Batch {
public:
    Batch(const Shape&, const Instances&);

    // Without a mesh: every instance is one point, expanded by a geometry shader.
    static Batch points(const Instances&);

    Batch(Batch&& other) noexcept;
    Batch& operator=(Batch&&) = delete;
    ~Batch();

    // Draws the mesh once per instance. Precondition: `instances` is that of the constructor. Returns the number of
    // draw calls: 1, or 0 without instances.
    int draw(const Instances&) const;

private:
    Batch() = default;

    unsigned array_ = 0, corners_ = 0, indices_ = 0;
    int index_count_ = 0;             // 0: points
    std::unique_ptr<Copies> copies_;  // of copied instances
};

// Let the bound vertex array read the locations above from the bound buffer, by corner, or by instance if the divisor
// is 1.
void read_corners();
void read_instances(int vectors, unsigned divisor);

Shape quad();              // x and y −1..1
Shape strip(int squares);  // squares in a row along x from 0 to 1, y from −1 to 1
Shape wire_strip();  // a strip with few squares, most of them at the end of a wire, where its arrowhead or ball is
Shape fan();         // x: number of the corner 0..3, for field.vert

// prism(): sides, rounded edge and top of a prism of up to eight corners, for block.vert: x: number of the edge, y: its
// end 0 or 1, z: level. skirt(): the shadow around its feet.
inline constexpr int prism_edge_steps = 4;  // of the rounded edge; same number in shaders/block.vert
Shape prism();
Shape skirt();

}  // namespace braitenlab::render

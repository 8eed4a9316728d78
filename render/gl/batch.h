// A mesh drawn many times in one call, each time with another instance.
#pragma once

#include <cstddef>
#include <vector>

#include "render/view/shapes.h"

namespace braitenlab::render {

// The graphics side's copy of one kind of thing, uploaded anew once a frame. Several batches may draw the same copy.
// Objects of the graphics library are made in the constructor alone; needs a current context for its whole life.
class Instances {
public:
    // `vectors` of four floats an instance.
    explicit Instances(int vectors);
    Instances(Instances&& other) noexcept;
    Instances& operator=(Instances&&) = delete;
    ~Instances();

    template <class Instance>
    void upload(const std::vector<Instance>& instances) {
        upload(instances.data(), instances.size(), sizeof(Instance));
    }

    int count() const { return count_; }

private:
    friend class Batch;
    void upload(const void* data, std::size_t count, std::size_t size);

    unsigned buffer_ = 0;
    int vectors_ = 0, count_ = 0;
    std::size_t capacity_ = 0;  // bytes
};

// A mesh and how it reads its instances. Objects are made in the constructor alone, as above.
//
// A shader finds the corner at locations 0 (place), 1 (normal) and 2 (paint), and the instance's vectors from 4 on.
class Batch {
public:
    Batch(const Shape&, const Instances&);

    // No mesh: every instance is one point, which a geometry shader makes into a shape.
    static Batch points(const Instances&);

    Batch(Batch&& other) noexcept;
    Batch& operator=(Batch&&) = delete;
    ~Batch();

    // Draws the mesh once for each of the instances it was made with; nothing for none. Returns the number of draw
    // calls: 0 or 1.
    int draw(const Instances&) const;

private:
    Batch() = default;
    void read(const Instances&, unsigned divisor);

    unsigned array_ = 0, corners_ = 0, indices_ = 0;
    int index_count_ = 0;  // 0: points
};

}  // namespace braitenlab::render

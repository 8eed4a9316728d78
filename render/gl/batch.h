// A mesh drawn many times in one call, each time with another instance.
#pragma once

#include <cstddef>
#include <vector>

#include "render/view/shapes.h"

namespace braitenlab {

// Holds the mesh and a growing buffer of instances. Objects of the graphics library are made in the constructor alone;
// needs a current context for its whole life.
//
// A shader finds the corner at locations 0 (place), 1 (normal) and 2 (paint), and the instance's vectors from 4 on.
class Batch {
public:
    // `vectors` of four floats an instance.
    Batch(const Shape&, int vectors);
    Batch(Batch&& other) noexcept;
    Batch& operator=(Batch&&) = delete;
    ~Batch();

    // Uploads the instances and draws them all; does nothing for none. Returns the number of draw calls: 0 or 1.
    template <class Instance>
    int draw(const std::vector<Instance>& instances) {
        return draw(instances.data(), instances.size(), sizeof(Instance));
    }

private:
    int draw(const void* data, std::size_t count, std::size_t size);

    unsigned array_ = 0, corners_ = 0, indices_ = 0, instances_ = 0;
    int index_count_ = 0;
    std::size_t stride_ = 0, capacity_ = 0;
};

}  // namespace braitenlab

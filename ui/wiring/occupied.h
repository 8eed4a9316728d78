// What ground is taken: boxes sorted into square cells, so that asking costs the same however many there are.
#pragma once

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/maths/vec.h"

namespace braitenlab {

class Occupied {
public:
    void add(maths::vec2 centre, maths::vec2 size) {
        visit(centre, size, [&](std::uint64_t cell) {
            cells_[cell].push_back({centre, size});
            return false;
        });
    }

    // Whether the box overlaps one that was added.
    bool touches(maths::vec2 centre, maths::vec2 size) const {
        return visit(centre, size, [&](std::uint64_t cell) {
            const auto found = cells_.find(cell);
            if (found == cells_.end()) return false;
            for (const Box& box : found->second)
                if (std::abs(centre.x - box.centre.x) * 2 < size.x + box.size.x &&
                    std::abs(centre.y - box.centre.y) * 2 < size.y + box.size.y)
                    return true;
            return false;
        });
    }

private:
    struct Box {
        maths::vec2 centre, size;
    };
    static constexpr float cell_size = 128;  // units; about as large as a card

    // Calls back for every cell that the box reaches into, until one says true.
    template <class Visitor>
    static bool visit(maths::vec2 centre, maths::vec2 size, Visitor visitor) {
        const auto cell = [](float at) { return static_cast<std::int32_t>(std::floor(at / cell_size)); };
        for (std::int32_t x = cell(centre.x - size.x / 2); x <= cell(centre.x + size.x / 2); ++x)
            for (std::int32_t y = cell(centre.y - size.y / 2); y <= cell(centre.y + size.y / 2); ++y)
                if (visitor(std::uint64_t{static_cast<std::uint32_t>(x)} << 32U | static_cast<std::uint32_t>(y)))
                    return true;
        return false;
    }

    std::unordered_map<std::uint64_t, std::vector<Box>> cells_;
};

}  // namespace braitenlab

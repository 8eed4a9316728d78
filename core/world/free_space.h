// Free-space search: positions where one more vehicle fits. Inside core/world only.
#pragma once

#include <cstdint>
#include <vector>

#include "core/maths/vec.h"

namespace braitenlab::world {

struct WorldData;

// A grid of square cells with all vehicles, sources and obstacles. The cost of a query does not grow with their number.
// Holds the positions at construction and does not follow later motion.
class FreeSpace {
public:
    explicit FreeSpace(const WorldData&);

    // True when the distance to every vehicle and source is at least `reach` (m) plus its reach, and that to every
    // obstacle at least `reach`.
    bool is_free(maths::vec2 position, float reach) const;
    void occupy(maths::vec2 position, float reach);

private:
    struct Disc {
        maths::vec2 position;
        float reach = 0;
        std::int32_t next = -1;  // in the same cell
    };
    struct Block {
        std::vector<maths::vec2> corners;  // counter-clockwise, world coordinates
    };
    struct BlockAt {
        std::int32_t block = 0, next = -1;
    };
    int column(float x) const;
    int row(float y) const;
    std::size_t cell(int c, int r) const { return static_cast<std::size_t>(r * columns_ + c); }
    void add(Block);
    static bool is_near(const Block&, maths::vec2 position, float reach);

    maths::vec2 origin_;
    float side_ = 1;  // m, of a cell; overlapping discs are in the same or in neighbouring cells
    int columns_ = 1, rows_ = 1;
    std::vector<Disc> discs_;
    std::vector<Block> blocks_;
    std::vector<BlockAt> blocks_at_;
    std::vector<std::int32_t> first_disc_, first_block_;
    std::vector<std::int32_t> wide_;  // blocks that cover too many cells to be listed in each
};

}  // namespace braitenlab::world

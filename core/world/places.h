// Where there is room for one more.
#pragma once

#include <cstdint>
#include <vector>

#include "core/maths/vec.h"

namespace braitenlab {

struct WorldState;

// Everything that stands in a world, by square cells: to ask for a place costs the same however many there are. What
// moves afterwards is not followed.
class Places {
public:
    explicit Places(const WorldState&);

    // Whether nothing comes nearer to the place than `reach` (m) beyond its own.
    bool is_free(maths::vec2 place, float reach) const;
    void take(maths::vec2 place, float reach);

private:
    struct Disc {
        maths::vec2 place;
        float reach = 0;
        std::int32_t next = -1;  // in the same cell
    };
    struct Block {
        std::vector<maths::vec2> corners;  // counter-clockwise, world
    };
    struct BlockAt {
        std::int32_t block = 0, next = -1;
    };
    int column(float x) const;
    int row(float y) const;
    std::size_t cell(int c, int r) const { return static_cast<std::size_t>(r * columns_ + c); }
    void put(Block);
    static bool is_near(const Block&, maths::vec2 place, float reach);

    maths::vec2 origin_;
    float side_ = 1;  // of a cell: no two discs that are too near are more than one cell apart
    int columns_ = 1, rows_ = 1;
    std::vector<Disc> discs_;
    std::vector<Block> blocks_;
    std::vector<BlockAt> blocks_at_;
    std::vector<std::int32_t> first_disc_, first_block_;
    std::vector<std::int32_t> wide_;  // blocks that cover too many cells to stand in each of them
};

}  // namespace braitenlab

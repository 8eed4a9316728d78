// Everything that can be sensed on one channel, sorted into square cells, so that an eye looks at its neighbourhood
// only.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/maths/vec.h"
#include "core/scene/scene.h"

namespace braitenlab {

struct Stimulus {
    maths::vec2 place;
    float strength = 1;       // 0..1
    std::int32_t owner = -1;  // the row of the vehicle that carries it, which does not sense itself; −1: nobody
};

class Field {
public:
    // Cells as large as the farthest eye on the channel looks: then an eye needs at most nine of them.
    void lay_out(const Arena& arena, float farthest_range) {
        constexpr float most_cells_a_side = 512;
        const float side = std::max(arena.width, arena.height);
        cell_ = std::max(farthest_range, side / most_cells_a_side);
        origin_ = {-arena.width / 2, -arena.height / 2};
        columns_ = static_cast<int>(arena.width / cell_) + 1;
        rows_ = static_cast<int>(arena.height / cell_) + 1;
    }

    // Sorts by cell; within a cell the given order stays (a counting sort), so sums run in a fixed order.
    void fill(const std::vector<Stimulus>& stimuli) {
        first_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
        for (const Stimulus& s : stimuli) ++first_[cell_of(s.place) + 1];
        for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
        sorted_.resize(stimuli.size());
        next_.assign(first_.begin(), first_.end() - 1);
        for (const Stimulus& s : stimuli) sorted_[next_[cell_of(s.place)]++] = s;
    }

    // Calls visit(stimulus) for everything in the cells that the square round `centre` touches.
    template <class Visit>
    void near(maths::vec2 centre, float range, Visit visit) const {
        if (sorted_.empty()) return;
        const int left = column(centre.x - range), right = column(centre.x + range);
        const int low = row(centre.y - range), high = row(centre.y + range);
        for (int r = low; r <= high; ++r) {
            const auto begin = first_[index(left, r)],
                       end = first_[index(right, r) + 1];  // a row's cells lie side by side
            for (auto i = begin; i < end; ++i) visit(sorted_[i]);
        }
    }

private:
    int column(float x) const { return std::clamp(static_cast<int>((x - origin_.x) / cell_), 0, columns_ - 1); }
    int row(float y) const { return std::clamp(static_cast<int>((y - origin_.y) / cell_), 0, rows_ - 1); }
    std::size_t index(int c, int r) const { return static_cast<std::size_t>(r * columns_ + c); }
    std::size_t cell_of(maths::vec2 p) const { return index(column(p.x), row(p.y)); }

    maths::vec2 origin_;
    float cell_ = 1;
    int columns_ = 1, rows_ = 1;
    std::vector<std::uint32_t> first_{0, 0}, next_;
    std::vector<Stimulus> sorted_;
};

}  // namespace braitenlab

// Everything that can be sensed on one channel, sorted into cells, so that an eye looks at its neighbourhood only.
#pragma once

#include <cstdint>
#include <vector>

#include "core/world/eye.h"
#include "core/world/seam.h"

namespace braitenlab {

struct Stimulus {
    maths::vec2 place;
    float strength = 1;       // 0..1
    std::int32_t owner = -1;  // the row of the vehicle that carries it, which does not sense itself; −1: nobody
};

class Field {
public:
    // For eyes that look at most so far (m).
    void lay_out(const Arena&, float farthest_range);

    // Sorts by cell; within a cell the given order stays (a counting sort), so sums run in a fixed order.
    void fill(const std::vector<Stimulus>&);

    // The sum of an eye's answers to everything that others than `self` (a row) give off. In a joined arena each
    // stimulus counts once, on the shortest way.
    float total(const Eye&, const Gaze&, std::int32_t self) const;

    // The same, but of what `hidden(from, to)` does not hide from the eye.
    template <class Hidden>
    float total_in_sight(const Eye&, const Gaze&, std::int32_t self, Hidden hidden) const;

private:
    struct Cells {
        int count = 1;
        float size = 1;  // m
        int of(float x) const { return std::clamp(static_cast<int>(x / size), 0, count - 1); }
    };
    // Calls visit(begin, end) for the stretches of the sorted arrays that the bounds touch: a row's cells lie side by
    // side.
    template <class Visit>
    void for_each_span(const Bounds&, Visit visit) const;
    template <class Visit>
    void for_each_span_joined(const Bounds&, Visit visit) const;
    template <bool is_graded, bool joined>
    float sum(const Eye&, const Gaze&, std::int32_t self) const;
    std::size_t cell_of(maths::vec2 place) const;

    Seam seam_;
    maths::vec2 origin_, size_;  // m
    float farthest_ = 1;
    Cells columns_, rows_;
    std::vector<std::uint32_t> first_, cell_;
    std::vector<float> x_, y_, strength_;  // sorted, and padded so that a block may look beyond the end
    std::vector<std::int32_t> owner_;
};

template <class Visit>
void Field::for_each_span(const Bounds& bounds, Visit visit) const {
    if (seam_.joined) return for_each_span_joined(bounds, visit);
    const int left = columns_.of(bounds.low.x - origin_.x), right = columns_.of(bounds.high.x - origin_.x);
    const int low = rows_.of(bounds.low.y - origin_.y), high = rows_.of(bounds.high.y - origin_.y);
    for (int row = low; row <= high; ++row) {
        const auto begin = static_cast<std::size_t>(row * columns_.count);
        visit(first_[begin + static_cast<std::size_t>(left)], first_[begin + static_cast<std::size_t>(right) + 1]);
    }
}

template <class Visit>
void Field::for_each_span_joined(const Bounds& bounds, Visit visit) const {
    const auto cell = [](float x, const Cells& cells) { return static_cast<int>(std::floor(x / cells.size)); };
    const auto on = [](int i, int count) { return (i % count + count) % count; };
    const int left = cell(bounds.low.x - origin_.x, columns_);
    const int wide = std::min(columns_.count, cell(bounds.high.x - origin_.x, columns_) - left + 1);
    const int low = cell(bounds.low.y - origin_.y, rows_);
    const int tall = std::min(rows_.count, cell(bounds.high.y - origin_.y, rows_) - low + 1);
    const int begin = on(left, columns_.count), end = std::min(begin + wide, columns_.count);
    for (int row = low; row < low + tall; ++row) {
        const auto first = first_.begin() + on(row, rows_.count) * columns_.count;
        visit(first[begin], first[end]);
        if (const int rest = begin + wide - columns_.count; rest > 0) visit(first[0], first[rest]);
    }
}

template <class Hidden>
float Field::total_in_sight(const Eye& eye, const Gaze& gaze, std::int32_t self, Hidden hidden) const {
    float sum = 0;
    for_each_span(bounds_of(eye, gaze), [&](std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t i = begin; i < end; ++i) {
            if (owner_[i] == self) continue;
            const maths::vec2 place = gaze.from + seam_.shortest(maths::vec2{x_[i], y_[i]} - gaze.from);
            const float answered = answer(eye, gaze, place, strength_[i]);
            if (answered > 0 && !hidden(gaze.from, place)) sum += answered;
        }
    });
    return sum;
}

}  // namespace braitenlab

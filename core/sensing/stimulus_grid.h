// All stimuli of one channel, sorted into the cells of a uniform grid, so that a sensor visits only cells near it.
#pragma once

#include <cstdint>
#include <vector>

#include "core/sensing/compiled_sensor.h"
#include "core/sensing/seam.h"

namespace braitenlab::sensing {

struct Stimulus {
    maths::vec2 position;
    float strength = 1;       // 0..1
    std::int32_t owner = -1;  // row of the vehicle that carries it, which does not sense itself; −1: none
    float candela = 0;        // as Source
    friend bool operator==(const Stimulus&, const Stimulus&) = default;
};

class StimulusGrid {
public:
    // Sets the arena and the longest range of the channel's sensors (m).
    void lay_out(const Arena&, float farthest_range);

    // Replaces all stimuli. Counting sort by cell; the given order is kept within a cell, so sums have a fixed order.
    void fill(const std::vector<Stimulus>&);

    // Sum of a sensor's responses to all stimuli whose owner is not `self` (a row). In a joined arena each stimulus
    // counts once, on the shortest path.
    float total(const CompiledSensor&, const SensorPose&, std::int32_t self) const;

    // The same without the stimuli at `to` for which hidden(from, to) is true.
    template <class Hidden>
    float total_in_sight(const CompiledSensor&, const SensorPose&, std::int32_t self, Hidden hidden) const;

private:
    struct Cells {
        int count = 1;
        float size = 1;  // m
        int of(float x) const { return std::clamp(static_cast<int>(x / size), 0, count - 1); }
    };
    // Calls visit(begin, end) for each range of the sorted arrays whose cells the bounds touch: one range per row of
    // cells, two where a row crosses the seam.
    template <class Visit>
    void for_each_span(const Bounds&, Visit visit) const;
    template <class Visit>
    void for_each_span_joined(const Bounds&, Visit visit) const;
    template <bool is_graded, bool joined>
    float sum(const CompiledSensor&, const SensorPose&, std::int32_t self) const;
    std::size_t cell_of(maths::vec2 position) const;

    Seam seam_;
    maths::vec2 origin_, size_;  // m
    float farthest_ = 1;
    Cells columns_, rows_;
    std::vector<std::uint32_t> first_, cell_;
    std::vector<float> x_, y_, strength_, candela_;  // sorted, padded for reads of whole blocks
    std::vector<std::int32_t> owner_;
};

template <class Visit>
void StimulusGrid::for_each_span(const Bounds& bounds, Visit visit) const {
    if (seam_.joined) return for_each_span_joined(bounds, visit);
    const int left = columns_.of(bounds.low.x - origin_.x), right = columns_.of(bounds.high.x - origin_.x);
    const int low = rows_.of(bounds.low.y - origin_.y), high = rows_.of(bounds.high.y - origin_.y);
    for (int row = low; row <= high; ++row) {
        const auto begin = static_cast<std::size_t>(row * columns_.count);
        visit(first_[begin + static_cast<std::size_t>(left)], first_[begin + static_cast<std::size_t>(right) + 1]);
    }
}

template <class Visit>
void StimulusGrid::for_each_span_joined(const Bounds& bounds, Visit visit) const {
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
float StimulusGrid::total_in_sight(const CompiledSensor& sensor, const SensorPose& pose, std::int32_t self,
                                   Hidden hidden) const {
    float sum = 0;
    for_each_span(bounds_of(sensor, pose), [&](std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t i = begin; i < end; ++i) {
            if (owner_[i] == self) continue;
            const maths::vec2 position = pose.position + seam_.shortest(maths::vec2{x_[i], y_[i]} - pose.position);
            const float answered = response_to(sensor, pose, position, strength_for(sensor, strength_[i], candela_[i]));
            if (answered > 0 && !hidden(pose.position, position)) sum += answered;
        }
    });
    return sum;
}

}  // namespace braitenlab::sensing

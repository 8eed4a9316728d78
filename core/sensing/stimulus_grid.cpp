#include "core/sensing/stimulus_grid.h"

#include <cmath>

namespace braitenlab::sensing {

using maths::vec2;

namespace {

// Number of partial sums. They are written out so that the order of additions is the same, vectorised or not, in debug
// and in release builds.
constexpr std::uint32_t lanes = 8;

// So few stimuli are read one by one: eight lanes take longer. The order of the additions of two does not matter, so
// they need no cells either.
constexpr std::uint32_t few = 2;

}  // namespace

void StimulusGrid::lay_out(const Arena& arena, float farthest_range) {
    seam_ = Seam(arena);
    size_ = {arena.width, arena.height};
    origin_ = -size_ / 2;
    farthest_ = farthest_range;
}

std::size_t StimulusGrid::cell_of(vec2 position) const {
    return static_cast<std::size_t>(rows_.of(position.y - origin_.y) * columns_.count +
                                    columns_.of(position.x - origin_.x));
}

void StimulusGrid::fill(const std::vector<Stimulus>& stimuli) {
    // Rows as high as the longest range and four columns per range. More cells cost more to look up than they save, as
    // do more than a few cells per stimulus.
    constexpr float columns_a_range = 4, cells_a_stimulus = 4;
    x_.resize(stimuli.size() + lanes), y_.resize(x_.size()), strength_.resize(x_.size()), owner_.resize(x_.size());
    candela_.resize(x_.size());
    const auto put = [this](std::size_t at, const Stimulus& stimulus) {
        x_[at] = stimulus.position.x, y_[at] = stimulus.position.y;
        strength_[at] = stimulus.strength, owner_[at] = stimulus.owner;
        candela_[at] = stimulus.candela;
    };
    if (stimuli.size() <= few) {
        columns_ = {1, size_.x}, rows_ = {1, size_.y};
        first_.assign({0, static_cast<std::uint32_t>(stimuli.size())});
        for (std::size_t i = 0; i < stimuli.size(); ++i) put(i, stimuli[i]);
        return;
    }
    const auto count = static_cast<float>(stimuli.size());
    float wide = farthest_ / columns_a_range, high = farthest_;
    const float crowded = size_.x * size_.y / (wide * high * (16 + cells_a_stimulus * count));
    if (crowded > 1) wide *= std::sqrt(crowded), high *= std::sqrt(crowded);
    columns_.count = std::max(1, static_cast<int>(size_.x / wide));
    rows_.count = std::max(1, static_cast<int>(size_.y / high));
    columns_.size = size_.x / static_cast<float>(columns_.count);
    rows_.size = size_.y / static_cast<float>(rows_.count);

    const std::size_t cells = static_cast<std::size_t>(columns_.count) * static_cast<std::size_t>(rows_.count);
    first_.assign(cells + 1, 0);
    cell_.resize(stimuli.size());
    for (std::size_t i = 0; i < stimuli.size(); ++i) {
        cell_[i] = static_cast<std::uint32_t>(cell_of(stimuli[i].position));
        ++first_[cell_[i]];
    }
    // first_ now holds each cell's end; filling backwards turns ends into beginnings.
    for (std::size_t c = 1; c <= cells; ++c) first_[c] += first_[c - 1];
    for (std::size_t i = stimuli.size(); i-- > 0;) put(--first_[cell_[i]], stimuli[i]);
}

template <bool is_graded, bool joined>
float StimulusGrid::sum(const CompiledSensor& sensor, const SensorPose& pose, std::int32_t self) const {
    const float *x = x_.data(), *y = y_.data(), *strength = strength_.data();
    const std::int32_t* owner = owner_.data();
    if (const std::uint32_t count = first_.back(); !joined && count <= few) {
        float total = 0;
        for (std::uint32_t i = 0; i < count; ++i)
            if (owner[i] != self) total += response_to(sensor, pose, {x[i], y[i]}, strength[i]);
        return total;
    }
    const float half_x = seam_.size.x / 2, half_y = seam_.size.y / 2;
    float partial[lanes] = {};
    for_each_span(bounds_of(sensor, pose), [&](std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t block = begin; block < end; block += lanes) {
            const auto left = static_cast<std::int32_t>(end - block);
            if (!joined && end - block <= few) {
                for (std::uint32_t k = 0; block + k < end; ++k)
                    if (owner[block + k] != self)
                        partial[k] += response_to(sensor, pose, {x[block + k], y[block + k]}, strength[block + k]);
                break;
            }
#pragma omp simd
            for (std::uint32_t k = 0; k < lanes; ++k) {
                float dx = x[block + k] - pose.position.x, dy = y[block + k] - pose.position.y;
                if constexpr (joined) {
                    dx -= dx > half_x ? seam_.size.x : dx < -half_x ? -seam_.size.x : 0.0f;
                    dy -= dy > half_y ? seam_.size.y : dy < -half_y ? -seam_.size.y : 0.0f;
                }
                const float squared = dx * dx + dy * dy, along = dx * pose.axis.x + dy * pose.axis.y;
                const float distance = std::sqrt(squared);
                const bool in_field = (squared <= sensor.range_squared) & (along >= sensor.cos_half_field * distance) &
                                      (along <= sensor.reach) & (owner[block + k] != self) &
                                      (static_cast<std::int32_t>(k) < left);
                const float answered = is_graded
                                           ? graded_response(sensor, squared, distance, along, strength[block + k])
                                           : strength[block + k];
                partial[k] += in_field ? answered : 0.0f;
            }
        }
    });
    return ((partial[0] + partial[4]) + (partial[1] + partial[5])) +
           ((partial[2] + partial[6]) + (partial[3] + partial[7]));
}

float StimulusGrid::total(const CompiledSensor& sensor, const SensorPose& pose, std::int32_t self) const {
    if (sensor.response == SensorResponse::graded)
        return seam_.joined ? sum<true, true>(sensor, pose, self) : sum<true, false>(sensor, pose, self);
    if (sensor.response == SensorResponse::boolean)
        return seam_.joined ? sum<false, true>(sensor, pose, self) : sum<false, false>(sensor, pose, self);
    return total_in_sight(sensor, pose, self, [](vec2, vec2) { return false; });
}

}  // namespace braitenlab::sensing

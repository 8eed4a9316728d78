#include "core/world/field.h"

#include <cmath>

namespace braitenlab {

using maths::vec2;

namespace {

// Sums run in this many partial sums, written out, so that no optimiser chooses their order: vectorised or not, in
// debug and in release, the bits are the same.
constexpr std::uint32_t lanes = 8;

}  // namespace

void Field::lay_out(const Arena& arena, float farthest_range) {
    seam_ = Seam(arena);
    size_ = {arena.width, arena.height};
    origin_ = -size_ / 2;
    farthest_ = farthest_range;
}

std::size_t Field::cell_of(vec2 place) const {
    return static_cast<std::size_t>(rows_.of(place.y - origin_.y) * columns_.count + columns_.of(place.x - origin_.x));
}

void Field::fill(const std::vector<Stimulus>& stimuli) {
    // Rows as high as the farthest eye looks, and four columns to that: more cells would cost more to look up than they
    // save, and so would more than a few for each stimulus.
    constexpr float columns_a_range = 4, cells_a_stimulus = 4;
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
        cell_[i] = static_cast<std::uint32_t>(cell_of(stimuli[i].place));
        ++first_[cell_[i]];
    }
    // Each cell's end; filling backwards then turns ends into beginnings.
    for (std::size_t c = 1; c <= cells; ++c) first_[c] += first_[c - 1];
    x_.resize(stimuli.size() + lanes), y_.resize(x_.size()), strength_.resize(x_.size()), owner_.resize(x_.size());
    for (std::size_t i = stimuli.size(); i-- > 0;) {
        const std::uint32_t at = --first_[cell_[i]];
        x_[at] = stimuli[i].place.x, y_[at] = stimuli[i].place.y;
        strength_[at] = stimuli[i].strength, owner_[at] = stimuli[i].owner;
    }
}

template <bool is_graded, bool joined>
float Field::sum(const Eye& eye, const Gaze& gaze, std::int32_t self) const {
    const float *x = x_.data(), *y = y_.data(), *strength = strength_.data();
    const std::int32_t* owner = owner_.data();
    const float half_x = seam_.size.x / 2, half_y = seam_.size.y / 2;
    float partial[lanes] = {};
    for_each_span(bounds_of(eye, gaze), [&](std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t block = begin; block < end; block += lanes) {
            const auto left = static_cast<std::int32_t>(end - block);
#pragma omp simd
            for (std::uint32_t k = 0; k < lanes; ++k) {
                float dx = x[block + k] - gaze.from.x, dy = y[block + k] - gaze.from.y;
                if constexpr (joined) {
                    dx -= dx > half_x ? seam_.size.x : dx < -half_x ? -seam_.size.x : 0.0f;
                    dy -= dy > half_y ? seam_.size.y : dy < -half_y ? -seam_.size.y : 0.0f;
                }
                const float squared = dx * dx + dy * dy, along = dx * gaze.axis.x + dy * gaze.axis.y;
                const float distance = std::sqrt(squared);
                const bool in_field = (squared <= eye.range_squared) & (along >= eye.cos_half_field * distance) &
                                      (along <= eye.reach) & (owner[block + k] != self) &
                                      (static_cast<std::int32_t>(k) < left);
                const float answered =
                    is_graded ? graded(eye, squared, distance, along, strength[block + k]) : strength[block + k];
                partial[k] += in_field ? answered : 0.0f;
            }
        }
    });
    return ((partial[0] + partial[4]) + (partial[1] + partial[5])) +
           ((partial[2] + partial[6]) + (partial[3] + partial[7]));
}

float Field::total(const Eye& eye, const Gaze& gaze, std::int32_t self) const {
    if (eye.response == SensorResponse::graded)
        return seam_.joined ? sum<true, true>(eye, gaze, self) : sum<true, false>(eye, gaze, self);
    return seam_.joined ? sum<false, true>(eye, gaze, self) : sum<false, false>(eye, gaze, self);
}

}  // namespace braitenlab

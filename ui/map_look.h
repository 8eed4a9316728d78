// Colours and marks of a map of behaviour, for the window and for pictures of braitenctl. Each kind has a colour that
// is told apart with any colour vision (M. Okabe and K. Ito, Color Universal Design, 2008) and a mark of its own.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/insight/behaviour.h"

namespace braitenlab::ui {

struct MapColour {
    float r = 0, g = 0, b = 0;  // 0..1
};

inline constexpr int mark_size = 5;

struct BehaviourLook {
    insight::Behaviour value;
    MapColour colour;
    std::array<std::uint8_t, mark_size> mark;  // rows from the top; the highest of five bits is left
};
inline constexpr std::array<BehaviourLook, insight::behaviour_count> behaviour_looks{{
    {insight::Behaviour::touches, {0.84f, 0.37f, 0.00f}, {0b10001, 0b01010, 0b00100, 0b01010, 0b10001}},
    {insight::Behaviour::rests_near, {0.94f, 0.89f, 0.26f}, {0b00000, 0b01110, 0b01110, 0b01110, 0b00000}},
    {insight::Behaviour::circles, {0.80f, 0.47f, 0.65f}, {0b01110, 0b10001, 0b10001, 0b10001, 0b01110}},
    {insight::Behaviour::passes, {0.34f, 0.71f, 0.91f}, {0b00000, 0b00000, 0b11111, 0b00000, 0b00000}},
    {insight::Behaviour::approaches, {0.90f, 0.62f, 0.00f}, {0b00000, 0b00100, 0b01010, 0b10001, 0b00000}},
    {insight::Behaviour::flees, {0.00f, 0.45f, 0.70f}, {0b00000, 0b10001, 0b01010, 0b00100, 0b00000}},
    {insight::Behaviour::leaves, {0.00f, 0.62f, 0.45f}, {0b00000, 0b00100, 0b11111, 0b00100, 0b00000}},
    {insight::Behaviour::stands, {0.62f, 0.62f, 0.62f}, {0b00000, 0b00000, 0b00100, 0b00000, 0b00000}},
}};
constexpr const BehaviourLook& look_of(insight::Behaviour kind) {
    return behaviour_looks[static_cast<std::size_t>(kind)];
}

// True where the mark has a dot; column and row from the left and the top, below mark_size.
constexpr bool is_marked(insight::Behaviour kind, int column, int row) {
    return (look_of(kind).mark[static_cast<std::size_t>(row)] >> (mark_size - 1 - column) & 1) != 0;
}

// A colour of the scale of numbers, 0 ≤ share ≤ 1: from dark blue to light yellow, lighter throughout.
inline MapColour scale_colour(float share) {
    constexpr std::array<MapColour, 4> steps{
        {{0.16f, 0.11f, 0.40f}, {0.13f, 0.45f, 0.56f}, {0.37f, 0.75f, 0.42f}, {0.98f, 0.92f, 0.35f}}};
    const float at = std::clamp(share, 0.0f, 1.0f) * (steps.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(at), steps.size() - 2);
    const float part = at - static_cast<float>(low);
    const MapColour &a = steps[low], &b = steps[low + 1];
    return {a.r + (b.r - a.r) * part, a.g + (b.g - a.g) * part, a.b + (b.b - a.b) * part};
}

// The smallest and the largest number of a map that is finite; 0 and 1 without one or where all are the same.
struct MapScale {
    float low = 0, high = 1;
    float share(float number) const { return (number - low) / (high - low); }
};
template <class Cells>
MapScale scale_of(const Cells& cells, insight::MapMeasure measure) {
    float low = INFINITY, high = -INFINITY;
    for (const auto& cell : cells) {
        if (!cell || measure == insight::MapMeasure::behaviour) continue;
        const float number = insight::number_of(cell->outcome, measure);
        if (std::isfinite(number)) low = std::min(low, number), high = std::max(high, number);
    }
    if (!(low < high)) return low == high ? MapScale{low, low + 1} : MapScale{};
    return {low, high};
}

// The colour of a cell on a ground: the smaller the share of runs that agree, the nearer to it. A number that is not
// finite ("never", "no object") has the colour of the ground.
inline MapColour cell_colour(const insight::Outcome& outcome, float agree, insight::MapMeasure measure,
                             const MapScale& scale, MapColour ground) {
    MapColour colour = look_of(outcome.behaviour).colour;
    if (measure != insight::MapMeasure::behaviour) {
        const float number = insight::number_of(outcome, measure);
        return std::isfinite(number) ? scale_colour(scale.share(number)) : ground;
    }
    const float part = 0.2f + 0.8f * std::clamp(agree, 0.0f, 1.0f);
    return {ground.r + (colour.r - ground.r) * part, ground.g + (colour.g - ground.g) * part,
            ground.b + (colour.b - ground.b) * part};
}

}  // namespace braitenlab::ui

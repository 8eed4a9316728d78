// The last seconds, kept for the pictures over time: sampled from snapshots, forgotten when the run starts over.
#pragma once

#include <array>
#include <cstdint>
#include <deque>

#include "ui/lab_view.h"

namespace braitenlab {

struct History {
    static constexpr std::uint64_t signal_period = 3;       // ticks between samples
    static constexpr std::size_t signal_samples = 200;      // 10 s
    static constexpr std::uint64_t population_period = 60;  // ticks
    static constexpr std::size_t population_samples = 120;  // two minutes

    VehicleId vehicle = no_vehicle;               // whose signals they are
    std::array<std::deque<float>, 4> signals;     // SL, SR 0..1, ML, MR −1..1; oldest first
    std::deque<std::array<float, 2>> population;  // predators, prey
    std::uint64_t tick = 0;                       // of the last snapshot seen
    std::uint64_t signal_tick = 0, population_tick = 0;
};

// Takes a sample where one is due. Call once a frame; at high speed frames are further apart than samples, and the
// pictures get coarser.
void remember(History&, const LabView&);

}  // namespace braitenlab

// What the pictures over time are made of: sampled from snapshots while they pass, forgotten where the run goes back.
#pragma once

#include <array>
#include <cstdint>
#include <deque>

#include "ui/lab_view.h"

namespace braitenlab {

struct History {
    static constexpr std::uint64_t signal_period = 3;       // ticks between samples
    static constexpr std::size_t signal_samples = 1200;     // one minute
    static constexpr std::uint64_t population_period = 60;  // ticks
    static constexpr std::size_t population_samples = 600;  // ten minutes

    struct Signals {
        double seconds = 0;           // simulated
        std::array<float, 4> values;  // SL, SR 0..1, ML, MR −1..1
    };
    struct Population {
        double seconds = 0;
        std::array<int, 3> count{};     // predators, prey, others
        std::array<float, 3> energy{};  // their means, 0..1; NaN where there is nobody
    };

    VehicleId vehicle = no_vehicle;  // whose signals they are
    std::deque<Signals> signals;     // oldest first
    std::deque<Population> population;
    std::uint64_t tick = 0;    // of the last snapshot seen
    std::uint64_t run_id = 0;  // whose run it is: LabView::run_id
};

// Takes a sample where one is due, and takes one anew that belongs to the moment shown, which an edit may have changed;
// samples of a time that has been taken back go, and all of them where another scene was opened. Call once a frame; at
// high speed frames are further apart than samples, and the pictures get coarser.
void remember(History&, const LabView&);

}  // namespace braitenlab

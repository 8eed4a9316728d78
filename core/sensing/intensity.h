// The intensity of one channel over the whole floor, on a regular grid of samples. Its contours are drawn elsewhere.
#pragma once

#include <memory>
#include <vector>

#include "core/sensing/environment.h"

namespace braitenlab::sensing {

// Samples over the arena, row by row from the lower edge up, from one corner to the opposite one.
struct Intensity {
    int columns = 0, rows = 0;
    std::vector<float> values;  // 0..1

    static constexpr int most_columns = 160, most_rows = 160;
};

// Everything that an intensity map depends on; see intensity_input() in core/world/snapshot.h.
struct IntensityInput {
    Sensor sensor;                             // see measuring_sensor()
    std::vector<Stimulus> stimuli;             // without those of the vehicle that senses
    std::vector<mechanics::Motion> obstacles;  // empty when the channel does not depend on them
    std::shared_ptr<const Scene> scene;        // null: intensity 0 everywhere
    friend bool operator==(const IntensityInput&, const IntensityInput&) = default;
};

// The kind's first sensor for the channel, or the default sensor when `kind` is null or has none, changed to look in
// all directions from the vehicle's origin without noise and delay.
Sensor measuring_sensor(const Kind* kind, Channel);

class IntensityMap {
public:
    // Recomputes the grid if the input differs from the last one; returns whether it did. Each value is the reading of
    // the measuring sensor at that position. Obstacles block it as they block sensors. The grid is coarser when there
    // are many stimuli, so that a call costs about a million responses at most.
    bool update(IntensityInput);

    const Intensity& grid() const { return grid_; }

private:
    void resize_grid();

    IntensityInput input_;
    Intensity grid_;
};

}  // namespace braitenlab::sensing

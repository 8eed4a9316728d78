// Golden vectors: inputs of a brain and the wheel commands that the lab computes from them. An exported program is
// tested with them: the same inputs in the same order must give the same commands.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/export/plan.h"

namespace braitenlab::robots {

struct GoldenVector {
    std::vector<float> sensed;   // of each input; whole thousandths from 0 to 1
    float left = 0, right = 0;   // commands of the wheels, −1..1
    bool is_close_call = false;  // a threshold or a step is closer than `margin` to its input; see golden_vectors()
};

struct GoldenVectors {
    std::vector<std::string> sensors;  // names of the brain's sensors with an effect, in the order of Plan::inputs
    float rate_hz = 60;
    std::vector<GoldenVector> ticks;  // consecutive; the brain starts with all values 0
};

// A threshold or step whose input is closer than this to it can switch differently in another arithmetic.
inline constexpr float close_call_margin = 0.004f;

// Drives the brain with inputs that begin with all combinations of 0 and 1 (of the first six sensors) and go on with
// constant, slowly changing and random values. The same arguments give the same vectors on every platform. Inputs that
// lead to a close call are replaced, up to a hundred times per tick. Fails as compile() does.
Result<GoldenVectors> golden_vectors(const BrainToExport&, float rate_hz, int ticks, std::uint64_t seed = 1);

// As CSV: tick, sensor_NAME…, left, right, close_call (0 or 1). Commands have nine significant digits, so that a float
// keeps its bits.
std::string write_csv(const GoldenVectors&);

}  // namespace braitenlab::robots

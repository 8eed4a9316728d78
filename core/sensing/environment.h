// Everything that sensors read from outside their own vehicle: stimuli, obstacles, the floor and ambient light.
//
// A running world and the intensity map build it from their own data, so each channel's law exists once.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/sensing/ground.h"
#include "core/sensing/outline.h"
#include "core/sensing/seam.h"
#include "core/sensing/stimulus_grid.h"

namespace braitenlab::sensing {

struct PointSource {
    Channel channel = Channel::light;
    maths::vec2 position;  // m
    float strength = 1;    // 0..1
    float candela = 0;     // as Source
};

// What gives off stimuli. The spans of vehicles have one element per vehicle.
struct Emitters {
    std::span<const PointSource> sources;
    const std::vector<Kind>& kinds;  // for the lamps that vehicles carry
    std::span<const mechanics::Motion> motion;
    std::span<const std::int32_t> kind;  // in `kinds`
    std::span<const Role> role;          // may be empty when the channel is neither predator nor prey
};

// True when the channel is sensed as a sum of stimuli at positions; then its stimuli are kept in a grid.
bool has_stimuli(Channel);

// Replaces `out` with all stimuli of a channel in a fixed order: sources, vehicles by row, the lamps that they carry.
// The owner of a stimulus is the vehicle's row.
void gather_stimuli(const Emitters&, const Seam&, Channel, std::vector<Stimulus>& out);

using StimulusGrids = std::array<StimulusGrid, channel_count>;  // by channel

struct Environment {
    Environment(const Scene&, const std::vector<mechanics::Motion>& obstacles);

    Ground ground;
    Outlines outlines;
    Seam seam;
    float ambient = 0;  // 0..1
    float lux = 0;      // of photocells
};

// Reading of a channel with stimuli, of `obstacle` or of `floor`, before noise, delay and clamping. Stimuli owned by
// the vehicle in row `self` do not count. Precondition: the channel's grid is filled.
float read_environment(const Environment&, const StimulusGrids&, const CompiledSensor&, SensorPose, std::int32_t self);

// Reading of an amount (0..1) that is always present: a boolean sensor reads 1 from 0.5 upwards, others the amount.
inline float response_to_amount(const CompiledSensor& sensor, float amount) {
    return sensor.response != SensorResponse::boolean ? amount : amount >= 0.5f ? 1.0f : 0.0f;
}

}  // namespace braitenlab::sensing

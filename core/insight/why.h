// The cause of a vehicle's turn: what each sensor adds to the difference between its wheels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/world/snapshot.h"

namespace braitenlab::insight {

// Ticks over which a sensor is silenced in a brain with hidden neurons: half a second.
inline constexpr std::size_t silenced_ticks = 30;

// The brain of a vehicle at one tick: its readings, and the values of neurons, motors and learned parts after it.
struct BrainMoment {
    std::vector<float> sensed;  // as kind_of().sensors
    std::vector<float> state;   // Brain::state_size() values
};
BrainMoment moment_of(const Snapshot&, const VehicleView&);

// The part of one sensor that the brain reads.
struct SensorPart {
    std::string sensor;
    float reading = 0;  // 0..1; 0 for a silenced sensor
    float value = 0;    // what it adds to right − left
};

// Sensors, bias and rest add up to the difference of the wheel commands.
struct Why {
    VehicleId vehicle = no_vehicle;
    std::uint64_t tick = 0;
    float left = 0, right = 0;        // wheel commands, −1..1
    std::vector<SensorPart> sensors;  // the largest value first
    float bias = 0;                   // of the right motor − of the left motor
    float rest = 0;                   // curves and memory of the motors, the limit −1..1, what sensors do together
    std::size_t ticks = 0;            // silenced for so many ticks; 0: the sums of the wires
};

// Without hidden neurons a sensor's part is the sum of its wires: signal to the right motor − signal to the left one.
// With hidden neurons it is what is lost at this tick when the sensor reads 0 in all moments but the first: the brain
// alone is computed again, with the readings as they were. `past`: of successive ticks with this brain, the last one
// being that of the snapshot; fewer than two moments: parts through neurons are in the rest.
// Precondition: the vehicle is in the snapshot.
Why why(const Snapshot&, const VehicleView&, std::span<const BrainMoment> past = {});

// A part below this is 0.00 with two decimals and is no cause.
inline constexpr float least_part = 0.005f;

// Wheel commands that differ by less are alike: the vehicle drives straight on.
inline bool are_alike(float left, float right) {
    const float difference = right - left;
    return -least_part < difference && difference < least_part;
}

// The cause of a turn: the index of the part that adds most towards it. `parts`: what each one adds to the difference
// of the wheels, positive towards the turn. Of equal parts the first one; nullopt: none adds at least least_part.
std::optional<std::size_t> main_part(std::span<const float> parts);

// True if why() needs moments of the past.
bool has_hidden_neurons(const BrainGraph&);

}  // namespace braitenlab::insight

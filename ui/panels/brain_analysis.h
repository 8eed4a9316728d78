// Computations of the brain card: the sums of both motors, the cause of a turn, and the recognised character.
#pragma once

#include <array>
#include <memory>
#include <string_view>
#include <vector>

#include "core/world/character.h"
#include "core/world/snapshot.h"

namespace braitenlab::ui {

// The wire of one sensor to the motor: value = input · weight, or 0 when the wire is cut.
struct Product {
    std::string_view letters;  // "SL·LL"
    float input = 0;           // reading after threshold and curve of the wire; 0 for a silenced sensor
    float weight = 0;          // includes what a Hebbian wire has learned
    float value = 0;           // contribution to the motor's sum
    bool masked = false;       // the reading is below the threshold and counts as 0
    bool cut = false;          // lesion: delivers 0
};

struct MotorSum {
    std::string_view motor, bias_letters;  // "ML", "LM"
    std::array<Product, 2> products;       // the uncrossed wire, then the crossed one
    float bias = 0;
    bool more_wires = false;  // the brain has more wires than the sliders show
    float others = 0;         // with more_wires: further wires and the motor's memory and curve; else 0
    bool stopped = false;     // lesion of the motor: the total is 0
    bool limited = false;     // the sum is outside −1..1: the total is −1 or 1
    float total = 0;          // the wheel command, −1..1
};

// Left and right motor. Precondition: the vehicle is in the snapshot.
std::array<MotorSum, 2> motor_sums(const Snapshot&, const VehicleView&);

// The cause of the difference between the wheels: the largest contribution towards it, from either wheel.
struct Cause {
    enum class By { nothing, product, biases, others };
    float difference = 0;  // right − left
    By by = By::nothing;
    const Product* product = nullptr;  // points into the sums; null unless by product
    bool holds_back = false;           // it slows the other wheel instead of driving the faster one
};
Cause cause(const std::array<MotorSum, 2>&);

// Cached result of the recogniser for the selected vehicle.
struct Recognised {
    std::shared_ptr<const BrainGraph> brain;
    VehicleId vehicle = no_vehicle;
    std::vector<Reading> readings;  // rounded to 0.05, so that noise does not change the result
    double at = 0;                  // wall seconds
    Character character = Character::still;
};

// Recomputed at once for another brain or vehicle, and at most four times a second for changed readings.
Character recognised(Recognised&, const Snapshot&, const VehicleView&, double wall_seconds);

}  // namespace braitenlab::ui

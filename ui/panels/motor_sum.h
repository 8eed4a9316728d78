// A motor's sum as the brain card writes it: two products, a bias, what further wires bring, and what came of them.
#pragma once

#include <array>
#include <string_view>

#include "core/world/snapshot.h"

namespace braitenlab {

// One eye's wire to the motor: value = input · weight, unless the wire is cut.
struct Product {
    std::string_view letters;  // "SL·LL"
    float input = 0;      // what threshold and curve of the wire let through; of a covered eye as of one in the dark
    float weight = 0;     // with what a Hebbian wire has learned
    float value = 0;      // what arrives
    bool masked = false;  // what the eye reads is below the threshold: counts as 0
    bool cut = false;     // a lesion: delivers nothing
};

struct MotorSum {
    std::string_view motor, bias_letters;  // "ML", "LM"
    std::array<Product, 2> products;       // the straight wire, then the crossed one
    float bias = 0;
    bool more_wires = false;  // the brain is longer than the sliders'
    float others = 0;         // what is then left: further wires, memory, the motor's curve; 0 otherwise
    bool stopped = false;     // a lesion of the motor: whatever the sum, the total is 0
    bool limited = false;     // the sum is more than a wheel can do: the total is −1 or 1
    float total = 0;          // what the motor really gets, −1..1
};

// Of the left and the right motor, at the snapshot's moment. Precondition: the vehicle is in the snapshot.
std::array<MotorSum, 2> motor_sums(const Snapshot&, const VehicleView&);

// What decides which wheel is faster: the largest push towards that difference, from either wheel.
struct Cause {
    enum class By { nothing, product, biases, others };
    float difference = 0;  // right − left
    By by = By::nothing;
    const Product* product = nullptr;  // lives as long as the sums; null unless by product
    bool holds_back = false;           // it slows the other wheel instead of driving the faster one
};
Cause cause(const std::array<MotorSum, 2>&);

}  // namespace braitenlab

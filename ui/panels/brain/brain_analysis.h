// Computations of the brain card: the sums of both motors, the cause of a turn, and the recognised character.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/world/character.h"
#include "core/world/snapshot.h"

namespace braitenlab::ui {

// The wire of one sensor to the motor: value = input · weight, or 0 when the wire is cut.
struct Product {
    std::string sensor;   // its name
    std::string letters;  // "SL·LL"; "f(SL)·LL" where the wire has a curve, f
    std::string label;    // the same with wiring::short_name() of the sensor
    float reading = 0;    // of the sensor
    float input = 0;      // reading after threshold and curve of the wire; 0 for a silenced sensor
    float weight = 0;     // includes what a Hebbian wire has learned
    float value = 0;      // contribution to the motor's sum
    bool masked = false;  // the reading is below the threshold and counts as 0
    bool cut = false;     // lesion: delivers 0
};

// The contribution of a node that is not in the shown pair: another sensor or a neuron.
struct Term {
    std::string name;   // of the node
    std::string label;  // wiring::short_name() of it
    float value = 0;
};

inline constexpr std::size_t most_terms = 2;  // of each motor; the card has no room for more

struct MotorSum {
    std::string_view motor, bias_letters;  // "ML", "LM"
    std::array<Product, 2> products;       // the uncrossed wire of the shown pair, then the crossed one
    std::vector<Term> terms;               // the largest contributions of further wires, at most most_terms
    float bias = 0;
    bool shows_products = true;  // false in both sums: with more_wires, and no wire is one of the products
    bool more_wires = false;     // the brain has more wires than the sliders show
    float rest = 0;              // with more_wires: the remaining wires and the motor's memory and curve; else 0
    bool stopped = false;        // lesion of the motor: the total is 0
    bool limited = false;        // the sum is outside −1..1: the total is −1 or 1
    float total = 0;             // the wheel command, −1..1
};

// Left and right motor, with the wires of this pair as products. Precondition: the vehicle is in the snapshot.
std::array<MotorSum, 2> motor_sums(const Snapshot&, const VehicleView&, const SensorPair& = {});

// The cause of the difference between the wheels: the sensor or neuron that adds most to it with all of its wires, the
// biases, or the rest, by the rule of insight::main_part(). It is named by its largest contribution to either wheel.
struct Cause {
    enum class By { nothing, product, term, biases, rest };
    float difference = 0;  // right − left
    By by = By::nothing;
    const Product* product = nullptr;  // points into the sums; null unless by product
    std::string name;                  // by product: its letters; by term: the node's name
    float value = 0;                   // of that contribution
    bool holds_back = false;           // it slows the other wheel instead of driving the faster one
};
Cause cause(const std::array<MotorSum, 2>&);

// Cached result of the recogniser for the selected vehicle.
struct Recognised {
    std::shared_ptr<const BrainGraph> brain;
    std::shared_ptr<const Scene> scene;
    VehicleId vehicle = no_vehicle;
    std::vector<Reading> readings;  // rounded to 0.05, so that noise does not change the result
    double at = 0;                  // wall seconds
    std::vector<PairCharacter> pairs;
    // Without a wired pair: the response to SL and SR, or, if the brain reads no sensor, indifferent or still.
    std::optional<Character> single;
};

// Recomputed at once for another brain or vehicle, and at most four times a second for changed readings.
const Recognised& recognised(Recognised&, const Snapshot&, const VehicleView&, double wall_seconds);

// The character for this pair, `single` without a wired pair. nullopt: the brain reads only sensors without a pair, or
// it has neurons and its response to the pair says little about it.
std::optional<Character> shown_character(const Recognised&, const Snapshot&, const VehicleView&, const SensorPair&);

// Key of the word for it, below "character." and "character_story.": the name of the shown character, or what decides
// instead, "parts" (neurons) or "single_sensors".
std::string_view character_key(const Recognised&, const Snapshot&, const VehicleView&, const SensorPair&);

}  // namespace braitenlab::ui

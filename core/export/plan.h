// What an exported brain computes: the compiled brain with the names of its parts, without parts that have no effect.
// Every target is written from a plan, so all targets compute the same.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "core/brain/brain.h"
#include "core/result.h"
#include "core/scene/scene.h"

namespace braitenlab::robots {

// Smallest and largest value that a number can have, whatever the sensors read.
struct Range {
    float low = 0, high = 0;
    friend bool operator==(const Range&, const Range&) = default;
};

// Where a sensor is on the vehicle: ahead of the middle and to the left, as shares of the body's length and width, or
// in m where the body is not known; the angle to the left.
struct Place {
    float x = 0, y = 0, angle = 0;
    bool is_share = false;
};

// A sensor that has an effect on a motor.
struct Input {
    std::string name;                    // of the brain's node
    std::string id;                      // "sensor_SL": an identifier of C, Python and Aseba
    std::optional<Channel> channel{};    // what it senses; nullopt: a brain alone does not say
    std::optional<Place> place{};        // nullopt: a brain alone does not say
    float half_lux = Sensor{}.half_lux;  // of a photocell; the default for other sensors
    float range = 0;                     // m, to which it reads in the lab; 0: a brain alone does not say
    float in_room = 0;                   // reading of an eye in the lab, of a room without a lamp
};

// Which value a wire reads: a sensor, a unit of this tick (`now`) or one of the previous tick (`before`).
enum class Reads { sensor, now, before };

struct PlanTap {
    Reads reads = Reads::sensor;
    int source = 0;  // index in Plan::inputs or Plan::units
    float weight = 0, threshold = 0;
    Curve curve{};
    float learning_rate = 0, decay = 0;  // 1/s; learning_rate 0: does not learn
    std::string learned_id{};            // "learned_SEES_FEAR"; empty: does not learn
    friend bool operator==(const PlanTap&, const PlanTap&) = default;
};

// A hidden neuron or a motor.
struct PlanUnit {
    std::string name, id;     // "THREE", "neuron_THREE"; "ML", "motor_ML"
    float bias = 0;           // with what wires from covered sensors add
    float time_constant = 0;  // s; 0: none
    float follow = 1;         // share of the way to the new value per tick, above 0
    Curve curve{};
    std::vector<PlanTap> taps{};
    Range sum{};           // of bias and wires; every partial sum is within it, too
    Range value{};         // of the unit
    bool is_kept = false;  // the next tick reads its value
};

struct Plan {
    std::string title;  // of the file that is written
    float rate_hz = 60;
    std::vector<Input> inputs;
    std::vector<PlanUnit> units;  // hidden neurons, then the left motor, then the right one
    float lux = 0;                // of the room

    std::size_t hidden() const { return units.size() - 2; }
    float period() const { return 1 / rate_hz; }
};

// The brain of a file with what its sensors sense. `sensors`: those of the vehicle; empty for a brain alone.
struct BrainToExport {
    std::string title;
    BrainGraph brain;
    std::vector<Sensor> sensors{};
    float length = 0, width = 0;  // m, of the vehicle's body; 0: not known
    float ambient = 0, lux = 0;   // of the scene's arena; a brain alone is in the dark
};

// Left out: wires of weight 0 that do not learn, neurons that reach no motor, sensors that reach no motor. A wire from
// a covered sensor becomes a part of the bias. `rate_hz`: calls of the brain per second, above 0. Fails as compile()
// does.
Result<Plan> make_plan(const BrainToExport&, float rate_hz);

// True if a unit or a wire has this response.
bool has_response(const Plan&, Response);

// True if the test is true of a wire.
bool has_wire(const Plan& plan, const auto& test) {
    return std::any_of(plan.units.begin(), plan.units.end(),
                       [&](const PlanUnit& unit) { return std::any_of(unit.taps.begin(), unit.taps.end(), test); });
}
inline bool has_threshold(const Plan& plan) {
    return has_wire(plan, [](const PlanTap& tap) { return tap.threshold > 0; });
}

// Values of a response for inputs of this range.
Range range_of(const Curve&, Range inputs);

// Bound of a value that grows without limit: think() clamps there.
inline constexpr float largest_value = 1e3f;

}  // namespace braitenlab::robots

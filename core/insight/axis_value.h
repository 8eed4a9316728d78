// The values of a vehicle and its scene that an axis of a map or a study can vary, as a list to choose from.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/insight/map.h"
#include "core/scene/schema.h"
#include "core/world/command.h"

namespace braitenlab::insight {

enum class ValueGroup { brain, body, scene };
inline constexpr int value_group_count = 3;

// What has the value. sensors: both of the pair, where y and angle of the right one have the other sign.
enum class ValueOwner { dials, sensors, body, start, source, arena };
constexpr ValueGroup group_of(ValueOwner owner) {
    if (owner == ValueOwner::dials) return ValueGroup::brain;
    return owner == ValueOwner::sensors || owner == ValueOwner::body ? ValueGroup::body : ValueGroup::scene;
}

struct AxisValue {
    ValueOwner owner = ValueOwner::dials;
    std::string id;           // "LL=RR", "sensor.angle", "source.lamp.x": the same for every vehicle and pair
    std::string key;          // "LL=RR", "angle", "x"
    std::string source;       // name of the source
    std::vector<Dial> dials;  // of the brain
    // In a file of the scene, as MapAxis::values. For dials of the pair SL and SR alone.
    std::vector<std::string> paths;
    std::string_view unit;  // angles in degrees
    Range allowed{0, 0};
    float from = 0, to = 1;  // the usual range; the present value is in it
    float now = 0;           // of the first dial or sensor
    bool is_one = true;      // all dials or sensors have this value
};

// Whose values: the vehicle is in the snapshot.
struct ValueSubject {
    const Snapshot& now;
    const VehicleView& vehicle;
    Target target;  // whose brain and sensors
    SensorPair pair;
};

inline constexpr std::size_t most_offered_sources = 6;

// By group: the numbers of the brain (brain_axes), the sensors of the pair, or the only sensor, and the body; the start
// of the vehicle, the first sources and the arena.
std::vector<AxisValue> axis_values(const ValueSubject&);
const AxisValue* find_value(const std::vector<AxisValue>&, std::string_view id);  // null: none

// The axis of a map, whose path is the id.
MapAxis axis_of(const AxisValue&, float from, float to);

// The commands that set the value; none where it is so already. A value of the start moves the vehicle, too, before
// the first tick.
std::vector<Command> commands_that_set(const ValueSubject&, const AxisValue&, float value);

// Prepares a scene for runs with other values of the subject's sensors or brain: those of the target are where the
// paths say. The run does not change, except that a target of a whole kind has those of the subject's vehicle.
void place_sensors(Scene&, const ValueSubject&);
void place_brain(Scene&, const ValueSubject&);

}  // namespace braitenlab::insight

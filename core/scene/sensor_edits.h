// Edits of a list of sensors as pure functions, and the sensors that a preset brain needs.
#pragma once

#include <string>
#include <vector>

#include "core/brain/presets.h"
#include "core/scene/scene.h"

namespace braitenlab {

// The sensor with this name, or null.
const Sensor* find_sensor(const std::vector<Sensor>&, const std::string& name);
Sensor* find_sensor(std::vector<Sensor>&, const std::string& name);

// A sensor as mirror image at the x axis: y and angle have the other sign.
Sensor mirrored(Sensor);

// The name of the sensor on the other side: SR for SL, SR2 for SL2. Empty where the name has no side.
std::string other_side(const std::string& name);

// The sensor on the other side of the one with this name: by its name, else by its position (see sensor_pairs()).
// Empty where there is none.
std::string opposite_of(const std::vector<Sensor>&, const std::string& name);

// The sensors that are added for a channel: a left and a right one, or one in the middle. Their names follow from the
// channel and are neither those of `sensors` nor `taken`; numbers from 2 on make them free: SL2, SR2.
std::vector<Sensor> new_sensors(const std::vector<Sensor>& sensors, Channel, bool as_pair,
                                const std::vector<std::string>& taken = {});

// Adds the mirror image of the sensor with this name, or makes the sensor on its other side its mirror image. The list
// is unchanged without such a sensor and for one in the middle that looks straight ahead.
std::vector<Sensor> with_mirror_image(std::vector<Sensor>, const std::string& name);

// The list in which `more` replace sensors of the same names; the others are appended.
std::vector<Sensor> with_sensors(std::vector<Sensor>, const std::vector<Sensor>& more);

// The sensors that the preset's brain reads, as they are in the shipped scene of the preset.
std::vector<Sensor> preset_sensors(const Preset&);

// The sensors that the preset's brain needs and the list lacks: those whose names it lacks, and where the preset is
// about certain channels, e.g. prey, those that sense another channel. A brain of two eyes works on any channel.
std::vector<Sensor> lacking_for(const std::vector<Sensor>&, const Preset&);

// A sensor for a brain that reads this name: as in a preset, else with the channel whose names begin so, else light.
Sensor sensor_named(const std::string& name);

// The brain with a node for each sensor that it does not have; a node needs a name that no other node has.
BrainGraph with_sensor_nodes(BrainGraph, const std::vector<Sensor>&);

// The brain without the nodes of these sensors, unless a wire leads from them or a slider sets them (SL, SR).
BrainGraph without_idle_sensors(BrainGraph, const std::vector<std::string>& names);

}  // namespace braitenlab

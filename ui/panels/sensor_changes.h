// Requests that change the sensors of a vehicle or of its kind together with the brains that read them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ui/lab_view.h"
#include "ui/request.h"

namespace braitenlab::ui {

// Sets the sensors of target_of(vehicle). In the same step of undo, its brains get a node for each sensor that is added
// and lose the nodes without wires of sensors that are removed.
void request_sensors(const LabView&, Outbox&, const VehicleView&, std::vector<Sensor>, std::uint64_t gesture);

// As above, and replaces the brains by `brain`.
void request_brain_and_sensors(const LabView&, Outbox&, const VehicleView&, BrainGraph brain, std::vector<Sensor>,
                               std::uint64_t gesture);

// Renames a sensor of target_of(vehicle); its brains read it by the new name.
void request_renamed_sensor(const LabView&, Outbox&, const VehicleView&, const std::string& from, const std::string& to,
                            std::uint64_t gesture);

// True if a brain of target_of(vehicle) or its sensors use the name.
bool is_name_taken(const LabView&, const VehicleView&, const std::string& name);

// The names of neurons and motors of the vehicle's brain, which a new sensor cannot have.
std::vector<std::string> names_taken(const LabView&, const VehicleView&);

}  // namespace braitenlab::ui

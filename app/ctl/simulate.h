// Runs a world for braitenctl and makes the rows of its table.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/vehicle_table.h"
#include "core/world/world.h"

namespace braitenlab {

// Runs the world for this time (s). Passes the snapshot at its start and at each whole 0.1 s of the run to `add_rows`,
// unless that is empty. Returns false, before the end, when the user has interrupted the program.
bool simulate(World&, double seconds, const std::function<void(const Snapshot&)>& add_rows = {});

// A line per vehicle. Each begins with `first_cells`, which is empty or ends with a comma.
std::string table_rows(const std::vector<io::VehicleColumn>&, const Snapshot&, std::string_view first_cells = "");

}  // namespace braitenlab

// Runs every combination of a sweep and writes one table.
#pragma once

#include <set>

#include "app/ctl/ctl.h"
#include "app/ctl/sweep.h"
#include "core/io/vehicle_table.h"

namespace braitenlab {

// Writes the columns run, seed, one per --set argument, and those of a vehicle table. Runs are numbered from 1; the
// seed varies fastest, then the last --set argument. The table does not depend on RunOptions::threads. Every
// combination of values is checked before the first run. Returns the exit code.
int run_sweep(const RunOptions&, const Sweep&, const std::set<io::ColumnGroup>&);

}  // namespace braitenlab

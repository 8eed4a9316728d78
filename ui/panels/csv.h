// What the pictures show, as text for a spreadsheet: one header line, commas, points, seconds of the simulation.
#pragma once

#include <string>

#include "core/world/snapshot.h"
#include "ui/panels/history.h"

namespace braitenlab {

// seconds,SL,SR,ML,MR: the selected vehicle's eyes 0..1 and motors −1..1.
std::string signals_csv(const History&);

// seconds,predators,prey,others,energy_predators,energy_prey,energy_others: numbers and mean energies 0..1; empty where
// there is nobody.
std::string population_csv(const History&);

// id,kind,role,energy: everybody at this moment.
std::string energies_csv(const Snapshot&);

}  // namespace braitenlab

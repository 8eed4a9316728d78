// In which order everybody's energy is shown.
#pragma once

#include <cstddef>
#include <vector>

#include "core/world/snapshot.h"

namespace braitenlab {

struct EnergyOrder {
    enum class By { number, energy, kind };
    By by = By::number;
    bool falling = false;
    friend bool operator==(const EnergyOrder&, const EnergyOrder&) = default;
};

// Indices into the snapshot's vehicles. Who is alike stands by number, whichever way the rest is sorted.
void sort(const Snapshot&, const EnergyOrder&, std::vector<std::size_t>& rows);

}  // namespace braitenlab

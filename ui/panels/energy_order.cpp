#include "ui/panels/energy_order.h"

#include <algorithm>
#include <numeric>

namespace braitenlab {

void sort(const Snapshot& now, const EnergyOrder& order, std::vector<std::size_t>& rows) {
    rows.resize(now.vehicles.size());
    std::iota(rows.begin(), rows.end(), std::size_t{0});  // the snapshot is by number
    if (order.by == EnergyOrder::By::number) {
        if (order.falling) std::reverse(rows.begin(), rows.end());
        return;
    }
    std::sort(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) {
        const VehicleView &one = now.vehicles[a], &other = now.vehicles[b];
        const bool by_energy = order.by == EnergyOrder::By::energy;
        const float x = by_energy ? one.energy : static_cast<float>(one.kind);
        const float y = by_energy ? other.energy : static_cast<float>(other.kind);
        if (x == y) return a < b;
        return order.falling ? x > y : x < y;
    });
}

}  // namespace braitenlab

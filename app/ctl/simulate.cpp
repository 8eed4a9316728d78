#include "app/ctl/simulate.h"

#include <cmath>
#include <cstdint>

#include "app/platform/platform.h"

namespace braitenlab {

bool simulate(World& world, double seconds, const std::function<void(const Snapshot&)>& add_rows) {
    constexpr std::uint64_t ticks_per_row = 6;  // 0.1 s
    const auto end = world.tick() + static_cast<std::uint64_t>(std::llround(seconds * 60));
    Snapshot now;
    if (add_rows) world.capture(now), add_rows(now);
    while (world.tick() < end) {
        if (is_told_to_end()) return false;
        world.step();
        if (!add_rows || world.tick() % ticks_per_row != 0) continue;
        world.capture(now);
        add_rows(now);
    }
    return true;
}

std::string table_rows(const std::vector<io::VehicleColumn>& columns, const Snapshot& now,
                       std::string_view first_cells) {
    std::string rows;
    for (const VehicleView& vehicle : now.vehicles) {
        rows += first_cells;
        io::add_csv_row(rows, columns, io::VehicleRow{now, vehicle});
    }
    return rows;
}

}  // namespace braitenlab

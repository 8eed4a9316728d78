// A desk with open charts below a vehicle with neurons, and two recorded seconds.
#pragma once

#include "desk.h"

namespace braitenlab::tests {

struct ChartDesk : Desk {
    explicit ChartDesk(float height) : Desk{1280, height, 1, true} {
        now = shipped_scene("5-logic");
        view.settings.selection.vehicle = 0;
        panels.charts.open = true;
        for (std::uint64_t tick = 0; tick <= 120; tick += 3) {
            now.tick = tick, now.seconds = static_cast<double>(tick) / 60;
            frame();
        }
    }
};

}  // namespace braitenlab::tests

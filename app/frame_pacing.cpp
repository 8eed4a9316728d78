#include "app/frame_pacing.h"

#include <algorithm>

namespace braitenlab {

double pause_after_swap(double turn_seconds, int refresh_rate) {
    constexpr double usual_rate = 60, part_of_interval = 0.9;
    const double least = refresh_rate > 0 ? part_of_interval / refresh_rate : 1 / usual_rate;
    return std::max(0.0, least - turn_seconds);
}

}  // namespace braitenlab

#include "app/frame_pacing.h"

#include <algorithm>

namespace braitenlab {

double pause_after_swap(double turn_seconds, int refresh_rate, int frame_rate) {
    constexpr double usual_rate = 60, part_of_interval = 0.9;
    double least = refresh_rate > 0 ? part_of_interval / refresh_rate : 1 / usual_rate;
    if (frame_rate > 0) least = std::max(least, 1.0 / frame_rate);
    return std::max(0.0, least - turn_seconds);
}

double idle_wait(double seconds_since_change) {
    constexpr double settling = 1, period = 0.1;
    return seconds_since_change < settling ? 0 : period;
}

}  // namespace braitenlab

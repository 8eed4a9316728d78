// How long a turn of the main loop waits after its picture has been shown.
#pragma once

namespace braitenlab {

// Seconds to wait, at least 0. `turn_seconds`: duration of the turn so far, its buffer swap included. `refresh_rate`:
// pictures per second of the fastest display, or 0 if unknown.
//
// With vertical sync the swap waits for the display, so the turn has taken a whole refresh interval (or several) and
// does not wait here: the display sets the pace, at 60, 75 or 144 Hz alike. A turn shorter than that shows that the
// swap has not waited. Then the turn waits here, for slightly less than a refresh interval, so that it never misses the
// next one where the swap returns early only now and then.
double pause_after_swap(double turn_seconds, int refresh_rate);

}  // namespace braitenlab

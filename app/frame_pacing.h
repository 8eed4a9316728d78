// Frame pacing: the waits of a turn of the main loop after its buffer swap.
#pragma once

namespace braitenlab {

// Seconds to wait, at least 0. `turn_seconds`: duration of the turn so far, its buffer swap included. `refresh_rate`:
// pictures per second of the fastest display, or 0 if unknown. `frame_rate`: pictures per second that the user allows,
// or 0 for no such limit.
//
// With vertical sync the swap waits for the display, so a turn takes one refresh interval or several, and the result is
// 0. A shorter turn means that the swap has not waited. The result is then the rest of slightly less than one refresh
// interval, so that the turn does not miss the next interval if the swap returns early only sometimes.
double pause_after_swap(double turn_seconds, int refresh_rate, int frame_rate = 0);

// Seconds to wait for the next event if nothing in the window moves; 0 for the first second after a change, in which
// the camera eases and highlights fade. Afterwards the window draws ten frames per second, enough for a text cursor and
// a pulsing hint, and an event ends the wait, so that the window reacts without delay.
double idle_wait(double seconds_since_change);

}  // namespace braitenlab

// When the next turn of the program is due in a browser: Window::poll() puts it off, an event makes it due.
#pragma once

namespace braitenlab::web {

// Puts the next turn off for this long.
void put_off(double seconds);
// Makes the next turn due: the page has received an event.
void wake();
bool is_due();

}  // namespace braitenlab::web

// Executes the requests that panels, keys and the mouse make.
#pragma once

#include "app/lab.h"

namespace braitenlab {

void handle(Lab&, const Request&);

// Executes requests in order. Moves of one gesture that follow each other are one command: their cost does not grow
// with the square of their number.
void handle_all(Lab&, const Outbox&);

}  // namespace braitenlab

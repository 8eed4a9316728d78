// The program for a Thymio II in the Aseba language: 16-bit integers, computed at each `prox` event (10 Hz).
#pragma once

#include <optional>
#include <string>

#include "core/export/plan.h"
#include "core/result.h"

namespace braitenlab::robots::thymio {

// The integer that stands for 1.0: the largest of 8000, 4000, 2000, 1000 for which no number of the program, partial
// sums included, leaves −32767..32767. 0 if there is none.
int unit_of(const Plan&);

// The first part that the program cannot hold, with its name: a sensor that a Thymio does not have, two sensors for the
// same place, a learning wire, a sum that could wrap, a memory too slow for 16 bits, too many words of program.
std::optional<Error> refusal(const Plan&);

// brain.aesl. Precondition: refusal() is nullopt.
std::string program(const Plan&);

// README.md. The same precondition.
std::string readme(const Plan&);

}  // namespace braitenlab::robots::thymio

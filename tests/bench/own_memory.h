// How much memory of our own is in use. Box2D takes its own by another way and is not counted.
#pragma once

#include <cstdint>

namespace braitenlab::bench {

std::int64_t bytes_in_use();  // by operator new, since the program began
std::int64_t allocations();   // how often it was asked, since the program began

}  // namespace braitenlab::bench

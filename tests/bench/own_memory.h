// Memory in use by operator new. Box2D uses another allocator and is not counted.
#pragma once

#include <cstdint>

namespace braitenlab::bench {

std::int64_t bytes_in_use();  // since the program started
std::int64_t allocations();   // number of calls since the program started

}  // namespace braitenlab::bench

// Ends the process where a promise is broken, as a sanitizer does.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace braitenlab::fuzz {

inline void promise(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "a broken promise: %s\n", what);
    std::abort();
}

}  // namespace braitenlab::fuzz

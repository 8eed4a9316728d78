// Random number generator with the same numbers on every platform and standard library.
//
// PCG-XSH-RR 64/32 (M. E. O'Neill, "PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms for
// Random Number Generation", HMC-CS-2014-0905). Streams with different numbers are independent, so that a new use
// of random numbers does not change the results of another.
#pragma once

#include <cstdint>

namespace braitenlab::maths {

struct Random {
    std::uint64_t state = 0;
    std::uint64_t increment = 1;  // odd; selects the stream

    Random() = default;
    Random(std::uint64_t seed, std::uint64_t stream) : increment(stream * 2 + 1) {
        next();
        state += seed;
        next();
    }

    // 32 uniformly random bits.
    std::uint32_t next() {
        const std::uint64_t old = state;
        state = old * 6364136223846793005ULL + increment;
        const auto xorshifted = static_cast<std::uint32_t>(((old >> 18U) ^ old) >> 27U);
        const auto rotation = static_cast<std::uint32_t>(old >> 59U);
        return (xorshifted >> rotation) | (xorshifted << ((32 - rotation) & 31U));
    }

    // Uniform in [low, high), from 24 bits.
    float uniform(float low, float high) { return low + (high - low) * (static_cast<float>(next() >> 8U) * 0x1p-24f); }

    // Approximately normal with mean 0 and standard deviation 1: the sum of twelve uniform numbers minus 6, within ±6.
    float normal() {
        float sum = -6;
        for (int i = 0; i < 12; ++i) sum += uniform(0, 1);
        return sum;
    }

    friend bool operator==(const Random&, const Random&) = default;
};

}  // namespace braitenlab::maths

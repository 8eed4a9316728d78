// The final state of a run: the JSON object and the summary of `braitenctl run`; numbers of all JSON objects.
#pragma once

#include <cstdint>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "core/world/snapshot.h"

namespace braitenlab {

// The number to five decimals; null if it is not finite.
nlohmann::ordered_json rounded_json(float);

// Sixteen hexadecimal digits.
std::string hash_text(std::uint64_t);

// One object: scene, seed, ticks, seconds, hash, generation, population, predators, prey, events {captures, deaths,
// births, contacts}, sources [{id, channel, x, y}], vehicles [{id, kind, role, x, y, heading, speed, energy, left,
// right, sensors [..]}]. Speed in m/s, energy 0..1, left and right: wheel commands, −1..1.
std::string report_json(const Snapshot&, std::uint64_t hash);

// A summary of a few lines.
std::string report_text(const Snapshot&, std::uint64_t hash);

}  // namespace braitenlab

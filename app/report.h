// A run as data for scripts: the JSON object and the CSV rows of `braitenctl run`.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>

#include "core/world/snapshot.h"

namespace braitenlab {

// Sixteen hexadecimal digits.
std::string hash_text(std::uint64_t);

// One object: scene, seed, ticks, seconds, hash, generation, population, predators, prey, events {captures, deaths,
// births, contacts}, sources [{id, channel, x, y}], vehicles [{id, kind, role, x, y, heading, speed, energy, left,
// right, sensors [..]}]. Speed in m/s, energy 0..1, left and right the commanded wheel speeds −1..1.
std::string report_json(const Snapshot&, std::uint64_t hash);

// A few lines for people.
std::string report_text(const Snapshot&, std::uint64_t hash);

// The header line and the rows of one moment: seconds,id,kind,role,x,y,heading,speed,energy,left,right.
void write_csv_header(std::ostream&);
void write_csv_rows(std::ostream&, const Snapshot&);

}  // namespace braitenlab

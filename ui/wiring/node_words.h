// What a node is, in words.
#pragma once

#include <string_view>

#include "core/world/snapshot.h"

namespace braitenlab {

// A string key: the first two eyes and the motors are known by their side, every further sensor by what it senses.
std::string_view node_words(const Snapshot&, const VehicleView&, const Node&);

}  // namespace braitenlab

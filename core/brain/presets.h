// The canonical vehicles of V. Braitenberg, "Vehicles: Experiments in Synthetic Psychology" (MIT Press, 1984).
#pragma once

#include <span>
#include <string_view>

#include "core/brain/four_neurons.h"

namespace braitenlab {

struct Preset {
    std::string_view name;  // "2a-coward": also the key of its title and story in the string files
    FourNeurons brain;
};

// In the order of the book.
std::span<const Preset> presets();

}  // namespace braitenlab

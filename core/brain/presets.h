// The canonical vehicles of V. Braitenberg, "Vehicles: Experiments in Synthetic Psychology" (MIT Press, 1984), and
// W. Grey Walter's tortoise ("An Imitation of Life", Scientific American 182, 1950), as brains to look at and to take.
//
// Every preset begins with the four neurons SL, SR, ML, MR, so that the sliders reach it. Eyes come in pairs whose
// names end in L and R: S what the vehicle mainly looks at, H heat, N smell (a nose), A oxygen (air), Q obstacles
// that it remembers. TC is a bumper, EN the vehicle's own energy, UP a photocell that looks all round. A vehicle that
// lacks a sensor reads 0 there.
#pragma once

#include <span>
#include <string_view>

#include "core/brain/graph.h"

namespace braitenlab {

struct Preset {
    std::string_view name;   // "2a-coward": also the key of its title and story in the string files
    std::string_view scene;  // the shipped scene that shows it, the stem of its file
    BrainGraph brain;        // compiles as it stands; the scene's vehicle may have feelers besides
};

// In the order of the book, then the tortoise, then the hunt.
std::span<const Preset> presets();

// The preset of this name, or null.
const Preset* find_preset(std::string_view name);

}  // namespace braitenlab

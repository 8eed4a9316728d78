// Recogniser: classifies a brain by its response to a stimulus, independent of its wiring.
#pragma once

#include <span>
#include <string>

#include "core/brain/four_neurons.h"

namespace braitenlab {

// The characters. mixed: a response that none of the others describes.
enum class Character { still, indifferent, alive, drowsy, coward, aggressor, love, explorer, orbiting, mixed };

// The field's name: "coward", "aggressor", "love" …; a stable key, not a translated word.
const char* name(Character);

// The constant reading of another sensor; sensors without one read 0.
struct Reading {
    std::string sensor;
    float value = 0;
    friend bool operator==(const Reading&, const Reading&) = default;
};

// Applies constant stimuli of eight strengths to the left and to the right sensor of the pair and reads the motors
// after they have settled.
//   still        never drives;           indifferent  drives, independent of the stimulus
//   alive        faster, does not turn;  drowsy       slower, does not turn
//   coward       turns away and faster;  aggressor    turns towards and faster
//   love         turns towards, can rest before a strong one;  explorer  turns away, slower
//   orbiting     turns towards a weak stimulus and away from a strong one
// A brain whose turn depends less on the side of the stimulus than on a fixed bias to one side is mixed. A brain that
// does not compile is still.
Character recognise(const BrainGraph&, const SensorPair& = {}, std::span<const Reading> meanwhile = {});

// +1: turns towards the stimulus; −1: turns away; 0: neither. Gives the role of a vehicle for Role::wiring.
int attraction(Character);

}  // namespace braitenlab

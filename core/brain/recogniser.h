// Names what a brain does to a stimulus, judged by the brain's response alone, as an observer would.
#pragma once

#include <span>
#include <string>

#include "core/brain/graph.h"

namespace braitenlab {

// The classic characters. `mixed` answers to a stimulus in a way that none of the others describes.
enum class Character { still, indifferent, alive, drowsy, coward, aggressor, love, explorer, orbiting, mixed };

// The field's name: "coward", "aggressor", "love" …; a stable key, not a translated word.
const char* name(Character);

// The two eyes before which the stimulus is put: a brain of several senses has a character for each.
struct EyePair {
    std::string left = "SL", right = "SR";
};

// What any other sensor reads meanwhile; 0 where it is not named.
struct Reading {
    std::string sensor;
    float value = 0;
    friend bool operator==(const Reading&, const Reading&) = default;
};

// Puts steady stimuli of eight strengths before the left eye and before the right one, and looks at what the motors
// settle to.
//   still        never drives;           indifferent  drives the same whatever it sees
//   alive        faster, does not turn;  drowsy       slower, does not turn
//   coward       turns away and faster;  aggressor    turns towards and faster
//   love         turns towards, slower at last;  explorer  turns away, slower
//   orbiting     turns towards what is faint and away from what is strong
// A brain that veers to one side more than it turns to where the stimulus is, is mixed.
Character recognise(const BrainGraph&, const EyePair& = {}, std::span<const Reading> meanwhile = {});

// +1 drawn to what it sees, −1 driven away by it, 0 neither: what makes a predator or a prey by wiring alone.
int attraction(Character);

}  // namespace braitenlab

// Names what a brain does to a stimulus, judged by the brain's response alone, as an observer would.
#pragma once

#include "core/brain/graph.h"

namespace braitenlab {

// The classic characters. `mixed` answers to a stimulus in a way that none of the others describes.
enum class Character { still, indifferent, alive, coward, aggressor, love, explorer, mixed };

// The field's name: "coward", "aggressor", "love" …; a stable key, not a translated word.
const char* name(Character);

// Puts steady stimuli before the left eye, the right eye and both, and looks at what the motors settle to.
//   still        never drives;           indifferent  drives the same whatever it sees
//   alive        faster when it sees, but does not turn
//   coward       turns away and faster;  aggressor    turns towards and faster
//   love         turns towards, slower;  explorer     turns away, slower
Character recognise(const BrainGraph&);

// +1 drawn to what it sees, −1 driven away by it, 0 neither: what makes a predator or a prey by wiring alone.
int attraction(Character);

}  // namespace braitenlab

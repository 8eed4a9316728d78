// How the canvas asks for what a hand wants, or says why not; and what it selects.
#pragma once

#include "ui/wiring/interaction.h"

namespace braitenlab {

inline bool nothing_selected(const CanvasState& state) {
    return state.selection.nodes.empty() && state.selection.wires.empty();
}

// Shows the reason at the cursor for a moment.
void refuse(CanvasState&, const CanvasFrame&, std::string_view key);
void refuse(CanvasState&, const CanvasFrame&, Refusal);

// Asks for the edited brain, nobody in it moved (see in_place()), or says why there is none. True when asked.
bool ask(CanvasState&, const CanvasFrame&, const Edit&, std::uint64_t gesture, Outbox&);

// Asks for a wire's weight: by the slider's number where the wire has one, so that both are the same command.
void ask_weight(const CanvasFrame&, const BrainGraph&, WireEnds, float weight, std::uint64_t gesture, Outbox&);

// Asks for these nodes to stand there, and for all others to stay where they are: once somebody has put a node
// anywhere, tidying has no say.
void ask_places(const CanvasFrame&, const Places& moved, std::uint64_t gesture, Outbox&);

// Makes the thing the only one selected, or adds it to what is (a second time: takes it out).
void select(CanvasState&, const Hit&, bool add);

}  // namespace braitenlab

// Edits that the canvas makes: sent to the lab as requests, or refused with a note at the pointer. No Dear ImGui.
//
// `gesture` is the undo step: equal for all edits of one drag.
#pragma once

#include <string>

#include "ui/wiring/canvas_state.h"

namespace braitenlab::wiring {

// The string key of a refusal: "wiring.refused.duplicate".
std::string refusal_key(Refusal);

// Shows the reason (a string key) at the pointer for a moment.
void show_refusal(CanvasState&, const CanvasFrame&, const std::string& key);
void show_refusal(CanvasState&, const CanvasFrame&, Refusal);

// Sends the edited brain with the displayed positions of its nodes, or shows the refusal. Returns true if sent.
bool send_edit(CanvasState&, const CanvasFrame&, const Edit&, std::uint64_t gesture, Outbox&);

// Sends a wire's weight: as TurnDial where the wire has a dial, so that slider and wire give the same command.
void send_weight(const CanvasFrame&, const BrainGraph&, WireEnds, float weight, std::uint64_t gesture, Outbox&);

// Sends new positions of these nodes, together with the displayed positions of all others: after the user has moved a
// node, no node is tidied.
void send_positions(const CanvasFrame&, const Positions& moved, std::uint64_t gesture, Outbox&);

// Selects the part alone; with `add` adds it to the selection, or removes it if it is selected.
void select(CanvasState&, const Hit&, bool add);

// Removes the selected parts.
void erase_selected(CanvasState&, const CanvasFrame&, Outbox&);

// Copies the selected neurons to the clipboard. False, with a refusal, when there are none.
bool copy_selected(CanvasState&, const CanvasFrame&);

// Pastes the clipboard near the pointer, or in the middle of the canvas when the pointer is elsewhere.
void paste_copied(CanvasState&, const CanvasFrame&, Outbox&);

// Adds a copy of the selected neurons beside them.
void duplicate_selected(CanvasState&, const CanvasFrame&, Outbox&);

// Adds a neuron of this row of neuron_kinds where the menu was opened, joined to the menu's loose wire if it has one.
void add_chosen(CanvasState&, const CanvasFrame&, const CanvasMenu&, std::size_t kind, Outbox&);

// Adds a neuron in the middle of a wire.
void insert_new(CanvasState&, const CanvasFrame&, WireEnds, Outbox&);

// The effect of a release of a dragged wire's end.
struct WireDrop {
    enum class What { nothing, connect, new_neuron, take_off, refused } what = What::nothing;
    WireEnds ends{};       // of connect
    std::string reason{};  // of refused: a string key
};

// Precondition of both: the phase is drag_wire. drop_wire joins, removes, opens the menu of neurons or shows a refusal.
WireDrop drop_of(const CanvasState&, const CanvasFrame&);
void drop_wire(CanvasState&, const CanvasFrame&, Outbox&);

// The wire that a dragged neuron would be inserted into: it is dragged alone and has no wires.
std::optional<WireEnds> insertion_of(const CanvasState&, const CanvasFrame&);

// Precondition: the phase is move_nodes. Inserts the neuron into the wire under it, else sends the new positions.
void drop_nodes(CanvasState&, const CanvasFrame&, Outbox&);

}  // namespace braitenlab::wiring

// What lies under the pointer in the scene, and what a press would take hold of.
#pragma once

#include <optional>

#include "ui/scene_input/interaction.h"

namespace braitenlab {

// The pointer's place on the floor, m; nothing above the horizon.
std::optional<maths::vec2> floor_at(const SceneInputFrame&);

// How many pixels the pointer is away from a place on the floor; very many from one that cannot be seen.
float pixels_from(const SceneInputFrame&, maths::vec2 place);

// The nearest place within the arena's rim.
maths::vec2 in_arena(const LabView&, maths::vec2 place);

// Nothing while a tool draws, while wiring, and under a card.
SceneInputHit under_pointer(const SceneInputState&, const SceneInputFrame&);

// The ring round a thing by which it is turned.
struct Handle {
    maths::vec2 middle;  // m
    float radius = 0;    // m
    maths::vec2 knob;    // m, on the ring, where the thing faces
};

// Of the chosen thing, where it can be turned; only near the pointer or while it turns, so that a run stays calm.
std::optional<Handle> handle_of(const SceneInputState&, const SceneInputFrame&);

}  // namespace braitenlab

// The object under the pointer in the scene, and the object or handle that a press takes.
#pragma once

#include <optional>

#include "ui/scene_input/state.h"

namespace braitenlab::ui {

// The object that Delete, Ctrl+D, the arrow keys and the handle act on: the selected lamp, obstacle or zone, else the
// selected vehicle.
SceneObject chosen(const LabView&);

// The pointer's position on the floor, m; nullopt above the horizon.
std::optional<maths::vec2> floor_at(const SceneInputFrame&);

// Distance from the pointer to a position on the floor, window pixels; 1e9 for a position behind the camera.
float pixels_from(const SceneInputFrame&, maths::vec2 place);

// The position in whole millimetres, so that a place that the pointer gives is short in a file.
maths::vec2 to_millimetres(maths::vec2 place);

// The nearest position within the arena, in whole millimetres except at its edge.
maths::vec2 in_arena(const LabView&, maths::vec2 place);

// The object under the pointer; zones only while they are shown.
SceneObject object_at_pointer(const SceneInputFrame&);

// The object or handle that a press takes. None while a tool draws, in Mode::wiring, and under a card.
SceneInputHit under_pointer(const SceneInputState&, const SceneInputFrame&);

// The ring around an object, by which it is turned.
struct Handle {
    maths::vec2 middle;  // m
    float radius = 0;    // m
    maths::vec2 knob;    // m, on the ring, in the direction of the heading
};

// The handle of the chosen object. Shown only while the pointer is near or the object is being turned.
std::optional<Handle> handle_of(const SceneInputState&, const SceneInputFrame&);

}  // namespace braitenlab::ui

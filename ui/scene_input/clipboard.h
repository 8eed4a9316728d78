// Copies of objects of a scene, as a scene of their own: positions as in the original, and the kinds of its vehicles.
// They can be added to any scene. Does not use Dear ImGui.
#pragma once

#include <optional>
#include <vector>

#include "core/maths/vec.h"
#include "core/world/command.h"
#include "core/world/snapshot.h"
#include "render/view/pick.h"

namespace braitenlab::ui {

// The objects as a scene. A vehicle is a start with its present pose; its brain and driver are given where they differ
// from those of its kind. Objects that do not exist are left out.
Scene copied(const Snapshot&, const std::vector<SceneObject>&);

// The number of objects in a copy.
std::size_t object_count(const Scene& copy);

// The commands that add a copy to a scene, in order. `middle`: the position that the middle of the copy gets, m;
// nullopt: beside the original. Positions are clamped to the arena; with_room() finds free ones. A kind is added if the
// scene has none of the same name and design; a brain is given where it differs from that of the kind in this scene.
std::vector<Command> pasted(const Snapshot&, const Scene& copy, std::optional<maths::vec2> middle);

}  // namespace braitenlab::ui

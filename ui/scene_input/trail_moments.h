// Moments of the selected vehicle's path, picked on its trail..
#pragma once

#include <cstdint>
#include <optional>

#include "ui/scene_input/state.h"

namespace braitenlab::ui {

// The tick at which the selected vehicle was at the point of its trail under the pointer; of several the latest one.
// nullopt: the trail is farther away, or is not shown, or the vehicle is still there, or the cause of its turns may not
// be told.
std::optional<std::uint64_t> trail_moment_at_pointer(const SceneInputState&, const SceneInputFrame&);

// A ring on the trail at FeatureViews::path[tick].
void draw_trail_moment(const SceneInputFrame&, const Ui&, std::uint64_t tick);

}  // namespace braitenlab::ui
